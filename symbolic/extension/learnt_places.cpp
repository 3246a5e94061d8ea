// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/learnt_places.h"

#include "symbolic/dynamics/coordinates.h"

namespace sinew {

LearntPlaces learnt_places(const Mechanism& mechanism, bool motors) {
  LearntPlaces places;
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    places.push_back({joint.name, PlaceKind::joint, joint.type == JointType::revolute});
  }
  for (std::size_t i = 1; motors && i <= mechanism.tendons.size(); ++i)
    places.push_back({"motor " + std::to_string(i), PlaceKind::joint, true});
  for (const Tendon& tendon : mechanism.tendons)
    places.push_back({tendon_place(tendon.name), PlaceKind::tendon, false});
  for (const Body& body : mechanism.bodies)
    places.push_back({"link " + body.name, PlaceKind::link, false});
  places.push_back({"base", PlaceKind::base, false});
  return places;
}

LearntPlaces learnt_places_of_motor() {
  return {{"motor", PlaceKind::joint, true}};
}

std::string tendon_place(const std::string& name) {
  return "tendon " + name;
}

}  // namespace sinew
