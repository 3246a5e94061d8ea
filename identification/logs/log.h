// SPDX-License-Identifier: GPL-3.0-or-later
// A measured log after reading: uniform stretches of channels in SI units, and what was wrong with
// it.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace sinew {

enum class FaultKind {
  missing_cell,
  not_a_number,
  not_numeric,
  row_length,
  missing_unit,
  wrong_unit,
  duplicate_time,
  backward_time,
  time_restart,
  gap,
  jitter,
  coarse_time,
  time_unit,
  unit_slip,
  swapped_columns,
  reversed_sign,
  constant_channel,
  clipping,
  stuck,
  held_samples,
  spike,
  wrapped_angle,
  out_of_range,
  discrepancy,
  too_short,
  too_long,
};

/// note: nothing was changed. repaired: the log was changed as `action` says. doubtful: kept, but a
/// result that rests on it needs a second look. stop: the log is not used.
enum class Severity { note, repaired, doubtful, stop };

/// One finding about a log. Rows are line numbers of the file (the first line is 1), columns count
/// from 1; 0 where it concerns no single row or column.
struct DataFault {
  FaultKind kind = FaultKind::missing_cell;
  Severity severity = Severity::note;
  std::string file;
  long row = 0;
  long last_row = 0;  ///< same as row for a single one
  int column = 0;
  std::string channel;
  long count = 1;       ///< occurrences that this finding stands for
  std::string meaning;  ///< what is wrong, and what was expected
  std::string action;   ///< what the program does about it
};

/// "unit slip", "backward time", ...
std::string fault_name(FaultKind kind);

/// "note", "repaired", "doubtful" or "stop".
std::string severity_name(Severity severity);

/// "file:row:column: what is wrong; action".
std::string message(const DataFault& fault);

/// The log cannot be used; what() carries every finding that stops it, one a line.
class LogError : public std::runtime_error {
 public:
  explicit LogError(std::vector<DataFault> findings);
  std::vector<DataFault> faults;
};

enum class ChannelRole { position, velocity, reference, effort, current, other };

/// One channel of a log. Values are in the SI unit named.
struct Channel {
  std::string name;
  std::string unit;
  ChannelRole role = ChannelRole::other;
  int column = 0;    ///< of the file, from 1
  double low = 0.0;  ///< smallest and largest value kept
  double high = 0.0;
  double quantum = 0.0;      ///< step of a quantised signal; 0 where none is seen
  double last_digit = 0.0;   ///< what its values were rounded to on their way into the file
  double noise_floor = 0.0;  ///< rms of the part that no smooth signal explains (kept samples)
  bool is_current = false;   ///< an effort that the file has as a current
};

/// What a diagnosis reads: its band and the turns of friction need no more [Hz].
inline constexpr double kDiagnosisRate = 1000.0;
/// Of a tendon-driven model, whose many channels would make every look at a log long: ten samples
/// of the fastest motion looked at [Hz].
inline constexpr double kTendonRate = 600.0;

/// Of either in a first look: up to 25 Hz are looked at [Hz].
inline constexpr double kFirstLookRate = 250.0, kFirstLookBand = 25.0;

/// Values of all channels that a diagnosis keeps of a log that is one of `logs`, so that its memory
/// and time do not grow with their length: one log of a finger with eight tendons and their motors
/// is kept for a minute, in a first look for ten seconds.
long diagnosis_values(std::size_t logs, bool first_look = false);

/// Samples of a segment that is worth diagnosing, at a sampling period [s]: the smoothers of the
/// motion are longer than a few hundred where samples are dense.
inline Eigen::Index shortest_segment(double period) {
  return std::max<Eigen::Index>(400, static_cast<Eigen::Index>(std::ceil(0.5 / period)));
}

/// A stretch without gaps. Sample k was taken at start + k * Log::period.
struct Segment {
  double start = 0.0;       ///< s, in the file's own time
  long first_row = 0;       ///< line of the file
  Eigen::ArrayXXd samples;  ///< one row a sample, one column a channel, SI units
};

struct Log {
  std::string file;
  std::string sha256;       ///< of the file's bytes, 64 hexadecimal digits
  long rows = 0;            ///< data rows in the file
  double raw_period = 0.0;  ///< s, as logged
  double period = 0.0;      ///< s, of the kept samples: raw_period * decimation
  int decimation = 1;
  std::vector<Channel> channels;
  std::vector<Segment> segments;
  std::vector<DataFault> faults;

  /// Index of a channel, -1 where the log has none of this name.
  int channel(const std::string& name) const;
  /// Kept samples of all segments together.
  long sample_count() const;
  /// One channel, segments joined end to end [sample_count()].
  Eigen::ArrayXd joined(int channel) const;
};

/// White part of a signal's noise: median of third differences, so that motion much slower than
/// the sampling leaves no trace (rms, the signal's unit).
double white_noise_rms(const Eigen::Ref<const Eigen::ArrayXd>& signal);

}  // namespace sinew
