// SPDX-License-Identifier: GPL-3.0-or-later
// The committed C of every finger, function by function, against independent numerics: the model's
// joints without their couplings by Newton-Euler and tendon paths, the couplings by differences.
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "fifth_catalogue.h"
#include "index_catalogue.h"
#include "middle_catalogue.h"
#include "ring_catalogue.h"
#include "tests/symbolic/hand/coupled_check.h"
#include "tests/symbolic/hand/model_values.h"
#include "thumb_catalogue.h"
#include "thumb_table_5_2_catalogue.h"

using namespace sinew_tests;

namespace {

const sinew_catalogue* const fingers[] = {&index_catalogue, &middle_catalogue,
                                          &ring_catalogue,  &fifth_catalogue,
                                          &thumb_catalogue, &thumb_table_5_2_catalogue};

sinew::Mechanism mechanism_of(const sinew_catalogue& finger) {
  return sinew::read_mechanism(model_folder(finger.model));
}

Model committed(const sinew_catalogue& finger) {
  return [&finger](const std::string& name, const Values& inputs) {
    return call(finger, name, inputs);
  };
}

State random_state(const sinew_catalogue& finger, std::mt19937& random) {
  State state;
  const auto fill = [&](const char* function, int input, Values& values) {
    const sinew_argument& argument = find_function(finger, function)->inputs[input];
    for (int i = 0; i < argument.rows * argument.cols; ++i)
      values.push_back(
          std::uniform_real_distribution<double>(argument.low[i], argument.high[i])(random));
  };
  fill("inverse_dynamics", 0, state.q);
  fill("inverse_dynamics", 1, state.qd);
  fill("inverse_dynamics", 2, state.qdd);
  fill("joint_stiffness", 1, state.f);
  fill("joint_stiffness", 2, state.kt);
  return state;
}

double worst_deviation(const sinew_catalogue& finger, const sinew::Mechanism& mechanism,
                       const State& s) {
  double worst = 0;
  for (const auto& [name, error] : deviations(committed(finger), CoupledReference(mechanism), s))
    worst = std::max(worst, error);
  return worst;
}

}  // namespace

TEST_CASE("every finger's functions are those of independent numerics", "[fingers]") {
  std::mt19937 random(31);
  for (const sinew_catalogue* finger : fingers) {
    const CoupledReference reference(mechanism_of(*finger));
    for (int trial = 0; trial < 2; ++trial) {
      const State s = random_state(*finger, random);
      for (const auto& [name, error] : deviations(committed(*finger), reference, s)) {
        INFO(finger->model << "_" << name << ": " << error);
        CHECK(error < 1e-12);
      }
      const Values tau = call(*finger, "inverse_dynamics", joined(joined(s.q, s.qd), s.qdd)),
                   qdd = call(*finger, "forward_dynamics", joined(joined(s.q, s.qd), tau));
      for (std::size_t i = 0; i < qdd.size(); ++i) CHECK(qdd[i] == Approx(s.qdd[i]).epsilon(1e-9));
    }
  }
}

TEST_CASE("planted: a mass, a loop's ratio and a point moved by a millionth show", "[fingers]") {
  std::mt19937 random(37);
  const State ring = random_state(ring_catalogue, random),
              thumb = random_state(thumb_catalogue, random);
  sinew::Mechanism changed = mechanism_of(ring_catalogue);
  CHECK(worst_deviation(ring_catalogue, changed, ring) < 1e-12);
  changed.couplings[0].ratio *= 1 + 1e-6;
  CHECK(worst_deviation(ring_catalogue, changed, ring) > 1e-9);
  changed = mechanism_of(ring_catalogue);
  changed.bodies[3].mass *= 1 + 1e-6;
  CHECK(worst_deviation(ring_catalogue, changed, ring) > 1e-9);
  changed = mechanism_of(thumb_catalogue);
  changed.tendons[0].straights[0].to.x() *= 1 + 1e-6;
  CHECK(worst_deviation(thumb_catalogue, changed, thumb) > 1e-9);
}

TEST_CASE("covariance of constant couplings is sigma^2 (P^T P)^-1 for every finger", "[fingers]") {
  for (const sinew_catalogue* finger :
       {&index_catalogue, &middle_catalogue, &ring_catalogue, &fifth_catalogue}) {
    const CoupledReference reference(mechanism_of(*finger));
    const CoupledReference::Matrix P =
        reference.coupling_matrix(CoupledReference::Vector::Zero(reference.size()));
    const Eigen::MatrixXd expected = ((P.transpose() * P).cast<double>() * 1e6).inverse();
    const Values covariance = call(*finger, "link_position_covariance", {1e-3});
    const Eigen::Index n = expected.rows();
    for (Eigen::Index k = 0; k < n * n; ++k)
      CHECK(covariance[std::size_t(k)] ==
            Approx(expected(k / n, k % n)).epsilon(1e-10).margin(1e-16));
  }
}
