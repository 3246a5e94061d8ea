/* SPDX-License-Identifier: BSD-2-Clause
 *
 * One tendon in series with its lever
 *
 * Made by: sinew generate models/tendon
 * Model:   sha256 9fa49807a7e8a052fcdd9aca09d5e31e41ada5f891672ef877029e3417b31747
 * Do not edit: change the model and generate again.
 */
#include "tendon.h"

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

void tendon_series_stiffness(double k_lever, double k[SINEW_AT_LEAST(1)])
{
    const double t1 = sinew_min(sinew_max(k_lever, 0.0), 1e+12);
    k[0] = 20000.0 * t1 / (20000.0 + t1);
}

void tendon_force(double elongation, double theta, double out[SINEW_AT_LEAST(3)],
    double residual[SINEW_AT_LEAST(1)])
{
    const double theta_start = sinew_min(sinew_max(theta, 0.09548248781986068), 0.8377580409572781);
    const struct sinew_sines sines1 = sinew_one_sincos(theta_start);
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
    const double elongation_slope = dL_safe_slope + 5e-05 * force_by_theta;
    const double s23_angle = sinew_one_atan2(-s23_v, s23_u);
    const double limited_elongation = sinew_min(sinew_max(elongation, -1.0), 1.0);
    const double t15 = limited_elongation - 0.04541547683053999;
    const double s12_angle = sinew_one_atan2(s12_v, s12_u);
    const double t16 = t15 + s12_length + s23_length - 0.008 * s23_angle + 0.009 * s12_angle - 5e-05
        * force;
    const double theta_next = theta_start - t16 / elongation_slope;
    const double theta_limited = sinew_min(sinew_max(theta_next, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines17 = sinew_one_sincos(theta_limited);
    const double sin_theta_2 = sines17.s[0];
    const double cos_theta_2 = sines17.c[0];
    const double C2_y_2_by_theta = 0.014 * cos_theta_2;
    const double C2_x_2 = 0.005 + C2_y_2_by_theta;
    const double s23_x_2 = 0.034 - C2_x_2;
    const double t18 = s23_x_2 * s23_x_2;
    const double C2_x_2_by_theta = 0.014 * sin_theta_2;
    const double C2_y_2 = 0.005 - C2_x_2_by_theta;
    const double t19 = C2_y_2 * C2_y_2;
    const double s23_distance_squared_2 = sinew_max(t19 + t18, 1e-10);
    const double s23_margin_2 = 6.4e-05 - s23_distance_squared_2;
    const double s23_length_2 = sinew_sqrt(sinew_max(-s23_margin_2, 1e-10));
    const double s23_v_2 = 0.008 * s23_x_2 - C2_y_2 * s23_length_2;
    const double t20 = 1.0 / s23_distance_squared_2;
    const double s23_along_y_2 = s23_v_2 * t20;
    const double t21 = C2_x_2 * C2_x_2;
    const double s12_distance_squared_2 = sinew_max(t21 + t19, 1e-10);
    const double s12_margin_2 = 8.1e-05 - s12_distance_squared_2;
    const double s12_length_2 = sinew_sqrt(sinew_max(-s12_margin_2, 1e-10));
    const double s12_v_2 = 0.009 * C2_x_2 - C2_y_2 * s12_length_2;
    const double t22 = 1.0 / s12_distance_squared_2;
    const double s12_along_y_2 = s12_v_2 * t22;
    const double t23 = s12_along_y_2 + s23_along_y_2;
    const double s23_u_2 = 0.008 * C2_y_2 + s23_x_2 * s23_length_2;
    const double s23_along_x_2 = s23_u_2 * t20;
    const double s12_u_2 = 0.009 * C2_y_2 + C2_x_2 * s12_length_2;
    const double s12_along_x_2 = s12_u_2 * t22;
    const double t24 = s12_along_x_2 - s23_along_x_2;
    const double dL_slope_2 = C2_y_2_by_theta * t23 - C2_x_2_by_theta * t24;
    const double dL_safe_slope_2 = sinew_choose(dL_slope_2, sinew_max(dL_slope_2, 1.4e-08),
        sinew_min(dL_slope_2, -1.4e-08));
    const double t25 = 1.0 / dL_safe_slope_2;
    const double spring_y_2 = 0.00964181414529809 * sin_theta_2 + 0.01149066664678467 * cos_theta_2;
    const double spring_x_2 = 0.00964181414529809 * cos_theta_2 - 0.01149066664678467 * sin_theta_2;
    const double spring_length_squared_2 = 0.000769 - 0.024 * spring_y_2 + 0.04 * spring_x_2;
    const double spring_length_2 = sinew_sqrt(spring_length_squared_2);
    const double t26 = 1.0 / spring_length_2;
    const double spring_strain_2 = 1.0 - 0.018138347076759653 * t26;
    const double t27 = 6400.0 * spring_strain_2;
    const double spring_moment_2 = 0.012 * spring_x_2 + 0.02 * spring_y_2;
    const double energy_slope_2 = t27 * spring_moment_2;
    const double force_2 = energy_slope_2 * t25;
    const double s23_angle_2 = sinew_one_atan2(-s23_v_2, s23_u_2);
    const double s12_angle_2 = sinew_one_atan2(s12_v_2, s12_u_2);
    const double t28 = t15 + s12_length_2 + s23_length_2 - 0.008 * s23_angle_2 + 0.009
        * s12_angle_2;
    const double t29 = (C2_y_2 + C2_y_2) * C2_y_2_by_theta;
    const double s23_distance_squared_2_by_theta = sinew_choose(-(1e-10 - t19 - t18), -(t29
        - (s23_x_2 + s23_x_2) * C2_x_2_by_theta), 0.0);
    const double t30 = 0.5 * s23_distance_squared_2_by_theta * sinew_choose(-(1e-10 + s23_margin_2),
        1.0, 0.0);
    const double s23_length_2_by_theta = t30 / s23_length_2;
    const double s23_u_2_by_theta = 0.008 * C2_y_2_by_theta - s23_x_2 * s23_length_2_by_theta
        - s23_length_2 * C2_x_2_by_theta;
    const double s23_along_x_2_by_theta = (s23_u_2_by_theta + s23_along_x_2
        * s23_distance_squared_2_by_theta) * t20;
    const double s12_distance_squared_2_by_theta = sinew_choose(-(1e-10 - t21 - t19), -((C2_x_2
        + C2_x_2) * C2_x_2_by_theta + t29), 0.0);
    const double t31 = 0.5 * s12_distance_squared_2_by_theta * sinew_choose(-(1e-10 + s12_margin_2),
        1.0, 0.0);
    const double s12_length_2_by_theta = t31 / s12_length_2;
    const double s12_u_2_by_theta = 0.009 * C2_y_2_by_theta - C2_x_2 * s12_length_2_by_theta
        + s12_length_2 * C2_x_2_by_theta;
    const double s12_along_x_2_by_theta = (s12_u_2_by_theta + s12_along_x_2
        * s12_distance_squared_2_by_theta) * t22;
    const double t32 = C2_x_2_by_theta * (s12_along_x_2_by_theta - s23_along_x_2_by_theta - t23);
    const double s23_v_2_by_theta = 0.008 * C2_x_2_by_theta - C2_y_2 * s23_length_2_by_theta
        + s23_length_2 * C2_y_2_by_theta;
    const double s23_along_y_2_by_theta = (s23_v_2_by_theta - s23_along_y_2
        * s23_distance_squared_2_by_theta) * t20;
    const double s12_v_2_by_theta = 0.009 * C2_x_2_by_theta + C2_y_2 * s12_length_2_by_theta
        - s12_length_2 * C2_y_2_by_theta;
    const double s12_along_y_2_by_theta = (s12_v_2_by_theta + s12_along_y_2
        * s12_distance_squared_2_by_theta) * t22;
    const double t33 = C2_y_2_by_theta * (s23_along_y_2_by_theta - s12_along_y_2_by_theta - t24);
    const double dL_slope_2_by_theta = t32 + t33;
    const double dL_safe_slope_2_by_theta = sinew_choose(dL_slope_2, dL_slope_2_by_theta
        * sinew_choose(-(1.4e-08 - dL_slope_2), 1.0, 0.0), dL_slope_2_by_theta
        * sinew_choose(-(1.4e-08 + dL_slope_2), 1.0, 0.0));
    const double spring_length_2_by_theta = spring_moment_2 * t26;
    const double spring_strain_2_by_theta = 0.018138347076759653 * spring_length_2_by_theta
        / (spring_length_2 * spring_length_2);
    const double spring_moment_2_by_theta = 0.012 * spring_y_2 - 0.02 * spring_x_2;
    const double energy_slope_2_by_theta = t27 * spring_moment_2_by_theta + 6400.0 * spring_moment_2
        * spring_strain_2_by_theta;
    const double force_2_by_theta = (energy_slope_2_by_theta + force_2 * dL_safe_slope_2_by_theta)
        * t25;
    const double elongation_slope_2 = dL_safe_slope_2 + 5e-05 * force_2_by_theta;
    const double theta_next_2 = theta_limited - (t28 - 5e-05 * force_2) / elongation_slope_2;
    const double theta_limited_2 = sinew_min(sinew_max(theta_next_2, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines34 = sinew_one_sincos(theta_limited_2);
    const double sin_theta_4 = sines34.s[0];
    const double cos_theta_4 = sines34.c[0];
    const double C2_y_4_by_theta = 0.014 * cos_theta_4;
    const double C2_x_4 = 0.005 + C2_y_4_by_theta;
    const double t35 = C2_x_4 * C2_x_4;
    const double C2_x_4_by_theta = 0.014 * sin_theta_4;
    const double C2_y_4 = 0.005 - C2_x_4_by_theta;
    const double t36 = C2_y_4 * C2_y_4;
    const double s12_distance_squared_4 = sinew_max(t35 + t36, 1e-10);
    const double s12_margin_4 = 8.1e-05 - s12_distance_squared_4;
    const double s12_length_4 = sinew_sqrt(sinew_max(-s12_margin_4, 1e-10));
    const double s23_x_4 = 0.034 - C2_x_4;
    const double t37 = s23_x_4 * s23_x_4;
    const double s23_distance_squared_4 = sinew_max(t36 + t37, 1e-10);
    const double s23_margin_4 = 6.4e-05 - s23_distance_squared_4;
    const double s23_length_4 = sinew_sqrt(sinew_max(-s23_margin_4, 1e-10));
    const double s23_v_4 = 0.008 * s23_x_4 - C2_y_4 * s23_length_4;
    const double s23_u_4 = 0.008 * C2_y_4 + s23_x_4 * s23_length_4;
    const double s23_angle_4 = sinew_one_atan2(-s23_v_4, s23_u_4);
    const double s12_v_4 = 0.009 * C2_x_4 - C2_y_4 * s12_length_4;
    const double s12_u_4 = 0.009 * C2_y_4 + C2_x_4 * s12_length_4;
    const double s12_angle_4 = sinew_one_atan2(s12_v_4, s12_u_4);
    const double t38 = t15 + s12_length_4 + s23_length_4 - 0.008 * s23_angle_4 + 0.009
        * s12_angle_4;
    const double spring_y_4 = 0.00964181414529809 * sin_theta_4 + 0.01149066664678467 * cos_theta_4;
    const double spring_x_4 = 0.00964181414529809 * cos_theta_4 - 0.01149066664678467 * sin_theta_4;
    const double spring_length_squared_4 = 0.000769 - 0.024 * spring_y_4 + 0.04 * spring_x_4;
    const double spring_length_4 = sinew_sqrt(spring_length_squared_4);
    const double t39 = 1.0 / spring_length_4;
    const double spring_strain_4 = 1.0 - 0.018138347076759653 * t39;
    const double t40 = 6400.0 * spring_strain_4;
    const double spring_moment_4 = 0.012 * spring_x_4 + 0.02 * spring_y_4;
    const double energy_slope_4 = t40 * spring_moment_4;
    const double t41 = 1.0 / s12_distance_squared_4;
    const double s12_along_y_4 = s12_v_4 * t41;
    const double t42 = 1.0 / s23_distance_squared_4;
    const double s23_along_y_4 = s23_v_4 * t42;
    const double t43 = s12_along_y_4 + s23_along_y_4;
    const double s12_along_x_4 = s12_u_4 * t41;
    const double s23_along_x_4 = s23_u_4 * t42;
    const double t44 = s12_along_x_4 - s23_along_x_4;
    const double dL_slope_4 = C2_y_4_by_theta * t43 - C2_x_4_by_theta * t44;
    const double dL_safe_slope_4 = sinew_choose(dL_slope_4, sinew_max(dL_slope_4, 1.4e-08),
        sinew_min(dL_slope_4, -1.4e-08));
    const double t45 = 1.0 / dL_safe_slope_4;
    const double force_4 = energy_slope_4 * t45;
    const double spring_moment_4_by_theta = 0.012 * spring_y_4 - 0.02 * spring_x_4;
    const double spring_length_4_by_theta = spring_moment_4 * t39;
    const double spring_strain_4_by_theta = 0.018138347076759653 * spring_length_4_by_theta
        / (spring_length_4 * spring_length_4);
    const double energy_slope_4_by_theta = t40 * spring_moment_4_by_theta + 6400.0 * spring_moment_4
        * spring_strain_4_by_theta;
    const double t46 = (C2_y_4 + C2_y_4) * C2_y_4_by_theta;
    const double s12_distance_squared_4_by_theta = sinew_choose(-(1e-10 - t35 - t36), -((C2_x_4
        + C2_x_4) * C2_x_4_by_theta + t46), 0.0);
    const double t47 = 0.5 * s12_distance_squared_4_by_theta * sinew_choose(-(1e-10 + s12_margin_4),
        1.0, 0.0);
    const double s12_length_4_by_theta = t47 / s12_length_4;
    const double s12_u_4_by_theta = 0.009 * C2_y_4_by_theta - C2_x_4 * s12_length_4_by_theta
        + s12_length_4 * C2_x_4_by_theta;
    const double s12_along_x_4_by_theta = (s12_u_4_by_theta + s12_along_x_4
        * s12_distance_squared_4_by_theta) * t41;
    const double s23_distance_squared_4_by_theta = sinew_choose(-(1e-10 - t36 - t37), -(t46
        - (s23_x_4 + s23_x_4) * C2_x_4_by_theta), 0.0);
    const double t48 = 0.5 * s23_distance_squared_4_by_theta * sinew_choose(-(1e-10 + s23_margin_4),
        1.0, 0.0);
    const double s23_length_4_by_theta = t48 / s23_length_4;
    const double s23_u_4_by_theta = 0.008 * C2_y_4_by_theta - s23_x_4 * s23_length_4_by_theta
        - s23_length_4 * C2_x_4_by_theta;
    const double s23_along_x_4_by_theta = (s23_u_4_by_theta + s23_along_x_4
        * s23_distance_squared_4_by_theta) * t42;
    const double t49 = C2_x_4_by_theta * (s12_along_x_4_by_theta - s23_along_x_4_by_theta - t43);
    const double s23_v_4_by_theta = 0.008 * C2_x_4_by_theta - C2_y_4 * s23_length_4_by_theta
        + s23_length_4 * C2_y_4_by_theta;
    const double s23_along_y_4_by_theta = (s23_v_4_by_theta - s23_along_y_4
        * s23_distance_squared_4_by_theta) * t42;
    const double s12_v_4_by_theta = 0.009 * C2_x_4_by_theta + C2_y_4 * s12_length_4_by_theta
        - s12_length_4 * C2_y_4_by_theta;
    const double s12_along_y_4_by_theta = (s12_v_4_by_theta + s12_along_y_4
        * s12_distance_squared_4_by_theta) * t41;
    const double t50 = C2_y_4_by_theta * (s23_along_y_4_by_theta - s12_along_y_4_by_theta - t44);
    const double dL_slope_4_by_theta = t49 + t50;
    const double dL_safe_slope_4_by_theta = sinew_choose(dL_slope_4, dL_slope_4_by_theta
        * sinew_choose(-(1.4e-08 - dL_slope_4), 1.0, 0.0), dL_slope_4_by_theta
        * sinew_choose(-(1.4e-08 + dL_slope_4), 1.0, 0.0));
    const double force_4_by_theta = (energy_slope_4_by_theta + force_4 * dL_safe_slope_4_by_theta)
        * t45;
    const double elongation_slope_4 = dL_safe_slope_4 + 5e-05 * force_4_by_theta;
    const double theta_next_4 = theta_limited_2 - (t38 - 5e-05 * force_4) / elongation_slope_4;
    const double theta_limited_4 = sinew_min(sinew_max(theta_next_4, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines51 = sinew_one_sincos(theta_limited_4);
    const double sin_theta_6 = sines51.s[0];
    const double cos_theta_6 = sines51.c[0];
    const double C2_y_6_by_theta = 0.014 * cos_theta_6;
    const double C2_x_6 = 0.005 + C2_y_6_by_theta;
    const double t52 = C2_x_6 * C2_x_6;
    const double C2_x_6_by_theta = 0.014 * sin_theta_6;
    const double C2_y_6 = 0.005 - C2_x_6_by_theta;
    const double t53 = C2_y_6 * C2_y_6;
    const double s12_distance_squared_6 = sinew_max(t52 + t53, 1e-10);
    const double s12_margin_6 = 8.1e-05 - s12_distance_squared_6;
    const double s12_length_6 = sinew_sqrt(sinew_max(-s12_margin_6, 1e-10));
    const double s23_x_6 = 0.034 - C2_x_6;
    const double t54 = s23_x_6 * s23_x_6;
    const double s23_distance_squared_6 = sinew_max(t53 + t54, 1e-10);
    const double s23_margin_6 = 6.4e-05 - s23_distance_squared_6;
    const double s23_length_6 = sinew_sqrt(sinew_max(-s23_margin_6, 1e-10));
    const double s23_v_6 = 0.008 * s23_x_6 - C2_y_6 * s23_length_6;
    const double s23_u_6 = 0.008 * C2_y_6 + s23_x_6 * s23_length_6;
    const double s23_angle_6 = sinew_one_atan2(-s23_v_6, s23_u_6);
    const double s12_v_6 = 0.009 * C2_x_6 - C2_y_6 * s12_length_6;
    const double s12_u_6 = 0.009 * C2_y_6 + C2_x_6 * s12_length_6;
    const double s12_angle_6 = sinew_one_atan2(s12_v_6, s12_u_6);
    const double t55 = t15 + s12_length_6 + s23_length_6 - 0.008 * s23_angle_6 + 0.009
        * s12_angle_6;
    const double spring_y_6 = 0.00964181414529809 * sin_theta_6 + 0.01149066664678467 * cos_theta_6;
    const double spring_x_6 = 0.00964181414529809 * cos_theta_6 - 0.01149066664678467 * sin_theta_6;
    const double spring_length_squared_6 = 0.000769 - 0.024 * spring_y_6 + 0.04 * spring_x_6;
    const double spring_length_6 = sinew_sqrt(spring_length_squared_6);
    const double t56 = 1.0 / spring_length_6;
    const double spring_strain_6 = 1.0 - 0.018138347076759653 * t56;
    const double t57 = 6400.0 * spring_strain_6;
    const double spring_moment_6 = 0.012 * spring_x_6 + 0.02 * spring_y_6;
    const double energy_slope_6 = t57 * spring_moment_6;
    const double t58 = 1.0 / s12_distance_squared_6;
    const double s12_along_y_6 = s12_v_6 * t58;
    const double t59 = 1.0 / s23_distance_squared_6;
    const double s23_along_y_6 = s23_v_6 * t59;
    const double t60 = s12_along_y_6 + s23_along_y_6;
    const double s12_along_x_6 = s12_u_6 * t58;
    const double s23_along_x_6 = s23_u_6 * t59;
    const double t61 = s12_along_x_6 - s23_along_x_6;
    const double dL_slope_6 = C2_y_6_by_theta * t60 - C2_x_6_by_theta * t61;
    const double dL_safe_slope_6 = sinew_choose(dL_slope_6, sinew_max(dL_slope_6, 1.4e-08),
        sinew_min(dL_slope_6, -1.4e-08));
    const double t62 = 1.0 / dL_safe_slope_6;
    const double force_6 = energy_slope_6 * t62;
    const double spring_moment_6_by_theta = 0.012 * spring_y_6 - 0.02 * spring_x_6;
    const double spring_length_6_by_theta = spring_moment_6 * t56;
    const double spring_strain_6_by_theta = 0.018138347076759653 * spring_length_6_by_theta
        / (spring_length_6 * spring_length_6);
    const double energy_slope_6_by_theta = t57 * spring_moment_6_by_theta + 6400.0 * spring_moment_6
        * spring_strain_6_by_theta;
    const double t63 = (C2_y_6 + C2_y_6) * C2_y_6_by_theta;
    const double s12_distance_squared_6_by_theta = sinew_choose(-(1e-10 - t52 - t53), -((C2_x_6
        + C2_x_6) * C2_x_6_by_theta + t63), 0.0);
    const double t64 = 0.5 * s12_distance_squared_6_by_theta * sinew_choose(-(1e-10 + s12_margin_6),
        1.0, 0.0);
    const double s12_length_6_by_theta = t64 / s12_length_6;
    const double s12_u_6_by_theta = 0.009 * C2_y_6_by_theta - C2_x_6 * s12_length_6_by_theta
        + s12_length_6 * C2_x_6_by_theta;
    const double s12_along_x_6_by_theta = (s12_u_6_by_theta + s12_along_x_6
        * s12_distance_squared_6_by_theta) * t58;
    const double s23_distance_squared_6_by_theta = sinew_choose(-(1e-10 - t53 - t54), -(t63
        - (s23_x_6 + s23_x_6) * C2_x_6_by_theta), 0.0);
    const double t65 = 0.5 * s23_distance_squared_6_by_theta * sinew_choose(-(1e-10 + s23_margin_6),
        1.0, 0.0);
    const double s23_length_6_by_theta = t65 / s23_length_6;
    const double s23_u_6_by_theta = 0.008 * C2_y_6_by_theta - s23_x_6 * s23_length_6_by_theta
        - s23_length_6 * C2_x_6_by_theta;
    const double s23_along_x_6_by_theta = (s23_u_6_by_theta + s23_along_x_6
        * s23_distance_squared_6_by_theta) * t59;
    const double t66 = C2_x_6_by_theta * (s12_along_x_6_by_theta - s23_along_x_6_by_theta - t60);
    const double s23_v_6_by_theta = 0.008 * C2_x_6_by_theta - C2_y_6 * s23_length_6_by_theta
        + s23_length_6 * C2_y_6_by_theta;
    const double s23_along_y_6_by_theta = (s23_v_6_by_theta - s23_along_y_6
        * s23_distance_squared_6_by_theta) * t59;
    const double s12_v_6_by_theta = 0.009 * C2_x_6_by_theta + C2_y_6 * s12_length_6_by_theta
        - s12_length_6 * C2_y_6_by_theta;
    const double s12_along_y_6_by_theta = (s12_v_6_by_theta + s12_along_y_6
        * s12_distance_squared_6_by_theta) * t58;
    const double t67 = C2_y_6_by_theta * (s23_along_y_6_by_theta - s12_along_y_6_by_theta - t61);
    const double dL_slope_6_by_theta = t66 + t67;
    const double dL_safe_slope_6_by_theta = sinew_choose(dL_slope_6, dL_slope_6_by_theta
        * sinew_choose(-(1.4e-08 - dL_slope_6), 1.0, 0.0), dL_slope_6_by_theta
        * sinew_choose(-(1.4e-08 + dL_slope_6), 1.0, 0.0));
    const double force_6_by_theta = (energy_slope_6_by_theta + force_6 * dL_safe_slope_6_by_theta)
        * t62;
    const double elongation_slope_6 = dL_safe_slope_6 + 5e-05 * force_6_by_theta;
    const double theta_next_6 = theta_limited_4 - (t55 - 5e-05 * force_6) / elongation_slope_6;
    const double theta_limited_6 = sinew_min(sinew_max(theta_next_6, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines68 = sinew_one_sincos(theta_limited_6);
    const double sin_theta_8 = sines68.s[0];
    const double cos_theta_8 = sines68.c[0];
    const double C2_y_8_by_theta = 0.014 * cos_theta_8;
    const double C2_x_8 = 0.005 + C2_y_8_by_theta;
    const double t69 = C2_x_8 * C2_x_8;
    const double C2_x_8_by_theta = 0.014 * sin_theta_8;
    const double C2_y_8 = 0.005 - C2_x_8_by_theta;
    const double t70 = C2_y_8 * C2_y_8;
    const double s12_distance_squared_8 = sinew_max(t69 + t70, 1e-10);
    const double s12_margin_8 = 8.1e-05 - s12_distance_squared_8;
    const double s12_length_8 = sinew_sqrt(sinew_max(-s12_margin_8, 1e-10));
    const double s23_x_8 = 0.034 - C2_x_8;
    const double t71 = s23_x_8 * s23_x_8;
    const double s23_distance_squared_8 = sinew_max(t70 + t71, 1e-10);
    const double s23_margin_8 = 6.4e-05 - s23_distance_squared_8;
    const double s23_length_8 = sinew_sqrt(sinew_max(-s23_margin_8, 1e-10));
    const double s23_v_8 = 0.008 * s23_x_8 - C2_y_8 * s23_length_8;
    const double s23_u_8 = 0.008 * C2_y_8 + s23_x_8 * s23_length_8;
    const double s23_angle_8 = sinew_one_atan2(-s23_v_8, s23_u_8);
    const double s12_v_8 = 0.009 * C2_x_8 - C2_y_8 * s12_length_8;
    const double s12_u_8 = 0.009 * C2_y_8 + C2_x_8 * s12_length_8;
    const double s12_angle_8 = sinew_one_atan2(s12_v_8, s12_u_8);
    const double t72 = t15 + s12_length_8 + s23_length_8 - 0.008 * s23_angle_8 + 0.009
        * s12_angle_8;
    const double spring_y_8 = 0.00964181414529809 * sin_theta_8 + 0.01149066664678467 * cos_theta_8;
    const double spring_x_8 = 0.00964181414529809 * cos_theta_8 - 0.01149066664678467 * sin_theta_8;
    const double spring_length_squared_8 = 0.000769 - 0.024 * spring_y_8 + 0.04 * spring_x_8;
    const double spring_length_8 = sinew_sqrt(spring_length_squared_8);
    const double t73 = 1.0 / spring_length_8;
    const double spring_strain_8 = 1.0 - 0.018138347076759653 * t73;
    const double t74 = 6400.0 * spring_strain_8;
    const double spring_moment_8 = 0.012 * spring_x_8 + 0.02 * spring_y_8;
    const double energy_slope_8 = t74 * spring_moment_8;
    const double t75 = 1.0 / s12_distance_squared_8;
    const double s12_along_y_8 = s12_v_8 * t75;
    const double t76 = 1.0 / s23_distance_squared_8;
    const double s23_along_y_8 = s23_v_8 * t76;
    const double t77 = s12_along_y_8 + s23_along_y_8;
    const double s12_along_x_8 = s12_u_8 * t75;
    const double s23_along_x_8 = s23_u_8 * t76;
    const double t78 = s12_along_x_8 - s23_along_x_8;
    const double dL_slope_8 = C2_y_8_by_theta * t77 - C2_x_8_by_theta * t78;
    const double dL_safe_slope_8 = sinew_choose(dL_slope_8, sinew_max(dL_slope_8, 1.4e-08),
        sinew_min(dL_slope_8, -1.4e-08));
    const double t79 = 1.0 / dL_safe_slope_8;
    const double force_8 = energy_slope_8 * t79;
    const double spring_moment_8_by_theta = 0.012 * spring_y_8 - 0.02 * spring_x_8;
    const double spring_length_8_by_theta = spring_moment_8 * t73;
    const double spring_strain_8_by_theta = 0.018138347076759653 * spring_length_8_by_theta
        / (spring_length_8 * spring_length_8);
    const double energy_slope_8_by_theta = t74 * spring_moment_8_by_theta + 6400.0 * spring_moment_8
        * spring_strain_8_by_theta;
    const double t80 = (C2_y_8 + C2_y_8) * C2_y_8_by_theta;
    const double s12_distance_squared_8_by_theta = sinew_choose(-(1e-10 - t69 - t70), -((C2_x_8
        + C2_x_8) * C2_x_8_by_theta + t80), 0.0);
    const double t81 = 0.5 * s12_distance_squared_8_by_theta * sinew_choose(-(1e-10 + s12_margin_8),
        1.0, 0.0);
    const double s12_length_8_by_theta = t81 / s12_length_8;
    const double s12_u_8_by_theta = 0.009 * C2_y_8_by_theta - C2_x_8 * s12_length_8_by_theta
        + s12_length_8 * C2_x_8_by_theta;
    const double s12_along_x_8_by_theta = (s12_u_8_by_theta + s12_along_x_8
        * s12_distance_squared_8_by_theta) * t75;
    const double s23_distance_squared_8_by_theta = sinew_choose(-(1e-10 - t70 - t71), -(t80
        - (s23_x_8 + s23_x_8) * C2_x_8_by_theta), 0.0);
    const double t82 = 0.5 * s23_distance_squared_8_by_theta * sinew_choose(-(1e-10 + s23_margin_8),
        1.0, 0.0);
    const double s23_length_8_by_theta = t82 / s23_length_8;
    const double s23_u_8_by_theta = 0.008 * C2_y_8_by_theta - s23_x_8 * s23_length_8_by_theta
        - s23_length_8 * C2_x_8_by_theta;
    const double s23_along_x_8_by_theta = (s23_u_8_by_theta + s23_along_x_8
        * s23_distance_squared_8_by_theta) * t76;
    const double t83 = C2_x_8_by_theta * (s12_along_x_8_by_theta - s23_along_x_8_by_theta - t77);
    const double s23_v_8_by_theta = 0.008 * C2_x_8_by_theta - C2_y_8 * s23_length_8_by_theta
        + s23_length_8 * C2_y_8_by_theta;
    const double s23_along_y_8_by_theta = (s23_v_8_by_theta - s23_along_y_8
        * s23_distance_squared_8_by_theta) * t76;
    const double s12_v_8_by_theta = 0.009 * C2_x_8_by_theta + C2_y_8 * s12_length_8_by_theta
        - s12_length_8 * C2_y_8_by_theta;
    const double s12_along_y_8_by_theta = (s12_v_8_by_theta + s12_along_y_8
        * s12_distance_squared_8_by_theta) * t75;
    const double t84 = C2_y_8_by_theta * (s23_along_y_8_by_theta - s12_along_y_8_by_theta - t78);
    const double dL_slope_8_by_theta = t83 + t84;
    const double dL_safe_slope_8_by_theta = sinew_choose(dL_slope_8, dL_slope_8_by_theta
        * sinew_choose(-(1.4e-08 - dL_slope_8), 1.0, 0.0), dL_slope_8_by_theta
        * sinew_choose(-(1.4e-08 + dL_slope_8), 1.0, 0.0));
    const double force_8_by_theta = (energy_slope_8_by_theta + force_8 * dL_safe_slope_8_by_theta)
        * t79;
    const double elongation_slope_8 = dL_safe_slope_8 + 5e-05 * force_8_by_theta;
    const double theta_next_8 = theta_limited_6 - (t72 - 5e-05 * force_8) / elongation_slope_8;
    const double theta_limited_8 = sinew_min(sinew_max(theta_next_8, 0.09548248781986068),
        0.8377580409572781);
    const struct sinew_sines sines85 = sinew_one_sincos(theta_limited_8);
    const double sin_theta_10 = sines85.s[0];
    const double cos_theta_10 = sines85.c[0];
    const double C2_y_10_by_theta = 0.014 * cos_theta_10;
    const double C2_x_10 = 0.005 + C2_y_10_by_theta;
    const double t86 = C2_x_10 * C2_x_10;
    const double C2_x_10_by_theta = 0.014 * sin_theta_10;
    const double C2_y_10 = 0.005 - C2_x_10_by_theta;
    const double t87 = C2_y_10 * C2_y_10;
    const double s12_distance_squared_10 = sinew_max(t86 + t87, 1e-10);
    const double s12_margin_10 = 8.1e-05 - s12_distance_squared_10;
    const double s12_length_10 = sinew_sqrt(sinew_max(-s12_margin_10, 1e-10));
    const double s23_x_10 = 0.034 - C2_x_10;
    const double t88 = s23_x_10 * s23_x_10;
    const double s23_distance_squared_10 = sinew_max(t87 + t88, 1e-10);
    const double s23_margin_10 = 6.4e-05 - s23_distance_squared_10;
    const double s23_length_10 = sinew_sqrt(sinew_max(-s23_margin_10, 1e-10));
    const double s23_v_10 = 0.008 * s23_x_10 - C2_y_10 * s23_length_10;
    const double s23_u_10 = 0.008 * C2_y_10 + s23_x_10 * s23_length_10;
    const double s23_angle_10 = sinew_one_atan2(-s23_v_10, s23_u_10);
    const double s12_v_10 = 0.009 * C2_x_10 - C2_y_10 * s12_length_10;
    const double s12_u_10 = 0.009 * C2_y_10 + C2_x_10 * s12_length_10;
    const double s12_angle_10 = sinew_one_atan2(s12_v_10, s12_u_10);
    const double t89 = t15 + s12_length_10 + s23_length_10 - 0.008 * s23_angle_10 + 0.009
        * s12_angle_10;
    const double spring_y_10 = 0.00964181414529809 * sin_theta_10 + 0.01149066664678467
        * cos_theta_10;
    const double spring_x_10 = 0.00964181414529809 * cos_theta_10 - 0.01149066664678467
        * sin_theta_10;
    const double spring_length_squared_10 = 0.000769 - 0.024 * spring_y_10 + 0.04 * spring_x_10;
    const double spring_length_10 = sinew_sqrt(spring_length_squared_10);
    const double t90 = 1.0 / spring_length_10;
    const double spring_strain_10 = 1.0 - 0.018138347076759653 * t90;
    const double t91 = 6400.0 * spring_strain_10;
    const double spring_moment_10 = 0.012 * spring_x_10 + 0.02 * spring_y_10;
    const double energy_slope_10 = t91 * spring_moment_10;
    const double t92 = 1.0 / s12_distance_squared_10;
    const double s12_along_y_10 = s12_v_10 * t92;
    const double t93 = 1.0 / s23_distance_squared_10;
    const double s23_along_y_10 = s23_v_10 * t93;
    const double t94 = s12_along_y_10 + s23_along_y_10;
    const double s12_along_x_10 = s12_u_10 * t92;
    const double s23_along_x_10 = s23_u_10 * t93;
    const double t95 = s12_along_x_10 - s23_along_x_10;
    const double dL_slope_10 = C2_y_10_by_theta * t94 - C2_x_10_by_theta * t95;
    const double dL_safe_slope_10 = sinew_choose(dL_slope_10, sinew_max(dL_slope_10, 1.4e-08),
        sinew_min(dL_slope_10, -1.4e-08));
    const double t96 = 1.0 / dL_safe_slope_10;
    const double force_10 = energy_slope_10 * t96;
    const double t97 = -limited_elongation;
    const double spring_moment_10_by_theta = 0.012 * spring_y_10 - 0.02 * spring_x_10;
    const double spring_length_10_by_theta = spring_moment_10 * t90;
    const double spring_strain_10_by_theta = 0.018138347076759653 * spring_length_10_by_theta
        / (spring_length_10 * spring_length_10);
    const double energy_slope_10_by_theta = t91 * spring_moment_10_by_theta + 6400.0
        * spring_moment_10 * spring_strain_10_by_theta;
    const double t98 = (C2_y_10 + C2_y_10) * C2_y_10_by_theta;
    const double s12_distance_squared_10_by_theta = sinew_choose(-(1e-10 - t86 - t87), -((C2_x_10
        + C2_x_10) * C2_x_10_by_theta + t98), 0.0);
    const double t99 = 0.5 * s12_distance_squared_10_by_theta * sinew_choose(-(1e-10
        + s12_margin_10), 1.0, 0.0);
    const double s12_length_10_by_theta = t99 / s12_length_10;
    const double s12_u_10_by_theta = 0.009 * C2_y_10_by_theta - C2_x_10 * s12_length_10_by_theta
        + s12_length_10 * C2_x_10_by_theta;
    const double s12_along_x_10_by_theta = (s12_u_10_by_theta + s12_along_x_10
        * s12_distance_squared_10_by_theta) * t92;
    const double s23_distance_squared_10_by_theta = sinew_choose(-(1e-10 - t87 - t88), -(t98
        - (s23_x_10 + s23_x_10) * C2_x_10_by_theta), 0.0);
    const double t100 = 0.5 * s23_distance_squared_10_by_theta * sinew_choose(-(1e-10
        + s23_margin_10), 1.0, 0.0);
    const double s23_length_10_by_theta = t100 / s23_length_10;
    const double s23_u_10_by_theta = 0.008 * C2_y_10_by_theta - s23_x_10 * s23_length_10_by_theta
        - s23_length_10 * C2_x_10_by_theta;
    const double s23_along_x_10_by_theta = (s23_u_10_by_theta + s23_along_x_10
        * s23_distance_squared_10_by_theta) * t93;
    const double t101 = C2_x_10_by_theta * (s12_along_x_10_by_theta - s23_along_x_10_by_theta
        - t94);
    const double s23_v_10_by_theta = 0.008 * C2_x_10_by_theta - C2_y_10 * s23_length_10_by_theta
        + s23_length_10 * C2_y_10_by_theta;
    const double s23_along_y_10_by_theta = (s23_v_10_by_theta - s23_along_y_10
        * s23_distance_squared_10_by_theta) * t93;
    const double s12_v_10_by_theta = 0.009 * C2_x_10_by_theta + C2_y_10 * s12_length_10_by_theta
        - s12_length_10 * C2_y_10_by_theta;
    const double s12_along_y_10_by_theta = (s12_v_10_by_theta + s12_along_y_10
        * s12_distance_squared_10_by_theta) * t92;
    const double t102 = C2_y_10_by_theta * (s23_along_y_10_by_theta - s12_along_y_10_by_theta
        - t95);
    const double dL_slope_10_by_theta = t101 + t102;
    const double dL_safe_slope_10_by_theta = sinew_choose(dL_slope_10, dL_slope_10_by_theta
        * sinew_choose(-(1.4e-08 - dL_slope_10), 1.0, 0.0), dL_slope_10_by_theta
        * sinew_choose(-(1.4e-08 + dL_slope_10), 1.0, 0.0));
    const double force_10_by_theta = (energy_slope_10_by_theta + force_10
        * dL_safe_slope_10_by_theta) * t96;
    const double elongation_slope_10 = dL_safe_slope_10 + 5e-05 * force_10_by_theta;
    out[0] = sinew_choose(t97, 0.0, force_10);
    out[1] = sinew_choose(t97, 0.0, force_10_by_theta / elongation_slope_10);
    out[2] = theta_limited_8;
    residual[0] = sinew_choose(t97, 0.0, t89 - 5e-05 * force_10);
}
