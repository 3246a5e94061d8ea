// SPDX-License-Identifier: GPL-3.0-or-later
// The wrist's emitted C against the lengths of its links, and how it moves the tendons (chapter
// 6).
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "tests/skip.h"
#include "tests/symbolic/hand/model_values.h"
#include "tests/symbolic/hand/palm_pose.h"

using namespace sinew_tests;
using Eigen::Vector3d;

namespace {

/// Largest of the six errors of length [m] of points given as rows A, B, C.
double constraint_error(const Values& rows) {
  const double a = wrist_values().length, b = wrist_values().width, c = wrist_values().thickness;
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

/// Tendons by the layer they lie in: the palm points of equal height.
std::map<double, std::vector<std::size_t>> layers() {
  std::map<double, std::vector<std::size_t>> found;
  for (std::size_t i = 0; i < wrist_values().palm_points.size(); ++i)
    found[wrist_values().palm_points[i].z()].push_back(i);
  return found;
}

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
  for (std::size_t k = 0; k < 3; ++k)
    uncrossed[6 + k] = uncrossed[3 + k] + (k == 1 ? wrist_values().width : 0);
  CHECK(constraint_error(uncrossed) > 1e-3);
}

TEST_CASE("flexion moves the tendons by less than 0.75 mm, abduction linearly", "[wrist]") {
  const Values neutral = call(wrist_catalogue, "tendon_lengths", bars(0, 0));
  double flexion_coupling = 0, least_straight = 1;
  for (const double flexion : {-30.0, 30.0}) {
    const Values h = call(wrist_catalogue, "tendon_lengths", bars(flexion, 0));
    for (std::size_t i = 0; i < h.size(); ++i)
      flexion_coupling = std::max(flexion_coupling, std::abs(h[i] - neutral[i]));
  }
  CAPTURE(flexion_coupling);
  if (is_wrist_of_the_source()) {
    CHECK(flexion_coupling <= 0.75e-3);
    CHECK(flexion_coupling > 0.7e-3);
  } else {
    sinew::test::skip("the model is not the source's wrist, whose bound this is");
  }
  for (const double abduction : {-20.0, -10.0, 10.0, 20.0})
    for (const auto& [height, tendons] : layers()) {
      const Values h = call(wrist_catalogue, "tendon_lengths", bars(0, abduction));
      Values change, distance;
      for (const std::size_t i : tendons) {
        change.push_back(h[i] - neutral[i]);
        distance.push_back(wrist_values().palm_points[i].y());
      }
      least_straight = std::min(least_straight, straightness(distance, change));
      std::swap(change.front(), change.back());  // two tendons exchanged show
      CHECK(straightness(distance, change) < 0.99);
    }
  CAPTURE(least_straight);
  CHECK(least_straight >= 0.99);
}

TEST_CASE("the wrist's feedforward takes up what the wrist changes, rate included", "[wrist]") {
  const double R_motor = wrist_values().motor_radius;
  const Values neutral = call(wrist_catalogue, "tendon_lengths", bars(0, 0)), q = bars(17, -9);
  const Values h = call(wrist_catalogue, "tendon_lengths", q),
               delta = call(wrist_catalogue, "feedforward", q),
               P = call(wrist_catalogue, "tendon_jacobian", q),
               rate = call(wrist_catalogue, "feedforward_rate", joined(q, {0.7, -0.4}));
  for (std::size_t i = 0; i < h.size(); ++i) {
    CHECK(R_motor * delta[i] + h[i] == Approx(neutral[i]).epsilon(1e-14));
    CHECK(R_motor * rate[i] == Approx(-(0.7 * P[2 * i] - 0.4 * P[2 * i + 1])).margin(1e-16));
  }
}
