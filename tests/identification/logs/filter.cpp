// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/design.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace {

using namespace sinew::diagnosis;
using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kStep = 1e-3;
constexpr double kTurn = 2.0 * std::numbers::pi;

VectorXd sine(double hz, Index n, double late = 0.0) {
  return (kTurn * hz * (kStep * ArrayXd::LinSpaced(n, 0.0, static_cast<double>(n - 1)) - late))
      .sin();
}

/// Largest difference to a reference taken at the instants the outputs are centred on.
double deviation(const DecimatingFilter& filter, const VectorXd& output,
                 const VectorXd& reference) {
  double largest = 0.0;
  for (Index k = 0; k < output.size(); ++k)
    largest = std::max(largest, std::abs(output(k) - reference(centre_sample(filter, k))));
  return largest;
}

}  // namespace

TEST_CASE("the decimating filter keeps the band without any delay") {
  const DecimatingFilter filter = design_decimating_filter(kStep, 40.0);
  REQUIRE(filter.factor == 10);
  for (const double hz : {0.5, 7.0, 25.0, 39.0}) {
    const VectorXd x = sine(hz, 5000);
    CHECK(deviation(filter, filter_decimate(filter, x), x) < 5e-3);
  }
  SECTION("a delay of a single input sample would be seen") {
    const VectorXd late = sine(25.0, 5000, kStep);
    CHECK(deviation(filter, filter_decimate(filter, late), sine(25.0, 5000)) > 0.1);
  }
}

TEST_CASE("what lies beyond the stop edge does not fold into the band") {
  const DecimatingFilter filter = design_decimating_filter(kStep, 40.0);
  for (const double hz : {61.0, 95.0, 160.0, 333.0})
    CHECK(filter_decimate(filter, sine(hz, 5000)).cwiseAbs().maxCoeff() < 5e-3);
}

TEST_CASE("the filter moves a signal by a fraction of a sample and differentiates it") {
  const DecimatingFilter filter = design_decimating_filter(kStep, 40.0);
  const VectorXd x = sine(11.0, 5000);
  CHECK(deviation(filter, filter_decimate(filter, x, 0.37e-3), sine(11.0, 5000, -0.37e-3)) < 5e-3);
  const VectorXd rate = sine(11.0, 5000, -0.25 / 11.0) * (kTurn * 11.0);
  CHECK(deviation(filter, filter_decimate(filter, x, 0.0, 1), rate) < 5e-3 * kTurn * 11.0);
}

TEST_CASE("the derivative smoother is exact on a parabola and right on a sine") {
  const ArrayXd t = ArrayXd::LinSpaced(2000, 0.0, 1.999);
  const Motion parabola = differentiate((0.3 + 0.7 * t - 1.9 * t.square()).matrix(), kStep, 60.0);
  for (const Index i : {500, 1000, 1500}) {
    CHECK(parabola.qd(i, 0) == Approx(0.7 - 3.8 * t(i)).epsilon(1e-6));
    CHECK(parabola.qdd(i, 0) == Approx(-3.8).epsilon(1e-4));
  }
  const Motion swing = differentiate(sine(5.0, 2000), kStep, 60.0);
  CHECK(swing.qdd(1010, 0) == Approx(-std::pow(kTurn * 5.0, 2) * std::sin(kTurn * 5.0 * 1.01))
                                  .margin(3e-4 * std::pow(kTurn * 5.0, 2)));
  // Up to the cutoff: a kernel that ends in a step loses a seventh of the acceleration there, and
  // one that is scaled to be exact on parabolas makes all of it 0.1 % too large.
  for (const double hz : {20.0, 40.0, 55.0}) {
    const Motion fast = differentiate(sine(hz, 2000), kStep, 60.0);
    const double rate = std::pow(kTurn * hz, 2);
    CHECK(fast.qdd(1003, 0) == Approx(-rate * std::sin(kTurn * hz * 1.003)).margin(3e-4 * rate));
  }
}

TEST_CASE("a log shorter than the derivative smoother has the motion of its mirror images") {
  // Seen red where the images of the whole log were its only ones: an exception, and a hand's log
  // with a gap had no report. Half a second at 5 Hz, whose kernel is 0.8 s to each side.
  const ArrayXd t = ArrayXd::LinSpaced(500, 0.0, 0.499);
  const Motion line = differentiate((0.3 + 0.7 * t).matrix(), kStep, 5.0);
  CHECK((line.q.col(0).array() - (0.3 + 0.7 * t)).abs().maxCoeff() < 1e-5);
  CHECK((line.qd.col(0).array() - 0.7).abs().maxCoeff() < 1e-3);
  // From one zero of a sine to another one it goes on as it is.
  const Motion swing = differentiate(sine(2.0, 501), kStep, 5.0);
  CHECK((swing.q - sine(2.0, 501)).cwiseAbs().maxCoeff() < 1e-3);
}

TEST_CASE("a log shorter than the kernel gives no output instead of a wrong one") {
  const DecimatingFilter filter = design_decimating_filter(kStep, 40.0);
  CHECK(filtered_length(filter, 200) == 0);
  CHECK(filter_decimate(filter, VectorXd::Zero(200)).rows() == 0);
}

TEST_CASE("a log sampled much faster than the band is thinned, and nothing in the band changes") {
  constexpr double kFast = 1.0 / 3000.0;
  Problem problem;
  Recording log;
  log.name = "fast";
  log.step = kFast;
  log.time = VectorXd::LinSpaced(9000, 0.0, 8999.0 * kFast);
  log.q = (kTurn * 60.0 * log.time.array()).sin() + 0.3 * (kTurn * 7.0 * log.time.array()).cos();
  log.target = {log.q.col(0)};
  problem.training = {log};
  const Design design(problem, Settings{});
  CHECK(design.recording(0).step == Approx(5.0 * kFast));
  CHECK(design.recording(0).q.rows() < 1800);
  // As given and as thinned it is the same signal, and neither is moved: 60 Hz would show it.
  const VectorXd given = design.filtered(0, log.q),
                 thinned = design.filtered(0, design.recording(0).q);
  CHECK((given - thinned).norm() < 1e-12 * given.norm());
  const VectorXd t = design.at_instants(0, log.time);
  const VectorXd exact = (kTurn * 60.0 * t.array()).sin() + 0.3 * (kTurn * 7.0 * t.array()).cos();
  CHECK((given - exact).norm() < 3e-3 * exact.norm());
  const VectorXd late =
      (kTurn * 60.0 * (t.array() - kFast)).sin() + 0.3 * (kTurn * 7.0 * (t.array() - kFast)).cos();
  CHECK((given - late).norm() > 0.1 * exact.norm());
}
