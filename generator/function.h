// SPDX-License-Identifier: GPL-3.0-or-later
// The only type handed over from symbolic/ to the generator.
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

#include "generator/range.h"

namespace sinew {

/// One argument of an emitted function; row-major, `rows * cols` symbols.
struct Argument {
  std::string name;  ///< C identifier
  int rows = 1;
  int cols = 1;
  std::vector<GiNaC::symbol> symbols;  ///< size rows*cols
  std::string unit;                    ///< for the doc comment, for instance "rad"
  std::string doc;
  std::vector<Range> ranges;  ///< size rows*cols; where tests and the firmware check sample
  /// Size rows*cols: the model's reference pose; empty: reference_inputs' default.
  std::vector<double> reference = {};
  /// A single number by its nature, passed as such; false: an array, of whatever size.
  bool by_value = false;
};

/// A named intermediate: `symbol` stands for `value`, which may use the inputs and earlier
/// definitions. GiNaC expands and reorders eagerly; cutting an expression here keeps its shape.
struct Definition {
  GiNaC::symbol symbol;
  GiNaC::ex value;
};

/// One array result; row-major.
struct Output {
  std::string name;
  int rows = 1;
  int cols = 1;
  std::vector<GiNaC::ex> values;  ///< size rows*cols
  std::string unit;
  std::string doc;
  /// What 0, 1, ... mean where the result is a status (1 x 1): words for C identifiers, for
  /// instance "fine", "not_reached". Such a result is an int in C.
  std::vector<std::string> states = {};
};

/// A function to emit: `<model>_<name>(inputs..., outputs...)`.
///
/// Expressions may use +, *, integer and half-integer powers, sin, cos, atan, atan2, acos, asin,
/// exp, log, sqrt, abs and the functions of symbolic/expressions/piecewise.h (minimum, maximum,
/// choose).
struct Function {
  std::string name;      ///< without the model's prefix
  std::string doc;       ///< one or two sentences
  std::string equation;  ///< number in the source, for instance "(5.5)"; may be empty
  std::vector<Argument> inputs;
  std::vector<Definition> definitions;  ///< in order of evaluation
  std::vector<Output> outputs;
  /// Other functions of the model that compute the same one after the other, and are called for it:
  /// what one gives is by name an argument of later ones, and the last one gives the results.
  std::vector<std::string> chain = {};
};

}  // namespace sinew
