// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/thinned_recording.h"

#include <algorithm>
#include <cmath>

#include "identification/regression/position_noise.h"

namespace sinew::diagnosis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Half the work of a frictional drive lies below 40 Hz; more band costs time and adds noise.
constexpr double kBand = 100.0;

// With four a period of the motion, quantisation of a sensor was told where six show none.
constexpr double kSamplesPerPeriod = 6.0;

}  // namespace

double highest_compared(const Recording& log, const Settings& settings) {
  const double band = settings.band_hz > 0.0 ? settings.band_hz : kBand;
  if (log.band_hz.empty()) return band;
  return std::min(band, *std::max_element(log.band_hz.begin(), log.band_hz.end()));
}

DecimatingFilter thinning_filter(double step, double band_hz) {
  const double rate = kSamplesPerPeriod * std::max(band_hz, motion_cutoff(step));
  const double factor = std::max(1.0, std::floor(1.0 / (step * rate)));
  return design_decimating_filter(step, 0.4 / (factor * step) * (1.0 - 1e-9));
}

Recording thinned(const Recording& log, const DecimatingFilter& filter) {
  Recording r;
  const auto take = [&](const MatrixXd& x) {
    return x.size() == 0 ? x : filter_decimate(filter, x);
  };
  r.name = log.name;
  r.log = log.log;
  r.step = log.step * filter.factor;
  r.time = take(log.time);
  r.log_start = log.log_start;
  r.q = take(log.q);
  r.qd = take(log.qd);
  r.qdd = take(log.qdd);
  r.command = take(log.command);
  r.load = take(log.load);
  r.temperature = take(log.temperature);
  r.payload = take(log.payload);
  r.payload_effort = take(log.payload_effort);
  for (const auto& [name, signal] : log.signals)
    if (name != effort_of_logged_motion) r.signals[name] = take(*signal);
  for (const auto& [name, signal] : log.wide_signals)
    r.wide_signals[name] = std::make_shared<const MatrixXd>(take(*signal));
  for (const VectorXd& x : log.target) r.target.push_back(take(x));
  for (const VectorXd& x : log.known) r.known.push_back(take(x));
  r.standstills = log.standstills;
  r.disturbed = log.disturbed;
  r.band_hz = log.band_hz;
  return r;
}

}  // namespace sinew::diagnosis
