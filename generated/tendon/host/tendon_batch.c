/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model tendon over many states; element
 *     k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/tendon
 * Model:   sha256 9fa49807a7e8a052fcdd9aca09d5e31e41ada5f891672ef877029e3417b31747
 * Do not edit: change the model and generate again.
 */
#include "tendon_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void tendon_series_stiffness_batch(int count, const double *SINEW_RESTRICT k_lever,
    double *SINEW_RESTRICT k)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_min(sinew_max(k_lever[state], 0.0), 1e+12);
        k[state] = 20000.0 * t1 / (20000.0 + t1);
    }
}

void tendon_force_batch(int count, const double *SINEW_RESTRICT elongation,
    const double *SINEW_RESTRICT theta, double *SINEW_RESTRICT out, double *SINEW_RESTRICT residual)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double theta_start = sinew_min(sinew_max(theta[state], 0.09548248781986068),
            0.8377580409572781);
        double sin_theta, cos_theta;
        sinew_sincos(theta_start, &sin_theta, &cos_theta);
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
        const double limited_elongation = sinew_min(sinew_max(elongation[state], -1.0), 1.0);
        const double t14 = limited_elongation - 0.04541547683053999;
        const double t15 = t14 + s12_length + s23_length - 0.008 * sinew_atan2(-s23_v, s23_u)
            + 0.009 * sinew_atan2(s12_v, s12_u);
        const double theta_next = theta_start - (t15 - 5e-05 * force) / (dL_safe_slope + 5e-05
            * force_by_theta);
        const double theta_limited = sinew_min(sinew_max(theta_next, 0.09548248781986068),
            0.8377580409572781);
        double sin_theta_2, cos_theta_2;
        sinew_sincos(theta_limited, &sin_theta_2, &cos_theta_2);
        const double C2_y_2_by_theta = 0.014 * cos_theta_2;
        const double C2_x_2 = 0.005 + C2_y_2_by_theta;
        const double s23_x_2 = 0.034 - C2_x_2;
        const double t16 = s23_x_2 * s23_x_2;
        const double C2_x_2_by_theta = 0.014 * sin_theta_2;
        const double C2_y_2 = 0.005 - C2_x_2_by_theta;
        const double t17 = C2_y_2 * C2_y_2;
        const double s23_distance_squared_2 = sinew_max(t17 + t16, 1e-10);
        const double s23_margin_2 = 6.4e-05 - s23_distance_squared_2;
        const double s23_length_2 = sinew_sqrt(sinew_max(-s23_margin_2, 1e-10));
        const double s23_v_2 = 0.008 * s23_x_2 - C2_y_2 * s23_length_2;
        const double t18 = 1.0 / s23_distance_squared_2;
        const double s23_along_y_2 = s23_v_2 * t18;
        const double t19 = C2_x_2 * C2_x_2;
        const double s12_distance_squared_2 = sinew_max(t19 + t17, 1e-10);
        const double s12_margin_2 = 8.1e-05 - s12_distance_squared_2;
        const double s12_length_2 = sinew_sqrt(sinew_max(-s12_margin_2, 1e-10));
        const double s12_v_2 = 0.009 * C2_x_2 - C2_y_2 * s12_length_2;
        const double t20 = 1.0 / s12_distance_squared_2;
        const double s12_along_y_2 = s12_v_2 * t20;
        const double t21 = s12_along_y_2 + s23_along_y_2;
        const double s23_u_2 = 0.008 * C2_y_2 + s23_x_2 * s23_length_2;
        const double s23_along_x_2 = s23_u_2 * t18;
        const double s12_u_2 = 0.009 * C2_y_2 + C2_x_2 * s12_length_2;
        const double s12_along_x_2 = s12_u_2 * t20;
        const double t22 = s12_along_x_2 - s23_along_x_2;
        const double dL_slope_2 = C2_y_2_by_theta * t21 - C2_x_2_by_theta * t22;
        const double dL_safe_slope_2 = sinew_choose(dL_slope_2, sinew_max(dL_slope_2, 1.4e-08),
            sinew_min(dL_slope_2, -1.4e-08));
        const double t23 = 1.0 / dL_safe_slope_2;
        const double spring_y_2 = 0.00964181414529809 * sin_theta_2 + 0.01149066664678467
            * cos_theta_2;
        const double spring_x_2 = 0.00964181414529809 * cos_theta_2 - 0.01149066664678467
            * sin_theta_2;
        const double spring_length_squared_2 = 0.000769 - 0.024 * spring_y_2 + 0.04 * spring_x_2;
        const double spring_length_2 = sinew_sqrt(spring_length_squared_2);
        const double t24 = 1.0 / spring_length_2;
        const double t25 = 6400.0 * (1.0 - 0.018138347076759653 * t24);
        const double spring_moment_2 = 0.012 * spring_x_2 + 0.02 * spring_y_2;
        const double force_2 = t25 * spring_moment_2 * t23;
        const double t26 = t14 + s12_length_2 + s23_length_2 - 0.008 * sinew_atan2(-s23_v_2,
            s23_u_2);
        const double t27 = (C2_y_2 + C2_y_2) * C2_y_2_by_theta;
        const double s23_distance_squared_2_by_theta = sinew_choose(-(1e-10 - t17 - t16), -(t27
            - (s23_x_2 + s23_x_2) * C2_x_2_by_theta), 0.0);
        const double t28 = 0.5 * s23_distance_squared_2_by_theta * sinew_choose(-(1e-10
            + s23_margin_2), 1.0, 0.0);
        const double s23_length_2_by_theta = t28 / s23_length_2;
        const double s23_u_2_by_theta = 0.008 * C2_y_2_by_theta - s23_x_2 * s23_length_2_by_theta
            - s23_length_2 * C2_x_2_by_theta;
        const double s23_along_x_2_by_theta = (s23_u_2_by_theta + s23_along_x_2
            * s23_distance_squared_2_by_theta) * t18;
        const double s12_distance_squared_2_by_theta = sinew_choose(-(1e-10 - t19 - t17), -((C2_x_2
            + C2_x_2) * C2_x_2_by_theta + t27), 0.0);
        const double t29 = 0.5 * s12_distance_squared_2_by_theta * sinew_choose(-(1e-10
            + s12_margin_2), 1.0, 0.0);
        const double s12_length_2_by_theta = t29 / s12_length_2;
        const double s12_u_2_by_theta = 0.009 * C2_y_2_by_theta - C2_x_2 * s12_length_2_by_theta
            + s12_length_2 * C2_x_2_by_theta;
        const double s12_along_x_2_by_theta = (s12_u_2_by_theta + s12_along_x_2
            * s12_distance_squared_2_by_theta) * t20;
        const double t30 = C2_x_2_by_theta * (s12_along_x_2_by_theta - s23_along_x_2_by_theta
            - t21);
        const double s23_v_2_by_theta = 0.008 * C2_x_2_by_theta - C2_y_2 * s23_length_2_by_theta
            + s23_length_2 * C2_y_2_by_theta;
        const double s23_along_y_2_by_theta = (s23_v_2_by_theta - s23_along_y_2
            * s23_distance_squared_2_by_theta) * t18;
        const double s12_v_2_by_theta = 0.009 * C2_x_2_by_theta + C2_y_2 * s12_length_2_by_theta
            - s12_length_2 * C2_y_2_by_theta;
        const double s12_along_y_2_by_theta = (s12_v_2_by_theta + s12_along_y_2
            * s12_distance_squared_2_by_theta) * t20;
        const double t31 = C2_y_2_by_theta * (s23_along_y_2_by_theta - s12_along_y_2_by_theta
            - t22);
        const double dL_slope_2_by_theta = t30 + t31;
        const double dL_safe_slope_2_by_theta = sinew_choose(dL_slope_2, dL_slope_2_by_theta
            * sinew_choose(-(1.4e-08 - dL_slope_2), 1.0, 0.0), dL_slope_2_by_theta
            * sinew_choose(-(1.4e-08 + dL_slope_2), 1.0, 0.0));
        const double spring_strain_2_by_theta = 0.018138347076759653 * (spring_moment_2 * t24)
            / (spring_length_2 * spring_length_2);
        const double energy_slope_2_by_theta = t25 * (0.012 * spring_y_2 - 0.02 * spring_x_2)
            + 6400.0 * spring_moment_2 * spring_strain_2_by_theta;
        const double force_2_by_theta = (energy_slope_2_by_theta + force_2
            * dL_safe_slope_2_by_theta) * t23;
        const double elongation_slope_2 = dL_safe_slope_2 + 5e-05 * force_2_by_theta;
        const double t32 = (t26 + 0.009 * sinew_atan2(s12_v_2, s12_u_2) - 5e-05 * force_2)
            / elongation_slope_2;
        const double theta_limited_2 = sinew_min(sinew_max(theta_limited - t32,
            0.09548248781986068), 0.8377580409572781);
        double sin_theta_4, cos_theta_4;
        sinew_sincos(theta_limited_2, &sin_theta_4, &cos_theta_4);
        const double C2_y_4_by_theta = 0.014 * cos_theta_4;
        const double C2_x_4 = 0.005 + C2_y_4_by_theta;
        const double t33 = C2_x_4 * C2_x_4;
        const double C2_x_4_by_theta = 0.014 * sin_theta_4;
        const double C2_y_4 = 0.005 - C2_x_4_by_theta;
        const double t34 = C2_y_4 * C2_y_4;
        const double s12_distance_squared_4 = sinew_max(t33 + t34, 1e-10);
        const double s12_margin_4 = 8.1e-05 - s12_distance_squared_4;
        const double s12_length_4 = sinew_sqrt(sinew_max(-s12_margin_4, 1e-10));
        const double s23_x_4 = 0.034 - C2_x_4;
        const double t35 = s23_x_4 * s23_x_4;
        const double s23_distance_squared_4 = sinew_max(t34 + t35, 1e-10);
        const double s23_margin_4 = 6.4e-05 - s23_distance_squared_4;
        const double s23_length_4 = sinew_sqrt(sinew_max(-s23_margin_4, 1e-10));
        const double s23_v_4 = 0.008 * s23_x_4 - C2_y_4 * s23_length_4;
        const double s23_u_4 = 0.008 * C2_y_4 + s23_x_4 * s23_length_4;
        const double t36 = t14 + s12_length_4 + s23_length_4 - 0.008 * sinew_atan2(-s23_v_4,
            s23_u_4);
        const double s12_v_4 = 0.009 * C2_x_4 - C2_y_4 * s12_length_4;
        const double s12_u_4 = 0.009 * C2_y_4 + C2_x_4 * s12_length_4;
        const double spring_y_4 = 0.00964181414529809 * sin_theta_4 + 0.01149066664678467
            * cos_theta_4;
        const double spring_x_4 = 0.00964181414529809 * cos_theta_4 - 0.01149066664678467
            * sin_theta_4;
        const double spring_length_squared_4 = 0.000769 - 0.024 * spring_y_4 + 0.04 * spring_x_4;
        const double spring_length_4 = sinew_sqrt(spring_length_squared_4);
        const double t37 = 1.0 / spring_length_4;
        const double t38 = 6400.0 * (1.0 - 0.018138347076759653 * t37);
        const double spring_moment_4 = 0.012 * spring_x_4 + 0.02 * spring_y_4;
        const double t39 = 1.0 / s12_distance_squared_4;
        const double s12_along_y_4 = s12_v_4 * t39;
        const double t40 = 1.0 / s23_distance_squared_4;
        const double s23_along_y_4 = s23_v_4 * t40;
        const double t41 = s12_along_y_4 + s23_along_y_4;
        const double s12_along_x_4 = s12_u_4 * t39;
        const double s23_along_x_4 = s23_u_4 * t40;
        const double t42 = s12_along_x_4 - s23_along_x_4;
        const double dL_slope_4 = C2_y_4_by_theta * t41 - C2_x_4_by_theta * t42;
        const double dL_safe_slope_4 = sinew_choose(dL_slope_4, sinew_max(dL_slope_4, 1.4e-08),
            sinew_min(dL_slope_4, -1.4e-08));
        const double t43 = 1.0 / dL_safe_slope_4;
        const double force_4 = t38 * spring_moment_4 * t43;
        const double spring_strain_4_by_theta = 0.018138347076759653 * (spring_moment_4 * t37)
            / (spring_length_4 * spring_length_4);
        const double energy_slope_4_by_theta = t38 * (0.012 * spring_y_4 - 0.02 * spring_x_4)
            + 6400.0 * spring_moment_4 * spring_strain_4_by_theta;
        const double t44 = (C2_y_4 + C2_y_4) * C2_y_4_by_theta;
        const double s12_distance_squared_4_by_theta = sinew_choose(-(1e-10 - t33 - t34), -((C2_x_4
            + C2_x_4) * C2_x_4_by_theta + t44), 0.0);
        const double t45 = 0.5 * s12_distance_squared_4_by_theta * sinew_choose(-(1e-10
            + s12_margin_4), 1.0, 0.0);
        const double s12_length_4_by_theta = t45 / s12_length_4;
        const double s12_u_4_by_theta = 0.009 * C2_y_4_by_theta - C2_x_4 * s12_length_4_by_theta
            + s12_length_4 * C2_x_4_by_theta;
        const double s12_along_x_4_by_theta = (s12_u_4_by_theta + s12_along_x_4
            * s12_distance_squared_4_by_theta) * t39;
        const double s23_distance_squared_4_by_theta = sinew_choose(-(1e-10 - t34 - t35), -(t44
            - (s23_x_4 + s23_x_4) * C2_x_4_by_theta), 0.0);
        const double t46 = 0.5 * s23_distance_squared_4_by_theta * sinew_choose(-(1e-10
            + s23_margin_4), 1.0, 0.0);
        const double s23_length_4_by_theta = t46 / s23_length_4;
        const double s23_u_4_by_theta = 0.008 * C2_y_4_by_theta - s23_x_4 * s23_length_4_by_theta
            - s23_length_4 * C2_x_4_by_theta;
        const double s23_along_x_4_by_theta = (s23_u_4_by_theta + s23_along_x_4
            * s23_distance_squared_4_by_theta) * t40;
        const double t47 = C2_x_4_by_theta * (s12_along_x_4_by_theta - s23_along_x_4_by_theta
            - t41);
        const double s23_v_4_by_theta = 0.008 * C2_x_4_by_theta - C2_y_4 * s23_length_4_by_theta
            + s23_length_4 * C2_y_4_by_theta;
        const double s23_along_y_4_by_theta = (s23_v_4_by_theta - s23_along_y_4
            * s23_distance_squared_4_by_theta) * t40;
        const double s12_v_4_by_theta = 0.009 * C2_x_4_by_theta + C2_y_4 * s12_length_4_by_theta
            - s12_length_4 * C2_y_4_by_theta;
        const double s12_along_y_4_by_theta = (s12_v_4_by_theta + s12_along_y_4
            * s12_distance_squared_4_by_theta) * t39;
        const double t48 = C2_y_4_by_theta * (s23_along_y_4_by_theta - s12_along_y_4_by_theta
            - t42);
        const double dL_slope_4_by_theta = t47 + t48;
        const double dL_safe_slope_4_by_theta = sinew_choose(dL_slope_4, dL_slope_4_by_theta
            * sinew_choose(-(1.4e-08 - dL_slope_4), 1.0, 0.0), dL_slope_4_by_theta
            * sinew_choose(-(1.4e-08 + dL_slope_4), 1.0, 0.0));
        const double force_4_by_theta = (energy_slope_4_by_theta + force_4
            * dL_safe_slope_4_by_theta) * t43;
        const double elongation_slope_4 = dL_safe_slope_4 + 5e-05 * force_4_by_theta;
        const double t49 = (t36 + 0.009 * sinew_atan2(s12_v_4, s12_u_4) - 5e-05 * force_4)
            / elongation_slope_4;
        const double theta_limited_4 = sinew_min(sinew_max(theta_limited_2 - t49,
            0.09548248781986068), 0.8377580409572781);
        double sin_theta_6, cos_theta_6;
        sinew_sincos(theta_limited_4, &sin_theta_6, &cos_theta_6);
        const double C2_y_6_by_theta = 0.014 * cos_theta_6;
        const double C2_x_6 = 0.005 + C2_y_6_by_theta;
        const double t50 = C2_x_6 * C2_x_6;
        const double C2_x_6_by_theta = 0.014 * sin_theta_6;
        const double C2_y_6 = 0.005 - C2_x_6_by_theta;
        const double t51 = C2_y_6 * C2_y_6;
        const double s12_distance_squared_6 = sinew_max(t50 + t51, 1e-10);
        const double s12_margin_6 = 8.1e-05 - s12_distance_squared_6;
        const double s12_length_6 = sinew_sqrt(sinew_max(-s12_margin_6, 1e-10));
        const double s23_x_6 = 0.034 - C2_x_6;
        const double t52 = s23_x_6 * s23_x_6;
        const double s23_distance_squared_6 = sinew_max(t51 + t52, 1e-10);
        const double s23_margin_6 = 6.4e-05 - s23_distance_squared_6;
        const double s23_length_6 = sinew_sqrt(sinew_max(-s23_margin_6, 1e-10));
        const double s23_v_6 = 0.008 * s23_x_6 - C2_y_6 * s23_length_6;
        const double s23_u_6 = 0.008 * C2_y_6 + s23_x_6 * s23_length_6;
        const double t53 = t14 + s12_length_6 + s23_length_6 - 0.008 * sinew_atan2(-s23_v_6,
            s23_u_6);
        const double s12_v_6 = 0.009 * C2_x_6 - C2_y_6 * s12_length_6;
        const double s12_u_6 = 0.009 * C2_y_6 + C2_x_6 * s12_length_6;
        const double spring_y_6 = 0.00964181414529809 * sin_theta_6 + 0.01149066664678467
            * cos_theta_6;
        const double spring_x_6 = 0.00964181414529809 * cos_theta_6 - 0.01149066664678467
            * sin_theta_6;
        const double spring_length_squared_6 = 0.000769 - 0.024 * spring_y_6 + 0.04 * spring_x_6;
        const double spring_length_6 = sinew_sqrt(spring_length_squared_6);
        const double t54 = 1.0 / spring_length_6;
        const double t55 = 6400.0 * (1.0 - 0.018138347076759653 * t54);
        const double spring_moment_6 = 0.012 * spring_x_6 + 0.02 * spring_y_6;
        const double t56 = 1.0 / s12_distance_squared_6;
        const double s12_along_y_6 = s12_v_6 * t56;
        const double t57 = 1.0 / s23_distance_squared_6;
        const double s23_along_y_6 = s23_v_6 * t57;
        const double t58 = s12_along_y_6 + s23_along_y_6;
        const double s12_along_x_6 = s12_u_6 * t56;
        const double s23_along_x_6 = s23_u_6 * t57;
        const double t59 = s12_along_x_6 - s23_along_x_6;
        const double dL_slope_6 = C2_y_6_by_theta * t58 - C2_x_6_by_theta * t59;
        const double dL_safe_slope_6 = sinew_choose(dL_slope_6, sinew_max(dL_slope_6, 1.4e-08),
            sinew_min(dL_slope_6, -1.4e-08));
        const double t60 = 1.0 / dL_safe_slope_6;
        const double force_6 = t55 * spring_moment_6 * t60;
        const double spring_strain_6_by_theta = 0.018138347076759653 * (spring_moment_6 * t54)
            / (spring_length_6 * spring_length_6);
        const double energy_slope_6_by_theta = t55 * (0.012 * spring_y_6 - 0.02 * spring_x_6)
            + 6400.0 * spring_moment_6 * spring_strain_6_by_theta;
        const double t61 = (C2_y_6 + C2_y_6) * C2_y_6_by_theta;
        const double s12_distance_squared_6_by_theta = sinew_choose(-(1e-10 - t50 - t51), -((C2_x_6
            + C2_x_6) * C2_x_6_by_theta + t61), 0.0);
        const double t62 = 0.5 * s12_distance_squared_6_by_theta * sinew_choose(-(1e-10
            + s12_margin_6), 1.0, 0.0);
        const double s12_length_6_by_theta = t62 / s12_length_6;
        const double s12_u_6_by_theta = 0.009 * C2_y_6_by_theta - C2_x_6 * s12_length_6_by_theta
            + s12_length_6 * C2_x_6_by_theta;
        const double s12_along_x_6_by_theta = (s12_u_6_by_theta + s12_along_x_6
            * s12_distance_squared_6_by_theta) * t56;
        const double s23_distance_squared_6_by_theta = sinew_choose(-(1e-10 - t51 - t52), -(t61
            - (s23_x_6 + s23_x_6) * C2_x_6_by_theta), 0.0);
        const double t63 = 0.5 * s23_distance_squared_6_by_theta * sinew_choose(-(1e-10
            + s23_margin_6), 1.0, 0.0);
        const double s23_length_6_by_theta = t63 / s23_length_6;
        const double s23_u_6_by_theta = 0.008 * C2_y_6_by_theta - s23_x_6 * s23_length_6_by_theta
            - s23_length_6 * C2_x_6_by_theta;
        const double s23_along_x_6_by_theta = (s23_u_6_by_theta + s23_along_x_6
            * s23_distance_squared_6_by_theta) * t57;
        const double t64 = C2_x_6_by_theta * (s12_along_x_6_by_theta - s23_along_x_6_by_theta
            - t58);
        const double s23_v_6_by_theta = 0.008 * C2_x_6_by_theta - C2_y_6 * s23_length_6_by_theta
            + s23_length_6 * C2_y_6_by_theta;
        const double s23_along_y_6_by_theta = (s23_v_6_by_theta - s23_along_y_6
            * s23_distance_squared_6_by_theta) * t57;
        const double s12_v_6_by_theta = 0.009 * C2_x_6_by_theta + C2_y_6 * s12_length_6_by_theta
            - s12_length_6 * C2_y_6_by_theta;
        const double s12_along_y_6_by_theta = (s12_v_6_by_theta + s12_along_y_6
            * s12_distance_squared_6_by_theta) * t56;
        const double t65 = C2_y_6_by_theta * (s23_along_y_6_by_theta - s12_along_y_6_by_theta
            - t59);
        const double dL_slope_6_by_theta = t64 + t65;
        const double dL_safe_slope_6_by_theta = sinew_choose(dL_slope_6, dL_slope_6_by_theta
            * sinew_choose(-(1.4e-08 - dL_slope_6), 1.0, 0.0), dL_slope_6_by_theta
            * sinew_choose(-(1.4e-08 + dL_slope_6), 1.0, 0.0));
        const double force_6_by_theta = (energy_slope_6_by_theta + force_6
            * dL_safe_slope_6_by_theta) * t60;
        const double elongation_slope_6 = dL_safe_slope_6 + 5e-05 * force_6_by_theta;
        const double t66 = (t53 + 0.009 * sinew_atan2(s12_v_6, s12_u_6) - 5e-05 * force_6)
            / elongation_slope_6;
        const double theta_limited_6 = sinew_min(sinew_max(theta_limited_4 - t66,
            0.09548248781986068), 0.8377580409572781);
        double sin_theta_8, cos_theta_8;
        sinew_sincos(theta_limited_6, &sin_theta_8, &cos_theta_8);
        const double C2_y_8_by_theta = 0.014 * cos_theta_8;
        const double C2_x_8 = 0.005 + C2_y_8_by_theta;
        const double t67 = C2_x_8 * C2_x_8;
        const double C2_x_8_by_theta = 0.014 * sin_theta_8;
        const double C2_y_8 = 0.005 - C2_x_8_by_theta;
        const double t68 = C2_y_8 * C2_y_8;
        const double s12_distance_squared_8 = sinew_max(t67 + t68, 1e-10);
        const double s12_margin_8 = 8.1e-05 - s12_distance_squared_8;
        const double s12_length_8 = sinew_sqrt(sinew_max(-s12_margin_8, 1e-10));
        const double s23_x_8 = 0.034 - C2_x_8;
        const double t69 = s23_x_8 * s23_x_8;
        const double s23_distance_squared_8 = sinew_max(t68 + t69, 1e-10);
        const double s23_margin_8 = 6.4e-05 - s23_distance_squared_8;
        const double s23_length_8 = sinew_sqrt(sinew_max(-s23_margin_8, 1e-10));
        const double s23_v_8 = 0.008 * s23_x_8 - C2_y_8 * s23_length_8;
        const double s23_u_8 = 0.008 * C2_y_8 + s23_x_8 * s23_length_8;
        const double t70 = t14 + s12_length_8 + s23_length_8 - 0.008 * sinew_atan2(-s23_v_8,
            s23_u_8);
        const double s12_v_8 = 0.009 * C2_x_8 - C2_y_8 * s12_length_8;
        const double s12_u_8 = 0.009 * C2_y_8 + C2_x_8 * s12_length_8;
        const double spring_y_8 = 0.00964181414529809 * sin_theta_8 + 0.01149066664678467
            * cos_theta_8;
        const double spring_x_8 = 0.00964181414529809 * cos_theta_8 - 0.01149066664678467
            * sin_theta_8;
        const double spring_length_squared_8 = 0.000769 - 0.024 * spring_y_8 + 0.04 * spring_x_8;
        const double spring_length_8 = sinew_sqrt(spring_length_squared_8);
        const double t71 = 1.0 / spring_length_8;
        const double t72 = 6400.0 * (1.0 - 0.018138347076759653 * t71);
        const double spring_moment_8 = 0.012 * spring_x_8 + 0.02 * spring_y_8;
        const double t73 = 1.0 / s12_distance_squared_8;
        const double s12_along_y_8 = s12_v_8 * t73;
        const double t74 = 1.0 / s23_distance_squared_8;
        const double s23_along_y_8 = s23_v_8 * t74;
        const double t75 = s12_along_y_8 + s23_along_y_8;
        const double s12_along_x_8 = s12_u_8 * t73;
        const double s23_along_x_8 = s23_u_8 * t74;
        const double t76 = s12_along_x_8 - s23_along_x_8;
        const double dL_slope_8 = C2_y_8_by_theta * t75 - C2_x_8_by_theta * t76;
        const double dL_safe_slope_8 = sinew_choose(dL_slope_8, sinew_max(dL_slope_8, 1.4e-08),
            sinew_min(dL_slope_8, -1.4e-08));
        const double t77 = 1.0 / dL_safe_slope_8;
        const double force_8 = t72 * spring_moment_8 * t77;
        const double spring_strain_8_by_theta = 0.018138347076759653 * (spring_moment_8 * t71)
            / (spring_length_8 * spring_length_8);
        const double energy_slope_8_by_theta = t72 * (0.012 * spring_y_8 - 0.02 * spring_x_8)
            + 6400.0 * spring_moment_8 * spring_strain_8_by_theta;
        const double t78 = (C2_y_8 + C2_y_8) * C2_y_8_by_theta;
        const double s12_distance_squared_8_by_theta = sinew_choose(-(1e-10 - t67 - t68), -((C2_x_8
            + C2_x_8) * C2_x_8_by_theta + t78), 0.0);
        const double t79 = 0.5 * s12_distance_squared_8_by_theta * sinew_choose(-(1e-10
            + s12_margin_8), 1.0, 0.0);
        const double s12_length_8_by_theta = t79 / s12_length_8;
        const double s12_u_8_by_theta = 0.009 * C2_y_8_by_theta - C2_x_8 * s12_length_8_by_theta
            + s12_length_8 * C2_x_8_by_theta;
        const double s12_along_x_8_by_theta = (s12_u_8_by_theta + s12_along_x_8
            * s12_distance_squared_8_by_theta) * t73;
        const double s23_distance_squared_8_by_theta = sinew_choose(-(1e-10 - t68 - t69), -(t78
            - (s23_x_8 + s23_x_8) * C2_x_8_by_theta), 0.0);
        const double t80 = 0.5 * s23_distance_squared_8_by_theta * sinew_choose(-(1e-10
            + s23_margin_8), 1.0, 0.0);
        const double s23_length_8_by_theta = t80 / s23_length_8;
        const double s23_u_8_by_theta = 0.008 * C2_y_8_by_theta - s23_x_8 * s23_length_8_by_theta
            - s23_length_8 * C2_x_8_by_theta;
        const double s23_along_x_8_by_theta = (s23_u_8_by_theta + s23_along_x_8
            * s23_distance_squared_8_by_theta) * t74;
        const double t81 = C2_x_8_by_theta * (s12_along_x_8_by_theta - s23_along_x_8_by_theta
            - t75);
        const double s23_v_8_by_theta = 0.008 * C2_x_8_by_theta - C2_y_8 * s23_length_8_by_theta
            + s23_length_8 * C2_y_8_by_theta;
        const double s23_along_y_8_by_theta = (s23_v_8_by_theta - s23_along_y_8
            * s23_distance_squared_8_by_theta) * t74;
        const double s12_v_8_by_theta = 0.009 * C2_x_8_by_theta + C2_y_8 * s12_length_8_by_theta
            - s12_length_8 * C2_y_8_by_theta;
        const double s12_along_y_8_by_theta = (s12_v_8_by_theta + s12_along_y_8
            * s12_distance_squared_8_by_theta) * t73;
        const double t82 = C2_y_8_by_theta * (s23_along_y_8_by_theta - s12_along_y_8_by_theta
            - t76);
        const double dL_slope_8_by_theta = t81 + t82;
        const double dL_safe_slope_8_by_theta = sinew_choose(dL_slope_8, dL_slope_8_by_theta
            * sinew_choose(-(1.4e-08 - dL_slope_8), 1.0, 0.0), dL_slope_8_by_theta
            * sinew_choose(-(1.4e-08 + dL_slope_8), 1.0, 0.0));
        const double force_8_by_theta = (energy_slope_8_by_theta + force_8
            * dL_safe_slope_8_by_theta) * t77;
        const double elongation_slope_8 = dL_safe_slope_8 + 5e-05 * force_8_by_theta;
        const double t83 = (t70 + 0.009 * sinew_atan2(s12_v_8, s12_u_8) - 5e-05 * force_8)
            / elongation_slope_8;
        const double theta_limited_8 = sinew_min(sinew_max(theta_limited_6 - t83,
            0.09548248781986068), 0.8377580409572781);
        double sin_theta_10, cos_theta_10;
        sinew_sincos(theta_limited_8, &sin_theta_10, &cos_theta_10);
        const double C2_y_10_by_theta = 0.014 * cos_theta_10;
        const double C2_x_10 = 0.005 + C2_y_10_by_theta;
        const double t84 = C2_x_10 * C2_x_10;
        const double C2_x_10_by_theta = 0.014 * sin_theta_10;
        const double C2_y_10 = 0.005 - C2_x_10_by_theta;
        const double t85 = C2_y_10 * C2_y_10;
        const double s12_distance_squared_10 = sinew_max(t84 + t85, 1e-10);
        const double s12_margin_10 = 8.1e-05 - s12_distance_squared_10;
        const double s12_length_10 = sinew_sqrt(sinew_max(-s12_margin_10, 1e-10));
        const double s23_x_10 = 0.034 - C2_x_10;
        const double t86 = s23_x_10 * s23_x_10;
        const double s23_distance_squared_10 = sinew_max(t85 + t86, 1e-10);
        const double s23_margin_10 = 6.4e-05 - s23_distance_squared_10;
        const double s23_length_10 = sinew_sqrt(sinew_max(-s23_margin_10, 1e-10));
        const double s23_v_10 = 0.008 * s23_x_10 - C2_y_10 * s23_length_10;
        const double s23_u_10 = 0.008 * C2_y_10 + s23_x_10 * s23_length_10;
        const double t87 = t14 + s12_length_10 + s23_length_10 - 0.008 * sinew_atan2(-s23_v_10,
            s23_u_10);
        const double s12_v_10 = 0.009 * C2_x_10 - C2_y_10 * s12_length_10;
        const double s12_u_10 = 0.009 * C2_y_10 + C2_x_10 * s12_length_10;
        const double spring_y_10 = 0.00964181414529809 * sin_theta_10 + 0.01149066664678467
            * cos_theta_10;
        const double spring_x_10 = 0.00964181414529809 * cos_theta_10 - 0.01149066664678467
            * sin_theta_10;
        const double spring_length_squared_10 = 0.000769 - 0.024 * spring_y_10 + 0.04 * spring_x_10;
        const double spring_length_10 = sinew_sqrt(spring_length_squared_10);
        const double t88 = 1.0 / spring_length_10;
        const double t89 = 6400.0 * (1.0 - 0.018138347076759653 * t88);
        const double spring_moment_10 = 0.012 * spring_x_10 + 0.02 * spring_y_10;
        const double t90 = 1.0 / s12_distance_squared_10;
        const double s12_along_y_10 = s12_v_10 * t90;
        const double t91 = 1.0 / s23_distance_squared_10;
        const double s23_along_y_10 = s23_v_10 * t91;
        const double t92 = s12_along_y_10 + s23_along_y_10;
        const double s12_along_x_10 = s12_u_10 * t90;
        const double s23_along_x_10 = s23_u_10 * t91;
        const double t93 = s12_along_x_10 - s23_along_x_10;
        const double dL_slope_10 = C2_y_10_by_theta * t92 - C2_x_10_by_theta * t93;
        const double dL_safe_slope_10 = sinew_choose(dL_slope_10, sinew_max(dL_slope_10, 1.4e-08),
            sinew_min(dL_slope_10, -1.4e-08));
        const double t94 = 1.0 / dL_safe_slope_10;
        const double force_10 = t89 * spring_moment_10 * t94;
        const double t95 = -limited_elongation;
        const double t96 = sinew_choose(t95, 0.0, t87 + 0.009 * sinew_atan2(s12_v_10, s12_u_10)
            - 5e-05 * force_10);
        const double spring_strain_10_by_theta = 0.018138347076759653 * (spring_moment_10 * t88)
            / (spring_length_10 * spring_length_10);
        const double energy_slope_10_by_theta = t89 * (0.012 * spring_y_10 - 0.02 * spring_x_10)
            + 6400.0 * spring_moment_10 * spring_strain_10_by_theta;
        const double t97 = (C2_y_10 + C2_y_10) * C2_y_10_by_theta;
        const double s12_distance_squared_10_by_theta = sinew_choose(-(1e-10 - t84 - t85),
            -((C2_x_10 + C2_x_10) * C2_x_10_by_theta + t97), 0.0);
        const double t98 = 0.5 * s12_distance_squared_10_by_theta * sinew_choose(-(1e-10
            + s12_margin_10), 1.0, 0.0);
        const double s12_length_10_by_theta = t98 / s12_length_10;
        const double s12_u_10_by_theta = 0.009 * C2_y_10_by_theta - C2_x_10 * s12_length_10_by_theta
            + s12_length_10 * C2_x_10_by_theta;
        const double s12_along_x_10_by_theta = (s12_u_10_by_theta + s12_along_x_10
            * s12_distance_squared_10_by_theta) * t90;
        const double s23_distance_squared_10_by_theta = sinew_choose(-(1e-10 - t85 - t86), -(t97
            - (s23_x_10 + s23_x_10) * C2_x_10_by_theta), 0.0);
        const double t99 = 0.5 * s23_distance_squared_10_by_theta * sinew_choose(-(1e-10
            + s23_margin_10), 1.0, 0.0);
        const double s23_length_10_by_theta = t99 / s23_length_10;
        const double s23_u_10_by_theta = 0.008 * C2_y_10_by_theta - s23_x_10
            * s23_length_10_by_theta - s23_length_10 * C2_x_10_by_theta;
        const double s23_along_x_10_by_theta = (s23_u_10_by_theta + s23_along_x_10
            * s23_distance_squared_10_by_theta) * t91;
        const double t100 = C2_x_10_by_theta * (s12_along_x_10_by_theta - s23_along_x_10_by_theta
            - t92);
        const double s23_v_10_by_theta = 0.008 * C2_x_10_by_theta - C2_y_10 * s23_length_10_by_theta
            + s23_length_10 * C2_y_10_by_theta;
        const double s23_along_y_10_by_theta = (s23_v_10_by_theta - s23_along_y_10
            * s23_distance_squared_10_by_theta) * t91;
        const double s12_v_10_by_theta = 0.009 * C2_x_10_by_theta + C2_y_10 * s12_length_10_by_theta
            - s12_length_10 * C2_y_10_by_theta;
        const double s12_along_y_10_by_theta = (s12_v_10_by_theta + s12_along_y_10
            * s12_distance_squared_10_by_theta) * t90;
        const double t101 = C2_y_10_by_theta * (s23_along_y_10_by_theta - s12_along_y_10_by_theta
            - t93);
        const double dL_slope_10_by_theta = t100 + t101;
        const double dL_safe_slope_10_by_theta = sinew_choose(dL_slope_10, dL_slope_10_by_theta
            * sinew_choose(-(1.4e-08 - dL_slope_10), 1.0, 0.0), dL_slope_10_by_theta
            * sinew_choose(-(1.4e-08 + dL_slope_10), 1.0, 0.0));
        const double force_10_by_theta = (energy_slope_10_by_theta + force_10
            * dL_safe_slope_10_by_theta) * t94;
        const double elongation_slope_10 = dL_safe_slope_10 + 5e-05 * force_10_by_theta;
        out[state] = sinew_choose(t95, 0.0, force_10);
        out[1 * n + state] = sinew_choose(t95, 0.0, force_10_by_theta / elongation_slope_10);
        out[2 * n + state] = theta_limited_8;
        residual[state] = t96;
    }
}
