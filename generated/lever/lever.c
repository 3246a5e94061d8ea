/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Variable-stiffness lever: force and stiffness of one tendon
 *
 * Made by: sinew generate models/lever
 * Model:   sha256 15dde9f611cf6f60b088af06e8cd7bbe07ac2edbefd53940e6f2012efb5af55c
 * Do not edit: change the model and generate again.
 */
#include "lever.h"

#include "sinew_math.h"

#ifdef __GNUC__
#define SINEW_NOT_INLINE __attribute__((noinline))
#else
#define SINEW_NOT_INLINE
#endif

SINEW_NOT_INLINE static double sinew_one_atan2(double y, double x)
{
    return sinew_atan2(y, x);
}

struct sinew_sines {
    double s[1], c[1];
};

SINEW_NOT_INLINE static struct sinew_sines sinew_one_sincos(double x)
{
    struct sinew_sines y;
    sinew_sincos(x, y.s, y.c);
    return y;
}

void lever_state(double theta, double out[SINEW_AT_LEAST(4)])
{
    const struct sinew_sines sines1 = sinew_one_sincos(theta);
    const double sin_theta = sines1.s[0];
    const double cos_theta = sines1.c[0];
    const double C2_y_by_theta = 0.014 * cos_theta;
    const double C2_x = 0.005 + C2_y_by_theta;
    const double s23_x = 0.034 - C2_x;
    const double C2_x_by_theta = 0.014 * sin_theta;
    const double C2_y = 0.005 - C2_x_by_theta;
    const double t2 = (C2_y + C2_y) * C2_y_by_theta;
    const double t3 = s23_x * s23_x;
    const double t4 = C2_y * C2_y;
    const double s23_distance_squared_by_theta = sinew_choose(-(1e-10 - t4 - t3), -(t2 - (s23_x
        + s23_x) * C2_x_by_theta), 0.0);
    const double s23_distance_squared = sinew_max(t4 + t3, 1e-10);
    const double s23_margin = 6.4e-05 - s23_distance_squared;
    const double t5 = 0.5 * s23_distance_squared_by_theta * sinew_choose(-(1e-10 + s23_margin), 1.0,
        0.0);
    const double s23_length = sinew_sqrt(sinew_max(-s23_margin, 1e-10));
    const double s23_length_by_theta = t5 / s23_length;
    const double s23_u_by_theta = 0.008 * C2_y_by_theta - s23_x * s23_length_by_theta - s23_length
        * C2_x_by_theta;
    const double s23_u = 0.008 * C2_y + s23_x * s23_length;
    const double t6 = 1.0 / s23_distance_squared;
    const double s23_along_x = s23_u * t6;
    const double s23_along_x_by_theta = (s23_u_by_theta + s23_along_x
        * s23_distance_squared_by_theta) * t6;
    const double t7 = C2_x * C2_x;
    const double s12_distance_squared_by_theta = sinew_choose(-(1e-10 - t7 - t4), -((C2_x + C2_x)
        * C2_x_by_theta + t2), 0.0);
    const double s12_distance_squared = sinew_max(t7 + t4, 1e-10);
    const double s12_margin = 8.1e-05 - s12_distance_squared;
    const double t8 = 0.5 * s12_distance_squared_by_theta * sinew_choose(-(1e-10 + s12_margin), 1.0,
        0.0);
    const double s12_length = sinew_sqrt(sinew_max(-s12_margin, 1e-10));
    const double s12_length_by_theta = t8 / s12_length;
    const double s12_u_by_theta = 0.009 * C2_y_by_theta - C2_x * s12_length_by_theta + s12_length
        * C2_x_by_theta;
    const double s12_u = 0.009 * C2_y + C2_x * s12_length;
    const double t9 = 1.0 / s12_distance_squared;
    const double s12_along_x = s12_u * t9;
    const double s12_along_x_by_theta = (s12_u_by_theta + s12_along_x
        * s12_distance_squared_by_theta) * t9;
    const double s23_v = 0.008 * s23_x - C2_y * s23_length;
    const double s23_along_y = s23_v * t6;
    const double s12_v = 0.009 * C2_x - C2_y * s12_length;
    const double s12_along_y = s12_v * t9;
    const double t10 = s12_along_y + s23_along_y;
    const double s23_v_by_theta = 0.008 * C2_x_by_theta - C2_y * s23_length_by_theta + s23_length
        * C2_y_by_theta;
    const double s23_along_y_by_theta = (s23_v_by_theta - s23_along_y
        * s23_distance_squared_by_theta) * t6;
    const double s12_v_by_theta = 0.009 * C2_x_by_theta + C2_y * s12_length_by_theta - s12_length
        * C2_y_by_theta;
    const double s12_along_y_by_theta = (s12_v_by_theta + s12_along_y
        * s12_distance_squared_by_theta) * t9;
    const double t11 = s12_along_x - s23_along_x;
    const double dL_slope_by_theta = C2_x_by_theta * (s12_along_x_by_theta - s23_along_x_by_theta
        - t10) + C2_y_by_theta * (s23_along_y_by_theta - s12_along_y_by_theta - t11);
    const double dL_slope = C2_y_by_theta * t10 - C2_x_by_theta * t11;
    const double dL_safe_slope_by_theta = sinew_choose(dL_slope, dL_slope_by_theta
        * sinew_choose(-(1.4e-08 - dL_slope), 1.0, 0.0), dL_slope_by_theta * sinew_choose(-(1.4e-08
        + dL_slope), 1.0, 0.0));
    const double dL_safe_slope = sinew_choose(dL_slope, sinew_max(dL_slope, 1.4e-08),
        sinew_min(dL_slope, -1.4e-08));
    const double t12 = 1.0 / dL_safe_slope;
    const double spring_y = 0.00964181414529809 * sin_theta + 0.01149066664678467 * cos_theta;
    const double spring_x = 0.00964181414529809 * cos_theta - 0.01149066664678467 * sin_theta;
    const double spring_length_squared = 0.000769 - 0.024 * spring_y + 0.04 * spring_x;
    const double spring_length = sinew_sqrt(spring_length_squared);
    const double t13 = 1.0 / spring_length;
    const double spring_strain = 1.0 - 0.018138347076759653 * t13;
    const double t14 = 6400.0 * spring_strain;
    const double spring_moment = 0.012 * spring_x + 0.02 * spring_y;
    const double energy_slope = t14 * spring_moment;
    const double force = energy_slope * t12;
    const double spring_length_by_theta = spring_moment * t13;
    const double spring_strain_by_theta = 0.018138347076759653 * spring_length_by_theta
        / (spring_length * spring_length);
    const double spring_moment_by_theta = 0.012 * spring_y - 0.02 * spring_x;
    const double energy_slope_by_theta = t14 * spring_moment_by_theta + 6400.0 * spring_moment
        * spring_strain_by_theta;
    const double force_by_theta = (energy_slope_by_theta + force * dL_safe_slope_by_theta) * t12;
    const double s23_angle = sinew_one_atan2(-s23_v, s23_u);
    const double s12_angle = sinew_one_atan2(s12_v, s12_u);
    const double dL = s12_length + s23_length - 0.008 * s23_angle + 0.009 * s12_angle;
    out[0] = dL;
    out[1] = 0.04541547683053999 - dL;
    out[2] = force;
    out[3] = force_by_theta * t12;
}

void lever_slope(double theta, double out[SINEW_AT_LEAST(2)])
{
    const struct sinew_sines sines1 = sinew_one_sincos(theta);
    const double sin_theta = sines1.s[0];
    const double cos_theta = sines1.c[0];
    const double t2 = 0.014 * cos_theta;
    const double C2_x = 0.005 + t2;
    const double s23_x = 0.034 - C2_x;
    const double t3 = 0.014 * sin_theta;
    const double C2_y = 0.005 - t3;
    const double t4 = C2_y * C2_y;
    const double s23_distance_squared = sinew_max(t4 + s23_x * s23_x, 1e-10);
    const double s23_margin = 6.4e-05 - s23_distance_squared;
    const double s23_length = sinew_sqrt(sinew_max(-s23_margin, 1e-10));
    const double s23_v = 0.008 * s23_x - C2_y * s23_length;
    const double t5 = 1.0 / s23_distance_squared;
    const double s23_along_y = s23_v * t5;
    const double s12_distance_squared = sinew_max(C2_x * C2_x + t4, 1e-10);
    const double s12_margin = 8.1e-05 - s12_distance_squared;
    const double s12_length = sinew_sqrt(sinew_max(-s12_margin, 1e-10));
    const double s12_v = 0.009 * C2_x - C2_y * s12_length;
    const double t6 = 1.0 / s12_distance_squared;
    const double s12_along_y = s12_v * t6;
    const double s23_u = 0.008 * C2_y + s23_x * s23_length;
    const double s23_along_x = s23_u * t5;
    const double s12_u = 0.009 * C2_y + C2_x * s12_length;
    const double s12_along_x = s12_u * t6;
    const double dL_slope = t2 * (s12_along_y + s23_along_y) - t3 * (s12_along_x - s23_along_x);
    const double spring_y = 0.00964181414529809 * sin_theta + 0.01149066664678467 * cos_theta;
    const double spring_x = 0.00964181414529809 * cos_theta - 0.01149066664678467 * sin_theta;
    const double spring_length_squared = 0.000769 - 0.024 * spring_y + 0.04 * spring_x;
    const double spring_length = sinew_sqrt(spring_length_squared);
    const double spring_strain = 1.0 - 0.018138347076759653 / spring_length;
    const double spring_moment = 0.012 * spring_x + 0.02 * spring_y;
    const double energy_slope = 6400.0 * spring_strain * spring_moment;
    out[0] = dL_slope;
    out[1] = -energy_slope;
}

void lever_angle(double elongation, double theta, double theta_lever[SINEW_AT_LEAST(1)],
    double residual[SINEW_AT_LEAST(1)])
{
    const double theta_start = sinew_min(sinew_max(theta, 0.09548248781986068), 0.8377580409572781);
    const struct sinew_sines sines1 = sinew_one_sincos(theta_start);
    const double sin_theta = sines1.s[0];
    const double cos_theta = sines1.c[0];
    const double t2 = 0.014 * cos_theta;
    const double C2_x = 0.005 + t2;
    const double s23_x = 0.034 - C2_x;
    const double t3 = 0.014 * sin_theta;
    const double C2_y = 0.005 - t3;
    const double t4 = C2_y * C2_y;
    const double s23_distance_squared = sinew_max(t4 + s23_x * s23_x, 1e-10);
    const double s23_margin = 6.4e-05 - s23_distance_squared;
    const double s23_length = sinew_sqrt(sinew_max(-s23_margin, 1e-10));
    const double s23_v = 0.008 * s23_x - C2_y * s23_length;
    const double t5 = 1.0 / s23_distance_squared;
    const double s23_along_y = s23_v * t5;
    const double s12_distance_squared = sinew_max(C2_x * C2_x + t4, 1e-10);
    const double s12_margin = 8.1e-05 - s12_distance_squared;
    const double s12_length = sinew_sqrt(sinew_max(-s12_margin, 1e-10));
    const double s12_v = 0.009 * C2_x - C2_y * s12_length;
    const double t6 = 1.0 / s12_distance_squared;
    const double s12_along_y = s12_v * t6;
    const double s23_u = 0.008 * C2_y + s23_x * s23_length;
    const double s23_along_x = s23_u * t5;
    const double s12_u = 0.009 * C2_y + C2_x * s12_length;
    const double s12_along_x = s12_u * t6;
    const double dL_slope = t2 * (s12_along_y + s23_along_y) - t3 * (s12_along_x - s23_along_x);
    const double dL_safe_slope = sinew_choose(dL_slope, sinew_max(dL_slope, 1.4e-08),
        sinew_min(dL_slope, -1.4e-08));
    const double s23_angle = sinew_one_atan2(-s23_v, s23_u);
    const double limited_elongation = sinew_min(sinew_max(elongation, -1.0), 1.0);
    const double dL_target = 0.04541547683053999 - limited_elongation;
    const double s12_angle = sinew_one_atan2(s12_v, s12_u);
    const double t7 = dL_target - s12_length - s23_length + 0.008 * s23_angle - 0.009 * s12_angle;
    const double theta_next = theta_start + t7 / dL_safe_slope;
    const double theta_limited = sinew_min(sinew_max(theta_next, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines8 = sinew_one_sincos(theta_limited);
    const double sin_theta_2 = sines8.s[0];
    const double cos_theta_2 = sines8.c[0];
    const double t9 = 0.014 * cos_theta_2;
    const double C2_x_2 = 0.005 + t9;
    const double s23_x_2 = 0.034 - C2_x_2;
    const double t10 = 0.014 * sin_theta_2;
    const double C2_y_2 = 0.005 - t10;
    const double t11 = C2_y_2 * C2_y_2;
    const double s23_distance_squared_2 = sinew_max(t11 + s23_x_2 * s23_x_2, 1e-10);
    const double s23_margin_2 = 6.4e-05 - s23_distance_squared_2;
    const double s23_length_2 = sinew_sqrt(sinew_max(-s23_margin_2, 1e-10));
    const double s23_v_2 = 0.008 * s23_x_2 - C2_y_2 * s23_length_2;
    const double t12 = 1.0 / s23_distance_squared_2;
    const double s23_along_y_2 = s23_v_2 * t12;
    const double s12_distance_squared_2 = sinew_max(C2_x_2 * C2_x_2 + t11, 1e-10);
    const double s12_margin_2 = 8.1e-05 - s12_distance_squared_2;
    const double s12_length_2 = sinew_sqrt(sinew_max(-s12_margin_2, 1e-10));
    const double s12_v_2 = 0.009 * C2_x_2 - C2_y_2 * s12_length_2;
    const double t13 = 1.0 / s12_distance_squared_2;
    const double s12_along_y_2 = s12_v_2 * t13;
    const double s23_u_2 = 0.008 * C2_y_2 + s23_x_2 * s23_length_2;
    const double s23_along_x_2 = s23_u_2 * t12;
    const double s12_u_2 = 0.009 * C2_y_2 + C2_x_2 * s12_length_2;
    const double s12_along_x_2 = s12_u_2 * t13;
    const double dL_slope_2 = t9 * (s12_along_y_2 + s23_along_y_2) - t10 * (s12_along_x_2
        - s23_along_x_2);
    const double dL_safe_slope_2 = sinew_choose(dL_slope_2, sinew_max(dL_slope_2, 1.4e-08),
        sinew_min(dL_slope_2, -1.4e-08));
    const double s23_angle_2 = sinew_one_atan2(-s23_v_2, s23_u_2);
    const double s12_angle_2 = sinew_one_atan2(s12_v_2, s12_u_2);
    const double t14 = dL_target - s12_length_2 - s23_length_2 + 0.008 * s23_angle_2 - 0.009
        * s12_angle_2;
    const double theta_next_2 = theta_limited + t14 / dL_safe_slope_2;
    const double theta_limited_2 = sinew_min(sinew_max(theta_next_2, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines15 = sinew_one_sincos(theta_limited_2);
    const double sin_theta_4 = sines15.s[0];
    const double cos_theta_4 = sines15.c[0];
    const double t16 = 0.014 * cos_theta_4;
    const double C2_x_4 = 0.005 + t16;
    const double t17 = 0.014 * sin_theta_4;
    const double C2_y_4 = 0.005 - t17;
    const double t18 = C2_y_4 * C2_y_4;
    const double s12_distance_squared_4 = sinew_max(C2_x_4 * C2_x_4 + t18, 1e-10);
    const double s12_margin_4 = 8.1e-05 - s12_distance_squared_4;
    const double s12_length_4 = sinew_sqrt(sinew_max(-s12_margin_4, 1e-10));
    const double s23_x_4 = 0.034 - C2_x_4;
    const double s23_distance_squared_4 = sinew_max(t18 + s23_x_4 * s23_x_4, 1e-10);
    const double s23_margin_4 = 6.4e-05 - s23_distance_squared_4;
    const double s23_length_4 = sinew_sqrt(sinew_max(-s23_margin_4, 1e-10));
    const double s23_v_4 = 0.008 * s23_x_4 - C2_y_4 * s23_length_4;
    const double s23_u_4 = 0.008 * C2_y_4 + s23_x_4 * s23_length_4;
    const double s23_angle_4 = sinew_one_atan2(-s23_v_4, s23_u_4);
    const double s12_v_4 = 0.009 * C2_x_4 - C2_y_4 * s12_length_4;
    const double s12_u_4 = 0.009 * C2_y_4 + C2_x_4 * s12_length_4;
    const double s12_angle_4 = sinew_one_atan2(s12_v_4, s12_u_4);
    const double t19 = dL_target - s12_length_4 - s23_length_4 + 0.008 * s23_angle_4 - 0.009
        * s12_angle_4;
    const double t20 = 1.0 / s12_distance_squared_4;
    const double s12_along_y_4 = s12_v_4 * t20;
    const double t21 = 1.0 / s23_distance_squared_4;
    const double s23_along_y_4 = s23_v_4 * t21;
    const double s12_along_x_4 = s12_u_4 * t20;
    const double s23_along_x_4 = s23_u_4 * t21;
    const double dL_slope_4 = t16 * (s12_along_y_4 + s23_along_y_4) - t17 * (s12_along_x_4
        - s23_along_x_4);
    const double dL_safe_slope_4 = sinew_choose(dL_slope_4, sinew_max(dL_slope_4, 1.4e-08),
        sinew_min(dL_slope_4, -1.4e-08));
    const double theta_next_4 = theta_limited_2 + t19 / dL_safe_slope_4;
    const double theta_limited_4 = sinew_min(sinew_max(theta_next_4, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines22 = sinew_one_sincos(theta_limited_4);
    const double sin_theta_6 = sines22.s[0];
    const double cos_theta_6 = sines22.c[0];
    const double t23 = 0.014 * cos_theta_6;
    const double C2_x_6 = 0.005 + t23;
    const double t24 = 0.014 * sin_theta_6;
    const double C2_y_6 = 0.005 - t24;
    const double t25 = C2_y_6 * C2_y_6;
    const double s12_distance_squared_6 = sinew_max(C2_x_6 * C2_x_6 + t25, 1e-10);
    const double s12_margin_6 = 8.1e-05 - s12_distance_squared_6;
    const double s12_length_6 = sinew_sqrt(sinew_max(-s12_margin_6, 1e-10));
    const double s23_x_6 = 0.034 - C2_x_6;
    const double s23_distance_squared_6 = sinew_max(t25 + s23_x_6 * s23_x_6, 1e-10);
    const double s23_margin_6 = 6.4e-05 - s23_distance_squared_6;
    const double s23_length_6 = sinew_sqrt(sinew_max(-s23_margin_6, 1e-10));
    const double s23_v_6 = 0.008 * s23_x_6 - C2_y_6 * s23_length_6;
    const double s23_u_6 = 0.008 * C2_y_6 + s23_x_6 * s23_length_6;
    const double s23_angle_6 = sinew_one_atan2(-s23_v_6, s23_u_6);
    const double s12_v_6 = 0.009 * C2_x_6 - C2_y_6 * s12_length_6;
    const double s12_u_6 = 0.009 * C2_y_6 + C2_x_6 * s12_length_6;
    const double s12_angle_6 = sinew_one_atan2(s12_v_6, s12_u_6);
    const double t26 = dL_target - s12_length_6 - s23_length_6 + 0.008 * s23_angle_6 - 0.009
        * s12_angle_6;
    const double t27 = 1.0 / s12_distance_squared_6;
    const double s12_along_y_6 = s12_v_6 * t27;
    const double t28 = 1.0 / s23_distance_squared_6;
    const double s23_along_y_6 = s23_v_6 * t28;
    const double s12_along_x_6 = s12_u_6 * t27;
    const double s23_along_x_6 = s23_u_6 * t28;
    const double dL_slope_6 = t23 * (s12_along_y_6 + s23_along_y_6) - t24 * (s12_along_x_6
        - s23_along_x_6);
    const double dL_safe_slope_6 = sinew_choose(dL_slope_6, sinew_max(dL_slope_6, 1.4e-08),
        sinew_min(dL_slope_6, -1.4e-08));
    const double theta_next_6 = theta_limited_4 + t26 / dL_safe_slope_6;
    const double theta_limited_6 = sinew_min(sinew_max(theta_next_6, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines29 = sinew_one_sincos(theta_limited_6);
    const double sin_theta_8 = sines29.s[0];
    const double cos_theta_8 = sines29.c[0];
    const double t30 = 0.014 * cos_theta_8;
    const double C2_x_8 = 0.005 + t30;
    const double t31 = 0.014 * sin_theta_8;
    const double C2_y_8 = 0.005 - t31;
    const double t32 = C2_y_8 * C2_y_8;
    const double s12_distance_squared_8 = sinew_max(C2_x_8 * C2_x_8 + t32, 1e-10);
    const double s12_margin_8 = 8.1e-05 - s12_distance_squared_8;
    const double s12_length_8 = sinew_sqrt(sinew_max(-s12_margin_8, 1e-10));
    const double s23_x_8 = 0.034 - C2_x_8;
    const double s23_distance_squared_8 = sinew_max(t32 + s23_x_8 * s23_x_8, 1e-10);
    const double s23_margin_8 = 6.4e-05 - s23_distance_squared_8;
    const double s23_length_8 = sinew_sqrt(sinew_max(-s23_margin_8, 1e-10));
    const double s23_v_8 = 0.008 * s23_x_8 - C2_y_8 * s23_length_8;
    const double s23_u_8 = 0.008 * C2_y_8 + s23_x_8 * s23_length_8;
    const double s23_angle_8 = sinew_one_atan2(-s23_v_8, s23_u_8);
    const double s12_v_8 = 0.009 * C2_x_8 - C2_y_8 * s12_length_8;
    const double s12_u_8 = 0.009 * C2_y_8 + C2_x_8 * s12_length_8;
    const double s12_angle_8 = sinew_one_atan2(s12_v_8, s12_u_8);
    const double t33 = dL_target - s12_length_8 - s23_length_8 + 0.008 * s23_angle_8 - 0.009
        * s12_angle_8;
    const double t34 = 1.0 / s12_distance_squared_8;
    const double s12_along_y_8 = s12_v_8 * t34;
    const double t35 = 1.0 / s23_distance_squared_8;
    const double s23_along_y_8 = s23_v_8 * t35;
    const double s12_along_x_8 = s12_u_8 * t34;
    const double s23_along_x_8 = s23_u_8 * t35;
    const double dL_slope_8 = t30 * (s12_along_y_8 + s23_along_y_8) - t31 * (s12_along_x_8
        - s23_along_x_8);
    const double dL_safe_slope_8 = sinew_choose(dL_slope_8, sinew_max(dL_slope_8, 1.4e-08),
        sinew_min(dL_slope_8, -1.4e-08));
    const double theta_next_8 = theta_limited_6 + t33 / dL_safe_slope_8;
    const double theta_limited_8 = sinew_min(sinew_max(theta_next_8, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines36 = sinew_one_sincos(theta_limited_8);
    const double sin_theta_10 = sines36.s[0];
    const double cos_theta_10 = sines36.c[0];
    const double C2_x_10 = 0.005 + 0.014 * cos_theta_10;
    const double C2_y_10 = 0.005 - 0.014 * sin_theta_10;
    const double t37 = C2_y_10 * C2_y_10;
    const double s12_distance_squared_10 = sinew_max(C2_x_10 * C2_x_10 + t37, 1e-10);
    const double s12_margin_10 = 8.1e-05 - s12_distance_squared_10;
    const double s12_length_10 = sinew_sqrt(sinew_max(-s12_margin_10, 1e-10));
    const double s23_x_10 = 0.034 - C2_x_10;
    const double s23_distance_squared_10 = sinew_max(t37 + s23_x_10 * s23_x_10, 1e-10);
    const double s23_margin_10 = 6.4e-05 - s23_distance_squared_10;
    const double s23_length_10 = sinew_sqrt(sinew_max(-s23_margin_10, 1e-10));
    const double s23_v_10 = 0.008 * s23_x_10 - C2_y_10 * s23_length_10;
    const double s23_u_10 = 0.008 * C2_y_10 + s23_x_10 * s23_length_10;
    const double s23_angle_10 = sinew_one_atan2(-s23_v_10, s23_u_10);
    const double s12_v_10 = 0.009 * C2_x_10 - C2_y_10 * s12_length_10;
    const double s12_u_10 = 0.009 * C2_y_10 + C2_x_10 * s12_length_10;
    const double s12_angle_10 = sinew_one_atan2(s12_v_10, s12_u_10);
    const double t38 = dL_target - s12_length_10 - s23_length_10 + 0.008 * s23_angle_10 - 0.009
        * s12_angle_10;
    theta_lever[0] = theta_limited_8;
    residual[0] = t38;
}

void lever_status(double theta, int *status)
{
    const struct sinew_sines sines1 = sinew_one_sincos(theta);
    const double sin_theta = sines1.s[0];
    const double cos_theta = sines1.c[0];
    const double t2 = 0.014 * cos_theta;
    const double C2_x = 0.005 + t2;
    const double s23_x = 0.034 - C2_x;
    const double t3 = 0.014 * sin_theta;
    const double C2_y = 0.005 - t3;
    const double t4 = C2_y * C2_y;
    const double s23_distance_squared = sinew_max(t4 + s23_x * s23_x, 1e-10);
    const double s23_margin = 6.4e-05 - s23_distance_squared;
    const double t5 = -s23_margin;
    const double s23_length = sinew_sqrt(sinew_max(t5, 1e-10));
    const double s23_v = 0.008 * s23_x - C2_y * s23_length;
    const double t6 = 1.0 / s23_distance_squared;
    const double s23_along_y = s23_v * t6;
    const double s12_distance_squared = sinew_max(C2_x * C2_x + t4, 1e-10);
    const double s12_margin = 8.1e-05 - s12_distance_squared;
    const double t7 = -s12_margin;
    const double s12_length = sinew_sqrt(sinew_max(t7, 1e-10));
    const double s12_v = 0.009 * C2_x - C2_y * s12_length;
    const double t8 = 1.0 / s12_distance_squared;
    const double s12_along_y = s12_v * t8;
    const double s23_u = 0.008 * C2_y + s23_x * s23_length;
    const double s23_along_x = s23_u * t6;
    const double s12_u = 0.009 * C2_y + C2_x * s12_length;
    const double s12_along_x = s12_u * t8;
    const double dL_slope = t2 * (s12_along_y + s23_along_y) - t3 * (s12_along_x - s23_along_x);
    const double t9 = sinew_choose(-(1.4e-08 - sinew_max(dL_slope, -dL_slope)),
        sinew_choose(sinew_min(t7, t5), 0.0, 1.0), 1.0);
    const double t10 = theta - sinew_min(sinew_max(theta, 0.09548248781986068), 0.8377580409572781);
    *status = (int)sinew_choose(-sinew_max(t10, -t10), t9, 1.0);
}
