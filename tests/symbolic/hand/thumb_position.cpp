// SPDX-License-Identifier: GPL-3.0-or-later
// Link positions and their noise from the emitted C (5.4.3, (5.24)).
#include <Eigen/Core>
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "index_catalogue.h"
#include "tests/symbolic/hand/emitted_call.h"
#include "thumb_catalogue.h"
#include "thumb_table_5_2_catalogue.h"

using namespace sinew_tests;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

Values base_lengths(double q10, double q11) {
  Values h = call(thumb_catalogue, "tendon_lengths", {q10, q11, 0, 0});
  h.resize(4);
  return h;
}

double error(const Values& found, double q10, double q11) {
  return std::max(std::abs(found[0] - q10), std::abs(found[1] - q11));
}

/// Root mean square [rad] of the position error with noise on the lengths, and what the covariance
/// foretells, over a grid up to `limit` degrees in both angles.
struct NoiseFloor {
  double found = 0, foretold = 0;
};

NoiseFloor noise_floor(const sinew_catalogue& thumb, double sigma, int limit) {
  std::mt19937 random(21);
  std::normal_distribution<double> noise(0, sigma);
  NoiseFloor sum;
  int count = 0;
  for (int repeat = 0; repeat < 5; ++repeat)
    for (int i = -limit; i <= limit; i += 5)
      for (int j = -limit; j <= limit; j += 5) {
        Values h = call(thumb, "tendon_lengths", {i * degree, j * degree, 0, 0});
        h.resize(4);
        for (double& length : h) length += noise(random);
        const Values q = call(thumb, "link_position", joined(h, {0, 0}));
        const Values c = call(thumb, "link_position_covariance", {i * degree, j * degree, sigma});
        CHECK(c[1] == c[2]);
        CHECK(c[4] == 0.0);
        sum.found += std::pow(q[0] - i * degree, 2) + std::pow(q[1] - j * degree, 2);
        sum.foretold += c[0] + c[3];
        count += 2;
      }
  return {std::sqrt(sum.found / count), std::sqrt(sum.foretold / count)};
}

}  // namespace

TEST_CASE("Levenberg-Marquardt: 4 iterations from (0, 0) over 40 degrees", "[thumb]") {
  double worst = 0;
  for (int i = -40; i <= 40; i += 2)
    for (int j = -40; j <= 40; j += 2) {
      const Values q = call(thumb_catalogue, "link_position",
                            joined(base_lengths(i * degree, j * degree), {0, 0}));
      worst = std::max(worst, error(q, i * degree, j * degree));
      CHECK(q[3] == 0.0);
    }
  CAPTURE(worst);
  CHECK(worst <= 1e-6);
  // One iteration from (0, 0) is not enough, and says so.
  const Values far = call(thumb_catalogue, "link_position_warm",
                          joined(base_lengths(40 * degree, 40 * degree), {0, 0}));
  CHECK(error(far, 40 * degree, 40 * degree) > 1e-6);
  CHECK(far[3] == 1.0);
}

TEST_CASE("one iteration a tick follows 1 rad/s at 3 kHz", "[thumb]") {
  Values last{-0.6, -0.5};
  double worst = 0;
  for (int tick = 0; tick < 3000; ++tick) {
    const double t = tick / 3000.0, q10 = -0.6 + t, q11 = -0.5 + t;
    Values q = call(thumb_catalogue, "link_position_warm", joined(base_lengths(q10, q11), last));
    worst = std::max(worst, error(q, q10, q11));
    CHECK(q[3] == 0.0);
    last = {q[0], q[1]};
  }
  CAPTURE(worst);
  CHECK(worst <= 1e-6);
}

TEST_CASE("Algorithm 1, an iteration a tick, says when it has arrived", "[thumb]") {
  const double q10 = 25 * degree, q11 = -30 * degree;
  const Values h = base_lengths(q10, q11);
  Values search{0, 0, 0, 0, 300, 1};  // gradient 0 and a cost above any: the start
  int iterations = 0;
  const auto arrived = [&] {
    return call(thumb_catalogue, "link_position_status", joined(h, {search[0], search[1]}))[1] == 0;
  };
  CHECK_FALSE(arrived());
  for (; iterations < 200 && (iterations == 0 || !arrived()); ++iterations)
    search = call(thumb_catalogue, "link_position_gradient_step", joined(h, search));
  CAPTURE(iterations, error(search, q10, q11));
  CHECK(arrived());
  CHECK(iterations > 10);  // Levenberg-Marquardt: 4
  CHECK(iterations < 100);
  CHECK(error(search, q10, q11) < 2e-6);
  // From there one iteration follows the next tick.
  const double moved = q10 + 1.0 / 3000;
  const Values next = base_lengths(moved, q11);
  CHECK(call(thumb_catalogue, "link_position_status", joined(next, {search[0], search[1]}))[1] ==
        1.0);
}

TEST_CASE("noise floor of the thumb's base, as its covariance foretells", "[thumb]") {
  for (const double sigma : {0.5e-3, 1e-3})
    for (const sinew_catalogue* thumb : {&thumb_catalogue, &thumb_table_5_2_catalogue})
      for (const int limit : {30, 40}) {
        const NoiseFloor floor = noise_floor(*thumb, sigma, limit);
        CAPTURE(thumb->model, sigma, limit, floor.found, floor.foretold);
        CHECK(floor.found == Approx(floor.foretold).epsilon(0.06));
      }
  // Table 5.2's insertions within 30 degrees: 0.010 and 0.021 rad. The default ones pay 8 % more
  // there for a base that stays in equilibrium at large angles.
  CHECK(noise_floor(thumb_table_5_2_catalogue, 0.5e-3, 30).foretold == Approx(0.0104).margin(1e-4));
  CHECK(noise_floor(thumb_table_5_2_catalogue, 1e-3, 30).foretold == Approx(0.0208).margin(1e-4));
  CHECK(noise_floor(thumb_catalogue, 1e-3, 30).foretold == Approx(0.0225).margin(1e-4));
}

TEST_CASE("hinges behind the thumb's base", "[thumb]") {
  Values h = call(thumb_catalogue, "tendon_lengths", {0.3, -0.2, 0.7, 1.1});
  h.erase(h.begin(), h.begin() + 4);
  const Values q = call(thumb_catalogue, "hinge_position", h);
  CHECK(q[0] == Approx(0.7).epsilon(1e-14));
  CHECK(q[1] == Approx(1.1).epsilon(1e-14));
}

TEST_CASE("covariance of a constant coupling is sigma^2 (P^T P)^-1", "[fingers]") {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Values P = call(index_catalogue, "coupling_matrix", {0, 0, 0, 0});
  const Matrix coupling = Eigen::Map<const Matrix>(P.data(), 8, 4);
  const Matrix expected = 1e-6 * (coupling.transpose() * coupling).inverse();
  const Values c = call(index_catalogue, "link_position_covariance", {1e-3});
  for (Eigen::Index k = 0; k < 16; ++k)
    CHECK(c[std::size_t(k)] == Approx(expected(k / 4, k % 4)).epsilon(1e-12).margin(1e-18));
}

TEST_CASE("second derivatives of the thumb's lengths equal differences", "[thumb]") {
  const Values q{0.4, -0.3, 0.2, 0.9};
  const Values H = call(thumb_catalogue, "tendon_hessian", q);
  const double step = 1e-3;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto P = [&](double move) {
      Values at = q;
      at[k] += move;
      return call(thumb_catalogue, "coupling_matrix", at);
    };
    const Values a = P(step), b = P(-step), c = P(2 * step), d = P(-2 * step);
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        const double slope =
            (8 * (a[4 * i + j] - b[4 * i + j]) - (c[4 * i + j] - d[4 * i + j])) / (12 * step);
        CHECK(H[16 * i + 4 * j + k] == Approx(slope).epsilon(1e-9).margin(1e-12));
      }
  }
}
