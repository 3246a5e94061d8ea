// SPDX-License-Identifier: GPL-3.0-or-later
// What the elements of arrays are called: for the manifest, and for all that is made from it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "generator/graph.h"

namespace sinew {

/// A coordinate of a model: a joint that follows no other one.
struct NamedJoint {
  std::string name;
  std::string type = "revolute";       ///< or "prismatic"
  std::string unit = "rad";            ///< or "m"
  std::string parent = {}, body = {};  ///< the joint moves body against parent; "" where unknown
  std::string source_name = {};        ///< in the file that the model was imported from
  double low = 0.0, high = 0.0;        ///< range [unit]
  double reference = 0.0;              ///< of the reference pose [unit]
  double damping = 0.0;                ///< N m s/rad or N s/m; not part of the emitted dynamics
};

struct NamedTendon {
  std::string name;
  std::vector<std::string> joints = {};  ///< on whose pulleys it lies
  std::vector<std::string> bodies = {};  ///< between whose points it runs straight
};

/// A frame whose pose is offered; the first one is the tip.
struct NamedFrame {
  std::string name, body;
};

/// Which of the lists of names an array's elements follow.
enum class ElementOrder { none, joints, tendons, wrist, joints_and_wrist };

struct Naming {
  std::vector<NamedJoint> joints;
  std::vector<NamedTendon> tendons;
  std::vector<NamedFrame> frames;
  std::vector<std::string> wrist;                ///< bar angles of a hand's wrist
  std::optional<std::array<double, 3>> gravity;  ///< m/s^2, base frame
};

/// The order of the elements of an argument or result of the function called `function`; none where
/// they are no joints' or tendons'.
ElementOrder order_of(const Naming& naming, const std::string& function, const Port& port);

/// "joints", "tendons", "wrist", "joints_and_wrist"; "" for none.
const char* name_of(ElementOrder order);

}  // namespace sinew
