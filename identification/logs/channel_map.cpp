// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/channel_map.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include "identification/logs/units.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

struct HeaderCell {
  std::string name, unit, whole;
};

struct Override {
  std::string channel, column, unit;
};

class Mapper {
 public:
  Mapper(const std::vector<std::string>& header, const std::vector<ChannelSpec>& specs,
         std::string file, long row)
      : specs_(specs), file_(std::move(file)), row_(row) {
    for (const std::string& cell : header) {
      const NameAndUnit parts = split_name_and_unit(cell);
      cells_.push_back({parts.name, parts.unit, std::string(trimmed(cell))});
    }
    used_.assign(cells_.size(), false);
  }

  ColumnMap map(const std::vector<std::string>& overrides) {
    for (const std::string& text : overrides) read_override(text);
    ColumnMap result;
    if (const auto time = find(time_spec())) result.time = *time;
    for (const ChannelSpec& s : specs_)
      if (const auto column = find(s); column && !is_taken(*column, result.channels))
        result.channels.push_back(*column);
    note_unused();
    if (std::any_of(faults_.begin(), faults_.end(),
                    [](const DataFault& f) { return f.severity == Severity::stop; }))
      throw LogError(faults_);
    result.notes = faults_;
    return result;
  }

 private:
  static ChannelSpec time_spec() {
    ChannelSpec time;
    time.name = "time";
    time.unit = "s";
    time.required = true;
    return time;
  }

  /// A velocity that a position is the integral of says nothing more as a channel of its own.
  static bool is_taken(const MappedColumn& m, const std::vector<MappedColumn>& before) {
    return std::any_of(before.begin(), before.end(), [&](const MappedColumn& other) {
      return other.is_rate && other.column == m.column;
    });
  }

  void report(FaultKind kind, Severity severity, int column, const std::string& channel,
              const std::string& meaning, const std::string& action) {
    faults_.push_back({kind, severity, file_, row_, row_, column, channel, 1, meaning, action});
  }

  void read_override(const std::string& text) {
    const size_t at = text.find('=');
    const std::string channel(trimmed(std::string_view(text).substr(0, at)));
    const bool known = channel == "time" ||
                       std::any_of(specs_.begin(), specs_.end(),
                                   [&](const ChannelSpec& s) { return is_called(s, channel); });
    if (at == std::string::npos || !known) {
      report(
          FaultKind::missing_cell, Severity::stop, 0, channel,
          fmt::format("'{}' (--map or channels.toml) does not begin with a channel of this model "
                      "({})",
                      text, listed(channel_names())),
          "write \"channel=column name [unit]\"");
      return;
    }
    const NameAndUnit parts = split_name_and_unit(std::string_view(text).substr(at + 1));
    overrides_.push_back({channel, parts.name, parts.unit});
  }

  std::vector<std::string> channel_names() const {
    std::vector<std::string> names{"time"};
    for (const ChannelSpec& s : specs_) names.push_back(s.name);
    return names;
  }

  std::vector<std::string> column_names() const {
    std::vector<std::string> names;
    for (const HeaderCell& cell : cells_) names.push_back(cell.whole);
    return names;
  }

  const Override* override_of(const ChannelSpec& s) const {
    for (const Override& o : overrides_)
      if (is_called(s, o.channel)) return &o;
    return nullptr;
  }

  /// By its own name, or by another one that is understood.
  static bool is_called(const ChannelSpec& s, const std::string& name) {
    return s.name == name || std::find(s.also.begin(), s.also.end(), name) != s.also.end();
  }

  // Index of the column called so, -1 if there is none; a second one of the name is a finding.
  int column_called(const std::string& name, const std::string& channel) {
    for (const bool exact : {true, false}) {
      std::vector<int> hits;
      for (size_t i = 0; i < cells_.size(); ++i) {
        const HeaderCell& cell = cells_[i];
        const bool hit = exact
                             ? cell.name == name || cell.whole == name
                             : lower(cell.name) == lower(name) || lower(cell.whole) == lower(name);
        if (hit) hits.push_back(static_cast<int>(i));
      }
      if (hits.size() > 1)
        report(
            FaultKind::row_length, Severity::stop, hits[1] + 1, channel,
            fmt::format("two columns ({} and {}) are called '{}'", hits[0] + 1, hits[1] + 1, name),
            fmt::format("name one by its number: --map \"{}=#{} [unit]\"", channel, hits[0] + 1));
      if (!hits.empty()) return hits[0];
    }
    return -1;
  }

  int column_of_override(const Override& o) {
    if (o.column.starts_with('#')) {
      int number = 0;
      const char* end = o.column.data() + o.column.size();
      const auto parsed = std::from_chars(o.column.data() + 1, end, number);
      if (parsed.ptr == end && number >= 1 && number <= static_cast<int>(cells_.size()))
        return number - 1;
      return -1;
    }
    return column_called(o.column, o.channel);
  }

  // "q_deg" for channel q, "t_s" for time.
  int column_with_suffix(const std::string& channel) {
    for (size_t i = 0; i < cells_.size(); ++i) {
      if (!cells_[i].unit.empty()) continue;
      const auto parts = split_unit_suffix(cells_[i].name);
      if (parts && lower(parts->name) == lower(channel)) return static_cast<int>(i);
    }
    return -1;
  }

  int column_of(const ChannelSpec& s) {
    if (const Override* o = override_of(s)) {
      const int column = column_of_override(*o);
      if (column < 0)
        report(FaultKind::missing_cell, Severity::stop, 0, s.name,
               fmt::format("--map or channels.toml asks for column '{}', the header has: {}",
                           o->column, listed(column_names())),
               "the log is not used");
      return column;
    }
    int column = column_called(s.name, s.name);
    if (column < 0) column = column_with_suffix(s.name);
    for (const std::string& other : s.also) {
      if (column < 0) column = column_called(other, s.name);
      if (column < 0) column = column_with_suffix(other);
    }
    if (column < 0 && s.name == "time") {
      for (const char* alias : {"t", "timestamp"}) {
        if (column < 0) column = column_called(alias, s.name);
        if (column < 0) column = column_with_suffix(alias);
      }
    }
    return column;
  }

  void report_missing(const ChannelSpec& s) {
    report(FaultKind::missing_cell, Severity::stop, 0, s.name,
           fmt::format("no column for channel '{} [{}]'; the header has: {}", s.name, s.unit,
                       listed(column_names())),
           fmt::format("map it: --map \"{}=column name [unit]\"", s.name));
  }

  /// The velocity of a position's coordinate; null: the model knows none.
  const ChannelSpec* velocity_of(const ChannelSpec& s) const {
    if (s.role != ChannelRole::position) return nullptr;
    const auto found = std::find_if(specs_.begin(), specs_.end(), [&](const ChannelSpec& other) {
      return other.role == ChannelRole::velocity && other.group == s.group;
    });
    return found == specs_.end() ? nullptr : &*found;
  }

  /// A position that the log does not have, from the velocity that it has.
  std::optional<MappedColumn> integral(const ChannelSpec& s) {
    const ChannelSpec* rate = velocity_of(s);
    const int column = rate && s.required ? column_of(*rate) : -1;
    if (column < 0) {
      if (s.required) report_missing(s);
      return std::nullopt;
    }
    const std::optional<MappedColumn> mapped = find(*rate);
    if (!mapped) return std::nullopt;
    return integral_of(s, column, mapped->factor);
  }

  MappedColumn integral_of(const ChannelSpec& s, int column, double factor) {
    report(FaultKind::missing_cell, Severity::doubtful, column + 1, s.name,
           fmt::format("'{}' is a velocity, and channel '{}' a position",
                       cells_[static_cast<size_t>(column)].whole, s.name),
           fmt::format("'{}' is its integral from 0 on: what depends on the position itself, such "
                       "as gravity, is only as true as that zero",
                       s.name));
    return {column + 1, factor, s, false, true};
  }

  std::string unit_of(const ChannelSpec& s, int column) {
    const Override* o = override_of(s);
    if (o != nullptr && !o->unit.empty()) return o->unit;
    const HeaderCell& cell = cells_[static_cast<size_t>(column)];
    if (!cell.unit.empty()) return cell.unit;
    // A name that is a channel's own, such as tau_m, says nothing about its unit.
    const auto own = channel_names();
    const bool is_own = std::find(own.begin(), own.end(), cell.name) != own.end();
    const auto suffix = is_own ? std::nullopt : split_unit_suffix(cell.name);
    if (!suffix) return "";
    report(FaultKind::missing_unit, Severity::note, column + 1, s.name,
           fmt::format("'{}' has no [unit]; '{}' is taken from its name", cell.whole, suffix->unit),
           "");
    return suffix->unit;
  }

  std::optional<MappedColumn> find(const ChannelSpec& s) {
    const int column = column_of(s);
    if (column < 0 && !override_of(s)) return integral(s);
    if (column < 0) return std::nullopt;
    used_[static_cast<size_t>(column)] = true;
    const std::string& whole = cells_[static_cast<size_t>(column)].whole;
    const std::string text = unit_of(s, column);
    if (text.empty()) {
      report(FaultKind::missing_unit, Severity::stop, column + 1, s.name,
             fmt::format("column '{}' has no unit, channel '{}' is in {}", whole, s.name, s.unit),
             fmt::format("write '{} [{}]' in the header, or --map \"{}={} [unit]\"", whole, s.unit,
                         s.name, whole));
      return std::nullopt;
    }
    const std::optional<Unit> wanted = parse_unit(s.unit);
    const std::optional<Unit> given = text == kWhateverSi ? wanted : parse_unit(text);
    if (given && s.role == ChannelRole::effort && convertible(*given, *parse_unit("A")))
      return current(s, column, given->factor);
    if (const auto rate = parse_unit(s.unit + "/s");
        given && s.role == ChannelRole::position && rate && convertible(*given, *rate))
      return integral_of(s, column, given->factor / rate->factor);
    if (!given || !convertible(*given, *wanted)) {
      report(FaultKind::wrong_unit, Severity::stop, column + 1, s.name,
             given ? fmt::format("'{}' cannot be a unit of channel '{}', which is in {}", text,
                                 s.name, s.unit)
                   : fmt::format("'{}' is no unit that is known here; channel '{}' is in {}", text,
                                 s.name, s.unit),
             "the log is not used");
      return std::nullopt;
    }
    return MappedColumn{column + 1, given->factor / wanted->factor, s};
  }

  /// An effort that is logged as the current of its motor.
  std::optional<MappedColumn> current(const ChannelSpec& s, int column, double ampere) {
    const std::string& whole = cells_[static_cast<size_t>(column)].whole;
    if (s.per_ampere > 0.0) {
      report(FaultKind::missing_unit, Severity::note, column + 1, s.name,
             fmt::format("'{}' is a current", whole),
             fmt::format("'{}' is {:.6g} {}/A of it", s.name, s.per_ampere, s.unit));
      return MappedColumn{column + 1, ampere * s.per_ampere, s, true};
    }
    if (s.keep_ampere) return MappedColumn{column + 1, ampere, s, true};
    report(FaultKind::wrong_unit, Severity::stop, column + 1, s.name,
           fmt::format("'{}' is a current, channel '{}' is in {}", whole, s.name, s.unit),
           fmt::format("say how much of it 1 A makes: --torque-constant \"{}=VALUE\" in {}/A, or "
                       "in channels.toml",
                       s.name.starts_with("tau_") ? s.name.substr(4) : s.name, s.unit));
    return std::nullopt;
  }

  void note_unused() {
    std::vector<std::string> unused;
    int first = 0;
    for (size_t i = 0; i < cells_.size(); ++i) {
      if (used_[i]) continue;
      if (first == 0) first = static_cast<int>(i) + 1;
      unused.push_back(cells_[i].whole);
    }
    if (!unused.empty())
      report(FaultKind::row_length, Severity::note, first, "",
             fmt::format("columns that are no channel of this model: {}", listed(unused)),
             "they stay unused");
  }

  const std::vector<ChannelSpec>& specs_;
  std::string file_;
  long row_;
  std::vector<HeaderCell> cells_;
  std::vector<bool> used_;
  std::vector<Override> overrides_;
  std::vector<DataFault> faults_;
};

}  // namespace

bool names_channel(const std::vector<std::string>& header,
                   const std::vector<std::string>& overrides, const std::string& channel) {
  const auto is = [wanted = lower(channel)](std::string_view name) {
    return lower(name) == wanted;
  };
  for (const std::string& text : overrides)
    if (is(trimmed(std::string_view(text).substr(0, text.find('='))))) return true;
  return std::any_of(header.begin(), header.end(), [&](const std::string& cell) {
    const NameAndUnit parts = split_name_and_unit(cell);
    if (is(parts.name) || is(trimmed(cell))) return true;
    const auto suffix = parts.unit.empty() ? split_unit_suffix(parts.name) : std::nullopt;
    return suffix && is(suffix->name);
  });
}

ColumnMap map_columns(const std::vector<std::string>& header, const std::vector<ChannelSpec>& specs,
                      const std::vector<std::string>& overrides, const std::string& file,
                      long header_row) {
  return Mapper(header, specs, file, header_row).map(overrides);
}

}  // namespace sinew
