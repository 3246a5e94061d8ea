// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/model.h"

namespace sinew {

/// Text of manifest.json: model, hash, scalar, files, and for every function its arguments and
/// operation counts.
std::string emit_manifest(const EmittedModel& model);

}  // namespace sinew
