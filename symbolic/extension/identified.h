// SPDX-License-Identifier: GPL-3.0-or-later
// What logs taught about a model: identified.toml.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "symbolic/extension/learnt_places.h"
#include "symbolic/files/source_location.h"

namespace sinew {

struct IdentifiedValue {
  std::string name;  ///< as the effect declares it
  double value = 0.0;
  double standard_error = 0.0;  ///< 0 where it was given, not estimated
  std::string unit;
};

/// A log that an effect was learnt from.
struct IdentifiedLog {
  std::string file, sha256;
};

/// An effect of symbolic/effects at one place, or "delay" and "direction" (see below).
struct IdentifiedEffect {
  std::string effect;
  std::string place;  ///< joint of a mechanism, "motor" of a motor, "tendon <name>"
  std::vector<IdentifiedValue> shape, coefficients;
  SourceLocation where{};  ///< in identified.toml, where it was read

  /// Throws std::invalid_argument where there is none of this name.
  double coefficient(const std::string& name) const;
};

/// Contents of identified.toml. Besides the effects of the catalogue there are
///   delay      (coefficient delay [s]): the effort acts that much later than it is logged
///   (negative:
///              it was measured later);
///   direction  (shape presliding_length): the direction of friction is a bristle state, not a
///              function of the velocity;
///   torque_constant (coefficient gain_change [1]): the effort is that share larger than logged;
///   pulley_radius (the same): so are all moment arms at a joint.
struct Identified {
  std::vector<IdentifiedEffect> effects;
  std::vector<IdentifiedLog> logs;
  /// By joint, the effort of 1 A [N·m/A, N/A] with which currents were read: given, or fitted to
  /// the first logs. What was learnt there holds with these alone.
  std::map<std::string, double> torque_constants = {};
  bool empty() const { return effects.empty(); }
};

struct Observation;

/// Empty where the folder has no identified.toml. Names, units and limits are those that the
/// effects declare; values are converted to SI. `observation`: of a rig, whose effects these are
/// then; nullptr for what is driven. Throws DescriptionError with all mistakes found.
Identified read_identified(const std::filesystem::path& folder,
                           const Observation* observation = nullptr);
/// Of what is driven, at the places that it has.
Identified read_identified(const std::filesystem::path& folder, const LearntPlaces& places);

/// The same of a text; `name`: of its file, for messages.
Identified parse_identified(const std::string& text, const std::string& name,
                            const Observation& observation);
Identified parse_identified(const std::string& text, const std::string& name,
                            const LearntPlaces& places);

/// TOML text; the same for the same contents.
std::string identified_text(const Identified& identified);

}  // namespace sinew
