// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/column_readings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sinew::diagnosis {
namespace {

// One log of a hundred has a column that is not what it says. docs/blind_rates.md counts the faults
// that are found with that, and the sound logs that are refused.
constexpr double kOdds = 1e-2;

/// Of a reading that is made as often as any.
double price_of_one(const std::vector<ColumnReading>& readings) {
  double odds = 0.0;
  for (const ColumnReading& reading : readings) odds += reading.odds;
  return std::log(std::max(1.0, odds) / kOdds);
}

std::string evidence_told(double left_by, double left_now, const std::string& what) {
  return fmt::format("with that the model leaves {:.2g} % of {} over, and {:.3g} % as it is",
                     100.0 * left_by, what, 100.0 * left_now);
}

void tell_exchange(const Log& log, const ColumnReading& reading, const std::string& evidence,
                   FaultList& faults) {
  const Channel& a = log.channels[static_cast<std::size_t>(reading.column)];
  const Channel& b = log.channels[static_cast<std::size_t>(reading.other)];
  const long row = log.segments.front().first_row;
  faults.add(FaultKind::swapped_columns, Severity::stop, row, row, a.column, a.name,
             fmt::format("'{}' (column {}) and '{}' (column {}) are exchanged: {}", a.name,
                         a.column, b.name, b.column, evidence),
             fmt::format("name them rightly: --map \"{}=#{} [unit]\" --map \"{}=#{} [unit]\"",
                         a.name, b.column, b.name, a.column));
}

void tell_clock(const Log& log, const ColumnReading& reading, const std::string& evidence,
                FaultList& faults) {
  const long row = log.segments.front().first_row;
  const double factor = std::max(reading.factor, 1.0 / reading.factor);
  faults.add(FaultKind::time_unit, Severity::stop, row, row, 1, "time",
             fmt::format("'time' runs {:.3g} times too {}: {}", factor,
                         reading.factor > 1.0 ? "slow" : "fast", evidence),
             "units are converted only when told: --map \"time=column [unit]\"");
}

}  // namespace

double evidence_of_share(double share, double stretches) {
  return -0.5 * stretches * std::log(share + kAnyway * kAnyway);
}

std::vector<ColumnReading> known_slips(const Log& log, int column) {
  std::vector<ColumnReading> slips{{column, -1, -1.0, "its sign is reversed"}};
  const std::string& unit = log.channels[static_cast<std::size_t>(column)].unit;
  for (const double factor : {180.0 / std::numbers::pi, std::numbers::pi / 180.0, 1000.0, 0.001})
    if (const UnitSlip slip = unit_slip_of(factor, unit, 0.01); !slip.meaning.empty())
      slips.push_back({column, -1, factor, slip.meaning});
  return slips;
}

bool is_worth_reading(double gain, const std::vector<ColumnReading>& readings) {
  return gain > price_of_one(readings);
}

std::optional<ColumnReading> likelier_reading(
    const std::vector<ColumnReading>& others, double as_it_is,
    const std::function<double(const ColumnReading&, double)>& evidence) {
  double best = as_it_is + price_of_one(others);
  std::optional<ColumnReading> found;
  for (const ColumnReading& reading : others) {
    const double odds = std::log(reading.odds);
    const double here = evidence(reading, best - odds) + odds;
    if (!(here > best)) continue;
    best = here;
    found = reading;
  }
  return found;
}

void tell(const Log& log, const ColumnReading& reading, double left_by, double left_now,
          const std::string& what, FaultList& faults) {
  const std::string evidence = evidence_told(left_by, left_now, what);
  if (reading.other >= 0) return tell_exchange(log, reading, evidence, faults);
  if (reading.column == ColumnReading::kClock) return tell_clock(log, reading, evidence, faults);
  const Channel& at = log.channels[static_cast<std::size_t>(reading.column)];
  const long row = log.segments.front().first_row;
  const bool turned = reading.factor < 0.0;
  faults.add(turned ? FaultKind::reversed_sign : FaultKind::unit_slip, Severity::stop, row, row,
             at.column, at.name,
             fmt::format("'{}'{}: {}; {}", at.name, reading.all ? " and all its like" : "",
                         reading.meaning, evidence),
             turned ? "the log is not used"
                    : fmt::format("units are converted only when told: --map \"{}=#{} [unit]\"",
                                  at.name, at.column));
}

}  // namespace sinew::diagnosis
