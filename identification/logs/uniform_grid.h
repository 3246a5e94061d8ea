// SPDX-License-Identifier: GPL-3.0-or-later
// Rows with their time stamps -> uniform segments: order in time, short holes filled, long ones
// cut, jitter resampled, reduced to the number of samples that is kept.
#pragma once

#include <deque>
#include <vector>

#include "identification/logs/data_faults.h"
#include "identification/logs/log.h"

namespace sinew {

/// What is read of a log that is longer than is kept at its rate: pieces evenly spread over it. Its
/// rate, which fast effects need, stays, and so do its beginning and end, which slow ones need.
struct Stretches {
  long rows = 0;   ///< of each piece; 0: all rows are read
  long every = 1;  ///< rows from the beginning of one piece to that of the next
  bool holds(long row) const { return rows == 0 || row % every < rows; }
};
/// Two to eight pieces with `kept` samples together, which are every `decimation`-th of `rows`
/// rows.
Stretches spread_stretches(long rows, long kept, int decimation);

struct GridSettings {
  double period = 0.0;      ///< s
  bool resample = false;    ///< interpolate to the grid; else rows are taken as they stand
  bool count_rows = false;  ///< stamps coarser than the period: the row's number is its time
  int longest_fill = 5;     ///< samples that interpolation may fill
  int decimation = 1;
  long shortest_segment = 64;  ///< rows; a shorter stretch is left out
  int time_column = 1;
  Stretches stretches;
};

/// Keeps every n-th sample behind a symmetric low-pass (no phase shift), all channels alike. At
/// the ends the signal is continued by point reflection.
class Decimator {
 public:
  Decimator(int factor, size_t channels);
  /// Appends what is ready to `out` (rows of `channels` values).
  void push(const std::vector<double>& row, std::vector<double>& out);
  void finish(std::vector<double>& out);
  /// Taps on each side of the centre.
  long half() const { return half_; }

 private:
  double at(long row, size_t channel) const;
  void emit(std::vector<double>& out);
  int factor_;
  size_t channels_;
  long half_;
  std::vector<double> taps_;
  std::vector<double> rows_;
  long first_kept_ = 0;  ///< row number of rows_' first row
  long count_ = 0;
  long next_ = 0;  ///< row that the next output is centred on
  long end_ = -1;  ///< rows in the segment, once known
};

class UniformBuilder {
 public:
  UniformBuilder(const GridSettings& settings, size_t channels, FaultList& faults);
  /// One row of the file in SI units; NaN where a value is missing or not to be used.
  void push(long line, double time, const std::vector<double>& values);
  std::vector<Segment> finish();

 private:
  struct Row {
    long line = 0;
    double time = 0.0;
    std::vector<double> values;
  };
  struct Held {
    bool any = false;
    bool backward = false;
    Row row;
  };
  void order(Row row);
  bool settle_held(const Row& next);
  void drop_glitch();
  void accept(Row row);
  void place(Row row);
  void resample(bool last);
  std::vector<double> between(size_t left, double time) const;
  void emit(Row row);
  void emit_missing(long count);
  void release(bool flush);
  void fill_front();
  bool fill_channel(size_t channel);
  void store(const Row& row);
  void end_stretch();
  void end_segment();

  GridSettings settings_;
  size_t channels_;
  FaultList& faults_;
  double longest_step_;

  bool have_last_ = false;
  double last_time_ = 0.0;
  long dropped_ = 0;
  Held held_;

  bool in_stretch_ = false;
  double origin_ = 0.0;
  long placed_ = 0;  ///< grid points of this stretch so far
  double placed_time_ = 0.0;
  std::deque<Row> recent_;

  std::deque<Row> ahead_;
  std::vector<double> before_, before_that_;
  bool in_segment_ = false;
  double segment_start_ = 0.0;
  long segment_line_ = 0;
  long segment_rows_ = 0;
  long released_ = 0;  ///< rows so far, be they kept or not
  std::vector<double> kept_;
  std::vector<Decimator> decimator_;
  std::vector<Segment> segments_;
};

}  // namespace sinew
