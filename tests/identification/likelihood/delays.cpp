// SPDX-License-Identifier: GPL-3.0-or-later
// A delay that is long beside the motion's periods is no small deviation: it is searched by what it
// makes of the model's effort, at several lengths.
#include <catch2/catch.hpp>
#include <random>

#include "identification/likelihood/fitted_baseline.h"
#include "identification/likelihood/found_slots.h"
#include "identification/likelihood/slot_verdict.h"
#include "identification/subjects/model_candidates.h"

using namespace sinew::diagnosis;
using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kFrequencies[] = {5.0, 11.0, 23.0, 41.0};  // rad/s

/// A motion of four frequencies, or one of its derivatives.
ArrayXd motion(const ArrayXd& t, int derivative) {
  ArrayXd sum = ArrayXd::Zero(t.size());
  double phase = 0.3;
  for (const double w : kFrequencies) {
    const double quarter = 0.5 * M_PI * derivative;
    sum += std::pow(w, derivative - 1.5) * (w * t + phase + quarter).sin();
    phase += 1.7;
  }
  return sum;
}

Candidate of_motion(const std::string& name, int derivative) {
  Candidate c;
  c.name = name;
  c.place = "motor";
  c.linear.push_back({"size", "", -1e9, 1e9, false, {}});
  c.columns = [derivative](const Recording& r, int, const VectorXd&) -> MatrixXd {
    return MatrixXd(motion(r.time.array(), derivative));
  };
  return c;
}

/// Inertia and damping of a logged motion that is `delay` [s] late, in white noise.
Problem late_by(double delay) {
  constexpr double step = 2e-3;
  Recording log;
  log.step = step;
  log.time = ArrayXd::LinSpaced(15000, 0.0, step * 14999);
  log.q = motion(log.time.array(), 0);
  const ArrayXd then = log.time.array() + delay;
  VectorXd y = 0.02 * motion(then, 2) + 0.1 * motion(then, 1);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.02);
  for (double& value : y) value += noise(random);
  log.target.push_back(y);
  Problem problem;
  problem.training.push_back(std::move(log));
  problem.baseline = {of_motion("inertia", 2), of_motion("damping", 1)};
  // What a spring in the drive adds: the way a delay goes on behind its rate.
  problem.library = {delay_candidate({0, "motor", true}), of_motion("elasticity", 4),
                     of_motion("stiffness", 0)};
  return problem;
}

}  // namespace

// Seen red with the rate of what the model says as a delay's only column: a spring stood beside it.
TEST_CASE("a long delay is found as what it is, and nothing beside it") {
  const double hidden = GENERATE(-0.011, 0.001, 0.0065, 0.0165);
  CAPTURE(hidden);
  const Problem problem = late_by(hidden);
  Settings settings;
  settings.band_hz = 40.0;
  settings.edge_s = 0.2;
  const Design design(problem, settings);
  const Model baseline = fitted_baseline(design);
  const auto found = find_slots(design, settings, baseline, Rivals::asked, {});
  REQUIRE(found->slots.entries.size() == 1);
  CHECK(hypothesis_of(*found, 0).source->name == "delay");
  CHECK(found->model.terms.back().nonlinear(0) == Approx(hidden).margin(2e-4));
}
