// SPDX-License-Identifier: GPL-3.0-or-later
// names.toml: what joints and links are called in the file that a model was imported from, where
// that is no identifier. Logs and scenarios may use those names.
#pragma once

#include <string>
#include <string_view>

#include "symbolic/files/description_error.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// The text of names.toml: [joint] and [link] with `identifier = "name in the source"`; "" where no
/// joint and no body has another name there.
std::string source_names_text(const Mechanism& mechanism);

/// Sets `source_name` of joints and bodies from that text ("" sets none). Reports unknown
/// identifiers, values that are no text, and two joints or links of one name.
void set_source_names(std::string_view text, const std::string& file, Mechanism& mechanism,
                      Findings& findings);

}  // namespace sinew
