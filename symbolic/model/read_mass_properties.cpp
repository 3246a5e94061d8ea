// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/read_mass_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "symbolic/files/csv_reader.h"
#include "symbolic/files/identifier.h"
#include "symbolic/files/limits.h"
#include "symbolic/files/origin.h"
#include "symbolic/files/readable.h"
#include "symbolic/files/units.h"

namespace sinew {
namespace {

struct ColumnRule {
  std::string_view name;
  Dimension dimension;  // none: text
  bool required;
};

constexpr std::array<ColumnRule, 17> rules{{{"link", Dimension::none, true},
                                            {"mass", Dimension::mass, true},
                                            {"com_x", Dimension::length, true},
                                            {"com_y", Dimension::length, true},
                                            {"com_z", Dimension::length, true},
                                            {"ixx", Dimension::inertia, true},
                                            {"iyy", Dimension::inertia, true},
                                            {"izz", Dimension::inertia, true},
                                            {"ixy", Dimension::inertia, true},
                                            {"ixz", Dimension::inertia, true},
                                            {"iyz", Dimension::inertia, true},
                                            {"iyx", Dimension::inertia, false},
                                            {"izx", Dimension::inertia, false},
                                            {"izy", Dimension::inertia, false},
                                            {"from", Dimension::none, false},
                                            {"ref", Dimension::none, false},
                                            {"note", Dimension::none, false}}};

struct Column {
  const ColumnRule* rule = nullptr;  // null: not usable
  std::optional<MeasureUnit> unit;
};

const ColumnRule* find_rule(std::string_view name) {
  const auto rule = std::find_if(rules.begin(), rules.end(),
                                 [&](const ColumnRule& each) { return each.name == name; });
  return rule == rules.end() ? nullptr : &*rule;
}

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const ColumnRule& rule : rules) names.emplace_back(rule.name);
  return names;
}

std::string example(const ColumnRule& rule) {
  if (rule.dimension == Dimension::none) return std::string(rule.name);
  return fmt::format("{} [{}]", rule.name, si_unit(rule.dimension));
}

/// The unit in brackets of a header cell; reports a missing, unknown or wrong one.
std::optional<MeasureUnit> column_unit(const TableCell& cell, const ColumnRule& rule,
                                       std::string_view unit, Findings& findings) {
  const std::string expected =
      fmt::format("expected '{}', the unit of {} being one of: {}", example(rule),
                  name_of(rule.dimension), units_of(rule.dimension));
  if (unit.empty()) {
    findings.add(cell.where, fmt::format("column '{}' has no unit", rule.name), expected);
    return std::nullopt;
  }
  const std::optional<MeasureUnit> found = find_unit(unit);
  if (!found)
    findings.add(cell.where, fmt::format("column '{}' has the unknown unit '{}'", rule.name, unit),
                 expected);
  else if (found->dimension != rule.dimension)
    findings.add(cell.where,
                 fmt::format("column '{}' has the unit '{}' of {}", rule.name, unit,
                             name_of(found->dimension)),
                 expected);
  else
    return found;
  return std::nullopt;
}

Column read_column(const TableCell& cell, Findings& findings) {
  const std::size_t open = cell.text.find('[');
  std::string name = cell.text.substr(0, open);
  while (name.ends_with(' ')) name.pop_back();
  Column column{find_rule(name), std::nullopt};
  const bool has_unit = open != std::string::npos;
  if (column.rule == nullptr) {
    findings.add(cell.where,
                 fmt::format("unknown column '{}'{}", name, did_you_mean(name, column_names())),
                 fmt::format("expected one of: {}", listed(column_names())));
  } else if (has_unit && !cell.text.ends_with(']')) {
    findings.add(cell.where, fmt::format("the unit of column '{}' does not end with ]", name),
                 fmt::format("expected '{}'", example(*column.rule)));
  } else if (column.rule->dimension == Dimension::none) {
    if (has_unit)
      findings.add(cell.where, fmt::format("column '{}' has a unit", name),
                   fmt::format("expected '{}'", name));
  } else {
    const std::string unit =
        has_unit ? cell.text.substr(open + 1, cell.text.size() - open - 2) : "";
    column.unit = column_unit(cell, *column.rule, unit, findings);
  }
  return column;
}

std::vector<Column> read_header(const TableRow& header, Findings& findings) {
  if (header.cells.size() == 1 && header.cells[0].text.find(';') != std::string::npos)
    findings.add(header.where, "the columns are separated by semicolons", "expected commas");
  std::vector<Column> columns;
  std::map<std::string_view, int> seen;
  for (const TableCell& cell : header.cells) {
    columns.push_back(read_column(cell, findings));
    const ColumnRule* rule = columns.back().rule;
    if (rule != nullptr && ++seen[rule->name] == 2)
      findings.add(cell.where, fmt::format("column '{}' appears twice", rule->name),
                   "expected each column once");
  }
  for (const ColumnRule& rule : rules)
    if (rule.required && seen[rule.name] == 0)
      findings.add(header.where, fmt::format("column '{}' is missing", rule.name),
                   fmt::format("expected a column '{}'", example(rule)));
  return columns;
}

std::optional<double> read_number(const TableCell& cell, const Column& column, Findings& findings) {
  const std::string_view text =
      cell.text.starts_with('+') ? std::string_view(cell.text).substr(1) : cell.text;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view name = column.rule->name;
  if (cell.text.empty())
    findings.add(cell.where, fmt::format("{} is empty", name), "expected a number");
  else if (error == std::errc::result_out_of_range)
    findings.add(cell.where, fmt::format("{} '{}' is out of range", name, cell.text),
                 "expected a number a double can hold");
  else if (error != std::errc() || end != text.data() + text.size() || text.starts_with('+'))
    findings.add(cell.where, fmt::format("{} '{}' is not a number", name, cell.text),
                 "expected a number with a decimal point, such as 0.002 or 2e-3");
  else if (!std::isfinite(value) || !std::isfinite(to_si(value, *column.unit)))
    findings.add(cell.where, fmt::format("{} '{}' is not finite", name, cell.text),
                 "expected a finite number");
  else
    return to_si(value, *column.unit);
  return std::nullopt;
}

/// A row by column name: numbers in SI units, texts, and places.
struct NamedRow {
  std::map<std::string_view, double> numbers;
  std::map<std::string_view, std::string> texts;
  std::map<std::string_view, SourceLocation> places;
};

NamedRow read_cells(const TableRow& row, const std::vector<Column>& columns, Findings& findings) {
  NamedRow named;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ColumnRule* rule = columns[i].rule;
    if (rule == nullptr) continue;
    named.places[rule->name] = row.cells[i].where;
    if (rule->dimension == Dimension::none) {
      named.texts[rule->name] = row.cells[i].text;
    } else if (columns[i].unit) {
      const auto number = read_number(row.cells[i], columns[i], findings);
      if (number) named.numbers[rule->name] = *number;
    }
  }
  return named;
}

/// Sets both entries of a product of inertia; reports a lower one that differs from the upper.
void set_product(NamedRow& row, int i, int j, std::string_view upper, std::string_view lower,
                 MassProperties& properties, Findings& findings) {
  const double value = row.numbers[upper];
  properties.inertia(i, j) = properties.inertia(j, i) = value;
  if (!row.numbers.contains(lower)) return;
  const double other = row.numbers[lower];
  const double largest = properties.inertia.diagonal().cwiseAbs().maxCoeff();
  if (std::abs(other - value) > 1e-6 * std::max(std::abs(value), largest))
    findings.add(row.places[lower],
                 fmt::format("the inertia is not symmetric: {} = {} and {} = {} kg*m^2", upper,
                             value, lower, other),
                 "expected equal entries");
}

MassProperties assemble(NamedRow& row, const SourceLocation& where, Findings& findings) {
  MassProperties properties;
  auto& number = row.numbers;
  properties.body = row.texts["link"];
  properties.mass = number["mass"];
  properties.centre_of_mass << number["com_x"], number["com_y"], number["com_z"];
  properties.inertia.diagonal() << number["ixx"], number["iyy"], number["izz"];
  set_product(row, 0, 1, "ixy", "iyx", properties, findings);
  set_product(row, 0, 2, "ixz", "izx", properties, findings);
  set_product(row, 1, 2, "iyz", "izy", properties, findings);
  properties.where = row.places.contains("link") ? row.places["link"] : where;
  properties.mass_where = row.places["mass"];
  properties.inertia_where = row.places["ixx"];
  return properties;
}

std::string read_origin(NamedRow& row, Findings& findings) {
  const std::string from = row.texts["from"].empty() ? "cad" : row.texts["from"];
  const std::string& ref = row.texts["ref"];
  if (!is_origin(from))
    findings.add(row.places["from"], fmt::format("from is '{}'", from),
                 fmt::format("expected one of: {}", origin_words()));
  else if (from == "text" && ref.empty())
    findings.add(row.places["from"], "the row is from the text but does not say where",
                 "expected a column ref with, for instance, Table 5.1");
  return ref.empty() ? from : fmt::format("{}: {}", from, ref);
}

}  // namespace

std::vector<MassProperties> parse_mass_properties(std::string_view text, const std::string& file,
                                                  Findings& findings) {
  const std::vector<TableRow> rows = read_csv(text, file, findings);
  if (rows.empty()) {
    findings.add({file, 1, 1}, "the table is empty", "expected a header row");
    return {};
  }
  if (rows.size() > limits::entries + 1) {
    findings.add(rows[limits::entries + 1].where,
                 fmt::format("the table has {} rows", rows.size() - 1),
                 fmt::format("expected at most {}", limits::entries));
    return {};
  }
  const std::size_t before_header = findings.count();
  const std::vector<Column> columns = read_header(rows[0], findings);
  const bool has_header = findings.count() == before_header;
  std::vector<MassProperties> table;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::size_t before = findings.count();
    if (rows[i].cells.size() != columns.size()) {
      findings.add(rows[i].where, fmt::format("the row has {} cells", rows[i].cells.size()),
                   fmt::format("expected {}, as in the header", columns.size()));
      continue;
    }
    NamedRow row = read_cells(rows[i], columns, findings);
    if (!has_header || findings.count() != before) continue;
    table.push_back(assemble(row, rows[i].where, findings));
    table.back().provenance = read_origin(row, findings);
  }
  return table;
}

}  // namespace sinew
