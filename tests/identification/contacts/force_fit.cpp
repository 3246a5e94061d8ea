// SPDX-License-Identifier: GPL-3.0-or-later
// What a force that no log has is worth, against the probability of what it leaves over.
#include "identification/contacts/force_fit.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// One channel that leaves the same over in every sample, to one side and the other.
LeftOver left(Index samples, double residual) {
  LeftOver r;
  r.time = VectorXd::LinSpaced(samples, 0.0, 1.0);
  r.residual = r.explained = r.within_step = r.extrapolated = MatrixXd::Zero(samples, 1);
  for (Index k = 0; k < samples; ++k) r.residual(k, 0) = k % 2 == 0 ? residual : -residual;
  r.counts = MatrixXd::Ones(samples, 1);
  return r;
}

ForceNoise unit_noise(double independent) {
  ForceNoise noise;
  noise.covariance = MatrixXd::Identity(1, 1);
  noise.standing = VectorXd::Zero(1);
  noise.independent = independent;
  noise.price = 8.0;
  return noise;
}

}  // namespace

// Seen red with the deviance alone: what is off by twenty times the noise explained the most.
TEST_CASE("an explanation that is off by more says less of what fits it as well") {
  const ForceNoise noise = unit_noise(1.0);
  LeftOver sure = left(1, 1.0), unsure = sure;
  unsure.explained(0, 0) = 100.0;
  CHECK(log_loss_at(noise, sure, 0) < log_loss_at(noise, unsure, 0));
  sure = left(1, 20.0), unsure = sure;
  unsure.explained(0, 0) = 100.0;
  CHECK(log_loss_at(noise, sure, 0) > log_loss_at(noise, unsure, 0));
}

// Seen red without `extrapolated` in the covariance: a friction that few samples tell was told as a
// push wherever it had been left out.
TEST_CASE("what a model only guesses at where nothing was fitted is no push") {
  constexpr Index samples = 40;
  Disturbances disturbances;
  disturbances.left_over = {left(samples, 10.0)};
  disturbances.list = {{0, 0, samples}};
  ForcePlace place;
  place.name = "joint";
  place.effort = {MatrixXd::Constant(samples, 1, -1.0)};
  CHECK(fit_force(disturbances, unit_noise(1.0), place).forces.front().worth > 1000.0);
  disturbances.left_over.front().extrapolated.setConstant(10.0);
  CHECK(fit_force(disturbances, unit_noise(1.0), place).forces.front().worth < 10.0);
}

// Seen red with the price of a number for every independent sample, as other numbers have it.
TEST_CASE("a force's course costs what the logs narrow of what is expected of it") {
  constexpr double residual = 10.0, independent = 0.5;
  constexpr Index samples = 40;
  Disturbances disturbances;
  disturbances.left_over = {left(samples, residual)};
  disturbances.list = {{0, 0, samples}};
  ForcePlace place;
  place.name = "joint";
  place.effort = {MatrixXd::Constant(samples, 1, -1.0)};
  const ForceFit fit = fit_force(disturbances, unit_noise(independent), place);
  // In units of the noise, a lever arm's 3 % with it; expected is three times the most probable.
  const double square = residual * residual / (1.0 + std::pow(0.03 * residual, 2));
  const double narrowed = 1.0 + 9.0 * (square - 1.0), count = independent * samples;
  CHECK(fit.price == Approx(count * std::log(narrowed)).epsilon(1e-3));
  CHECK(fit.deviance == Approx(count * square / narrowed).epsilon(1e-3));
  CHECK(fit.forces.front().worth ==
        Approx(count * (square - square / narrowed - std::log(narrowed))).epsilon(1e-3));
  CHECK(fit.forces.front().peak == Approx(residual).epsilon(0.02));
}
