// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols in the place of a mechanism's numbers.
#pragma once

#include <string>
#include <vector>

#include "symbolic/dynamics/lagrangian.h"
#include "symbolic/equations/equations.h"

namespace sinew {

/// How a joint or body is called in a subscript: "20" of "q20", else its name.
std::string subscript_of(const std::string& name);

/// Makes a symbol for every number but 0 and the exact ones that say a direction (±1, quarter
/// turns), and remembers what it stands for.
class SymbolTable {
 public:
  explicit SymbolTable(const Mechanism& mechanism) : mechanism_(mechanism) {}

  /// 0 for 0; `path` is the value's place in the files (Mechanism::provenance).
  GiNaC::ex symbol(const std::string& name, const std::string& meaning, double value,
                   const std::string& unit, const std::string& path);
  /// An argument or a function: a symbol without value.
  GiNaC::symbol variable(const std::string& name, const std::string& meaning,
                         const std::string& unit);

  const std::vector<EquationSymbol>& entries() const { return entries_; }

 private:
  const Mechanism& mechanism_;
  std::vector<EquationSymbol> entries_;
};

/// Origins, axes, masses, centres of mass, inertias and gravity.
MechanismValues named_values(const Mechanism& mechanism, SymbolTable& table);

}  // namespace sinew
