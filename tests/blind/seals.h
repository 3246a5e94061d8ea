// SPDX-License-Identifier: GPL-3.0-or-later
// Plants and seals of trials by name and seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/blind/truth/draw_trial.h"

namespace sinew::trials {

inline std::unique_ptr<TrialPlant> plant_of(const std::string& name, std::uint64_t seed) {
  TrialRequest request;
  request.plant = name;
  return draw_plant(request, truth::Draw(seed));
}

/// Draws the trial into the folder.
inline nlohmann::json seal_of(const TrialRequest& request, const std::filesystem::path& folder) {
  return nlohmann::json::parse(draw_trial(request, folder));
}

}  // namespace sinew::trials
