// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/data_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr double spike_size = 12.0;   // in units of the usual deviation from the neighbours' line
constexpr double most_missing = 0.2;  // of a channel's cells
constexpr double slowest = 0.2,
                 fastest = 1.0e-5;  // sampling periods that a drive's log can have, s

// A signal whose noise is larger than its quantum never repeats a value for long.
bool is_noisy(const ChannelInspector& channel) {
  return channel.noise() > 2.0 * channel.quantum() && channel.noise() > 1.0e-9 * channel.high() &&
         channel.noise() > 1.0e-7 * (channel.high() - channel.low());
}

struct Judge {
  const Inspection& inspection;
  const ColumnMap& columns;
  int longest_fill;
  FaultList& faults;
  std::vector<Hole> holes;

  const MappedColumn& column(size_t c) const { return columns.channels[c]; }

  void add(size_t c, FaultKind kind, Severity severity, long first, long last,
           const std::string& meaning, const std::string& action) {
    faults.add(kind, severity, first, last, column(c).column, column(c).spec.name, meaning, action);
  }

  std::string repair(long length) const {
    return length <= longest_fill ? "they are interpolated" : "these rows are left out";
  }

  void dead(size_t c) {
    const ChannelInspector& channel = inspection.channels[c];
    const ChannelSpec& spec = column(c).spec;
    if (channel.count() == 0) {
      add(c, FaultKind::missing_cell, spec.required ? Severity::stop : Severity::doubtful, 0, 0,
          fmt::format("'{}' has no number in any row", spec.name), "the channel cannot be used");
      return;
    }
    const long missing = inspection.missing[c];
    if (static_cast<double>(missing) > most_missing * static_cast<double>(inspection.rows))
      add(c, FaultKind::missing_cell, spec.required ? Severity::stop : Severity::doubtful, 0, 0,
          fmt::format("'{}' has no number in {} of {} rows", spec.name, missing, inspection.rows),
          "too many to go on with it");
    if (channel.low() == channel.high() && channel.count() > 1 && !spec.is_set)
      add(c, FaultKind::constant_channel,
          spec.required && (spec.role == ChannelRole::position || spec.role == ChannelRole::effort)
              ? Severity::stop
              : Severity::doubtful,
          0, 0,
          fmt::format("'{}' has the same value {} in every row; a measurement changes", spec.name,
                      channel.low()),
          "the channel says nothing");
  }

  void spikes(size_t c) {
    const ChannelInspector& channel = inspection.channels[c];
    const double usual = std::max(
        {channel.roughness(), channel.quantum(), 1.0e-6 * (channel.high() - channel.low())});
    for (const SpikeCandidate& spike : channel.spikes()) {
      const double scale = std::max(usual, 1.25 * spike.local);
      if (spike.size < spike_size * scale) continue;
      add(c, FaultKind::spike, Severity::repaired, spike.first_row, spike.last_row,
          fmt::format("'{}' jumps by {:.4g} and back; its neighbours differ by about {:.2g}",
                      column(c).spec.name, spike.size, scale),
          "the value is interpolated");
      holes.push_back({c, spike.first_row, spike.last_row});
    }
  }

  bool is_stuck(const ChannelInspector& channel, const ChannelSpec& spec,
                const RunCandidate& run) const {
    if (spec.role == ChannelRole::reference || run.at_start || run.at_end) return false;
    if (spec.role == ChannelRole::position && is_rest(channel, run)) return false;
    if (is_noisy(channel)) return is_unlikely(channel, run.length);
    if (spec.role == ChannelRole::current || spec.role == ChannelRole::other) return false;
    // A commanded effort may rest; it gets there slowly, or by a step as large as the others.
    const bool at_speed = std::abs(run.entry) > 0.3 * channel.step(0.5) &&
                          std::abs(run.entry) < 4.0 * channel.step(0.98);
    if (spec.role == ChannelRole::effort && (!at_speed || channel.runs().size() > 8)) return false;
    const double largest_usual = std::max(channel.step(0.995), 2.5 * channel.quantum());
    return run.length >= 8 && std::abs(run.jump) > 2.5 * largest_usual;
  }

  // A joint at rest leaves its reading by a step or two of its sensor, which may be coarser than
  // the file's digits. A reading that was stuck has the motion meanwhile to make up for.
  static bool is_rest(const ChannelInspector& channel, const RunCandidate& run) {
    const double sensor_step = std::max(channel.quantum(), channel.step(0.02));
    return std::abs(run.jump) < 2.5 * sensor_step;
  }

  // A source that is slower than the log repeats its values all the time, in short runs.
  static bool is_unlikely(const ChannelInspector& channel, long length) {
    const double p = std::max(channel.repeated(), 1.0e-3);
    return static_cast<double>(channel.count()) * std::pow(p, static_cast<double>(length - 1)) <
           1.0e-4;
  }

  void held(size_t c) {
    const ChannelInspector& channel = inspection.channels[c];
    if (channel.low() == channel.high()) return;
    const long rows = channel.rows_a_value();
    if (rows > 1 && column(c).spec.role != ChannelRole::reference) {
      add(c, FaultKind::held_samples, Severity::doubtful, 0, 0,
          fmt::format(
              "'{}' is only fresh every {} rows: the log is written faster than the channel "
              "is measured",
              column(c).spec.name, rows),
          fmt::format("the rows are kept; it is up to {} rows late, and delays and fast effects "
                      "cannot be told",
                      rows - 1));
      return;
    }
    if (!is_noisy(channel) || channel.repeated() < 0.2) return;
    add(c, FaultKind::held_samples, Severity::doubtful, 0, 0,
        fmt::format("'{}' repeats the value before in {:.0f} % of the rows: the log is written "
                    "faster than the channel is measured",
                    column(c).spec.name, 100.0 * channel.repeated()),
        "the rows are kept; delays shorter than the repeats cannot be told");
  }

  void stuck(size_t c) {
    const ChannelInspector& channel = inspection.channels[c];
    if (channel.low() == channel.high()) return;
    for (const RunCandidate& run : channel.runs()) {
      if (!is_stuck(channel, column(c).spec, run)) continue;
      // A signal that sits at its limit is clipped, not stuck.
      const bool at_limit = run.value == channel.high() || run.value == channel.low();
      if (at_limit && std::abs(run.jump) < 2.5 * channel.step(0.995)) continue;
      add(c, FaultKind::stuck, Severity::repaired, run.first_row, run.last_row,
          fmt::format("'{}' keeps one value for {} rows and then jumps by {:.4g}",
                      column(c).spec.name, run.length, run.jump),
          repair(run.length - 1));
      holes.push_back({c, run.first_row + 1, run.last_row});
    }
  }

  void clipping(size_t c) {
    const ChannelInspector& channel = inspection.channels[c];
    const ChannelSpec& spec = column(c).spec;
    if (spec.role == ChannelRole::reference || channel.low() == channel.high()) return;
    for (const ExtremeRuns* runs : {&channel.at_high(), &channel.at_low()}) {
      if (!is_clipped(channel, *runs)) continue;
      const double value = runs == &channel.at_high() ? runs->value : -runs->value;
      add(c, FaultKind::clipping, Severity::doubtful, runs->first_row, runs->first_row,
          fmt::format("'{}' stays at its limit {:.6g} in {} rows, up to {} in a row; the signal "
                      "is cut off there",
                      spec.name, value, runs->samples, runs->longest),
          spec.role == ChannelRole::effort
              ? "the rows are kept: a commanded limit is the true effort, a sensor's limit is not"
              : "the rows are kept");
    }
  }

  // A motion that turns round stays within one of its sensor's quanta for as long as a parabola
  // does: the slower it comes, the longer. Its deceleration follows from the rows before.
  static bool turns_round(const ChannelInspector& channel, const ExtremeRuns& runs) {
    constexpr double kLonger = 1.5;
    const double approach = runs.approach_total / static_cast<double>(runs.counted_runs);
    const double rows = static_cast<double>(runs.longest);
    const double deceleration = approach / (0.5 * ChannelInspector::approach_rows + 0.5 * rows);
    return rows * rows < kLonger * kLonger * 8.0 * channel.quantum() / deceleration;
  }

  // What stands nearly all the time, wherever it stands, is set and not measured: a guide's angle, a
  // load on a hook.
  static bool is_setting(const ChannelInspector& channel) {
    constexpr double kStands = 0.9;
    long standing = 0;
    for (const RunCandidate& run : channel.runs()) standing += run.length;
    return static_cast<double>(standing) > kStands * static_cast<double>(channel.count());
  }

  // Cut off: the value is reached at speed and then does not change. A motion that comes to rest
  // at its end slows down before it gets there; a commanded step gets there at once.
  static bool is_clipped(const ChannelInspector& channel, const ExtremeRuns& runs) {
    if (runs.samples < 5 || runs.counted_runs == 0) return false;
    if (runs.longest < 2 * channel.rows_a_value()) return false;
    if (is_noisy(channel)) return true;
    if (is_setting(channel)) return false;
    const auto times = static_cast<double>(runs.counted_runs);
    const double entry = runs.entry_total / times, approach = runs.approach_total / times;
    if (entry > 4.0 * channel.step(0.98) || turns_round(channel, runs)) return false;
    // Where a row moves by less than some quanta, only the rows before tell the speed.
    if (channel.step(0.5) > 2.5 * channel.quantum())
      return entry > 0.3 * channel.step(0.5) && runs.longest >= 4;
    const double usual_run = channel.quantum() / std::max(channel.speed(), 1.0e-300);
    return approach > 0.4 * channel.speed() &&
           static_cast<double>(runs.longest) > std::max(4.0, 6.0 * usual_run);
  }
};

}  // namespace

void FaultList::add(FaultKind kind, Severity severity, long first_row, long last_row, int column,
                    const std::string& channel, const std::string& meaning,
                    const std::string& action) {
  auto& [times, last] = seen_[{kind, column}];
  if (times > 0 && first_row > 0) {
    DataFault& before = faults_[last];
    if (before.last_row > 0 && first_row == before.last_row + 1 && before.meaning == meaning) {
      before.last_row = last_row;
      return;
    }
    if (times >= listed) {
      ++before.count;
      return;
    }
  }
  ++times;
  last = faults_.size();
  faults_.push_back(
      {kind, severity, file_, first_row, last_row, column, channel, 1, meaning, action});
}

bool FaultList::stops() const {
  return std::any_of(faults_.begin(), faults_.end(),
                     [](const DataFault& f) { return f.severity == Severity::stop; });
}

std::vector<Hole> judge_channels(const Inspection& inspection, const ColumnMap& columns,
                                 int header_cells, int longest_fill, FaultList& faults) {
  if (inspection.long_rows > 0) {
    const bool all = 100 * inspection.long_rows > inspection.rows;
    faults.add(FaultKind::row_length, all ? Severity::stop : Severity::doubtful,
               inspection.first_long_row, inspection.first_long_row, header_cells + 1, "",
               fmt::format("{} cells where the header has {} (in {} rows){}",
                           inspection.cells_in_long_row, header_cells, inspection.long_rows,
                           all ? "; decimal commas need another separator, such as ';'" : ""),
               all ? "the log is not used" : "the cells beyond the header are not read");
  }
  Judge judge{inspection, columns, longest_fill, faults, {}};
  for (size_t c = 0; c < columns.channels.size(); ++c) {
    judge.dead(c);
    judge.spikes(c);
    judge.stuck(c);
    judge.held(c);
    judge.clipping(c);
  }
  return std::move(judge.holes);
}

void judge_time(const TimeInspector& time, int column, FaultList& faults) {
  const double dt = time.period();
  if (time.count() < 3 || dt <= 0.0) {
    faults.add(FaultKind::too_short, Severity::stop, 0, 0, column, "time",
               "the time does not run forward; expected at least three rising values",
               "the log is not used");
    return;
  }
  if (dt > slowest || dt < fastest) {
    const bool slow = dt > slowest;
    faults.add(FaultKind::time_unit, Severity::stop, 0, 0, column, "time",
               fmt::format("the sampling period would be {:.4g} s, which no drive is logged with; "
                           "is the time in {}?",
                           dt, slow ? "milliseconds" : "seconds already"),
               fmt::format("name the unit: --map \"time=#{} [{}]\"", column, slow ? "ms" : "s"));
    return;
  }
  if (time.coarse()) {
    faults.add(FaultKind::coarse_time, Severity::doubtful, 0, 0, column, "time",
               fmt::format("the time is written to {:.3g} s but the period is {:.3g} s",
                           time.resolution(), dt),
               "the rows are taken as evenly spaced; gaps cannot be seen");
    return;
  }
  if (!time.rounded() && (time.jitter() > 0.02 || time.off_steps() > 0))
    faults.add(FaultKind::jitter, Severity::repaired, time.worst_row(), time.worst_row(), column,
               "time",
               fmt::format("the sampling is uneven: {:.2g} of a period, at worst {:.2g}, {} steps "
                           "off by more than a tenth",
                           time.jitter(), time.worst_jitter(), time.off_steps()),
               "the log is resampled to even steps");
}

}  // namespace sinew
