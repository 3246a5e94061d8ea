// SPDX-License-Identifier: GPL-3.0-or-later
// Where a command speaks when its one output may be standard output.
#pragma once

#include <cstdio>
#include <string>

namespace sinew {

/// Standard output; standard error where `out` is standard output.
std::FILE* stream_of_report(const std::string& out);

/// Throws std::runtime_error where `out` and the report of --json would share standard output.
void refuse_two_reports(const std::string& out, bool json);

}  // namespace sinew
