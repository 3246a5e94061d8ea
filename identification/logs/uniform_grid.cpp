// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/uniform_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sinew {
namespace {

using std::numbers::pi;
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

// Windowed sinc (Blackman), cut off at 0.4 of the new sampling rate; unit gain at rest.
std::vector<double> low_pass(int factor, long half) {
  std::vector<double> taps(static_cast<size_t>(2 * half + 1));
  const double cut = 0.4 / factor;
  double sum = 0.0;
  for (long i = -half; i <= half; ++i) {
    const auto x = static_cast<double>(i);
    const double w = x / static_cast<double>(half + 1);
    const double window = 0.42 + 0.5 * std::cos(pi * w) + 0.08 * std::cos(2.0 * pi * w);
    const double sinc = i == 0 ? 2.0 * cut : std::sin(2.0 * pi * cut * x) / (pi * x);
    taps[static_cast<size_t>(i + half)] = sinc * window;
    sum += sinc * window;
  }
  for (double& tap : taps) tap /= sum;
  return taps;
}

// Value at `fraction` of the way from y0 to y1, with the slopes (per whole way) at both.
double hermite(double y0, double m0, double y1, double m1, double s) {
  const double t = 1.0 - s;
  return y0 * (1.0 + 2.0 * s) * t * t + m0 * s * t * t + y1 * s * s * (1.0 + 2.0 * t) -
         m1 * s * s * t;
}

}  // namespace

Stretches spread_stretches(long rows, long kept, int decimation) {
  constexpr long kMostPieces = 8, kSamplesOfPiece = 3000;
  if (rows <= kept * decimation) return {};
  const long pieces = std::clamp(kept / kSamplesOfPiece, 2L, kMostPieces);
  const long each = std::max(1L, kept / pieces) * decimation;
  return {each, (rows - each) / (pieces - 1)};
}

Decimator::Decimator(int factor, size_t channels)
    : factor_(factor), channels_(channels), half_(factor > 1 ? 10L * factor : 0) {
  if (factor_ > 1) taps_ = low_pass(factor_, half_);
}

double Decimator::at(long row, size_t channel) const {
  const auto read = [&](long r) {
    return rows_[static_cast<size_t>(r - first_kept_) * channels_ + channel];
  };
  if (row < 0) return 2.0 * read(0) - read(std::min(-row, count_ - 1));
  if (end_ >= 0 && row >= end_)
    return 2.0 * read(end_ - 1) - read(std::max(2 * (end_ - 1) - row, first_kept_));
  return read(row);
}

void Decimator::emit(std::vector<double>& out) {
  for (size_t c = 0; c < channels_; ++c) {
    double sum = 0.0;
    const long from = next_ - half_;
    if (from >= first_kept_ && next_ + half_ < count_) {
      const double* x = rows_.data() + static_cast<size_t>(from - first_kept_) * channels_ + c;
      for (size_t i = 0; i < taps_.size(); ++i) sum += taps_[i] * x[i * channels_];
    } else {
      for (size_t i = 0; i < taps_.size(); ++i)
        sum += taps_[i] * at(from + static_cast<long>(i), c);
    }
    out.push_back(sum);
  }
  next_ += factor_;
}

void Decimator::push(const std::vector<double>& row, std::vector<double>& out) {
  if (factor_ == 1) {
    out.insert(out.end(), row.begin(), row.end());
    return;
  }
  rows_.insert(rows_.end(), row.begin(), row.end());
  ++count_;
  while (next_ + half_ < count_) emit(out);
  // Reflection at the end reaches back 2 half; nothing older is needed.
  const long keep_from = next_ - 2 * half_ - factor_;
  if (keep_from - first_kept_ > 8 * half_) {
    rows_.erase(rows_.begin(),
                rows_.begin() + (keep_from - first_kept_) * static_cast<long>(channels_));
    first_kept_ = keep_from;
  }
}

void Decimator::finish(std::vector<double>& out) {
  end_ = count_;
  while (factor_ > 1 && next_ < end_) emit(out);
}

UniformBuilder::UniformBuilder(const GridSettings& settings, size_t channels, FaultList& faults)
    : settings_(settings),
      channels_(channels),
      faults_(faults),
      longest_step_((settings.resample ? 1.75 : 1.5) * settings.period) {}

void UniformBuilder::push(long line, double time, const std::vector<double>& values) {
  if (!std::isfinite(time)) {
    ++dropped_;
    return;
  }
  if (settings_.count_rows) {
    time = have_last_ ? last_time_ + settings_.period : time;
    have_last_ = true;
    last_time_ = time;
    accept({line, time, values});
    return;
  }
  order({line, time, values});
}

// Rows that are not in order are held until the next one tells whether the stamp or the log jumped.
void UniformBuilder::order(Row row) {
  if (held_.any && !settle_held(row)) return;
  if (!have_last_) {
    have_last_ = true;
    last_time_ = row.time;
    accept(std::move(row));
    return;
  }
  const double step = row.time - last_time_;
  if (std::abs(step) < 0.02 * settings_.period) {
    faults_.add(FaultKind::duplicate_time, Severity::repaired, row.line, row.line,
                settings_.time_column, "time", fmt::format("the time {} s occurs twice", row.time),
                "the second row is left out");
    return;
  }
  if (step < 0.0 || step > longest_step_) {
    held_ = {true, step < 0.0, std::move(row)};
    return;
  }
  last_time_ = row.time;
  accept(std::move(row));
}

void UniformBuilder::drop_glitch() {
  faults_.add(FaultKind::backward_time, Severity::repaired, held_.row.line, held_.row.line,
              settings_.time_column, "time",
              fmt::format("the time {} s is out of order (the row before has {} s)", held_.row.time,
                          last_time_),
              "the row is left out");
  ++dropped_;
  held_.any = false;
}

// Returns false where `next` has been dealt with too.
bool UniformBuilder::settle_held(const Row& next) {
  if (!held_.backward) {
    if (next.time > last_time_ && next.time <= held_.row.time) {
      drop_glitch();
      return true;
    }
    Row row = std::move(held_.row);
    held_.any = false;
    last_time_ = row.time;
    accept(std::move(row));
    return true;
  }
  if (next.time > last_time_ || next.time <= held_.row.time) {
    drop_glitch();
    return true;
  }
  faults_.add(FaultKind::time_restart, Severity::repaired, held_.row.line, held_.row.line,
              settings_.time_column, "time",
              fmt::format("the time goes back from {} s to {} s and runs on from there", last_time_,
                          held_.row.time),
              "a new stretch begins here");
  end_stretch();
  Row row = std::move(held_.row);
  held_.any = false;
  last_time_ = row.time;
  accept(std::move(row));
  return true;
}

void UniformBuilder::accept(Row row) {
  if (in_stretch_) {
    const double before = settings_.resample ? recent_.back().time : placed_time_;
    const long missing = std::lround((row.time - before) / settings_.period) - 1;
    if (row.time - before > longest_step_ && missing > dropped_ && missing > 0) {
      const bool fill = missing <= settings_.longest_fill;
      faults_.add(
          FaultKind::gap, Severity::repaired, row.line, row.line, settings_.time_column, "time",
          fmt::format("{} samples are missing between {} s and {} s", missing, before, row.time),
          fill ? "they are interpolated" : "a new stretch begins here");
    }
    if (missing > settings_.longest_fill) end_stretch();
  }
  dropped_ = 0;
  if (!in_stretch_) {
    in_stretch_ = true;
    origin_ = row.time;
    placed_ = 0;
  }
  if (!settings_.resample) {
    place(std::move(row));
    return;
  }
  recent_.push_back(std::move(row));
  resample(false);
}

void UniformBuilder::place(Row row) {
  if (placed_ > 0) {
    const long steps = std::lround((row.time - placed_time_) / settings_.period);
    if (steps > 1) emit_missing(steps - 1);
  }
  placed_time_ = row.time;
  emit(std::move(row));
}

void UniformBuilder::emit_missing(long count) {
  for (long i = 0; i < count; ++i) {
    Row row;
    row.values.assign(channels_, no_value);
    emit(std::move(row));
  }
}

// Rows 1 and 2 of four: the grid points between them are known once the fourth is there.
void UniformBuilder::resample(bool last) {
  for (;;) {
    const size_t left =
        recent_.size() > 1 && placed_time_ >= recent_[1].time && placed_ > 0 ? 1 : 0;
    const size_t needed = last ? left + 2 : left + 3;
    if (recent_.size() < needed) return;
    const double from = recent_[left].time, to = recent_[left + 1].time;
    for (;;) {
      const double time = origin_ + static_cast<double>(placed_) * settings_.period;
      if (time >= to - 1.0e-9 * settings_.period &&
          !(last && recent_.size() == needed && time <= to + 1.0e-9 * settings_.period))
        break;
      Row row{recent_[left].line, time, {}};
      row.values = to - from > longest_step_ && time - from > 0.3 * settings_.period
                       ? std::vector<double>(channels_, no_value)
                       : between(left, time);
      emit(std::move(row));
    }
    placed_time_ = to;
    if (left == 1) recent_.pop_front();
    if (last && recent_.size() <= 2) return;
  }
}

std::vector<double> UniformBuilder::between(size_t left, double time) const {
  size_t first = left, count = 2;
  const auto close = [&](size_t i) {
    return recent_[i + 1].time - recent_[i].time < longest_step_;
  };
  if (left > 0 && left + 2 < recent_.size() && close(left - 1) && close(left) && close(left + 1)) {
    first = left - 1;
    count = 4;
  }
  std::vector<double> values(channels_, 0.0);
  for (size_t i = 0; i < count; ++i) {
    double weight = 1.0;
    for (size_t j = 0; j < count; ++j)
      if (j != i)
        weight *=
            (time - recent_[first + j].time) / (recent_[first + i].time - recent_[first + j].time);
    for (size_t c = 0; c < channels_; ++c) values[c] += weight * recent_[first + i].values[c];
  }
  return values;
}

void UniformBuilder::emit(Row row) {
  row.time = origin_ + static_cast<double>(placed_++) * settings_.period;
  ahead_.push_back(std::move(row));
  release(false);
}

// A row goes on once enough rows behind it are known to fill its holes.
void UniformBuilder::release(bool flush) {
  const auto wanted = static_cast<size_t>(settings_.longest_fill + 2);
  while (!ahead_.empty() && (flush || ahead_.size() > wanted)) {
    fill_front();
    const Row row = std::move(ahead_.front());
    ahead_.pop_front();
    const bool whole = std::all_of(row.values.begin(), row.values.end(),
                                   [](double v) { return std::isfinite(v); });
    const bool looked_at = settings_.stretches.holds(released_++);
    if (whole && looked_at)
      store(row);
    else
      end_segment();
  }
}

void UniformBuilder::fill_front() {
  if (!in_segment_) return;
  for (size_t c = 0; c < channels_; ++c)
    if (!std::isfinite(ahead_.front().values[c]) && !fill_channel(c)) return;
}

bool UniformBuilder::fill_channel(size_t c) {
  size_t next = 1;
  while (next < ahead_.size() && !std::isfinite(ahead_[next].values[c])) ++next;
  if (next >= ahead_.size() || next > static_cast<size_t>(settings_.longest_fill)) return false;
  const double y0 = before_[c], y1 = ahead_[next].values[c];
  const auto way = static_cast<double>(next + 1);
  double m0 = y1 - y0, m1 = y1 - y0;
  if (!before_that_.empty()) m0 = (y0 - before_that_[c]) * way;
  if (next + 1 < ahead_.size() && std::isfinite(ahead_[next + 1].values[c]))
    m1 = (ahead_[next + 1].values[c] - y1) * way;
  for (size_t i = 0; i < next; ++i)
    ahead_[i].values[c] = hermite(y0, m0, y1, m1, static_cast<double>(i + 1) / way);
  return true;
}

void UniformBuilder::store(const Row& row) {
  if (!in_segment_) {
    in_segment_ = true;
    segment_start_ = row.time;
    segment_line_ = row.line;
    segment_rows_ = 0;
    kept_.clear();
    decimator_.assign(1, Decimator(settings_.decimation, channels_));
  }
  before_that_ = std::move(before_);
  before_ = row.values;
  if (segment_rows_ == 0) before_that_.clear();
  ++segment_rows_;
  decimator_.front().push(row.values, kept_);
}

void UniformBuilder::end_segment() {
  if (!in_segment_) return;
  in_segment_ = false;
  if (segment_rows_ < settings_.shortest_segment) {
    faults_.add(FaultKind::too_short, Severity::note, segment_line_, segment_line_, 0, "",
                fmt::format("a stretch of only {} rows", segment_rows_), "it is left out");
    return;
  }
  decimator_.front().finish(kept_);
  Segment segment;
  segment.start = segment_start_;
  segment.first_row = segment_line_;
  const auto rows = static_cast<long>(kept_.size() / channels_);
  segment.samples =
      Eigen::Map<const Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          kept_.data(), rows, static_cast<long>(channels_));
  segments_.push_back(std::move(segment));
}

void UniformBuilder::end_stretch() {
  if (settings_.resample) resample(true);
  recent_.clear();
  release(true);
  end_segment();
  in_stretch_ = false;
}

std::vector<Segment> UniformBuilder::finish() {
  if (held_.any) {
    if (held_.backward)
      drop_glitch();
    else
      accept(std::move(held_.row));
  }
  end_stretch();
  return std::move(segments_);
}

}  // namespace sinew
