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

static struct sinew_sines sinew_one_sincos(double x)
{
    struct sinew_sines y;
    sinew_sincos(x, y.s, y.c);
    return y;
}

/* Parts: what several functions compute alike, or one at several places. */

SINEW_NOT_INLINE static void tendon_part_1(double theta_start, double x,
    double part[SINEW_AT_LEAST(4)])
{
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
    const double t14 = 6400.0 * (1.0 - 0.018138347076759653 * t13);
    const double spring_moment = 0.012 * spring_x + 0.02 * spring_y;
    const double force = t14 * spring_moment * t12;
    const double spring_strain_by_theta = 0.018138347076759653 * (spring_moment * t13)
        / (spring_length * spring_length);
    const double energy_slope_by_theta = t14 * (0.012 * spring_y - 0.02 * spring_x) + 6400.0
        * spring_moment * spring_strain_by_theta;
    const double force_by_theta = (energy_slope_by_theta + force * dL_safe_slope_by_theta) * t12;
    const double t15 = x + s12_length + s23_length - 0.008 * sinew_one_atan2(-s23_v, s23_u) + 0.009
        * sinew_one_atan2(s12_v, s12_u);
    part[0] = force;
    part[1] = force_by_theta;
    part[2] = dL_safe_slope + 5e-05 * force_by_theta;
    part[3] = t15 - 5e-05 * force;
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
    const double limited_elongation = sinew_min(sinew_max(elongation, -1.0), 1.0);
    const double t1 = limited_elongation - 0.04541547683053999;
    double part_1[4];
    tendon_part_1(theta_start, t1, part_1);
    const double theta_limited = sinew_min(sinew_max(theta_start - part_1[3] / part_1[2],
        0.09548248781986068), 0.8377580409572781);
    double part_1_2[4];
    tendon_part_1(theta_limited, t1, part_1_2);
    const double theta_next_2 = theta_limited - part_1_2[3] / part_1_2[2];
    const double theta_limited_2 = sinew_min(sinew_max(theta_next_2, 0.09548248781986068),
        0.8377580409572781);
    double part_1_3[4];
    tendon_part_1(theta_limited_2, t1, part_1_3);
    const double theta_next_4 = theta_limited_2 - part_1_3[3] / part_1_3[2];
    const double theta_limited_4 = sinew_min(sinew_max(theta_next_4, 0.09548248781986068),
        0.8377580409572781);
    double part_1_4[4];
    tendon_part_1(theta_limited_4, t1, part_1_4);
    const double theta_next_6 = theta_limited_4 - part_1_4[3] / part_1_4[2];
    const double theta_limited_6 = sinew_min(sinew_max(theta_next_6, 0.09548248781986068),
        0.8377580409572781);
    double part_1_5[4];
    tendon_part_1(theta_limited_6, t1, part_1_5);
    const double theta_next_8 = theta_limited_6 - part_1_5[3] / part_1_5[2];
    const double theta_limited_8 = sinew_min(sinew_max(theta_next_8, 0.09548248781986068),
        0.8377580409572781);
    double part_1_6[4];
    tendon_part_1(theta_limited_8, t1, part_1_6);
    const double t2 = -limited_elongation;
    out[0] = sinew_choose(t2, 0.0, part_1_6[0]);
    out[1] = sinew_choose(t2, 0.0, part_1_6[1] / part_1_6[2]);
    out[2] = theta_limited_8;
    residual[0] = sinew_choose(t2, 0.0, part_1_6[3]);
}
