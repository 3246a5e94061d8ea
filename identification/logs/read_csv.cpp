// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/read_csv.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "identification/logs/csv_rows.h"
#include "identification/logs/data_faults.h"
#include "identification/logs/full_turns.h"
#include "identification/logs/inspect.h"
#include "identification/logs/running_integral.h"
#include "identification/logs/sha256.h"
#include "identification/logs/uniform_grid.h"

namespace sinew {
namespace {

std::vector<int> columns_of(const ColumnMap& map) {
  std::vector<int> columns{map.time.column};
  for (const MappedColumn& m : map.channels) columns.push_back(m.column);
  return columns;
}

class Reading {
 public:
  Reading(const std::string& path, const std::vector<ChannelSpec>& specs,
          const ReadOptions& options)
      : path_(path), options_(options), faults_(path), reader_(path) {
    log_.file = path;
    const CsvDialect& dialect = reader_.dialect();
    map_ = map_columns(dialect.header, specs, options.map, path, dialect.header_row);
    for (const DataFault& note : map_.notes) faults_.all().push_back(note);
  }

  Log read() {
    inspect();
    if (!wrapped_as_expected()) inspect();
    tell_wrapped();
    if (inspection_.rows == 0)
      faults_.add(FaultKind::too_short, Severity::stop, reader_.dialect().header_row + 1, 0, 0, "",
                  "no data after the header", "the log is not used");
    stop_if_needed();
    judge_time(inspection_.time, map_.time.column, faults_);
    const int cells = static_cast<int>(reader_.dialect().header.size());
    holes_ = judge_channels(inspection_, map_, cells, options_.longest_fill, faults_);
    stop_if_needed();
    build();
    describe_channels();
    if (log_.segments.empty())
      faults_.add(FaultKind::too_short, Severity::stop, reader_.dialect().header_row + 1, 0, 0, "",
                  "no stretch of the log is long enough to be used", "the log is not used");
    stop_if_needed();
    if (options_.check_consistency) judge_consistency(log_, used_specs(), faults_);
    stop_if_needed();
    log_.faults = std::move(faults_.all());
    return std::move(log_);
  }

 private:
  void stop_if_needed() {
    if (faults_.stops()) throw LogError(faults_.all());
  }

  std::vector<ChannelSpec> used_specs() const {
    std::vector<ChannelSpec> specs;
    for (const MappedColumn& m : map_.channels) specs.push_back(m.spec);
    return specs;
  }

  /// Jumps of a full turn are taken out at the first passage; it is made once more where they turn
  /// out to be none.
  bool wrapped_as_expected() {
    const std::vector<bool> wrapped = wrapped_channels(map_.channels, turns_);
    bool expected = true;
    for (size_t c = 0; c < wrapped.size(); ++c)
      expected = expected && (wrapped[c] || turns_[c].jumps() == 0);
    joined_ = wrapped;
    if (expected) return true;
    faults_ = FaultList(path_);
    for (const DataFault& note : map_.notes) faults_.all().push_back(note);
    inspection_ = Inspection();
    reader_ = CsvReader(path_);
    return false;
  }

  void tell_wrapped() {
    for (size_t c = 0; c < joined_.size(); ++c) {
      if (!joined_[c]) continue;
      const FullTurns& turns = turns_[c];
      const MappedColumn& m = map_.channels[c];
      faults_.add(FaultKind::wrapped_angle, Severity::repaired, turns.first_row(),
                  turns.first_row(), m.column, m.spec.name,
                  fmt::format("'{}' jumps by a full turn, {} times in all: its angle is wrapped",
                              m.spec.name, turns.jumps()),
                  "the turns are joined");
    }
  }

  /// What is followed from row to row, at the beginning of a passage.
  void start_passage() {
    turns_.assign(map_.channels.size(), FullTurns());
    integrals_.assign(map_.channels.size(), RunningIntegral());
  }

  /// A row's values in SI units, velocities integrated where a position is asked for, wrapped
  /// angles joined; NaN where a cell has no number.
  std::vector<double> values_of(const CsvRow& row) {
    std::vector<double> values(map_.channels.size());
    for (size_t c = 0; c < values.size(); ++c) {
      values[c] = row.value[c + 1] * map_.channels[c].factor;
      if (map_.channels[c].is_rate)
        values[c] = integrals_[c].push(row.value[0] * map_.time.factor, values[c]);
      if (joined_.empty() || joined_[c]) values[c] = turns_[c].push(row.line, values[c]);
    }
    return values;
  }

  /// Of wrapped angles: so many turns that the motion lies where the model's range is.
  std::vector<double> whole_turns() const {
    std::vector<double> shifts(map_.channels.size(), 0.0);
    for (size_t c = 0; c < shifts.size(); ++c) {
      const ChannelSpec& spec = map_.channels[c].spec;
      const double middle = 0.5 * (spec.low + spec.high);
      if (joined_[c]) shifts[c] = turns_[c].shift_towards(std::isfinite(middle) ? middle : 0.0);
    }
    return shifts;
  }

  void inspect() {
    start_passage();
    Sha256 hash;
    reader_.on_bytes([&](const char* bytes, size_t count) { hash.update(bytes, count); });
    reader_.select(columns_of(map_));
    for (const MappedColumn& m : map_.channels) inspection_.channels.emplace_back(m.factor);
    inspection_.missing.assign(map_.channels.size(), 0);
    CsvRow row;
    while (reader_.next(row)) inspect_row(row);
    inspection_.time.finish();
    for (ChannelInspector& channel : inspection_.channels) channel.finish();
    log_.sha256 = hash.finish();
    log_.rows = inspection_.rows;
  }

  void inspect_row(const CsvRow& row) {
    ++inspection_.rows;
    const int cells = static_cast<int>(reader_.dialect().header.size());
    if (row.cells > cells && inspection_.long_rows++ == 0) {
      inspection_.first_long_row = row.line;
      inspection_.cells_in_long_row = row.cells;
    }
    if (row.state[0] != CellState::number) report_cell(row, 0, map_.time);
    // The digits written are in the file's unit.
    inspection_.time.push(
        row.line, row.value[0] * map_.time.factor,
        row.time_decimals - static_cast<int>(std::lround(std::log10(map_.time.factor))));
    const std::vector<double> values = values_of(row);
    for (size_t c = 0; c < map_.channels.size(); ++c) {
      if (row.state[c + 1] != CellState::number) {
        ++inspection_.missing[c];
        report_cell(row, c + 1, map_.channels[c]);
      }
      inspection_.channels[c].push(row.line, values[c]);
    }
  }

  void report_cell(const CsvRow& row, size_t slot, const MappedColumn& column) {
    struct Text {
      FaultKind kind;
      const char* what;
    };
    const auto text = [&]() -> Text {
      switch (row.state[slot]) {
        case CellState::empty:
          return {FaultKind::missing_cell, "the cell is empty"};
        case CellState::nan:
          return {FaultKind::not_a_number, "the cell is no finite number"};
        case CellState::absent:
          return {FaultKind::row_length, "the row ends before this column"};
        default:
          return {FaultKind::not_numeric, "the cell is text, a number was expected"};
      }
    }();
    faults_.add(text.kind, Severity::repaired, row.line, row.line, column.column, column.spec.name,
                fmt::format("'{}': {}", column.spec.name, text.what),
                slot == 0 ? "the row is left out"
                          : fmt::format("up to {} such rows are interpolated, more are left out",
                                        options_.longest_fill));
  }

  GridSettings grid_settings() const {
    const TimeInspector& time = inspection_.time;
    GridSettings grid;
    grid.period = time.period();
    grid.longest_fill = options_.longest_fill;
    grid.time_column = map_.time.column;
    grid.count_rows = time.coarse();
    if (grid.count_rows)
      grid.period = (time.last() - time.first()) / static_cast<double>(time.count() - 1);
    const std::vector<DataFault>& found = faults_.all();
    grid.resample = std::any_of(found.begin(), found.end(),
                                [](const DataFault& f) { return f.kind == FaultKind::jitter; });
    const long for_memory =
        options_.max_values > 0
            ? 1L
            : (inspection_.rows + options_.max_samples - 1) / options_.max_samples;
    // 999.9 Hz is 1 kHz: a mean of stamps.
    const double for_rate = 1.01 / (grid.period * options_.max_rate);
    grid.decimation = static_cast<int>(std::max({1L, for_memory, static_cast<long>(for_rate)}));
    if (options_.max_values > 0)
      grid.stretches =
          spread_stretches(inspection_.rows,
                           std::min(options_.max_samples,
                                    options_.max_values / static_cast<long>(map_.channels.size())),
                           grid.decimation);
    return grid;
  }

  void tell_stretches(const GridSettings& grid) {
    if (grid.stretches.rows == 0) return;
    faults_.add(FaultKind::too_long, Severity::note, reader_.dialect().header_row + 1, 0, 0, "",
                fmt::format("{} s are more than is looked at",
                            std::lround(static_cast<double>(inspection_.rows) * grid.period)),
                fmt::format("stretches of {:.1f} s, evenly spread over the log, are read",
                            static_cast<double>(grid.stretches.rows) * grid.period));
  }

  void build() {
    const GridSettings grid = grid_settings();
    tell_stretches(grid);
    log_.raw_period = grid.period;
    log_.decimation = grid.decimation;
    log_.period = grid.period * grid.decimation;
    std::sort(holes_.begin(), holes_.end(),
              [](const Hole& a, const Hole& b) { return a.first_row < b.first_row; });
    UniformBuilder builder(grid, map_.channels.size(), faults_);
    CsvReader again(path_);
    again.select(columns_of(map_));
    CsvRow row;
    const std::vector<double> shifts = whole_turns();
    start_passage();
    size_t first_hole = 0;
    while (again.next(row)) {
      std::vector<double> values = values_of(row);
      for (size_t c = 0; c < values.size(); ++c) values[c] += shifts[c];
      cut_holes(row.line, first_hole, values);
      builder.push(row.line, row.value[0] * map_.time.factor, values);
    }
    log_.segments = builder.finish();
  }

  // Holes are sorted by their first row; those that ended are passed over once and for all.
  void cut_holes(long line, size_t& first_hole, std::vector<double>& values) const {
    while (first_hole < holes_.size() && holes_[first_hole].last_row < line) ++first_hole;
    for (size_t h = first_hole; h < holes_.size() && holes_[h].first_row <= line; ++h)
      if (holes_[h].last_row >= line)
        values[holes_[h].channel] = std::numeric_limits<double>::quiet_NaN();
  }

  void describe_channels() {
    for (size_t c = 0; c < map_.channels.size(); ++c) {
      const MappedColumn& m = map_.channels[c];
      Channel channel;
      channel.name = m.spec.name;
      channel.unit = m.spec.unit;
      channel.role = m.spec.role;
      channel.column = m.column;
      channel.is_current = m.is_current;
      channel.quantum = inspection_.channels[c].quantum();
      channel.last_digit = inspection_.channels[c].last_digit();
      bool any = false;
      long longest = 0;
      for (const Segment& segment : log_.segments) {
        const auto samples = segment.samples.col(static_cast<long>(c));
        channel.low = any ? std::min(channel.low, samples.minCoeff()) : samples.minCoeff();
        channel.high = any ? std::max(channel.high, samples.maxCoeff()) : samples.maxCoeff();
        any = true;
        if (samples.size() <= longest) continue;
        longest = samples.size();
        channel.noise_floor = white_noise_rms(samples);
      }
      log_.channels.push_back(std::move(channel));
    }
  }

  std::string path_;
  ReadOptions options_;
  FaultList faults_;
  CsvReader reader_;
  ColumnMap map_;
  Inspection inspection_;
  std::vector<FullTurns> turns_;
  std::vector<RunningIntegral> integrals_;
  std::vector<bool> joined_;  ///< angles that are wrapped; empty: not known yet, all are followed
  std::vector<Hole> holes_;
  Log log_;
};

}  // namespace

Log read_csv(const std::string& path, const std::vector<ChannelSpec>& specs,
             const ReadOptions& options) {
  return Reading(path, specs, options).read();
}

std::vector<Log> read_csv(const std::vector<LogFile>& files, const ReadOptions& options) {
  std::vector<Log> logs(files.size());
  std::vector<std::exception_ptr> errors(files.size());
  tbb::parallel_for(0, static_cast<int>(files.size()), [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    try {
      logs[i] = read_csv(files[i].path, files[i].specs, options);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
  return logs;
}

}  // namespace sinew
