// SPDX-License-Identifier: GPL-3.0-or-later
// The closed-form derivations through the whole generator: the optimised graphs, evaluated with the
// emitted C's arithmetic, against 50-digit values of the derivation itself.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include "generator/assemble.h"
#include "generator/evaluate.h"
#include "generator/write.h"
#include "tests/symbolic/parts/differences.h"
#include "tests/symbolic/parts/hand_parameters.h"

using namespace sinew;
using namespace sinew_tests;

namespace {

struct Model {
  std::string name;
  std::vector<Function> functions;
};

std::vector<Model> models() {
  std::vector<Function> wrist = wrist_functions(wrist_parameters());
  wrist.push_back(
      wrist_finger_stiffness(wrist_parameters(), "finger_stiffness", {8, 9, 10, 11}, 4));
  const GuidingParameters guiding = guiding_parameters();
  LinkPositionSettings settings;
  settings.gradient_iterations = 5;  // before the search comes to where rounding decides
  return {{"wrist", wrist},
          {"hmc", four_bar_functions(four_bar_parameters())},
          {"lever", lever_functions(lever_parameters())},
          {"tendon", tendon_force_functions(tendon_parameters(), lever_parameters())},
          {"motor", motor_functions(motor_parameters())},
          {"guiding", {guiding_friction_force(guiding)}},
          {"capstan", {capstan_friction_force(guiding), capstan_transmitted_force(guiding)}},
          {"thumb", link_position_functions(thumb_base_parameters(), settings)}};
}

std::vector<double> sample(const Function& function, std::mt19937& random) {
  std::vector<double> inputs;
  for (const Argument& argument : function.inputs)
    for (const Range& range : argument.ranges)
      inputs.push_back(std::uniform_real_distribution<double>(range.low, range.high)(random));
  return inputs;
}

/// Inputs of a search: lengths that some pose has, and a start near it.
std::vector<double> sample_search(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-0.6, 0.6), off(-0.1, 0.1);
  const double q10 = angle(random), q11 = angle(random);
  std::vector<double> inputs = evaluate(base_tendon_lengths(thumb_base_parameters()), {q10, q11});
  inputs.insert(inputs.end(), {q10 + off(random), q11 + off(random)});
  return inputs;
}

/// What an output of 0 in exact arithmetic is measured against: its unit's size in the hand.
double least_scale(const Output& output) {
  static const std::set<std::string> remainders{"residual", "correction"};
  return remainders.count(output.name) ? 1.0 : 0.0;
}

/// Sine of a hundredfold angle: half an ulp of the angle is 50 ulp of the result.
double allowed(const std::string& model, const std::string& function) {
  if (model == "motor" && function != "friction_torque") return 400;
  return 32;
}

}  // namespace

TEST_CASE("optimised graphs of the derivations agree with 50 digits", "[emitted]") {
  std::mt19937 random(17);
  for (const Model& model : models()) {
    const EmittedModel emitted = assemble({model.name, "", "", {}}, model.functions, {});
    for (std::size_t k = 0; k < model.functions.size(); ++k) {
      const Function& function = model.functions[k];
      std::vector<double> scale, error;
      for (int trial = 0; trial < 12; ++trial) {
        const bool is_search = function.outputs[0].name == "q" && model.name == "thumb";
        const std::vector<double> inputs =
            is_search ? sample_search(random) : sample(function, random);
        std::vector<GiNaC::numeric> exact;
        for (const double input : inputs) exact.push_back(binary_fraction(input));
        const auto found = evaluate(emitted.functions[k], inputs);
        const auto wanted = evaluate_precisely(function, exact);
        REQUIRE(found.size() == wanted.size());
        std::size_t next = 0;
        scale.resize(function.outputs.size());
        error.resize(function.outputs.size());
        for (std::size_t o = 0; o < function.outputs.size(); ++o) {
          scale[o] = std::max(scale[o], least_scale(function.outputs[o]));
          for (std::size_t i = 0; i < function.outputs[o].values.size(); ++i, ++next) {
            scale[o] = std::max(scale[o], std::abs(wanted[next].to_double()));
            error[o] = std::max(
                error[o], std::abs((binary_fraction(found[next]) - wanted[next]).to_double()));
          }
        }
      }
      for (std::size_t o = 0; o < function.outputs.size(); ++o) {
        INFO(model.name << "_" << function.name << " " << function.outputs[o].name);
        CHECK(error[o] <= allowed(model.name, function.name) * 0x1p-53 * scale[o]);
      }
    }
  }
}

TEST_CASE("no constant leaves the range of float", "[emitted]") {
  for (const Model& model : models()) {
    const EmittedModel emitted = assemble({model.name, "", "", {}}, model.functions, {});
    for (const Graph& graph : emitted.functions)
      for (const Node& node : graph.nodes()) {
        if (node.op != Op::constant || node.constant == 0.0) continue;
        INFO(model.name << "_" << graph.name << " " << node.constant);
        CHECK((std::abs(node.constant) > 1e-30 && std::abs(node.constant) < 1e30));
      }
  }
}

TEST_CASE("deriving again gives the same text", "[emitted][slow]") {
  const auto first = models(), second = models();
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto text = emit_files(assemble({first[i].name, "", "", {}}, first[i].functions, {}));
    INFO(first[i].name);
    const bool same =
        text == emit_files(assemble({second[i].name, "", "", {}}, second[i].functions, {}));
    CHECK(same);
  }
}

TEST_CASE("wrist, four-bar and thumb give finite values for any input", "[emitted]") {
  const double inputs[] = {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e308, -1e308, 5e-324, -0.0};
  LinkPositionSettings settings;
  settings.gradient_iterations = 3;
  const std::vector<Function> functions{wrist_pose(wrist_parameters()),
                                        wrist_points(wrist_parameters()),
                                        wrist_palm_angles(wrist_parameters()),
                                        wrist_bar_angles(wrist_parameters()),
                                        wrist_singularity(wrist_parameters()),
                                        wrist_tendon_lengths(wrist_parameters()),
                                        wrist_tendon_hessian(wrist_parameters()),
                                        wrist_feedforward(wrist_parameters()),
                                        four_bar(four_bar_parameters()),
                                        four_bar_locking(four_bar_parameters()),
                                        four_bar_coupler_pose(four_bar_parameters()),
                                        link_position(thumb_base_parameters(), settings),
                                        link_position_gradient(thumb_base_parameters(), settings),
                                        link_position_covariance(thumb_base_parameters(), settings),
                                        lever_angle(lever_parameters()),
                                        lever_state(lever_parameters()),
                                        tendon_force(tendon_parameters(), lever_parameters())};
  const EmittedModel emitted = assemble({"any", "", "", {}}, functions, {});
  std::mt19937 random(23);
  for (std::size_t k = 0; k < functions.size(); ++k) {
    INFO(functions[k].name);
    for (const double value : inputs) {
      std::vector<double> at = sample(functions[k], random);
      for (std::size_t i = 0; i < at.size(); ++i) {
        std::vector<double> one = at;
        one[i] = value;
        CHECK(all_finite(evaluate(emitted.functions[k], one)));
      }
      std::fill(at.begin(), at.end(), value);
      CHECK(all_finite(evaluate(emitted.functions[k], at)));
    }
  }
}
