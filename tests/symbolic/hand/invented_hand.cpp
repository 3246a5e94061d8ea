// SPDX-License-Identifier: GPL-3.0-or-later
// The routing primitives, all combined in hands that no folder of models holds, through the reader,
// the derivation and every pass, against numerics that share nothing with them.
#include "tests/symbolic/hand/invented_hand.h"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>

#include "generator/assemble.h"
#include "generator/evaluate.h"
#include "symbolic/dynamics/lagrangian.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/tendons/functions.h"
#include "tests/symbolic/hand/coupled_check.h"

using namespace sinew;
using namespace sinew_tests;

namespace {

using Matrix = CoupledReference::Matrix;

Mechanism read(const InventedHand& hand) {
  return parse_mechanism({hand.toml, hand.csv, "claw/mechanism.toml", "claw/mass_properties.csv"});
}

/// What is emitted for a mechanism, by its interpreter: the bits of the compiled C.
class Emitted {
 public:
  explicit Emitted(const Mechanism& mechanism)
      : model_(assemble({"claw", "", "", {}}, functions_of(mechanism), {})) {}

  const Graph& graph(const std::string& name) const {
    for (const Graph& graph : model_.functions)
      if (graph.name == name) return graph;
    throw std::out_of_range(name);
  }
  Values operator()(const std::string& name, const Values& inputs) const {
    return evaluate<double>(graph(name), inputs);
  }

 private:
  EmittedModel model_;
};

/// Somewhere in the ranges of an emitted function's argument.
Values sample(const Port& port, std::mt19937& random) {
  Values values;
  for (const Range& range : port.ranges)
    values.push_back(std::uniform_real_distribution<double>(range.low, range.high)(random));
  return values;
}

State random_state(const Emitted& emitted, std::mt19937& random) {
  const Graph &motion = emitted.graph("inverse_dynamics"),
              &stiffness = emitted.graph("joint_stiffness");
  return {sample(motion.inputs[0], random), sample(motion.inputs[1], random),
          sample(motion.inputs[2], random), sample(stiffness.inputs[1], random),
          sample(stiffness.inputs[2], random)};
}

}  // namespace

TEST_CASE("hands invented at random: every primitive combined, against independent numerics",
          "[invented]") {
  for (const unsigned seed : {1u, 2u}) {
    std::mt19937 random(seed);
    const Mechanism claw = read(invented_hand(random));
    const CoupledReference reference(claw);
    REQUIRE(reference.size() == 4);  // of 7 joints
    const Emitted emitted(claw);
    for (int trial = 0; trial < 2; ++trial) {
      const State s = random_state(emitted, random);
      for (const auto& [name, error] : deviations(emitted, reference, s)) {
        INFO("seed " << seed << ", " << name << ": " << error);
        CHECK(error < 1e-12);
      }
      // Christoffel form: C qd + g = bias.
      const Values C = emitted("coriolis_matrix", joined(s.q, s.qd)), g = emitted("gravity", s.q),
                   h = emitted("bias", joined(s.q, s.qd));
      for (std::size_t i = 0; i < 4; ++i) {
        double sum = g[i];
        for (std::size_t j = 0; j < 4; ++j) sum += C[4 * i + j] * s.qd[j];
        CHECK(sum == Approx(h[i]).epsilon(1e-11).margin(1e-12));
      }
      const Values qdd = emitted(
          "forward_dynamics",
          joined(joined(s.q, s.qd), emitted("inverse_dynamics", joined(joined(s.q, s.qd), s.qdd))));
      for (std::size_t i = 0; i < 4; ++i) CHECK(qdd[i] == Approx(s.qdd[i]).epsilon(1e-8));
    }
  }
}

TEST_CASE("planted: a link a thousandth longer, the other branch, a loop the other way round",
          "[invented]") {
  std::mt19937 random(7);
  const Mechanism claw = read(invented_hand(random));
  const Emitted emitted(claw);
  const State s = random_state(emitted, random);
  const auto worst = [&](const Mechanism& other) {
    double largest = 0;
    for (const auto& [name, error] : deviations(emitted, CoupledReference(other), s))
      largest = std::max(largest, error);
    return largest;
  };
  CHECK(worst(claw) < 1e-12);
  Mechanism longer = claw;
  longer.four_bars[0].rocker *= 1.001;
  CHECK(worst(longer) > 1e-5);
  Mechanism branch = claw;
  branch.four_bars[0].branch *= -1;
  CHECK(worst(branch) > 1e-2);
  Mechanism turned = claw;
  turned.couplings[0].ratio *= -1;
  CHECK(worst(turned) > 1e-2);
  Mechanism straight = claw;
  straight.couplings[0].offset = 0.0;
  CHECK(worst(straight) > 1e-2);
  Mechanism routed = claw;
  routed.tendons[0].pulleys[0].radius *= -1;
  CHECK(worst(routed) > 1e-2);
}

TEST_CASE("the Lagrangian differentiated gives the same with four-bars", "[invented]") {
  std::mt19937 random(11);
  const Mechanism claw = read(invented_hand(random));
  const Function textbook = textbook_inverse_dynamics(claw);
  const EmittedModel model = assemble({"claw", "", "", {}}, {textbook}, {});
  const Emitted emitted(claw);
  const State s = random_state(emitted, random);
  const Values inputs = joined(joined(s.q, s.qd), s.qdd),
               by_definition = evaluate<double>(model.functions[0], inputs),
               recursive = emitted("inverse_dynamics", inputs);
  for (std::size_t i = 0; i < recursive.size(); ++i)
    CHECK(recursive[i] == Approx(by_definition[i]).epsilon(1e-10).margin(1e-13));
}

TEST_CASE("positions of an invented hand follow from its tendons' lengths", "[invented]") {
  std::mt19937 random(13);
  const Mechanism claw = read(invented_hand(random));
  const Emitted emitted(claw);
  const Graph& search = emitted.graph("link_position");
  std::uniform_real_distribution<double> off(-0.25, 0.25), tick(-3e-4, 3e-4);
  for (int trial = 0; trial < 10; ++trial) {
    const State s = random_state(emitted, random);
    Values start = s.q, near = s.q;
    for (double& q : start) q += off(random);
    for (double& q : near) q += tick(random);
    const Values h = emitted("tendon_lengths", s.q),
                 found = emitted("link_position", joined(h, start)),
                 warm = emitted("link_position_warm", joined(h, near));
    REQUIRE(found.size() == s.q.size() + 2);
    for (std::size_t i = 0; i < s.q.size(); ++i) {
      CHECK(found[i] == Approx(s.q[i]).margin(1e-6));
      CHECK(warm[i] == Approx(s.q[i]).margin(1e-6));
    }
    CHECK(found.back() == 0.0);
    CHECK(warm.back() == 0.0);
    // One iteration from far away does not arrive, and says so.
    const Values far = emitted("link_position_warm", joined(h, start));
    CHECK(far.back() == 1.0);
    const Values covariance = emitted("link_position_covariance", joined(s.q, {1e-3}));
    const Matrix P = CoupledReference(claw).coupling_matrix(exact(s.q));
    const Eigen::MatrixXd normal = (P.transpose() * P).cast<double>() * 1e6;
    const Eigen::MatrixXd expected = normal.inverse();
    for (Eigen::Index k = 0; k < 16; ++k)
      CHECK(covariance[std::size_t(k)] ==
            Approx(expected(k / 4, k % 4)).epsilon(1e-7).margin(1e-9 * expected.norm()));
    CHECK(covariance.back() == 0.0);
  }
  for (const double wrong : {std::nan(""), 1e300, -1e300})
    for (const double value :
         evaluate<double>(search, Values(std::size_t(search.input_size()), wrong)))
      CHECK(std::isfinite(value));
}

TEST_CASE("tendons that do not determine the joints offer no position", "[invented]") {
  std::mt19937 random(17);
  Mechanism claw = read(invented_hand(random));
  claw.tendons.resize(3);  // of four coordinates
  for (const Function& function : functions_of(claw)) CHECK(function.name != "link_position");
}
