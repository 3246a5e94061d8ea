// SPDX-License-Identifier: GPL-3.0-or-later
// Comma-separated text as rows of cells that know their place.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "symbolic/files/description_error.h"

namespace sinew {

struct TableCell {
  std::string text;  ///< without quotes, and without blanks around it where there are none
  SourceLocation where;
};

struct TableRow {
  std::vector<TableCell> cells;
  SourceLocation where;
};

/// Rows of comma-separated text: a byte order mark, CR LF line ends, quoted cells ("" is a quote
/// inside one), empty lines and lines starting with # are understood. Columns count characters
/// (UTF-8 code points). Reports quotes that do not end or are followed by text.
std::vector<TableRow> read_csv(std::string_view text, const std::string& file, Findings& findings);

}  // namespace sinew
