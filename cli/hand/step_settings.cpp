// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/hand/step_settings.h"

#include <fmt/format.h>

#include "firmware/hand/hand_parameters.h"
#include "symbolic/files/read_text.h"
#include "symbolic/files/toml_reader.h"

namespace sinew {
namespace {

/// A number that must be above 0, or not below it.
double number(TomlTable& table, const char* key, Dimension dimension, bool above_zero = true) {
  const auto quantity = table.quantity(key, Shape::scalar, dimension, true);
  if (!quantity) return 1.0;
  const double value = quantity->values.front();
  if (value < 0.0 || (above_zero && value == 0.0))
    table.report(key, table.path() + "." + key + (above_zero ? " is not above 0" : " is negative"),
                 above_zero ? "expected a number above 0" : "expected 0 or more");
  return value;
}

SensorSettings sensor(TomlTable& table, Dimension dimension, double period) {
  SensorSettings s;
  if (const auto range = table.quantity("range", Shape::pair, dimension, true)) {
    s.low = range->values[0];
    s.high = range->values[1];
    if (!(s.low < s.high))
      table.report("range", "the range is empty", "expected the lower limit first");
  }
  s.largest_step = dimension == Dimension::angle
                       ? number(table, "largest_rate", Dimension::angular_velocity) * period
                       : number(table, "largest_step", dimension);
  s.hold = number(table, "hold", Dimension::time, false);
  s.settle = number(table, "settle", Dimension::time, false);
  s.frozen = number(table, "frozen", Dimension::time, false);
  return s;
}

void read_step(TomlTable& table, StepSettings& s) {
  s.period = number(table, "period", Dimension::time);
  s.pretension = number(table, "pretension", Dimension::force);
  s.servo_gain = number(table, "servo_gain", Dimension::torque, false);
  s.servo_rate_gain = number(table, "servo_rate_gain", Dimension::angular_damping, false);
  s.torque_limit = number(table, "torque_limit", Dimension::torque);
  s.reference_rate = number(table, "reference_rate", Dimension::angular_velocity);
  s.rate_filter = number(table, "rate_filter", Dimension::frequency);
  const double turns = number(table, "turns", Dimension::none);
  constexpr int schedule = HAND_TURNS;
  if (turns != 1.0 && turns != schedule)
    table.report("turns", "there is no schedule of so many turns",
                 fmt::format("expected 1 or {}", schedule));
  s.turns = static_cast<int>(turns);
  s.restart = number(table, "restart", Dimension::time);
  table.finish();
}

}  // namespace

StepSettings read_step_settings(const std::filesystem::path& folder) {
  const std::string name = (folder / "real_time.toml").string();
  Findings findings;
  const std::string text = read_text(name, findings);
  findings.raise_if_any();
  std::map<std::string, std::string> provenance;
  TomlFile file{name, findings, provenance};
  const toml::table parsed = parse_toml(text, file);
  findings.raise_if_any();
  TomlTable root(parsed, "", file);
  StepSettings s;
  if (auto table = root.table("step", true)) read_step(*table, s);
  if (auto table = root.table("motor", true)) {
    s.motor = sensor(*table, Dimension::angle, s.period);
    table->finish();
  }
  if (auto table = root.table("lever", true)) {
    s.lever = sensor(*table, Dimension::none, s.period);
    table->finish();
  }
  if (auto table = root.table("wrist", true)) {
    s.wrist = sensor(*table, Dimension::none, s.period);
    s.wrist_margin = number(*table, "margin", Dimension::angle);
    table->finish();
  }
  root.finish();
  findings.raise_if_any();
  return s;
}

}  // namespace sinew
