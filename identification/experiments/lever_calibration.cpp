// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/lever_calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/experiments/lever_loop.h"

namespace sinew {
namespace {

constexpr int bins = 60;  // over the sensor's range, for loop and stiffness

struct Samples {
  std::vector<double> count, force, elongation;
  std::vector<int> direction;        ///< +1 loading, -1 unloading, 0 at rest
  std::vector<Eigen::Index> starts;  ///< of the stretches
};

Samples gather(const std::vector<Log>& logs) {
  Samples all;
  for (const Log& log : logs)
    for (const Segment& segment : log.segments) {
      const Eigen::ArrayXd force = segment.samples.col(log.channel("force"));
      const long n = force.size();
      // Loading is a matter of seconds; noise is one of samples.
      const long reach = std::max(1L, n / 100);
      const int elongation = log.channel("elongation");
      all.starts.push_back(static_cast<Eigen::Index>(all.count.size()));
      for (long i = 0; i < n; ++i) {
        all.count.push_back(segment.samples(i, log.channel("count")));
        all.force.push_back(force(i));
        all.elongation.push_back(elongation >= 0 ? segment.samples(i, elongation) : 0.0);
        const long before = std::max(0L, i - reach), after = std::min(n - 1, i + reach);
        const double rise = segment.samples(after, log.channel("count")) -
                            segment.samples(before, log.channel("count"));
        all.direction.push_back(rise > 1.0 ? 1 : rise < -1.0 ? -1 : 0);
      }
    }
  return all;
}

/// Means of a quantity over bins of u in [-1, 1], for one direction.
struct Branch {
  double force[bins] = {}, elongation[bins] = {};
  long samples[bins] = {};

  void add(double u, double f, double x) {
    const int bin = std::clamp(static_cast<int>((u + 1.0) / 2.0 * bins), 0, bins - 1);
    force[bin] += f;
    elongation[bin] += x;
    ++samples[bin];
  }
};

void measure_loop(LeverCalibrationResult& result, const Branch& up, const Branch& down) {
  for (int b = 0; b < bins; ++b) {
    if (up.samples[b] == 0 || down.samples[b] == 0) continue;
    const double loading = up.force[b] / static_cast<double>(up.samples[b]),
                 unloading = down.force[b] / static_cast<double>(down.samples[b]);
    if (std::abs(loading - unloading) <= result.hysteresis) continue;
    result.hysteresis = std::abs(loading - unloading);
    result.hysteresis_at = 0.5 * (loading + unloading);
  }
}

/// Whether the length rises in one place and falls in another: no stiffness follows there.
bool turns_round(const CalibrationPolynomial& length) {
  bool rises = false, falls = false;
  for (int i = -200; i <= 200; ++i) (length.slope(i / 200.0) > 0.0 ? rises : falls) = true;
  return rises && falls;
}

/// Stiffness of the polynomials against force over elongation of one branch.
double stiffness_mismatch(const LeverCalibrationResult& result, const Branch& branch) {
  double worst = 0.0, largest = 0.0;
  for (int b = 2; b + 2 < bins; ++b) {
    if (branch.samples[b - 2] == 0 || branch.samples[b + 2] == 0) continue;
    const auto mean = [&](const double* sums, int at) {
      return sums[at] / static_cast<double>(branch.samples[at]);
    };
    const double dx = mean(branch.elongation, b + 2) - mean(branch.elongation, b - 2);
    if (dx == 0.0) continue;
    const double measured = (mean(branch.force, b + 2) - mean(branch.force, b - 2)) / dx;
    const double u = (2.0 * b + 1.0) / bins - 1.0;
    const double given = -result.force.slope(u) / result.length.slope(u);
    worst = std::max(worst, std::abs(given - measured));
    largest = std::max(largest, std::abs(measured));
  }
  return largest > 0.0 ? worst / largest : 0.0;
}

constexpr const char* lever_experiment =
    "expected the tendon pulled slowly over the whole travel and released again, several times";

/// The samples with the count scaled to [-1, 1], and each branch's means.
struct ScaledSamples {
  Eigen::ArrayXd u, force, length;
  Branch up, down;
};

ScaledSamples scaled(const Samples& samples, const LeverCalibration& c) {
  const auto n = static_cast<Eigen::Index>(samples.count.size());
  ScaledSamples s{Eigen::ArrayXd(n), Eigen::ArrayXd(n), Eigen::ArrayXd(n), {}, {}};
  for (std::size_t i = 0; i < samples.count.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    s.u(k) = (samples.count[i] - c.centre) / c.half_range;
    s.force(k) = samples.force[i];
    s.length(k) = -samples.elongation[i];
    if (samples.direction[i] > 0) s.up.add(s.u(k), s.force(k), samples.elongation[i]);
    if (samples.direction[i] < 0) s.down.add(s.u(k), s.force(k), samples.elongation[i]);
  }
  return s;
}

/// Whether at least a twentieth of the samples loads, and as many unload.
bool has_both_branches(const Samples& samples) {
  const auto unloading = std::count(samples.direction.begin(), samples.direction.end(), -1),
             loading = std::count(samples.direction.begin(), samples.direction.end(), 1);
  return 20 * std::min(loading, unloading) > static_cast<long>(samples.count.size());
}

void fit_force(const Samples& samples, const ScaledSamples& s, bool both, int highest,
               LeverCalibrationResult& result) {
  const double step = 1.5 / result.calibration.half_range;  // the sensor's own
  result.force = fit_polynomial(
      s.u, both ? middle_of_loop(s.u, s.force, samples.starts, step, highest).force : s.force,
      highest);
  result.calibration.force = result.force.coefficients;
  measure_loop(result, s.up, s.down);
  for (Eigen::Index i = 0; i < s.u.size(); ++i)
    result.largest_force_error =
        std::max(result.largest_force_error, std::abs(result.force.at(s.u(i)) - s.force(i)));
  if (!both)
    result.missing.push_back(
        std::string("the log loads or unloads only, so that the hysteresis is not seen; ") +
        lever_experiment);
}

void fit_length(const ScaledSamples& s, bool both, int highest, LeverCalibrationResult& result) {
  if (s.length.abs().maxCoeff() == 0.0) {
    result.missing.push_back(
        "there is no elongation, so that neither length nor stiffness follow; expected the channel "
        "elongation [m] beside the force");
    return;
  }
  result.length = fit_polynomial(s.u, s.length, highest);
  result.calibration.length = result.length.coefficients;
  result.largest_length_error = result.length.largest_error;
  result.stiffness_mismatch = std::min(stiffness_mismatch(result, s.up), 1e300);
  if (turns_round(result.length))
    result.missing.push_back(
        std::string("the path length turns round within the sensor's range; ") + lever_experiment);
  else
    result.identified = both;
}

}  // namespace

LeverCalibrationResult calibrate_lever(const std::vector<Log>& logs, int highest) {
  LeverCalibrationResult result;
  const Samples samples = gather(logs);
  const std::size_t n = samples.count.size();
  const auto [least, most] = std::minmax_element(samples.count.begin(), samples.count.end());
  if (n < 3 * static_cast<std::size_t>(highest + 1) || *most - *least < 16.0) {
    result.missing.push_back(fmt::format("{} samples over {:.0f} counts; {}", n,
                                         n ? *most - *least : 0.0, lever_experiment));
    return result;
  }
  result.calibration.centre = 0.5 * (*least + *most);
  result.calibration.half_range = 0.5 * (*most - *least);
  const ScaledSamples s = scaled(samples, result.calibration);
  const bool both = has_both_branches(samples);
  fit_force(samples, s, both, highest, result);
  fit_length(s, both, highest, result);
  return result;
}

}  // namespace sinew
