// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/link_position.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <random>

#include "tests/symbolic/parts/differences.h"
#include "tests/symbolic/parts/hand_parameters.h"

using namespace sinew;
using namespace sinew_tests;
using Eigen::AngleAxisd;
using Eigen::Translation3d;
using Eigen::Vector3d;

namespace {

std::vector<double> with_start(std::vector<double> h, double q10, double q11) {
  h.push_back(q10);
  h.push_back(q11);
  return h;
}

/// Largest distance from the truth [rad] over a grid of ±40°, starting `off` away from each point,
/// or at (0, 0) where off is negative.
double worst_error(const Function& estimate, double off) {
  const Function lengths = base_tendon_lengths(thumb_base_parameters());
  double worst = 0;
  for (int i = -40; i <= 40; i += 10)
    for (int j = -40; j <= 40; j += 10) {
      const double q10 = i * degree, q11 = j * degree;
      const std::vector<double> h = evaluate(lengths, {q10, q11});
      const auto q = off < 0 ? evaluate(estimate, with_start(h, 0, 0))
                             : evaluate(estimate, with_start(h, q10 + off, q11 - off));
      worst = std::max(worst, std::hypot(q[0] - q10, q[1] - q11));
      if (q[3] == 0.0) CHECK(q[2] <= 1e-6);
    }
  return worst;
}

}  // namespace

TEST_CASE("base tendons are as long as the straight lines between their points",
          "[link_position]") {
  ThumbBaseParameters p = thumb_base_parameters();
  p.offset = 0.003;
  p.free_lengths = {0.1, 0.2, 0.3, 0.4};
  const Function lengths = base_tendon_lengths(p);
  for (const double q10 : {-0.6, 0.0, 0.3})
    for (const double q11 : {-0.5, 0.1, 0.7}) {
      const Eigen::Isometry3d T =
          AngleAxisd(q10, Vector3d::UnitZ()) * AngleAxisd(90 * degree, Vector3d::UnitX()) *
          Translation3d(p.offset, 0, 0) * AngleAxisd(q11, Vector3d::UnitZ()) *
          AngleAxisd(-90 * degree, Vector3d::UnitX()) * Translation3d(p.length, 0, 0);
      const auto h = evaluate(lengths, {q10, q11});
      for (std::size_t i = 0; i < 4; ++i)
        CHECK(h[i] == Approx((T * p.distal_points[i] - p.base_points[i]).norm() + p.free_lengths[i])
                          .epsilon(1e-14));
    }
}

TEST_CASE("Levenberg-Marquardt finds the base angles in four iterations", "[link_position]") {
  const ThumbBaseParameters p = thumb_base_parameters();
  LinkPositionSettings settings;
  CHECK(worst_error(link_position(p, settings), -1) <= 1e-6);
  settings.iterations = 2;  // too few: seen as such
  CHECK(worst_error(link_position(p, settings), -1) > 1e-6);
  // From the last tick, at 1 rad/s and 3 kHz, one iteration is enough.
  settings.iterations = 1;
  CHECK(worst_error(link_position(p, settings), 1.0 / 3000) <= 1e-6);
}

TEST_CASE("status says when the search has not converged", "[link_position]") {
  const ThumbBaseParameters p = thumb_base_parameters();
  LinkPositionSettings settings;
  const auto h = evaluate(base_tendon_lengths(p), {0.6, -0.5});
  CHECK(evaluate(link_position(p, settings), with_start(h, 0, 0))[3] == 0.0);
  settings.iterations = 1;
  CHECK(evaluate(link_position(p, settings), with_start(h, 0, 0))[3] == 1.0);
  settings.gradient_iterations = 5;
  CHECK(evaluate(link_position_gradient(p, settings), with_start(h, 0, 0))[3] == 1.0);
}

TEST_CASE("corrected gradient search converges in 45 iterations", "[link_position]") {
  const ThumbBaseParameters p = thumb_base_parameters();
  LinkPositionSettings settings;
  settings.gradient_iterations = 45;
  CHECK(worst_error(link_position_gradient(p, settings), -1) <= 1e-6);
}

TEST_CASE("the gradient search taken step by step is the same search", "[link_position]") {
  const ThumbBaseParameters p = thumb_base_parameters();
  LinkPositionSettings settings;
  settings.gradient_iterations = 12;
  const auto h = evaluate(base_tendon_lengths(p), {0.5, 0.4});
  const auto whole = evaluate(link_position_gradient(p, settings), with_start(h, 0.05, -0.1));
  const Function step = link_position_gradient_step(p, settings);
  std::vector<double> state{0.05, -0.1, 0, 0, settings.gradient_step, 1.0};
  for (int i = 0; i < 13; ++i) {  // the first one only looks where it stands
    std::vector<double> inputs = h;
    inputs.insert(inputs.end(), state.begin(), state.end());
    const auto next = evaluate(step, inputs);
    CHECK(next[5] <= state[5]);
    state = next;
  }
  CHECK(state[0] == Approx(whole[0]).epsilon(1e-12));
  CHECK(state[1] == Approx(whole[1]).epsilon(1e-12));
}

TEST_CASE("scatter of the estimate is what the covariance says", "[link_position]") {
  const ThumbBaseParameters p = thumb_base_parameters();
  const LinkPositionSettings settings;
  const Function estimate = link_position(p, settings),
                 covariance = link_position_covariance(p, settings);
  const double q10 = 0.3, q11 = -0.2, sigma = 1e-4;
  const auto h = evaluate(base_tendon_lengths(p), {q10, q11}),
             C = evaluate(covariance, {q10, q11, sigma});
  CHECK(C[1] == C[2]);
  CHECK(C[4] == 0.0);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, sigma);
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  constexpr int trials = 600;
  for (int i = 0; i < trials; ++i) {
    std::vector<double> noisy = h;
    for (double& length : noisy) length += noise(random);
    const auto q = evaluate(estimate, with_start(noisy, q10, q11));
    const Eigen::Vector2d error(q[0] - q10, q[1] - q11);
    scatter += error * error.transpose() / trials;
  }
  // Four standard errors of a variance from 600 trials.
  CHECK(scatter(0, 0) == Approx(C[0]).epsilon(0.23));
  CHECK(scatter(1, 1) == Approx(C[3]).epsilon(0.23));
  // Per joint, at 0.5 and 1 mm.
  for (const double millimetres : {0.5, 1.0}) {
    const auto floor = evaluate(covariance, {0.0, 0.0, millimetres * 1e-3});
    CHECK(std::sqrt((floor[0] + floor[3]) / 2) == Approx(0.022 * millimetres).epsilon(0.05));
  }
}

TEST_CASE("base angles stay finite for impossible lengths", "[link_position]") {
  const ThumbBaseParameters p = thumb_base_parameters();
  const LinkPositionSettings settings;
  const Function estimate = link_position(p, settings),
                 covariance = link_position_covariance(p, settings);
  for (const std::vector<double>& h :
       {std::vector<double>{0, 0, 0, 0}, {1e6, -1e6, 1e6, 3}, {0.05, 0.05, 0.05, 9}})
    CHECK(all_finite(evaluate(estimate, with_start(h, 20, -30))));
  CHECK(evaluate(estimate, with_start({0.05, 0.05, 0.05, 9}, 0, 0))[3] == 1.0);
  CHECK(all_finite(evaluate(covariance, {1e3, -1e3, 1})));
  // Both joints on one tendon: nothing to tell them apart.
  ThumbBaseParameters blind = p;
  for (auto& point : blind.base_points) point = p.base_points[0];
  for (auto& point : blind.distal_points) point = p.distal_points[0];
  const auto C = evaluate(link_position_covariance(blind, settings), {0.1, 0.2, 1e-3});
  CHECK(C[4] == 1.0);
  CHECK(all_finite(C));
  blind.distal_points.pop_back();
  CHECK_THROWS_AS(link_position(blind, settings), std::invalid_argument);
}
