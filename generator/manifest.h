// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/model.h"

namespace sinew {

/// Text of manifest.json: model, hash, scalar, description, files; names of joints, tendons and
/// frames in the order of the arrays' elements; for every function its arguments, whose names their
/// elements follow ("order"), and operation counts (docs/emitted.md).
std::string emit_manifest(const EmittedModel& model);

}  // namespace sinew
