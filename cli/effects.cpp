// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/effects.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "symbolic/effects/effects.h"
#include "symbolic/print_mathml.h"

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

void print_page() {
  fmt::print(
      "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n# Effects\n\n"
      "What a diagnosis knows, one entry a file in `symbolic/effects/`. The page is the output "
      "of "
      "`sinew effects`.\nEfforts count positive where they have to be provided: q, qd, qdd are "
      "position, velocity and acceleration,\nqdddd the acceleration's second derivative, load an "
      "external effort against the motion, direction the\ndirection of friction (-1..1), t the "
      "time, "
      "step the sampling period.\n");
  for (const Effect& effect : effects()) fmt::print("{}", entry(effect));
}

}  // namespace

void add_effects_command(CLI::App& app, int&) {
  app.add_subcommand("effects", "The manual's page of the effects that a diagnosis knows")
      ->callback([] { print_page(); });
}

}  // namespace sinew
