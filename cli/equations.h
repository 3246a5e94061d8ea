// SPDX-License-Identifier: GPL-3.0-or-later
// `sinew dump --equations`: a model's equations for people.
#pragma once

#include <string>

#include "cli/models/model_folder.h"

namespace sinew {

/// The document. `format`: latex, mathml or text. Throws std::invalid_argument for another format,
/// and for models that have no such page.
std::string equations_of(const ModelFolder& folder, const std::string& format);

/// The same as a part of an HTML page; of a hand those of its fingers and its wrist. Empty where
/// there are none.
std::string equations_html(const ModelFolder& folder);

}  // namespace sinew
