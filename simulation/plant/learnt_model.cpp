// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/learnt_model.h"

#include <algorithm>

#include "generator/assemble.h"
#include "symbolic/effects/effects.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/hand/hand_mechanism.h"
#include "symbolic/parts/part.h"

namespace sinew {
namespace {

bool any_place_begins(const Identified& identified, const std::string& begin) {
  return std::any_of(identified.effects.begin(), identified.effects.end(),
                     [&](const IdentifiedEffect& e) { return e.place.rfind(begin, 0) == 0; });
}

bool speaks_of_tendons(const Identified& identified) {
  return any_place_begins(identified, tendon_place("")) || speaks_of_motors(identified) ||
         std::any_of(identified.effects.begin(), identified.effects.end(),
                     [](const IdentifiedEffect& e) { return e.effect == "pulley_radius"; });
}

}  // namespace

bool needs_motors(const IdentifiedEffect& entry) {
  return entry.place.starts_with("motor ") ||
         std::any_of(effects().begin(), effects().end(), [&](const Effect& effect) {
           return effect.motor_side && effect.id == entry.effect;
         });
}

std::filesystem::path folder_of_motor(const std::filesystem::path& model) {
  return (model / "").lexically_normal().parent_path().parent_path() / "motor";
}

std::optional<MotorParameters> motor_beside(const std::filesystem::path& model) {
  const std::filesystem::path folder = folder_of_motor(model);
  if (!is_part_folder(folder)) return {};
  const Part part = read_part(folder);
  const MotorParameters* motor = std::get_if<MotorParameters>(&part.parameters);
  return motor ? std::optional(*motor) : std::nullopt;
}

bool speaks_of_motors(const Identified& identified) {
  return std::any_of(identified.effects.begin(), identified.effects.end(), needs_motors);
}

DrivenModel learnt_model(const Mechanism& mechanism, const Identified& identified,
                         const std::filesystem::path& folder) {
  if (mechanism.tendons.empty() || !speaks_of_tendons(identified))
    return driven_model(mechanism, emitted_cost);
  return tendon_driven_model(
      mechanism, speaks_of_motors(identified) ? motor_beside(folder) : std::nullopt, emitted_cost);
}

DrivenModel learnt_model(const Hand& hand, const Identified& identified) {
  return tendon_driven_model(with_identified(held_hand(hand).mechanism, identified), {},
                             emitted_cost);
}

}  // namespace sinew
