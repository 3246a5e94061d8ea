// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/effects.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/terminal/terminal.h"
#include "symbolic/effects/effects.h"
#include "symbolic/effects/model_effects.h"
#include "symbolic/extension/lever_effects.h"
#include "symbolic/extension/wrist_effects.h"
#include "symbolic/notation/print_mathml.h"

namespace sinew {
namespace {

const char* limit_of(Sign sign) {
  return sign == Sign::positive ? " >= 0" : sign == Sign::negative ? " <= 0" : "";
}

std::string entry(const Effect& effect) {
  std::string text = fmt::format("\n## {} (`{}`)\n\n    {}\n\n", effect.name, effect.id,
                                 plain_equation("effort", effort(effect)));
  std::string parameters;
  for (const EffectColumn& column : effect.columns)
    parameters += fmt::format("{}`{}`{}{}", parameters.empty() ? "" : ", ", column.name,
                              limit_of(column.sign), column.per_log ? " (of each log)" : "");
  for (const ShapeParameter& shape : effect.shapes) parameters += fmt::format(", `{}`", shape.name);
  text += fmt::format("- parameters: {}\n- looks like: {}\n- is seen where there is: {}\n",
                      parameters, effect.signature, effect.excitation);
  text += fmt::format("- is shown alone by: {}\n", effect.experiment);
  if (!effect.limit.empty()) text += fmt::format("- not taken where {}\n", effect.limit);
  if (!effect.states.empty()) text += "- has a state of its own\n";
  if (effect.baseline_only) text += "- is fitted with every model and never named\n";
  text += fmt::format("- in the firmware's compensation: {}\n", effect.compensable ? "yes" : "no");
  return text;
}

/// What every cause has in common. `e`: an effect of a whole model or of a rig.
template <class Described>
std::string described(const Described& e) {
  std::string text =
      fmt::format("- looks like: {}\n- is seen where there is: {}\n- is shown alone by: {}\n",
                  e.signature, e.excitation, e.experiment);
  if (!e.limit.empty()) text += fmt::format("- not taken where {}\n", e.limit);
  return text;
}

std::string entry(const ModelEffect& effect) {
  return fmt::format("\n## {} (`{}`)\n\n    {}\n\n", effect.name, effect.id,
                     plain_equation("effort", effect.effort)) +
         described(effect);
}

std::string entry(const ObservationEffect& effect) {
  std::string parameters;
  for (const auto* list : {&effect.deviations, &effect.shapes})
    for (const ObservationParameter& p : *list)
      parameters += fmt::format("{}`{}` [{}]", parameters.empty() ? "" : ", ", p.name, p.unit);
  return fmt::format("\n## {} (`{}`, at {})\n\n    {}\n\n- parameters: {}\n", effect.name,
                     effect.id, effect.place, plain_equation(effect.left, effect.term),
                     parameters) +
         described(effect);
}

void print_efforts() {
  tell(
      "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n# Effects\n\n"
      "What a diagnosis knows, as `symbolic/effects/`, `symbolic/extension/lever_effects.cpp` and "
      "`symbolic/extension/wrist_effects.cpp`\nhave it. The page is the output of `sinew "
      "effects`.\nEfforts "
      "count positive where they have to be provided: q, qd, qdd are position, velocity and "
      "acceleration,\nqdddd the acceleration's second derivative, load an external effort against "
      "the motion, direction the\ndirection of friction (-1..1), t the time, step the sampling "
      "period.\n");
  for (const Effect& effect : effects()) tell("{}", entry(effect));
}

void print_whole_models() {
  tell(
      "\n# Of the model as a whole\n\n"
      "model is the effort of the model under test, model_rate its derivative by time, model_slope "
      "the one by the\nposition that the sensor shows.\n");
  for (const ModelEffect& effect : model_effects()) tell("{}", entry(effect));
}

void print_rigs() {
  tell(
      "\n# At a lever and its tendon on their calibration rig\n\n"
      "f is the lever's force, x its elongation, z the side of its loop (-1..1), alpha the bending "
      "angle between\nlever and load cell, direction the side that the guides' friction is on. A "
      "sensor whose steps are coarse is\nfound as well.\n");
  for (const ObservationEffect& effect : LeverEffects(0.0).all()) tell("{}", entry(effect));
  tell(
      "\n# At a wrist\n\n"
      "theta is a motor's angle, h a tendon's length, turned how far the tendon is bent from the "
      "reference pose. A\nsensor whose steps are coarse is found as well; the first motor stands "
      "for all.\n");
  for (const ObservationEffect& effect : WristEffects(1).all()) tell("{}", entry(effect));
}

}  // namespace

void add_effects_command(CLI::App& app, int&) {
  app.add_subcommand("effects", "The manual's page of the effects that a diagnosis knows")
      ->callback([] {
        print_efforts();
        print_whole_models();
        print_rigs();
      });
}

}  // namespace sinew
