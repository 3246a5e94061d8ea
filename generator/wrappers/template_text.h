// SPDX-License-Identifier: GPL-3.0-or-later
// Texts with places to fill, as wrappers are mostly made of.
#pragma once

#include <map>
#include <string>

#include "generator/wrappers/wrapped_model.h"

namespace sinew {

/// `text` with every @NAME@ replaced by what `values` has for NAME, and with @MODEL@, @HASH@ and
/// @SCALAR@ of the model. Throws std::logic_error for a place that has no value.
std::string filled(const std::string& text, const WrappedModel& model,
                   const std::map<std::string, std::string>& values = {});

/// The emitted C and the runtime's headers under `folder` ("source/"). `batch`: the loops over many
/// states, too.
void add_sources(FileSet& files, const WrappedModel& model, const std::string& folder, bool batch);

/// "4", "4x4"; "1" for a number.
std::string shape_text(const WrappedArray& array);

/// Its meaning in a line: "4 [rad] joint positions, in the order of joints".
std::string array_text(const WrappedArray& array);

/// A number that reads back as itself.
std::string number_text(double value);

}  // namespace sinew
