// SPDX-License-Identifier: GPL-3.0-or-later
// What of a model can be and hardly is: warnings, or mistakes with --strict.
#pragma once

#include <string>
#include <vector>

#include "cli/models/model_folder.h"

namespace sinew {

/// Of a mechanism, each as "file:line:column: text" (symbolic/model/plausibility.h,
/// symbolic/tendons/pulling.h); empty where all is plausible.
std::vector<std::string> plausibility_warnings(const Mechanism& mechanism);

/// Of the model of a folder: of a hand those of its fingers, each once. Parts have none.
std::vector<std::string> plausibility_warnings(const ModelFolder& folder);

/// Throws DescriptionError with the warnings where there are any and `strict` is set.
void refuse_if_strict(const std::vector<std::string>& warnings, bool strict);

}  // namespace sinew
