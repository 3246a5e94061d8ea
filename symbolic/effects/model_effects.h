// SPDX-License-Identifier: GPL-3.0-or-later
// Causes that change the model as a whole instead of adding an effort of their own: gains, delays,
// what the position sensors do to every signal, and the links' own parameters. `model` in their
// terms is the effort of the model under test, a rate or a slope its derivative by time or
// position.
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

#include "symbolic/effects/effect.h"

namespace sinew {

/// A number that identified.toml holds of such a cause.
struct ModelCoefficient {
  std::string name, unit;
  ValueLimits limits = {};
  bool required = true;
};

/// Where such a cause has its place.
enum class ModelPlace { joint, link, base };

struct ModelEffect {
  std::string id;    ///< as identified.toml and findings have it
  std::string name;  ///< as a report says it
  GiNaC::ex effort;
  std::string signature, excitation, experiment;  ///< as in Effect
  std::string limit;                              ///< what a violated limit says; may be empty
  /// What a model can learn of it; none: it is named, and the model stays as it is.
  std::vector<ModelCoefficient> coefficients = {};
  ModelPlace place = ModelPlace::joint;
};

const std::vector<ModelEffect>& model_effects();

/// nullptr where there is none of this identifier.
const ModelEffect* find_model_effect(const std::string& id);

}  // namespace sinew
