// SPDX-License-Identifier: GPL-3.0-or-later
// The wrist's emitted C against the lengths of its links, and how it moves the tendons (chapter
// 6).
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "tests/hand/palm_pose.h"

using namespace sinew_tests;
using Eigen::Vector3d;

namespace {

constexpr double a = 0.050, b = 0.042, c = 0.036;  // Table 6.1

/// Largest of the six errors of length [m] of points given as rows A, B, C.
double constraint_error(const Values& rows) {
  const Vector3d A(rows.data()), B(rows.data() + 3), C(rows.data() + 6);
  const Vector3d A0(0, b / 2, c), B0(0, 0, 0), C0(0, b, 0);
  const double r = std::sqrt(a * a + b * b + c * c), side = std::hypot(b / 2, c);
  double worst = 0;
  for (const double error :
       {(A - A0).norm() - std::hypot(a, c), (B - B0).norm() - r, (C - C0).norm() - r,
        (A - B).norm() - side, (A - C).norm() - side, (B - C).norm() - b})
    worst = std::max(worst, std::abs(error));
  return worst;
}

/// R² of the best straight line through (x, y).
double straightness(const Values& x, const Values& y) {
  const Eigen::Map<const Eigen::VectorXd> u(x.data(), Eigen::Index(x.size())),
      v(y.data(), Eigen::Index(y.size()));
  const Eigen::VectorXd du = u.array() - u.mean(), dv = v.array() - v.mean();
  return std::pow(du.dot(dv), 2) / (du.squaredNorm() * dv.squaredNorm());
}

/// y of each palm point over both layers, in the order of Table 6.2 [mm].
const Values palm_y = {-11, -10, -8,  -6, -5, -3, -2, 0,  2, 3, 5, 6, 8, 10, 11, 13, 14, 16, 18,
                       -13, -11, -10, -8, -6, -5, -3, -2, 0, 2, 3, 5, 6, 8,  10, 11, 13, 14, 16};

}  // namespace

TEST_CASE("the six link lengths hold on a 1 degree grid of palm angles", "[wrist]") {
  double worst = 0, worst_angle = 0;
  for (int flexion = -30; flexion <= 30; ++flexion)
    for (int abduction = -20; abduction <= 20; ++abduction) {
      const Values q = bars(flexion, abduction);
      worst = std::max(worst, constraint_error(call(wrist_catalogue, "points", q)));
      const Values palm = call(wrist_catalogue, "palm_angles", q);
      worst_angle = std::max({worst_angle, std::abs(palm[0] - flexion * degree),
                              std::abs(palm[1] - abduction * degree)});
    }
  CAPTURE(worst, worst_angle);
  CHECK(worst <= 1e-15);
  CHECK(worst_angle <= 2e-15);
  // The check sees a point a hundred femtometres off, and the uncrossed loop t_C = t_B.
  const Values q = bars(10, 10);
  Values moved = call(wrist_catalogue, "points", q);
  moved[0] += 1e-13;
  CHECK(constraint_error(moved) > 1e-15);
  Values uncrossed = call(wrist_catalogue, "points", q);
  for (std::size_t k = 0; k < 3; ++k) uncrossed[6 + k] = uncrossed[3 + k] + (k == 1 ? b : 0);
  CHECK(constraint_error(uncrossed) > 1e-3);
}

TEST_CASE("flexion moves the tendons by less than 0.75 mm, abduction linearly", "[wrist]") {
  const Values neutral = call(wrist_catalogue, "tendon_lengths", bars(0, 0));
  double flexion_coupling = 0, least_straight = 1;
  for (const double flexion : {-30.0, 30.0}) {
    const Values h = call(wrist_catalogue, "tendon_lengths", bars(flexion, 0));
    for (std::size_t i = 0; i < 38; ++i)
      flexion_coupling = std::max(flexion_coupling, std::abs(h[i] - neutral[i]));
  }
  CHECK(flexion_coupling <= 0.75e-3);
  CHECK(flexion_coupling > 0.7e-3);
  for (const double abduction : {-20.0, -10.0, 10.0, 20.0})
    for (const std::size_t layer : {0u, 19u}) {
      const Values h = call(wrist_catalogue, "tendon_lengths", bars(0, abduction));
      Values change, distance;
      for (std::size_t i = layer; i < layer + 19; ++i) {
        change.push_back(h[i] - neutral[i]);
        distance.push_back(palm_y[i]);
      }
      least_straight = std::min(least_straight, straightness(distance, change));
      std::swap(change[0], change[18]);  // two tendons exchanged show
      CHECK(straightness(distance, change) < 0.99);
    }
  CAPTURE(flexion_coupling, least_straight);
  CHECK(least_straight >= 0.99);
}

TEST_CASE("the wrist's feedforward takes up what the wrist changes, rate included", "[wrist]") {
  const double R_motor = 0.005;
  const Values neutral = call(wrist_catalogue, "tendon_lengths", bars(0, 0)), q = bars(17, -9);
  const Values h = call(wrist_catalogue, "tendon_lengths", q),
               delta = call(wrist_catalogue, "feedforward", q),
               P = call(wrist_catalogue, "tendon_jacobian", q),
               rate = call(wrist_catalogue, "feedforward_rate", joined(q, {0.7, -0.4}));
  for (std::size_t i = 0; i < 38; ++i) {
    CHECK(R_motor * delta[i] + h[i] == Approx(neutral[i]).epsilon(1e-14));
    CHECK(R_motor * rate[i] == Approx(-(0.7 * P[2 * i] - 0.4 * P[2 * i + 1])).margin(1e-16));
  }
}
