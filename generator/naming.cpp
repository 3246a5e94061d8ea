// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/naming.h"

#include <set>

namespace sinew {
namespace {

bool is_of_joints(const std::string& function, const std::string& port) {
  static const std::set<std::string> always{"q", "qd", "qdd", "tau", "q_start", "load", "effort"};
  // h is the bias of the dynamics, and elsewhere a length of tendons; g is gravity's torque.
  if (port == "h") return function == "bias" || function == "mass_matrix_and_bias";
  if (port == "g") return function == "gravity";
  return always.count(port) != 0;
}

bool is_of_tendons(const std::string& function, const std::string& port) {
  static const std::set<std::string> always{"f",       "kt",          "k",
                                            "tension", "delta_theta", "delta_theta_rate"};
  if (port == "h") return function != "bias" && function != "mass_matrix_and_bias";
  if (port == "angles") return function == "bending_angles";
  return always.count(port) != 0;
}

}  // namespace

ElementOrder order_of(const Naming& naming, const std::string& function, const Port& port) {
  if (port.cols != 1) return ElementOrder::none;
  const auto rows = static_cast<std::size_t>(port.rows);
  if (is_of_tendons(function, port.name) && rows == naming.tendons.size())
    return ElementOrder::tendons;
  if ((port.name == "q_wrist" || port.name == "qd_wrist") && rows == naming.wrist.size())
    return ElementOrder::wrist;
  if (!is_of_joints(function, port.name)) return ElementOrder::none;
  if (rows == naming.joints.size()) return ElementOrder::joints;
  if (!naming.wrist.empty() && rows == naming.joints.size() + naming.wrist.size())
    return ElementOrder::joints_and_wrist;
  return ElementOrder::none;
}

const char* name_of(ElementOrder order) {
  switch (order) {
    case ElementOrder::joints:
      return "joints";
    case ElementOrder::tendons:
      return "tendons";
    case ElementOrder::wrist:
      return "wrist";
    case ElementOrder::joints_and_wrist:
      return "joints_and_wrist";
    case ElementOrder::none:
      break;
  }
  return "";
}

}  // namespace sinew
