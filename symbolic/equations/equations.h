// SPDX-License-Identifier: GPL-3.0-or-later
// A model's equations for people: symbols kept instead of numbers, each step with the number that
// the source gives it, and a table of what the symbols stand for.
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <string>
#include <vector>

#include "symbolic/model/mechanism.h"
#include "symbolic/notation/print_mathml.h"
#include "symbolic/parts/wrist.h"

namespace sinew {

struct ReadableEquation {
  std::string left;
  GiNaC::ex right;
};

struct EquationSection {
  std::string title;
  std::string source;  ///< equation numbers of the source, "(2.1)"; "" where it has none
  std::string text;    ///< what the equations say, in a sentence or two
  std::vector<ReadableEquation> equations;
};

/// What a symbol stands for.
struct EquationSymbol {
  std::string name;
  std::string meaning;
  std::optional<double> value;  ///< SI; nothing for what is an argument or a function
  std::string unit;
  std::string origin;  ///< "text: Table 5.1", "assumed", ...; "" where there is no value
};

struct EquationPage {
  std::string title;
  std::vector<EquationSection> sections;
  std::vector<EquationSymbol> symbols;
  MathNames shown;  ///< how symbols of `sections` are written where they are not called so
};

/// Kinematics, the Lagrangian, the mass matrix, tendon lengths and the coupling matrix. A
/// four-bar's joint is a symbol for Freudenstein's function of its crank's joint.
EquationPage mechanism_equations(const Mechanism& mechanism);

/// The palm's pose in closed form and a tendon's length, chapter 6.
EquationPage wrist_equations(const WristParameters& parameters);

/// The effects that `diagnose` knows.
EquationPage effect_equations();

enum class EquationFormat { latex, mathml, text };

/// A whole document: LaTeX (article, amsmath), HTML with MathML, or plain text.
std::string printed(const EquationPage& page, EquationFormat format);

/// The same as a part of an HTML page, with headings from <h`level`> on: the equations as MathML,
/// each in a <div class="math">, and the table of symbols. `folds`: each part in a <details> of its
/// own.
std::string html_sections(const EquationPage& page, int level, bool folds);

}  // namespace sinew
