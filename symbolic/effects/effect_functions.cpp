// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effect_functions.h"

#include "symbolic/effects/effects.h"

namespace sinew {
namespace {

Argument signals_argument() {
  Argument argument;
  argument.name = "signals";
  argument.symbols = signal_list();
  argument.rows = static_cast<int>(argument.symbols.size());
  argument.unit = "SI";
  argument.doc =
      "position, velocity, acceleration, its second derivative, load, time, direction, step, "
      "parting, carried inertia, carried jounce";
  argument.ranges = {{-3.0, 3.0},   {-5.0, 5.0},  {-50.0, 50.0}, {-1e4, 1e4},
                     {-10.0, 10.0}, {0.0, 100.0}, {-1.0, 1.0},   {1e-4, 1e-2},
                     {-50.0, 50.0}, {1e-3, 10.0}, {-1e4, 1e4}};
  return argument;
}

Range shape_range(const ShapeParameter& shape) {
  return {shape.low > 0.0 ? shape.low : 0.1, shape.high};
}

Argument state_argument(const Effect& effect) {
  Argument argument;
  argument.name = "memory";  // "state" is a batch loop's index
  argument.rows = static_cast<int>(effect.states.size());
  argument.unit = "1";
  argument.doc = "before this sample; 0 before the first";
  for (const EffectState& state : effect.states) {
    argument.symbols.push_back(state.symbol);
    argument.ranges.push_back({-1.0, 1.0});
  }
  return argument;
}

}  // namespace

Function regressor_function(const Effect& effect) {
  Function f;
  f.name = effect.id;
  f.doc = "Terms of the effect '" + effect.name + "', to be multiplied by its coefficients.";
  f.inputs.push_back(signals_argument());
  if (!effect.shapes.empty()) {
    Argument shape;
    shape.name = "shape";
    shape.rows = static_cast<int>(effect.shapes.size());
    shape.unit = "SI";
    for (const ShapeParameter& p : effect.shapes) {
      shape.doc += (shape.doc.empty() ? "" : ", ") + p.name;
      shape.symbols.push_back(p.symbol);
      shape.ranges.push_back(shape_range(p));
    }
    f.inputs.push_back(shape);
  }
  if (!effect.states.empty()) f.inputs.push_back(state_argument(effect));
  Output columns{"columns", static_cast<int>(effect.columns.size()), 1, {}, "SI", ""};
  for (const EffectColumn& column : effect.columns) {
    columns.values.push_back(column.term);
    columns.doc += (columns.doc.empty() ? "" : ", ") + column.name;
  }
  f.outputs.push_back(columns);
  if (effect.states.empty()) return f;
  Output next{
      "next", static_cast<int>(effect.states.size()), 1, {}, "1", "states for the next sample"};
  for (const EffectState& state : effect.states) next.values.push_back(state.next);
  f.outputs.push_back(next);
  return f;
}

std::vector<Function> effect_functions() {
  std::vector<Function> functions;
  for (const Effect& effect : effects()) functions.push_back(regressor_function(effect));
  return functions;
}

}  // namespace sinew
