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
  text += fmt::format(
      "- What is estimated: {}\n- How it shows in a log: {}\n- What the motion needs for that: "
      "{}\n",
      parameters, effect.signature, effect.excitation);
  text += fmt::format("- An experiment that shows it alone: {}\n", effect.experiment);
  if (!effect.limit.empty()) text += fmt::format("- It is not considered where {}\n", effect.limit);
  if (!effect.states.empty())
    text += "- It remembers: what it does depends on the motion before, not on the instant alone\n";
  if (effect.of_one_make)
    text += "- It is looked for at each place, and with one coefficient at all of them\n";
  if (effect.baseline_only)
    text += "- It is fitted along with every cause, and never named as one itself\n";
  text += fmt::format("- Can firmware compensate it: {}\n", effect.compensable ? "yes" : "no");
  return text;
}

/// What every cause has in common. `e`: an effect of a whole model or of a rig.
template <class Described>
std::string described(const Described& e) {
  std::string text = fmt::format(
      "- How it shows in a log: {}\n- What the motion needs for that: {}\n"
      "- An experiment that shows it alone: {}\n",
      e.signature, e.excitation, e.experiment);
  if (!e.limit.empty()) text += fmt::format("- It is not considered where {}\n", e.limit);
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
  return fmt::format("\n## {} (`{}`, at {})\n\n    {}\n\n- What is estimated: {}\n", effect.name,
                     effect.id, effect.place, plain_equation(effect.left, effect.term),
                     parameters) +
         described(effect);
}

void print_efforts() {
  tell(
      "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n# Effects that the diagnosis knows\n\n"
      "When a measured log and a model disagree, `sinew diagnose` looks for the cause among the "
      "effects on this page.\nAn effect is one physical deviation: friction that the model lacks, "
      "a "
      "gear with play, a sensor with a wrong scale.\nEach has an equation that says what it adds "
      "to "
      "the model, and numbers in it that are estimated from the log.\nHow a cause is chosen is "
      "told "
      "in [diagnose.md](diagnose.md).\n\nThe page is the output of `sinew effects`; the equations "
      "are those that the program calculates with.\n\n"
      "## How to read the equations\n\n"
      "*Effort* is what has to be provided at a joint or a drive: a torque in N m, or a force in N "
      "where it slides. An\neffect's equation is the effort that is needed more because of it.\n\n"
      "| symbol | meaning |\n| --- | --- |\n"
      "| `q`, `qd`, `qdd` | position, velocity, acceleration |\n"
      "| `qdddd` | second derivative of the acceleration |\n"
      "| `load` | effort of something outside, against the motion |\n"
      "| `direction` | which way friction acts: from -1 to 1, and in between while the motion "
      "turns round |\n"
      "| `t`, `step` | time; time between two samples |\n"
      "| every other name | a number that is estimated |\n\n"
      "# At a joint, a drive or a tendon\n");
  for (const Effect& effect : effects()) tell("{}", entry(effect));
}

void print_whole_models() {
  tell(
      "\n# In the model as a whole\n\n"
      "`model` is the effort that the model under test calculates, `model_rate` how fast it "
      "changes "
      "with time,\n`model_slope` how it changes with the position that the sensor shows.\n");
  for (const ModelEffect& effect : model_effects()) tell("{}", entry(effect));
}

void print_rigs() {
  tell(
      "\n# At a lever and its tendon on their calibration rig\n\n"
      "On the rig a tendon is pulled and the lever's sensor is compared with a load cell. `f` is "
      "the "
      "lever's force, `x`\nits elongation, `z` the side of its hysteresis loop (from -1 to 1), "
      "`alpha` the angle by which the tendon is bent\nbetween lever and load cell, `direction` the "
      "side that the guides' friction is on,\n`count_speed` the count's smooth derivative, "
      "`play_direction` the side of the sensor's play. A sensor whose steps\nare coarse is found "
      "as "
      "well.\n");
  for (const ObservationEffect& effect : LeverEffects(0.0).all()) tell("{}", entry(effect));
  tell(
      "\n# At a wrist\n\n"
      "`theta` is a motor's angle, `h` a tendon's length, `turned` how far the tendon is bent from "
      "the reference pose,\n`q71_speed`, `q73_speed` an angle's smooth derivative, "
      "`play_direction` "
      "the side of its sensor's play. A sensor whose\nsteps are coarse is found as well. Each "
      "tendon has a pulley; the first one stands for all.\n");
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
