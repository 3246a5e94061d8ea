// SPDX-License-Identifier: GPL-3.0-or-later
// The points at which a search tries a shape lie so close that no cause falls between two of them.
#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "identification/regression/design.h"
#include "identification/regression/starting_values.h"
#include "identification/subjects/effect_candidate.h"
#include "symbolic/effects/effects.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;
using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// 20 s at 500 Hz: a Fourier series of so many harmonics of 0.1 Hz, speeds falling with the
/// frequency.
Recording excited(int harmonics) {
  constexpr Index samples = 10000;
  constexpr double step = 2e-3;
  sinew::reference::RandomNumbers random(1);
  Recording log;
  log.name = "excited";
  log.step = step;
  log.time = VectorXd::LinSpaced(samples, 0.0, step * double(samples - 1));
  log.q = log.qd = log.qdd = MatrixXd::Zero(samples, 1);
  for (int harmonic = 1; harmonic <= harmonics; ++harmonic) {
    const double w = 2.0 * std::numbers::pi * 0.1 * harmonic;
    const double size = random.uniform(0.5, 1.5) / (w * std::sqrt(double(harmonic)));
    const Eigen::ArrayXd angle = w * log.time.array() + random.uniform(0.0, 6.28);
    log.q.col(0).array() += size * angle.sin();
    log.qd.col(0).array() += size * w * angle.cos();
    log.qdd.col(0).array() -= size * w * w * angle.sin();
  }
  log.signals["direction"] = log.qd.cwiseSign();
  log.signals["jounce"] = MatrixXd::Zero(samples, 1);
  log.target.push_back(log.qdd.col(0));
  return log;
}

double left_between(const Design& design, const Candidate& c, const VectorXd& one,
                    const VectorXd& next) {
  VectorXd between = one;
  for (Index p = 0; p < one.size(); ++p)
    between(p) = c.nonlinear[std::size_t(p)].logarithmic ? std::sqrt(one(p) * next(p))
                                                         : 0.5 * (one(p) + next(p));
  MatrixXd both(design.columns(c, one).front().rows(), 2);
  both << design.columns(c, one).front(), design.columns(c, next).front();
  const VectorXd x = design.columns(c, between).front();
  return (x - both * both.completeOrthogonalDecomposition().solve(x)).squaredNorm() /
         x.squaredNorm();
}

/// Share of what is half-way between two points of the first shape's grid that both leave over, of
/// most of them: the others at their first point.
double usually_left_between(const char* effect, int harmonics) {
  Problem problem;
  problem.channels = 1;
  problem.training = {excited(harmonics)};
  const Candidate c =
      effect_candidate(find_effect(effect), {0, "joint", true}, scale_of(problem.training, 0));
  Settings settings;
  settings.band_hz = 60.0;
  const Design design(problem, settings);
  const std::vector<VectorXd> grid = starting_values(c);
  const std::size_t stride = grid.size() / std::size_t(c.nonlinear.front().grid);
  std::vector<double> left;
  for (std::size_t i = 0; i + stride < grid.size(); i += stride)
    left.push_back(left_between(design, c, grid[i], grid[i + stride]));
  std::nth_element(left.begin(), left.begin() + Index(left.size() / 2), left.end());
  return left[left.size() / 2];
}

}  // namespace

TEST_CASE("what lies between two points of a shape's grid is made of them") {
  // Seen red with 6 frequencies of a gear's spring, which only fast motion makes swing: 0.69 left.
  constexpr int slow = 30, fast = 200;
  for (const char* effect : {"stribeck", "concave_friction", "friction_drift"}) {
    CAPTURE(effect);
    CHECK(usually_left_between(effect, slow) < 0.3);
  }
  CHECK(usually_left_between("gear_resonance", fast) < 0.3);
}
