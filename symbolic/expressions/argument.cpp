// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/argument.h"

namespace sinew {

Argument scalar_argument(const std::string& name, const std::string& unit, const Range& range,
                         const std::string& doc) {
  return {name, 1, 1, {GiNaC::symbol(name)}, unit, doc, {range}, {}, true};
}

Argument array_argument(const std::string& name, int rows, int cols, const std::string& unit,
                        const Range& range, const std::string& doc) {
  Argument argument{name, rows, cols, {}, unit, doc, {}};
  for (int i = 0; i < rows * cols; ++i) {
    argument.symbols.emplace_back(name + "_" + std::to_string(i));
    argument.ranges.push_back(range);
  }
  return argument;
}

}  // namespace sinew
