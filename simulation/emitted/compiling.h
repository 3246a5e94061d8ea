// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace sinew {

/// Called with the name of a model that is about to be compiled, and with "" when that has ended;
/// not for what was compiled before (library_cache.h). To be set before anything is compiled.
void on_compiling(std::function<void(const std::string& model)> told);

}  // namespace sinew
