/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model lever over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/lever
 * Model:   sha256 15dde9f611cf6f60b088af06e8cd7bbe07ac2edbefd53940e6f2012efb5af55c
 * Do not edit: change the model and generate again.
 */
#include "lever_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void lever_state_batch(int count, const double *SINEW_RESTRICT theta, double *SINEW_RESTRICT out)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_theta, cos_theta;
        sinew_sincos(theta[state], &sin_theta, &cos_theta);
        const double C2_y_by_theta = 0.014 * cos_theta;
        const double C2_x = 0.005 + C2_y_by_theta;
        const double s23_x = 0.034 - C2_x;
        const double C2_x_by_theta = 0.014 * sin_theta;
        const double C2_y = 0.005 - C2_x_by_theta;
        const double t1 = (C2_y + C2_y) * C2_y_by_theta;
        const double t2 = s23_x * s23_x;
        const double t3 = C2_y * C2_y;
        const double s23_distance_squared_by_theta = sinew_choose(-(1e-10 - t3 - t2), -(t1 - (s23_x
            + s23_x) * C2_x_by_theta), 0.0);
        const double s23_distance_squared = sinew_max(t3 + t2, 1e-10);
        const double s23_margin = 6.4e-05 - s23_distance_squared;
        const double t4 = 0.5 * s23_distance_squared_by_theta * sinew_choose(-(1e-10 + s23_margin),
            1.0, 0.0);
        const double s23_length = sinew_sqrt(sinew_max(-s23_margin, 1e-10));
        const double s23_length_by_theta = t4 / s23_length;
        const double s23_u_by_theta = 0.008 * C2_y_by_theta - s23_x * s23_length_by_theta
            - s23_length * C2_x_by_theta;
        const double s23_u = 0.008 * C2_y + s23_x * s23_length;
        const double t5 = 1.0 / s23_distance_squared;
        const double s23_along_x = s23_u * t5;
        const double s23_along_x_by_theta = (s23_u_by_theta + s23_along_x
            * s23_distance_squared_by_theta) * t5;
        const double t6 = C2_x * C2_x;
        const double s12_distance_squared_by_theta = sinew_choose(-(1e-10 - t6 - t3), -((C2_x
            + C2_x) * C2_x_by_theta + t1), 0.0);
        const double s12_distance_squared = sinew_max(t6 + t3, 1e-10);
        const double s12_margin = 8.1e-05 - s12_distance_squared;
        const double t7 = 0.5 * s12_distance_squared_by_theta * sinew_choose(-(1e-10 + s12_margin),
            1.0, 0.0);
        const double s12_length = sinew_sqrt(sinew_max(-s12_margin, 1e-10));
        const double s12_length_by_theta = t7 / s12_length;
        const double s12_u_by_theta = 0.009 * C2_y_by_theta - C2_x * s12_length_by_theta
            + s12_length * C2_x_by_theta;
        const double s12_u = 0.009 * C2_y + C2_x * s12_length;
        const double t8 = 1.0 / s12_distance_squared;
        const double s12_along_x = s12_u * t8;
        const double s12_along_x_by_theta = (s12_u_by_theta + s12_along_x
            * s12_distance_squared_by_theta) * t8;
        const double s23_v = 0.008 * s23_x - C2_y * s23_length;
        const double s23_along_y = s23_v * t5;
        const double s12_v = 0.009 * C2_x - C2_y * s12_length;
        const double s12_along_y = s12_v * t8;
        const double t9 = s12_along_y + s23_along_y;
        const double s23_v_by_theta = 0.008 * C2_x_by_theta - C2_y * s23_length_by_theta
            + s23_length * C2_y_by_theta;
        const double s23_along_y_by_theta = (s23_v_by_theta - s23_along_y
            * s23_distance_squared_by_theta) * t5;
        const double s12_v_by_theta = 0.009 * C2_x_by_theta + C2_y * s12_length_by_theta
            - s12_length * C2_y_by_theta;
        const double s12_along_y_by_theta = (s12_v_by_theta + s12_along_y
            * s12_distance_squared_by_theta) * t8;
        const double t10 = s12_along_x - s23_along_x;
        const double dL_slope_by_theta = C2_x_by_theta * (s12_along_x_by_theta
            - s23_along_x_by_theta - t9) + C2_y_by_theta * (s23_along_y_by_theta
            - s12_along_y_by_theta - t10);
        const double dL_slope = C2_y_by_theta * t9 - C2_x_by_theta * t10;
        const double dL_safe_slope_by_theta = sinew_choose(dL_slope, dL_slope_by_theta
            * sinew_choose(-(1.4e-08 - dL_slope), 1.0, 0.0), dL_slope_by_theta
            * sinew_choose(-(1.4e-08 + dL_slope), 1.0, 0.0));
        const double dL_safe_slope = sinew_choose(dL_slope, sinew_max(dL_slope, 1.4e-08),
            sinew_min(dL_slope, -1.4e-08));
        const double t11 = 1.0 / dL_safe_slope;
        const double spring_y = 0.00964181414529809 * sin_theta + 0.01149066664678467 * cos_theta;
        const double spring_x = 0.00964181414529809 * cos_theta - 0.01149066664678467 * sin_theta;
        const double spring_length_squared = 0.000769 - 0.024 * spring_y + 0.04 * spring_x;
        const double spring_length = sinew_sqrt(spring_length_squared);
        const double t12 = 1.0 / spring_length;
        const double t13 = 6400.0 * (1.0 - 0.018138347076759653 * t12);
        const double spring_moment = 0.012 * spring_x + 0.02 * spring_y;
        const double force = t13 * spring_moment * t11;
        const double spring_strain_by_theta = 0.018138347076759653 * (spring_moment * t12)
            / (spring_length * spring_length);
        const double energy_slope_by_theta = t13 * (0.012 * spring_y - 0.02 * spring_x) + 6400.0
            * spring_moment * spring_strain_by_theta;
        const double force_by_theta = (energy_slope_by_theta + force * dL_safe_slope_by_theta)
            * t11;
        const double dL = s12_length + s23_length - 0.008 * sinew_atan2(-s23_v, s23_u) + 0.009
            * sinew_atan2(s12_v, s12_u);
        out[state] = dL;
        out[1 * n + state] = 0.04541547683053999 - dL;
        out[2 * n + state] = force;
        out[3 * n + state] = force_by_theta * t11;
    }
}

void lever_slope_batch(int count, const double *SINEW_RESTRICT theta, double *SINEW_RESTRICT out)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_theta, cos_theta;
        sinew_sincos(theta[state], &sin_theta, &cos_theta);
        const double t1 = 0.014 * cos_theta;
        const double C2_x = 0.005 + t1;
        const double s23_x = 0.034 - C2_x;
        const double t2 = 0.014 * sin_theta;
        const double C2_y = 0.005 - t2;
        const double t3 = C2_y * C2_y;
        const double s23_distance_squared = sinew_max(t3 + s23_x * s23_x, 1e-10);
        const double s23_length = sinew_sqrt(sinew_max(-(6.4e-05 - s23_distance_squared), 1e-10));
        const double t4 = 1.0 / s23_distance_squared;
        const double s12_distance_squared = sinew_max(C2_x * C2_x + t3, 1e-10);
        const double s12_length = sinew_sqrt(sinew_max(-(8.1e-05 - s12_distance_squared), 1e-10));
        const double t5 = 1.0 / s12_distance_squared;
        const double t6 = (0.009 * C2_x - C2_y * s12_length) * t5 + (0.008 * s23_x - C2_y
            * s23_length) * t4;
        const double t7 = (0.009 * C2_y + C2_x * s12_length) * t5 - (0.008 * C2_y + s23_x
            * s23_length) * t4;
        const double spring_y = 0.00964181414529809 * sin_theta + 0.01149066664678467 * cos_theta;
        const double spring_x = 0.00964181414529809 * cos_theta - 0.01149066664678467 * sin_theta;
        const double spring_length_squared = 0.000769 - 0.024 * spring_y + 0.04 * spring_x;
        const double spring_strain = 1.0 - 0.018138347076759653 / sinew_sqrt(spring_length_squared);
        const double energy_slope = 6400.0 * spring_strain * (0.012 * spring_x + 0.02 * spring_y);
        out[state] = t1 * t6 - t2 * t7;
        out[1 * n + state] = -energy_slope;
    }
}

void lever_angle_batch(int count, const double *SINEW_RESTRICT elongation,
    const double *SINEW_RESTRICT theta, double *SINEW_RESTRICT theta_lever,
    double *SINEW_RESTRICT residual)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double theta_start = sinew_min(sinew_max(theta[state], 0.09548248781986068),
            0.8377580409572781);
        double sin_theta, cos_theta;
        sinew_sincos(theta_start, &sin_theta, &cos_theta);
        const double t1 = 0.014 * cos_theta;
        const double C2_x = 0.005 + t1;
        const double s23_x = 0.034 - C2_x;
        const double t2 = 0.014 * sin_theta;
        const double C2_y = 0.005 - t2;
        const double t3 = C2_y * C2_y;
        const double s23_distance_squared = sinew_max(t3 + s23_x * s23_x, 1e-10);
        const double s23_length = sinew_sqrt(sinew_max(-(6.4e-05 - s23_distance_squared), 1e-10));
        const double s23_v = 0.008 * s23_x - C2_y * s23_length;
        const double t4 = 1.0 / s23_distance_squared;
        const double s12_distance_squared = sinew_max(C2_x * C2_x + t3, 1e-10);
        const double s12_length = sinew_sqrt(sinew_max(-(8.1e-05 - s12_distance_squared), 1e-10));
        const double s12_v = 0.009 * C2_x - C2_y * s12_length;
        const double t5 = 1.0 / s12_distance_squared;
        const double s23_u = 0.008 * C2_y + s23_x * s23_length;
        const double s12_u = 0.009 * C2_y + C2_x * s12_length;
        const double dL_slope = t1 * (s12_v * t5 + s23_v * t4) - t2 * (s12_u * t5 - s23_u * t4);
        const double dL_safe_slope = sinew_choose(dL_slope, sinew_max(dL_slope, 1.4e-08),
            sinew_min(dL_slope, -1.4e-08));
        const double limited_elongation = sinew_min(sinew_max(elongation[state], -1.0), 1.0);
        const double dL_target = 0.04541547683053999 - limited_elongation;
        const double t6 = dL_target - s12_length - s23_length + 0.008 * sinew_atan2(-s23_v, s23_u)
            - 0.009 * sinew_atan2(s12_v, s12_u);
        const double theta_limited = sinew_min(sinew_max(theta_start + t6 / dL_safe_slope,
            0.09548248781986068), 0.8377580409572781);
        double sin_theta_2, cos_theta_2;
        sinew_sincos(theta_limited, &sin_theta_2, &cos_theta_2);
        const double t7 = 0.014 * cos_theta_2;
        const double C2_x_2 = 0.005 + t7;
        const double s23_x_2 = 0.034 - C2_x_2;
        const double t8 = 0.014 * sin_theta_2;
        const double C2_y_2 = 0.005 - t8;
        const double t9 = C2_y_2 * C2_y_2;
        const double s23_distance_squared_2 = sinew_max(t9 + s23_x_2 * s23_x_2, 1e-10);
        const double s23_length_2 = sinew_sqrt(sinew_max(-(6.4e-05 - s23_distance_squared_2),
            1e-10));
        const double s23_v_2 = 0.008 * s23_x_2 - C2_y_2 * s23_length_2;
        const double t10 = 1.0 / s23_distance_squared_2;
        const double s12_distance_squared_2 = sinew_max(C2_x_2 * C2_x_2 + t9, 1e-10);
        const double s12_length_2 = sinew_sqrt(sinew_max(-(8.1e-05 - s12_distance_squared_2),
            1e-10));
        const double s12_v_2 = 0.009 * C2_x_2 - C2_y_2 * s12_length_2;
        const double t11 = 1.0 / s12_distance_squared_2;
        const double s23_u_2 = 0.008 * C2_y_2 + s23_x_2 * s23_length_2;
        const double s12_u_2 = 0.009 * C2_y_2 + C2_x_2 * s12_length_2;
        const double dL_slope_2 = t7 * (s12_v_2 * t11 + s23_v_2 * t10) - t8 * (s12_u_2 * t11
            - s23_u_2 * t10);
        const double dL_safe_slope_2 = sinew_choose(dL_slope_2, sinew_max(dL_slope_2, 1.4e-08),
            sinew_min(dL_slope_2, -1.4e-08));
        const double t12 = dL_target - s12_length_2 - s23_length_2 + 0.008 * sinew_atan2(-s23_v_2,
            s23_u_2);
        const double theta_next_2 = theta_limited + (t12 - 0.009 * sinew_atan2(s12_v_2, s12_u_2))
            / dL_safe_slope_2;
        const double theta_limited_2 = sinew_min(sinew_max(theta_next_2, 0.09548248781986068),
            0.8377580409572781);
        double sin_theta_4, cos_theta_4;
        sinew_sincos(theta_limited_2, &sin_theta_4, &cos_theta_4);
        const double t13 = 0.014 * cos_theta_4;
        const double C2_x_4 = 0.005 + t13;
        const double t14 = 0.014 * sin_theta_4;
        const double C2_y_4 = 0.005 - t14;
        const double t15 = C2_y_4 * C2_y_4;
        const double s12_distance_squared_4 = sinew_max(C2_x_4 * C2_x_4 + t15, 1e-10);
        const double s12_length_4 = sinew_sqrt(sinew_max(-(8.1e-05 - s12_distance_squared_4),
            1e-10));
        const double s23_x_4 = 0.034 - C2_x_4;
        const double s23_distance_squared_4 = sinew_max(t15 + s23_x_4 * s23_x_4, 1e-10);
        const double s23_length_4 = sinew_sqrt(sinew_max(-(6.4e-05 - s23_distance_squared_4),
            1e-10));
        const double s23_v_4 = 0.008 * s23_x_4 - C2_y_4 * s23_length_4;
        const double s23_u_4 = 0.008 * C2_y_4 + s23_x_4 * s23_length_4;
        const double t16 = dL_target - s12_length_4 - s23_length_4 + 0.008 * sinew_atan2(-s23_v_4,
            s23_u_4);
        const double s12_v_4 = 0.009 * C2_x_4 - C2_y_4 * s12_length_4;
        const double s12_u_4 = 0.009 * C2_y_4 + C2_x_4 * s12_length_4;
        const double t17 = 1.0 / s12_distance_squared_4;
        const double t18 = 1.0 / s23_distance_squared_4;
        const double dL_slope_4 = t13 * (s12_v_4 * t17 + s23_v_4 * t18) - t14 * (s12_u_4 * t17
            - s23_u_4 * t18);
        const double dL_safe_slope_4 = sinew_choose(dL_slope_4, sinew_max(dL_slope_4, 1.4e-08),
            sinew_min(dL_slope_4, -1.4e-08));
        const double theta_next_4 = theta_limited_2 + (t16 - 0.009 * sinew_atan2(s12_v_4, s12_u_4))
            / dL_safe_slope_4;
        const double theta_limited_4 = sinew_min(sinew_max(theta_next_4, 0.09548248781986068),
            0.8377580409572781);
        double sin_theta_6, cos_theta_6;
        sinew_sincos(theta_limited_4, &sin_theta_6, &cos_theta_6);
        const double t19 = 0.014 * cos_theta_6;
        const double C2_x_6 = 0.005 + t19;
        const double t20 = 0.014 * sin_theta_6;
        const double C2_y_6 = 0.005 - t20;
        const double t21 = C2_y_6 * C2_y_6;
        const double s12_distance_squared_6 = sinew_max(C2_x_6 * C2_x_6 + t21, 1e-10);
        const double s12_length_6 = sinew_sqrt(sinew_max(-(8.1e-05 - s12_distance_squared_6),
            1e-10));
        const double s23_x_6 = 0.034 - C2_x_6;
        const double s23_distance_squared_6 = sinew_max(t21 + s23_x_6 * s23_x_6, 1e-10);
        const double s23_length_6 = sinew_sqrt(sinew_max(-(6.4e-05 - s23_distance_squared_6),
            1e-10));
        const double s23_v_6 = 0.008 * s23_x_6 - C2_y_6 * s23_length_6;
        const double s23_u_6 = 0.008 * C2_y_6 + s23_x_6 * s23_length_6;
        const double t22 = dL_target - s12_length_6 - s23_length_6 + 0.008 * sinew_atan2(-s23_v_6,
            s23_u_6);
        const double s12_v_6 = 0.009 * C2_x_6 - C2_y_6 * s12_length_6;
        const double s12_u_6 = 0.009 * C2_y_6 + C2_x_6 * s12_length_6;
        const double t23 = 1.0 / s12_distance_squared_6;
        const double t24 = 1.0 / s23_distance_squared_6;
        const double dL_slope_6 = t19 * (s12_v_6 * t23 + s23_v_6 * t24) - t20 * (s12_u_6 * t23
            - s23_u_6 * t24);
        const double dL_safe_slope_6 = sinew_choose(dL_slope_6, sinew_max(dL_slope_6, 1.4e-08),
            sinew_min(dL_slope_6, -1.4e-08));
        const double theta_next_6 = theta_limited_4 + (t22 - 0.009 * sinew_atan2(s12_v_6, s12_u_6))
            / dL_safe_slope_6;
        const double theta_limited_6 = sinew_min(sinew_max(theta_next_6, 0.09548248781986068),
            0.8377580409572781);
        double sin_theta_8, cos_theta_8;
        sinew_sincos(theta_limited_6, &sin_theta_8, &cos_theta_8);
        const double t25 = 0.014 * cos_theta_8;
        const double C2_x_8 = 0.005 + t25;
        const double t26 = 0.014 * sin_theta_8;
        const double C2_y_8 = 0.005 - t26;
        const double t27 = C2_y_8 * C2_y_8;
        const double s12_distance_squared_8 = sinew_max(C2_x_8 * C2_x_8 + t27, 1e-10);
        const double s12_length_8 = sinew_sqrt(sinew_max(-(8.1e-05 - s12_distance_squared_8),
            1e-10));
        const double s23_x_8 = 0.034 - C2_x_8;
        const double s23_distance_squared_8 = sinew_max(t27 + s23_x_8 * s23_x_8, 1e-10);
        const double s23_length_8 = sinew_sqrt(sinew_max(-(6.4e-05 - s23_distance_squared_8),
            1e-10));
        const double s23_v_8 = 0.008 * s23_x_8 - C2_y_8 * s23_length_8;
        const double s23_u_8 = 0.008 * C2_y_8 + s23_x_8 * s23_length_8;
        const double t28 = dL_target - s12_length_8 - s23_length_8 + 0.008 * sinew_atan2(-s23_v_8,
            s23_u_8);
        const double s12_v_8 = 0.009 * C2_x_8 - C2_y_8 * s12_length_8;
        const double s12_u_8 = 0.009 * C2_y_8 + C2_x_8 * s12_length_8;
        const double t29 = 1.0 / s12_distance_squared_8;
        const double t30 = 1.0 / s23_distance_squared_8;
        const double dL_slope_8 = t25 * (s12_v_8 * t29 + s23_v_8 * t30) - t26 * (s12_u_8 * t29
            - s23_u_8 * t30);
        const double dL_safe_slope_8 = sinew_choose(dL_slope_8, sinew_max(dL_slope_8, 1.4e-08),
            sinew_min(dL_slope_8, -1.4e-08));
        const double theta_next_8 = theta_limited_6 + (t28 - 0.009 * sinew_atan2(s12_v_8, s12_u_8))
            / dL_safe_slope_8;
        const double theta_limited_8 = sinew_min(sinew_max(theta_next_8, 0.09548248781986068),
            0.8377580409572781);
        double sin_theta_10, cos_theta_10;
        sinew_sincos(theta_limited_8, &sin_theta_10, &cos_theta_10);
        const double C2_x_10 = 0.005 + 0.014 * cos_theta_10;
        const double C2_y_10 = 0.005 - 0.014 * sin_theta_10;
        const double t31 = C2_y_10 * C2_y_10;
        const double s12_distance_squared_10 = sinew_max(C2_x_10 * C2_x_10 + t31, 1e-10);
        const double s12_length_10 = sinew_sqrt(sinew_max(-(8.1e-05 - s12_distance_squared_10),
            1e-10));
        const double s23_x_10 = 0.034 - C2_x_10;
        const double s23_distance_squared_10 = sinew_max(t31 + s23_x_10 * s23_x_10, 1e-10);
        const double s23_length_10 = sinew_sqrt(sinew_max(-(6.4e-05 - s23_distance_squared_10),
            1e-10));
        const double s23_v_10 = 0.008 * s23_x_10 - C2_y_10 * s23_length_10;
        const double s23_u_10 = 0.008 * C2_y_10 + s23_x_10 * s23_length_10;
        const double t32 = dL_target - s12_length_10 - s23_length_10 + 0.008
            * sinew_atan2(-s23_v_10, s23_u_10);
        const double s12_v_10 = 0.009 * C2_x_10 - C2_y_10 * s12_length_10;
        const double s12_u_10 = 0.009 * C2_y_10 + C2_x_10 * s12_length_10;
        theta_lever[state] = theta_limited_8;
        residual[state] = t32 - 0.009 * sinew_atan2(s12_v_10, s12_u_10);
    }
}

void lever_status_batch(int count, const double *SINEW_RESTRICT theta, int *SINEW_RESTRICT status)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_theta, cos_theta;
        sinew_sincos(theta[state], &sin_theta, &cos_theta);
        const double t1 = 0.014 * cos_theta;
        const double C2_x = 0.005 + t1;
        const double s23_x = 0.034 - C2_x;
        const double t2 = 0.014 * sin_theta;
        const double C2_y = 0.005 - t2;
        const double t3 = C2_y * C2_y;
        const double s23_distance_squared = sinew_max(t3 + s23_x * s23_x, 1e-10);
        const double t4 = -(6.4e-05 - s23_distance_squared);
        const double s23_length = sinew_sqrt(sinew_max(t4, 1e-10));
        const double t5 = 1.0 / s23_distance_squared;
        const double s12_distance_squared = sinew_max(C2_x * C2_x + t3, 1e-10);
        const double t6 = -(8.1e-05 - s12_distance_squared);
        const double s12_length = sinew_sqrt(sinew_max(t6, 1e-10));
        const double t7 = 1.0 / s12_distance_squared;
        const double t8 = (0.009 * C2_x - C2_y * s12_length) * t7 + (0.008 * s23_x - C2_y
            * s23_length) * t5;
        const double t9 = (0.009 * C2_y + C2_x * s12_length) * t7 - (0.008 * C2_y + s23_x
            * s23_length) * t5;
        const double dL_slope = t1 * t8 - t2 * t9;
        const double t10 = sinew_choose(-(1.4e-08 - sinew_max(dL_slope, -dL_slope)),
            sinew_choose(sinew_min(t6, t4), 0.0, 1.0), 1.0);
        const double t11 = sinew_min(sinew_max(theta[state], 0.09548248781986068),
            0.8377580409572781);
        const double t12 = theta[state] - t11;
        status[state] = (int)sinew_choose(-sinew_max(t12, -t12), t10, 1.0);
    }
}
