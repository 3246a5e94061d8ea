// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnosis of a lever, a tendon or a wrist from its folder.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/models/model_folder.h"
#include "identification/adoption/diagnose_observed.h"

namespace sinew {

/// The request's rig, logs and kind for a part whose sensors a model predicts; nothing for any
/// other model.
std::optional<diagnosis::ObservedRequest> rig_request(const ModelFolder& folder,
                                                      const std::vector<std::string>& logs,
                                                      const std::vector<std::string>& holdout,
                                                      const std::vector<std::string>& map);

}  // namespace sinew
