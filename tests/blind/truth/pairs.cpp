// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/pairs.h"

#include <algorithm>
#include <stdexcept>

namespace sinew::trials {
namespace {

/// Of drives and of lone joints alike.
const std::vector<Pairing>& of_any_axis() {
  static const std::vector<Pairing> table = {
      // To and fro at one speed, both are a friction that has two values.
      {"one speed", {{"coulomb_level"}, {"viscous_level"}}, truth::Course::one_speed},
      // Always forward, what friction is more of and what pushes are the same.
      {"one way",
       {{"offset", 0}, {"coulomb_level", 0}, {"coulomb_asymmetry", 0}},
       truth::Course::one_way},
  };
  return table;
}

const std::vector<Pairing>& of_drives() {
  static const std::vector<Pairing> table = {
      {"one load", {{"load_friction", 1}, {"coulomb_level", 1}}, truth::Course::mixed, true},
      {"one load", {{"load_ripple 1"}, {"input_ripple 1"}}, truth::Course::mixed, true},
  };
  return table;
}

const std::vector<Pairing>& of_joints() {
  // At one frequency the acceleration is as large as the way, and against it.
  static const std::vector<Pairing> table = {
      {"one frequency", {{"inertia", -1}, {"spring", 1}}, truth::Course::one_sine, false, true},
  };
  return table;
}

bool has(const Pairing& pairing, const std::string& cause) {
  return cause.empty() || std::any_of(pairing.members.begin(), pairing.members.end(),
                                      [&](const PairMember& m) { return m.cause == cause; });
}

}  // namespace

Pairing draw_pairing(const std::string& plant, const std::string& cause, truth::Draw& draw) {
  if (plant != "drive" && plant != "joint")
    throw std::invalid_argument("pairs are drawn at drives and lone joints, not at '" + plant +
                                "'");
  std::vector<Pairing> from = of_any_axis();
  const auto& own = plant == "drive" ? of_drives() : of_joints();
  from.insert(from.end(), own.begin(), own.end());
  std::erase_if(from, [&](const Pairing& p) { return !has(p, cause); });
  if (from.empty()) throw std::invalid_argument("no pair of '" + plant + "' has '" + cause + "'");
  return from[static_cast<std::size_t>(draw.below(static_cast<int>(from.size())))];
}

}  // namespace sinew::trials
