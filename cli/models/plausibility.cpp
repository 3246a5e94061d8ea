// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/models/plausibility.h"

#include <algorithm>

#include "symbolic/files/description_error.h"
#include "symbolic/model/plausibility.h"
#include "symbolic/tendons/pulling.h"

namespace sinew {

std::vector<std::string> plausibility_warnings(const Mechanism& mechanism) {
  std::vector<std::string> warnings;
  for (const Suspicion& each : implausible_bodies(mechanism)) warnings.push_back(to_text(each));
  for (const Suspicion& each : implausible_tendons(mechanism)) warnings.push_back(to_text(each));
  return warnings;
}

std::vector<std::string> plausibility_warnings(const ModelFolder& folder) {
  if (const auto* mechanism = std::get_if<Mechanism>(&folder.model))
    return plausibility_warnings(*mechanism);
  std::vector<std::string> warnings;
  if (const auto* hand = std::get_if<Hand>(&folder.model))
    for (const HandFinger& finger : hand->fingers)
      for (std::string& each : plausibility_warnings(finger.mechanism))
        if (std::find(warnings.begin(), warnings.end(), each) == warnings.end())
          warnings.push_back(std::move(each));
  return warnings;
}

void refuse_if_strict(const std::vector<std::string>& warnings, bool strict) {
  if (strict && !warnings.empty()) throw DescriptionError(warnings);
}

}  // namespace sinew
