// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/scenario/command_table.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "symbolic/files/csv_reader.h"
#include "symbolic/files/identifier.h"
#include "symbolic/files/read_text.h"

namespace sinew {
namespace {

using Channels = std::map<std::string, Dimension>;

struct Column {
  std::string name;
  std::optional<MeasureUnit> unit;  ///< nothing: the column cannot be used
};

std::vector<std::string> names_of(const Channels& channels) {
  std::vector<std::string> names{"time"};
  for (const auto& [name, ignored] : channels) names.push_back(name);
  return names;
}

std::optional<MeasureUnit> unit_of(const TableCell& cell, const std::string& name,
                                   const std::string& spelling, Dimension dimension,
                                   Findings& findings) {
  const std::string expected =
      fmt::format("expected '{} [{}]', the unit of {} being one of: {}", name, si_unit(dimension),
                  name_of(dimension), units_of(dimension));
  const std::optional<MeasureUnit> unit = find_unit(spelling);
  if (spelling.empty())
    findings.add(cell.where, fmt::format("column '{}' has no unit", name), expected);
  else if (!unit)
    findings.add(cell.where, fmt::format("column '{}' has the unknown unit '{}'", name, spelling),
                 expected);
  else if (unit->dimension != dimension)
    findings.add(cell.where,
                 fmt::format("column '{}' has the unit '{}' of {}", name, spelling,
                             name_of(unit->dimension)),
                 expected);
  else
    return unit;
  return std::nullopt;
}

Column read_column(const TableCell& cell, const Channels& channels, Findings& findings) {
  const std::size_t open = cell.text.find('[');
  Column column{cell.text.substr(0, open), std::nullopt};
  while (column.name.ends_with(' ')) column.name.pop_back();
  std::string unit = open == std::string::npos ? "" : cell.text.substr(open + 1);
  if (unit.ends_with(']')) unit.pop_back();
  const auto channel = channels.find(column.name);
  if (column.name == "time") {
    column.unit = unit_of(cell, column.name, unit, Dimension::time, findings);
  } else if (channel != channels.end()) {
    column.unit = unit_of(cell, column.name, unit, channel->second, findings);
  } else {
    const auto names = names_of(channels);
    findings.add(cell.where,
                 fmt::format("the model has no command '{}'{}", column.name,
                             did_you_mean(column.name, names)),
                 fmt::format("expected one of: {}", fmt::join(names, ", ")));
  }
  return column;
}

std::vector<Column> read_header(const TableRow& row, const Channels& channels, Findings& findings) {
  std::vector<Column> columns;
  for (const TableCell& cell : row.cells) {
    columns.push_back(read_column(cell, channels, findings));
    for (std::size_t i = 0; i + 1 < columns.size(); ++i)
      if (columns[i].name == columns.back().name)
        findings.add(cell.where, fmt::format("column '{}' appears twice", columns[i].name),
                     "expected each column once");
  }
  if (columns.empty() || columns.front().name != "time")
    findings.add(row.where, "the first column is not the time", "expected 'time [s]'");
  return columns;
}

std::optional<double> read_number(const TableCell& cell, const Column& column, Findings& findings) {
  double value = 0.0;
  const char* last = cell.text.data() + cell.text.size();
  const auto [end, error] = std::from_chars(cell.text.data(), last, value);
  if (error != std::errc() || end != last || !std::isfinite(value)) {
    findings.add(cell.where, fmt::format("{} '{}' is no finite number", column.name, cell.text),
                 "expected a number with a decimal point");
    return std::nullopt;
  }
  return to_si(value, *column.unit);
}

using Signals = std::map<std::string, SampledSignal>;

void take_row(const TableRow& row, const std::vector<Column>& columns, Signals& signals,
              Findings& findings) {
  if (row.cells.size() != columns.size()) {
    findings.add(row.where, fmt::format("the row has {} cells", row.cells.size()),
                 fmt::format("expected {}, as in the header", columns.size()));
    return;
  }
  std::optional<double> time;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::optional<double> value = read_number(row.cells[i], columns[i], findings);
    if (!value) continue;
    if (i == 0) {
      time = value;
      continue;
    }
    SampledSignal& signal = signals[columns[i].name];
    if (!time) continue;
    if (!signal.time.empty() && *time <= signal.time.back())
      findings.add(row.where,
                   fmt::format("the time {} s is not after {} s", *time, signal.time.back()),
                   "expected time that rises from row to row");
    signal.time.push_back(*time);
    signal.value.push_back(*value);
  }
}

}  // namespace

Signals read_command_table(const std::filesystem::path& file, const Channels& channels,
                           Findings& findings) {
  const std::size_t before = findings.count();
  const std::string text = read_text(file, findings);
  if (findings.count() > before) return {};
  const std::vector<TableRow> rows = read_csv(text, file.string(), findings);
  if (rows.size() < 2) {
    findings.add({file.string(), 1, 1}, "the file holds no commands",
                 "expected a header and at least one row");
    return {};
  }
  const std::vector<Column> columns = read_header(rows.front(), channels, findings);
  Signals signals;
  if (findings.count() == before)
    for (std::size_t i = 1; i < rows.size(); ++i) take_row(rows[i], columns, signals, findings);
  if (findings.count() > before) return {};
  return signals;
}

}  // namespace sinew
