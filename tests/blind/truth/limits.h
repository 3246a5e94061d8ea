// SPDX-License-Identifier: GPL-3.0-or-later
// How large a cause can be at all: written once, with reasons, and not the engine's limits.
#pragma once

#include <string>
#include <vector>

namespace sinew::trials {

struct Limit {
  const char* cause;
  double least, most;  ///< in units of `per`; least >= 0: one sign only
  const char* per;     ///< what of the place it is measured by
  const char* reason;
};

const std::vector<Limit>& limits();

/// Throws std::out_of_range for a cause without an entry.
const Limit& limit_of(const std::string& cause);

/// The table as Markdown.
std::string limits_text();

}  // namespace sinew::trials
