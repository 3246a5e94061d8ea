// SPDX-License-Identifier: GPL-3.0-or-later
// Where a model can have learnt something: the places that entries of identified.toml name.
#pragma once

#include <string>
#include <vector>

#include "symbolic/model/mechanism.h"

namespace sinew {

enum class PlaceKind { joint, tendon, link, base };

struct LearntPlace {
  std::string name;  ///< "q21", "motor 3", "tendon flexor", "link distal", "base"
  PlaceKind kind = PlaceKind::joint;
  bool revolute = true;  ///< of a joint: its position is an angle, its effort a torque
};

using LearntPlaces = std::vector<LearntPlace>;

/// Joints that follow no other one, tendons, links and the base; `motors`: one for each tendon.
LearntPlaces learnt_places(const Mechanism& mechanism, bool motors);

/// "motor", of a model that is one.
LearntPlaces learnt_places_of_motor();

/// How identified.toml calls a tendon: "tendon <name>".
std::string tendon_place(const std::string& name);

}  // namespace sinew
