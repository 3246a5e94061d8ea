// SPDX-License-Identifier: GPL-3.0-or-later
// What can be wrong with a log: found, named, and what is done about it.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "identification/logs/channel_map.h"
#include "identification/logs/inspect.h"
#include "identification/logs/log.h"

namespace sinew {

/// Collects findings: neighbouring rows become one, and after `listed` of a kind in a channel only
/// the number goes up.
class FaultList {
 public:
  static constexpr int listed = 20;
  explicit FaultList(std::string file) : file_(std::move(file)) {}
  void add(FaultKind kind, Severity severity, long first_row, long last_row, int column,
           const std::string& channel, const std::string& meaning, const std::string& action);
  std::vector<DataFault>& all() { return faults_; }
  const std::vector<DataFault>& all() const { return faults_; }
  const std::string& file() const { return file_; }
  bool stops() const;

 private:
  std::string file_;
  std::vector<DataFault> faults_;
  std::map<std::pair<FaultKind, int>, std::pair<int, size_t>> seen_;  ///< how many, the last one
};

/// Rows of one channel that must not be used. `channel` indexes ColumnMap::channels.
struct Hole {
  size_t channel = 0;
  long first_row = 0, last_row = 0;
};

/// What the first passage saw.
struct Inspection {
  TimeInspector time;
  std::vector<ChannelInspector> channels;
  std::vector<long> missing;  ///< cells without a number, per channel
  long rows = 0;
  long long_rows = 0;  ///< rows with more cells than the header
  long first_long_row = 0;
  int cells_in_long_row = 0;
};

/// Judges spikes, stuck values, clipping, dead channels and rows of the wrong length; what is to be
/// left out is returned.
std::vector<Hole> judge_channels(const Inspection& inspection, const ColumnMap& columns,
                                 int header_cells, int longest_fill, FaultList& faults);

/// Judges the sampling: period plausible, jitter, stamps too coarse.
void judge_time(const TimeInspector& time, int column, FaultList& faults);

/// Units by plausible range and by consistency, swapped columns, reversed signs: compares the
/// channels of each group (position, velocity, reference, effort) with one another and with what
/// the model expects. `specs` belong to log.channels, index by index.
void judge_consistency(const Log& log, const std::vector<ChannelSpec>& specs, FaultList& faults);

/// A ratio measured/expected explained by a wrong unit.
struct UnitSlip {
  double factor = 1.0;
  std::string meaning;  ///< "degrees taken for radians"
};
/// The slip whose factor is within `tolerance` (relative) of the ratio; an empty meaning if none
/// is. `unit` is the channel's SI unit and limits what comes into question.
UnitSlip unit_slip_of(double ratio, const std::string& unit, double tolerance);

}  // namespace sinew
