// SPDX-License-Identifier: GPL-3.0-or-later
// A derivation written down line by line: every partial result gets a name.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/function.h"

namespace sinew {

/// Named intermediates in order of evaluation. A sum with long fractions wants a name of its own
/// before it is multiplied or raised to a power: GiNaC would pull out its common denominator,
/// whatever its size, and not always the same one. Names are made unique by appending a number, so
/// that the same derivation step can be used several times.
class DefinitionList {
 public:
  /// Appends `name := value` and returns its symbol; numbers and symbols come back as they are,
  /// without a definition.
  GiNaC::ex define(const std::string& name, const GiNaC::ex& value);

  const std::vector<Definition>& items() const { return items_; }

  /// Position of the definition of `symbol`; nothing for an input.
  std::optional<std::size_t> position(const GiNaC::ex& symbol) const;

  /// Positions of the definitions that `value` uses directly, ascending.
  std::vector<std::size_t> used_by(const GiNaC::ex& value) const;

 private:
  std::string unique(const std::string& name);

  std::vector<Definition> items_;
  std::map<GiNaC::ex, std::size_t, GiNaC::ex_is_less> positions_;
  std::map<std::string, int> uses_;
};

}  // namespace sinew
