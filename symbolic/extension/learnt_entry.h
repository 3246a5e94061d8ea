// SPDX-License-Identifier: GPL-3.0-or-later
// What an entry of identified.toml may say, as its effect declares it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symbolic/effects/effect.h"
#include "symbolic/extension/learnt_places.h"

namespace sinew {

struct Observation;

/// A value of an entry. `unit`: SI.
struct DeclaredValue {
  std::string name, unit;
  ValueLimits limits = {};
  bool required = true;
  std::string or_unit{};           ///< where it is not known whether the joint turns; may be empty
  std::optional<double> before{};  ///< what an entry that does not have it means
};

struct DeclaredEntry {
  PlaceKind place = PlaceKind::joint;
  std::vector<DeclaredValue> shapes, coefficients;
  std::string limit;    ///< what a value beyond its limits says; may be empty
  bool single = false;  ///< once at a place, whatever its shape
};

/// The entry of a driven model's effect: one of the catalogue, one that changes the model as a
/// whole, or "direction". `revolute`: of the joint it is at. Nothing for an unknown one.
std::optional<DeclaredEntry> declared_entry(const std::string& effect, bool revolute);

/// The same at a joint of which it is not known whether it turns.
std::optional<DeclaredEntry> declared_entry(const std::string& effect);

/// All identifiers that declared_entry knows.
std::vector<std::string> declared_effects();

/// The entry of a rig's effect at its place; nothing for an unknown one.
std::optional<DeclaredEntry> declared_entry(const Observation& observation,
                                            const std::string& effect, const std::string& place);

}  // namespace sinew
