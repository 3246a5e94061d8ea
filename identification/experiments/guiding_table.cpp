// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/guiding_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "identification/logs/units.h"
#include "symbolic/files/csv_reader.h"
#include "symbolic/files/read_text.h"

namespace sinew {
namespace {

struct Column {
  const char* name;
  const char* unit;  ///< SI; empty: words
  int at = -1;       ///< cell of a row
  double factor = 1.0;
};

enum Field { tendon, guide, surface, radius, tension, bending, friction, fields };

class TableReader {
 public:
  TableReader(std::string file, Findings& findings) : file_(std::move(file)), findings_(findings) {}

  std::vector<GuidingSeries> read(const std::vector<TableRow>& rows) {
    if (rows.empty()) {
      findings_.add({file_, 1, 1}, "the table is empty", "expected a header and measurements");
      return {};
    }
    read_header(rows.front());
    if (findings_.any()) return {};
    for (std::size_t i = 1; i < rows.size(); ++i) read_row(rows[i]);
    if (rows.size() == 1)
      findings_.add(rows.front().where, "the table has no measurements", "expected a row each");
    return std::move(series_);
  }

 private:
  void read_header(const TableRow& header) {
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
      const NameAndUnit found = split_name_and_unit(header.cells[i].text);
      for (Column& column : columns_)
        if (found.name == column.name) take(column, static_cast<int>(i), found, header.cells[i]);
    }
    for (const Column& column : columns_)
      if (column.at < 0)
        findings_.add(header.where, fmt::format("there is no column '{}'", column.name),
                      *column.unit ? fmt::format("expected one, in a unit like {}", column.unit)
                                   : std::string("expected one, of words"));
  }

  void take(Column& column, int at, const NameAndUnit& found, const TableCell& cell) {
    if (column.at >= 0)
      findings_.add(cell.where, fmt::format("a second column '{}'", column.name),
                    "expected one of each name");
    column.at = at;
    if (!*column.unit) return;
    const auto unit = parse_unit(found.unit), wanted = parse_unit(column.unit);
    if (found.unit.empty())
      findings_.add(
          cell.where, fmt::format("'{}' has no unit", column.name),
          fmt::format("expected {} [{}] or another unit of this kind", column.name, column.unit));
    else if (!unit || !convertible(*unit, *wanted))
      findings_.add(cell.where, fmt::format("'{}' is no unit of {}", found.unit, column.name),
                    fmt::format("expected one like {}", column.unit));
    else
      column.factor = unit->factor / wanted->factor;
  }

  void read_row(const TableRow& row) {
    for (const Column& column : columns_)
      if (column.at >= static_cast<int>(row.cells.size())) {
        findings_.add(row.where, fmt::format("the row has no cell for '{}'", column.name),
                      "expected as many cells as the header has");
        return;
      }
    const auto words = [&](Field f) {
      return row.cells[static_cast<std::size_t>(columns_[f].at)].text;
    };
    const std::string kind = words(guide);
    if (kind != "pulley" && kind != "sliding")
      findings_.add(row.cells[static_cast<std::size_t>(columns_[guide].at)].where,
                    fmt::format("'{}' is no kind of guide", kind), "expected pulley or sliding");
    const double r = number(row, radius), t = number(row, tension), a = number(row, bending),
                 f = number(row, friction);
    if (!std::isfinite(r + t + a + f)) return;
    if (f >= t && t > 0.0)
      findings_.add(row.cells[static_cast<std::size_t>(columns_[friction].at)].where,
                    "the friction is not below the tension",
                    "expected the tension on the pulling side");
    series_of(words(tendon), kind, words(surface), r).points.push_back({t, a, f});
  }

  double number(const TableRow& row, Field field) {
    const Column& column = columns_[field];
    const TableCell& cell = row.cells[static_cast<std::size_t>(column.at)];
    double value = std::numeric_limits<double>::quiet_NaN();
    const char *begin = cell.text.data(), *end = begin + cell.text.size();
    const auto parsed = std::from_chars(begin, end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(value)) {
      findings_.add(cell.where, fmt::format("'{}' is no number", cell.text),
                    fmt::format("expected the {} as a finite number", column.name));
      return std::numeric_limits<double>::quiet_NaN();
    }
    const bool zero_fits = field == bending || field == friction;
    if (value < 0.0 || (value == 0.0 && !zero_fits)) {
      findings_.add(cell.where, fmt::format("the {} is {}", column.name, value),
                    zero_fits ? "expected 0 or more" : "expected more than 0");
      return std::numeric_limits<double>::quiet_NaN();
    }
    return value * column.factor;
  }

  GuidingSeries& series_of(const std::string& of, const std::string& kind, const std::string& on,
                           double bend_radius) {
    for (GuidingSeries& s : series_)
      if (s.tendon == of && s.guide == kind && s.surface == on &&
          std::abs(s.radius - bend_radius) < 1e-9)
        return s;
    series_.push_back({of, kind, on, bend_radius, {}});
    return series_.back();
  }

  std::string file_;
  Findings& findings_;
  std::array<Column, fields> columns_{{{"tendon", ""},
                                       {"guide", ""},
                                       {"surface", ""},
                                       {"radius", "m"},
                                       {"tension", "N"},
                                       {"bending", "rad"},
                                       {"friction", "N"}}};
  std::vector<GuidingSeries> series_;
};

}  // namespace

std::vector<GuidingSeries> read_guiding_table(const std::filesystem::path& file) {
  const std::string name = file.string();
  Findings findings;
  const std::string text = read_text(name, findings);
  findings.raise_if_any();
  const std::vector<TableRow> rows = read_csv(text, name, findings);
  findings.raise_if_any();
  std::vector<GuidingSeries> series = TableReader(name, findings).read(rows);
  findings.raise_if_any();
  return series;
}

}  // namespace sinew
