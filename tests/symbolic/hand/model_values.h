// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of the model files, so that the tests of emitted C follow a change of them.
#pragma once

#include <string>

#include "symbolic/parts/part.h"
#include "symbolic/hand/read_hand.h"
#include "symbolic/model/read_mechanism.h"

namespace sinew_tests {

inline std::string model_folder(const std::string& name) {
  return std::string(SINEW_SOURCE_DIR) + "/models/" + name;
}

inline const sinew::WristParameters& wrist_values() {
  static const auto values =
      std::get<sinew::WristParameters>(sinew::read_part(model_folder("wrist")).parameters);
  return values;
}

/// Whether the wrist still has the lengths of Table 6.1: what the source says of its own wrist in
/// millimetres and degrees holds for no other.
inline bool is_wrist_of_the_source() {
  const sinew::WristParameters& p = wrist_values();
  return p.length == 0.050 && p.width == 0.042 && p.thickness == 0.036;
}

inline const sinew::FourBarParameters& four_bar_values() {
  static const auto values =
      std::get<sinew::FourBarParameters>(sinew::read_part(model_folder("hmc")).parameters);
  return values;
}

/// Signed radius of one pulley.
inline double radius(const std::string& model, const std::string& tendon, std::size_t pulley) {
  for (const sinew::Tendon& each : sinew::read_mechanism(model_folder(model)).tendons)
    if (each.name == tendon) return each.pulleys.at(pulley).radius;
  throw std::out_of_range(model + " has no tendon " + tendon);
}

}  // namespace sinew_tests
