// SPDX-License-Identifier: GPL-3.0-or-later
// The first passage through a log: what its time and each channel look like, row by row, in memory
// that does not grow with the log.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

namespace sinew {

/// An even sample of a stream of unknown length: every stride-th value, the stride doubling.
class StridedSample {
 public:
  void push(double value) {
    if (seen_++ % stride_ != 0) return;
    if (values_.size() == capacity) halve();
    if ((seen_ - 1) % stride_ == 0) values_.push_back(value);
  }
  const std::vector<double>& values() const { return values_; }
  double quantile(double fraction) const;

 private:
  static constexpr size_t capacity = 8192;
  void halve();
  std::vector<double> values_;
  size_t seen_ = 0;
  size_t stride_ = 1;
};

/// Rows of one channel that look wrong, before it is known how the channel usually behaves.
struct SpikeCandidate {
  long first_row = 0, last_row = 0;
  double size = 0.0;   ///< deviation from the line through both neighbours
  double local = 0.0;  ///< mean deviation of the samples around it
};

struct RunCandidate {
  long first_row = 0, last_row = 0;
  long length = 0;
  double entry = 0.0;     ///< step into the run
  double approach = 0.0;  ///< step a row over the rows before it
  double jump = 0.0;      ///< step out of it; 0 where the log ends
  double value = 0.0;
  bool at_start = false, at_end = false;
};

/// Runs of the largest (or smallest) value.
struct ExtremeRuns {
  double value = 0.0;
  long samples = 0, runs = 0, longest = 0, first_row = 0;
  long counted_runs = 0;        ///< runs of at least three
  double entry_total = 0.0;     ///< sum of the steps into them
  double approach_total = 0.0;  ///< sum of the mean steps over the rows before
};

class ChannelInspector {
 public:
  /// unit: of the digits the values are written with, in the values' own unit.
  explicit ChannelInspector(double unit = 1.0) : unit_(unit) {}

  /// One row's value; NaN where the cell has none.
  void push(long row, double value);
  void finish();

  long count() const { return count_; }
  double low() const { return low_; }
  double high() const { return high_; }
  /// Smallest step where (nearly) all steps are its multiples, else 0.
  double quantum() const;
  /// What the values were rounded to on their way into the file: the last digit that at least some
  /// are written with, or that of single precision.
  double last_digit() const;
  /// rms of the white part, from third differences.
  double noise() const;
  /// Typical deviation of a sample from the line through its neighbours (1 sigma equivalent).
  double roughness() const;
  /// Quantile of the absolute steps that are not zero.
  double step(double fraction) const { return steps_.quantile(fraction); }
  /// Median of the mean step over a few rows, where it moves.
  double speed() const { return speeds_.quantile(0.5); }
  const std::vector<SpikeCandidate>& spikes() const { return spikes_; }
  const std::vector<RunCandidate>& runs() const { return runs_; }
  /// Share of rows that repeat the one before, long stand-stills left out.
  double repeated() const {
    return count_ > 1 ? static_cast<double>(repeats_) / static_cast<double>(count_ - 1) : 0.0;
  }
  /// Rows from one fresh value to the next where they come regularly: the source is so many times
  /// slower than the log. 1 where it is not, or a quantum alone holds the values.
  long rows_a_value() const;
  const ExtremeRuns& at_high() const { return at_high_; }
  const ExtremeRuns& at_low() const { return at_low_; }

  /// Rows before a run that its approach is the mean step of.
  static constexpr long approach_rows = 16;

 private:
  double least_step() const;
  bool is_of_digits(double step) const;
  struct Pending {
    SpikeCandidate candidate;
    long due = 0;
  };
  void push_step(long row, double value);
  void look_for_spike(int width);
  void close_run(double next, bool ended);
  double mean_step() const;
  void extreme(ExtremeRuns& runs, double value, long row, bool repeats) const;

  double unit_;
  long count_ = 0;
  long repeats_ = 0;
  double low_ = 0.0, high_ = 0.0;
  double window_[7] = {};
  long rows_[7] = {};
  int filled_ = 0;
  double local_ = 0.0;
  StridedSample steps_, third_, rough_, speeds_;
  double trail_[approach_rows] = {};  // ring of the last values
  std::deque<Pending> pending_;
  std::vector<SpikeCandidate> spikes_;
  std::vector<RunCandidate> runs_;
  std::array<long, 64> holds_{};  ///< how often a value stood for so many rows
  RunCandidate run_;
  ExtremeRuns at_high_, at_low_;
};

/// The time column.
class TimeInspector {
 public:
  void push(long row, double time, int decimals);
  void finish();

  long count() const { return count_; }
  /// Mean of the steps within half of the median: the sampling period; 0 where there is none.
  double period() const;
  /// Median of |step - period| / period, as 1 sigma, of the usual steps.
  double jitter() const;
  /// Largest |step - period| / period among steps that are no gap.
  double worst_jitter() const { return worst_; }
  long worst_row() const { return worst_row_; }
  /// Steps off by more than a tenth of the period.
  long off_steps() const { return off_; }
  /// Share of all steps, gaps and repeats too, that are off by more than a tenth.
  double uneven() const {
    return count_ > 1 ? static_cast<double>(uneven_) / static_cast<double>(count_ - 1) : 0.0;
  }
  /// Stamps too coarse for the period: they tell the time of no row.
  bool coarse() const { return resolution_ > 0.5 * period() && uneven() > 0.05; }
  /// One unit of the last digit written.
  double resolution() const { return resolution_; }
  double first() const { return first_; }
  double last() const { return last_; }
  bool rounded() const;

 private:
  void settle();
  void use(double step, long row);
  long count_ = 0;
  double first_ = 0.0, last_ = 0.0;
  double previous_ = 0.0;
  int decimals_ = -100;
  double resolution_ = 0.0;
  StridedSample steps_;
  std::vector<std::pair<double, long>> early_;
  double median_ = 0.0;
  double sum_ = 0.0;
  long used_ = 0;
  double worst_ = 0.0;
  long worst_row_ = 0;
  long off_ = 0;
  long uneven_ = 0;
};

}  // namespace sinew
