// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "symbolic/effects/effects.h"
#include "symbolic/effects/model_effects.h"
#include "symbolic/equations/equations.h"

namespace sinew {
namespace {

void add_once(EquationPage& page, std::set<std::string>& known, EquationSymbol symbol) {
  if (known.insert(symbol.name).second) page.symbols.push_back(std::move(symbol));
}

void add_parameters(EquationPage& page, std::set<std::string>& known, const Effect& effect) {
  for (const EffectColumn& column : effect.columns)
    add_once(page, known,
             {column.symbol.get_name(), "coefficient of an effect, from logs", std::nullopt,
              column.unit, ""});
  for (const ShapeParameter& shape : effect.shapes)
    add_once(
        page, known,
        {shape.symbol.get_name(), "shape of an effect, from logs", std::nullopt, shape.unit, ""});
}

}  // namespace

EquationPage effect_equations() {
  EquationPage page;
  page.title = "Equations of the effects";
  std::set<std::string> known;
  const std::pair<const char*, const char*> signals[] = {
      {"q", "position at the effect's place"},
      {"qd", "its rate"},
      {"qdd", "its acceleration"},
      {"load", "external load against positive motion"},
      {"t", "time since the log's start"},
      {"direction", "soft sign of the velocity"}};
  for (const auto& [name, meaning] : signals)
    add_once(page, known, {name, meaning, std::nullopt, "", ""});
  for (const Effect& effect : effects()) {
    page.sections.push_back({effect.name,
                             "",
                             "Effort that has to be provided to overcome it.",
                             {{"effort", sinew::effort(effect)}}});
    add_parameters(page, known, effect);
  }
  for (const ModelEffect& effect : model_effects())
    page.sections.push_back({effect.name, "", "Effort that it adds.", {{"effort", effect.effort}}});
  return page;
}

}  // namespace sinew
