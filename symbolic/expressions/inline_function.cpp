// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/inline_function.h"

#include <stdexcept>

namespace sinew {

using GiNaC::ex;

std::vector<std::vector<ex>> inlined(DefinitionList& list, const Function& function,
                                     const std::vector<ex>& inputs) {
  GiNaC::exmap known;
  std::size_t used = 0;
  for (const Argument& argument : function.inputs)
    for (const GiNaC::symbol& symbol : argument.symbols) {
      if (used == inputs.size()) throw std::invalid_argument(function.name + ": too few inputs");
      known[symbol] = inputs[used++];
    }
  if (used != inputs.size()) throw std::invalid_argument(function.name + ": too many inputs");
  const auto replaced = [&](const ex& value) {
    return value.subs(known, GiNaC::subs_options::no_pattern);
  };
  for (const Definition& definition : function.definitions)
    known[definition.symbol] =
        list.define(definition.symbol.get_name(), replaced(definition.value));
  std::vector<std::vector<ex>> results;
  for (const Output& output : function.outputs) {
    std::vector<ex> values;
    for (const ex& value : output.values) values.push_back(replaced(value));
    results.push_back(std::move(values));
  }
  return results;
}

}  // namespace sinew
