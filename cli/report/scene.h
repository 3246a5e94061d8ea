// SPDX-License-Identifier: GPL-3.0-or-later
// What the page draws of a model, as data: frames that move, bodies, joints and the tendons' paths.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/function.h"
#include "symbolic/hand/hand.h"
#include "symbolic/model/mechanism.h"
#include "symbolic/parts/wrist.h"

namespace sinew {

/// A slider of the page.
struct DrawnCoordinate {
  std::string group;   ///< "" or the finger
  std::string label;   ///< name of the joint
  std::string column;  ///< what the coupling matrix's column is called; "" for the label
  std::string unit;    ///< rad, m
  double low = 0.0, high = 0.0, reference = 0.0;
};

/// A drawing. The JSON is what cli/report/page/mechanism.js and drawing.js read: lengths in m,
/// poses [R p] row by row, frames and tendons by number.
struct DrawnScene {
  nlohmann::ordered_json scene;
  std::vector<DrawnCoordinate> coordinates;
  /// Functions that the drawing calls beside those that the model offers, under the names that the
  /// scene uses.
  std::vector<Function> functions;
  /// Coordinates that are the palm's angles, of which the wrist's bar angles follow; empty without.
  std::vector<int> palm;
  double yaw = -1.1, pitch = 0.38;  ///< rad, from where it is seen first
};

/// Tendons by number, joints in the order of the coordinates. `tip_jacobian`: name of the function.
DrawnScene scene_of(const Mechanism& mechanism, const std::string& tip_jacobian);
DrawnScene scene_of(const WristParameters& wrist);
DrawnScene scene_of(const Hand& hand);

}  // namespace sinew
