// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/inspect.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sinew {
namespace {

constexpr long shortest_run = 6;
constexpr long longest_hold = 20;  // rows; longer is a stand-still, not a slow source
constexpr size_t candidates_kept = 2048;
constexpr size_t early_steps = 2000;
constexpr size_t divisor_steps = 1000;  // the smallest ones, that tell a quantum
constexpr double most_quanta = 200.0;   // a step of more does not tell it
constexpr long context = 48;            // rows after a spike that still tell what is usual there

double quantile_of(std::vector<double> values, double fraction) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<size_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<long>(at), values.end());
  return values[at];
}

// The greatest common divisor of the smallest steps; larger ones carry more rounding error.
// `steps` rise; off: share of the divisor by which a multiple may be missed. 0 where there is none.
double common_divisor(const std::vector<double>& steps, double floor, double off) {
  double divisor = 0.0, products = 0.0, squares = 0.0;
  for (size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] < floor) return 0.0;
    if (divisor == 0.0) divisor = steps[i];
    const double times = std::round(steps[i] / divisor);
    if (times > most_quanta) break;
    const double rest = std::abs(steps[i] - divisor * times);
    if (rest > off * divisor) {
      if (i >= divisor_steps) continue;
      divisor = rest;
      products = squares = 0.0;
      continue;
    }
    // Values written with few digits: of the smallest steps as many are rounded down as up, and
    // the mean over all multiples is finer than any of them.
    products += times * steps[i];
    squares += times * times;
    divisor = products / squares;
  }
  // A motion under constant acceleration has small steps with a common divisor too, but not all.
  size_t near = 0, fitting = 0;
  for (const double step : steps) {
    if (step > most_quanta * divisor) break;
    ++near;
    fitting += std::abs(step - divisor * std::round(step / divisor)) <= off * divisor ? 1u : 0u;
  }
  return static_cast<double>(fitting) > 0.95 * static_cast<double>(near) ? divisor : 0.0;
}

}  // namespace

double StridedSample::quantile(double fraction) const {
  return quantile_of(values_, fraction);
}

void StridedSample::halve() {
  for (size_t i = 0; 2 * i < values_.size(); ++i) values_[i] = values_[2 * i];
  values_.resize((values_.size() + 1) / 2);
  stride_ *= 2;
}

void ChannelInspector::push(long row, double value) {
  if (!std::isfinite(value)) return;
  if (count_ == 0) low_ = high_ = value;
  low_ = std::min(low_, value);
  high_ = std::max(high_, value);
  push_step(row, value);
  ++count_;
  for (int i = 0; i < 6; ++i) {
    window_[i] = window_[i + 1];
    rows_[i] = rows_[i + 1];
  }
  window_[6] = value;
  rows_[6] = row;
  filled_ = std::min(filled_ + 1, 7);
  const double* w = window_;
  if (filled_ >= 4) third_.push(std::abs(w[6] - 3.0 * w[5] + 3.0 * w[4] - w[3]));
  if (filled_ >= 3) {
    const double rough = std::abs(w[5] - 0.5 * (w[4] + w[6]));
    rough_.push(rough);
    local_ += (rough - local_) / 32.0;
  }
  while (!pending_.empty() && pending_.front().due <= count_) {
    SpikeCandidate& done = pending_.front().candidate;
    done.local = std::max(done.local, local_);
    spikes_.push_back(done);
    pending_.pop_front();
  }
  if (filled_ == 7) {
    look_for_spike(1);
    look_for_spike(2);
  }
}

// A spike leaves its neighbours and comes back to them; a step does not come back.
void ChannelInspector::look_for_spike(int width) {
  const double* w = window_ + (width == 1 ? 1 : 0);
  const double left = w[1], right = w[2 + width];
  double size = 1.0e300;
  bool above = true, below = true;
  for (int i = 0; i < width; ++i) {
    const double deviation = w[2 + i] - 0.5 * (left + right);
    above = above && deviation > 0.0;
    below = below && deviation < 0.0;
    size = std::min(size, std::abs(deviation));
  }
  const double quiet = 0.35 * size;
  if (!(above || below) || size < 4.0 * local_ / (width + 3.0)) return;
  if (std::abs(right - left) > quiet || std::abs(left - w[0]) > quiet ||
      std::abs(w[3 + width] - right) > quiet)
    return;
  SpikeCandidate found;
  const long* r = rows_ + (width == 1 ? 1 : 0);
  found.first_row = r[2];
  found.last_row = r[1 + width];
  found.size = size;
  // The spike itself has entered the running mean three or four times; take its share out.
  found.local = std::max(0.0, local_ - size * (width + 2.0) / 32.0);
  pending_.push_back({found, count_ + context});
  if (spikes_.size() < candidates_kept) return;
  const auto middle = spikes_.begin() + static_cast<long>(candidates_kept / 2);
  std::nth_element(spikes_.begin(), middle, spikes_.end(),
                   [](const auto& a, const auto& b) { return a.size > b.size; });
  spikes_.resize(candidates_kept / 2);
}

void ChannelInspector::push_step(long row, double value) {
  const double before = window_[6];
  const bool repeats = count_ > 0 && value == before;
  if (repeats) {
    ++run_.length;
    if (run_.length <= longest_hold) ++repeats_;
    run_.last_row = row;
  } else {
    if (count_ > 0) {
      close_run(value, false);
      if (run_.length < static_cast<long>(holds_.size()))
        ++holds_[static_cast<size_t>(run_.length)];
      steps_.push(std::abs(value - before));
    }
    run_ = RunCandidate();
    run_.first_row = run_.last_row = row;
    run_.length = 1;
    run_.entry = count_ > 0 ? value - before : 0.0;
    run_.approach = mean_step();
    run_.value = value;
    run_.at_start = count_ == 0;
    if (run_.approach > 0.0) speeds_.push(run_.approach);
  }
  extreme(at_high_, value, row, repeats);
  extreme(at_low_, -value, row, repeats);
  trail_[count_ % approach_rows] = value;
}

// Over the rows before the newest one, which is not in the ring yet.
double ChannelInspector::mean_step() const {
  if (count_ < approach_rows) return 0.0;
  const double oldest = trail_[count_ % approach_rows];
  return std::abs(window_[6] - oldest) / static_cast<double>(approach_rows - 1);
}

void ChannelInspector::extreme(ExtremeRuns& runs, double value, long row, bool repeats) const {
  if (runs.samples == 0 || value > runs.value)
    runs = ExtremeRuns{value, 0, 0, 0, row, 0, 0.0, 0.0};
  else if (value < runs.value)
    return;
  ++runs.samples;
  if (!repeats) ++runs.runs;
  runs.longest = std::max(runs.longest, run_.length);
  if (run_.length == 3) {
    ++runs.counted_runs;
    runs.entry_total += std::abs(run_.entry);
    runs.approach_total += run_.approach;
  }
}

void ChannelInspector::close_run(double next, bool ended) {
  if (run_.length < shortest_run) return;
  run_.jump = ended ? 0.0 : next - window_[6];
  run_.at_end = ended;
  runs_.push_back(run_);
  if (runs_.size() < candidates_kept) return;
  const auto by_length = [](const auto& a, const auto& b) { return a.length > b.length; };
  const auto by_jump = [](const auto& a, const auto& b) {
    return std::abs(a.jump) > std::abs(b.jump);
  };
  const long half = static_cast<long>(candidates_kept / 4);
  std::nth_element(runs_.begin(), runs_.begin() + half, runs_.end(), by_length);
  std::nth_element(runs_.begin() + half, runs_.begin() + 2 * half, runs_.end(), by_jump);
  runs_.resize(static_cast<size_t>(2 * half));
}

void ChannelInspector::finish() {
  if (count_ > 0) close_run(window_[6], true);
  for (const Pending& p : pending_) spikes_.push_back(p.candidate);
  pending_.clear();
  const auto by_row = [](const auto& a, const auto& b) { return a.first_row < b.first_row; };
  std::sort(spikes_.begin(), spikes_.end(), by_row);
  std::sort(runs_.begin(), runs_.end(), by_row);
}

// Smaller differences are rounding errors of the numbers.
double ChannelInspector::least_step() const {
  return std::max(1.0e-8 * (high_ - low_), 64.0e-16 * std::max(std::abs(low_), std::abs(high_)));
}

bool ChannelInspector::is_of_digits(double step) const {
  const double power = std::log10(step / std::abs(unit_));
  return std::abs(power - std::round(power)) < 1.0e-3;
}

double ChannelInspector::last_digit() const {
  constexpr double kSome = 0.3;  // of numbers with nine digits in all, large ones end sooner
  const double single =
      double(std::numeric_limits<float>::epsilon()) * std::max(std::abs(low_), std::abs(high_));
  const double least = std::max(least_step(), single);
  const std::vector<double> steps = steps_.values();
  double digit = std::abs(unit_) * std::pow(10.0, std::ceil(std::log10(high_ - low_)));
  for (; digit > least; digit *= 0.1) {
    const auto fitting = std::count_if(steps.begin(), steps.end(), [&](double step) {
      const double times = std::round(step / digit);
      return times > 0.0 && std::abs(step - times * digit) < 1.0e-3 * digit;
    });
    if (static_cast<double>(fitting) > kSome * static_cast<double>(steps.size())) return digit;
  }
  return least;
}

double ChannelInspector::quantum() const {
  std::vector<double> steps = steps_.values();
  if (steps.size() < 4) return 0.0;
  std::sort(steps.begin(), steps.end());
  const double floor = least_step();
  // Few digits show themselves as a decimal step; the sensor's may stand above it, off by some of
  // them.
  const double exact = common_divisor(steps, floor, 0.05);
  if (exact > 0.0 && !is_of_digits(exact)) return exact;
  const double rounded = common_divisor(steps, floor, 0.12);
  return rounded > 5.0 * exact ? rounded : exact;
}

long ChannelInspector::rows_a_value() const {
  const auto most = std::max_element(holds_.begin(), holds_.end());
  const auto rows = static_cast<size_t>(most - holds_.begin());
  const long all = std::accumulate(holds_.begin(), holds_.end(), 0L);
  if (rows < 2 || all < 50 || 2 * *most < all || step(0.5) < 2.5 * quantum()) return 1;
  long regular = 0;  // two equal values in a row stand twice as long
  for (size_t times = rows; times < holds_.size(); times += rows) regular += holds_[times];
  return static_cast<double>(regular) > 0.95 * static_cast<double>(all) ? static_cast<long>(rows)
                                                                        : 1;
}

double ChannelInspector::noise() const {
  return third_.quantile(0.5) / (0.674489750196 * std::sqrt(20.0));
}

double ChannelInspector::roughness() const {
  return rough_.quantile(0.5) / 0.674489750196;
}

void TimeInspector::push(long row, double time, int decimals) {
  if (!std::isfinite(time)) return;
  decimals_ = std::max(decimals_, std::min(decimals, 15));
  if (count_ == 0) first_ = time;
  if (count_ > 0) {
    const double step = time - previous_;
    steps_.push(step);
    if (median_ > 0.0) {
      use(step, row);
    } else {
      early_.emplace_back(step, row);
      if (early_.size() >= early_steps) settle();
    }
  }
  previous_ = last_ = time;
  ++count_;
}

void TimeInspector::settle() {
  std::vector<double> positive;
  for (const auto& [step, row] : early_)
    if (step > 0.0) positive.push_back(step);
  median_ = quantile_of(positive, 0.5);
  if (median_ <= 0.0) return;
  const auto early = std::move(early_);
  early_.clear();
  for (const auto& [step, row] : early) use(step, row);
}

void TimeInspector::use(double step, long row) {
  if (std::abs(step - median_) < 0.5 * median_) {
    sum_ += step;
    ++used_;
  }
  const double off = std::abs(step / median_ - 1.0);
  if (off > 0.1) ++uneven_;
  if (step <= 0.0 || off > 0.8) return;
  if (off > 0.1) ++off_;
  if (off > worst_) {
    worst_ = off;
    worst_row_ = row;
  }
}

void TimeInspector::finish() {
  if (median_ <= 0.0) settle();
  resolution_ = decimals_ > -100 ? std::pow(10.0, -decimals_) : 0.0;
}

double TimeInspector::period() const {
  return used_ > 0 ? sum_ / static_cast<double>(used_) : 0.0;
}

double TimeInspector::jitter() const {
  const double dt = period();
  if (dt <= 0.0) return 0.0;
  std::vector<double> off;
  for (const double step : steps_.values())
    if (step > 0.0 && step < 1.8 * dt) off.push_back(std::abs(step / dt - 1.0));
  return quantile_of(off, 0.5) / 0.674489750196;
}

bool TimeInspector::rounded() const {
  // Two rounded stamps differ from the true step by at most one unit of the last digit.
  return worst_ * median_ <= 1.05 * resolution_;
}

}  // namespace sinew
