// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figures/lever.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "identification/experiments/lever_calibration.h"

namespace sinew {
namespace {

enum State { path, elongation, force, stiffness };

/// state(theta) at the share s of the travel.
std::vector<double> state_at(const CompiledModel& lever, const LeverParameters& p, double s) {
  return lever("state", {p.free_angle + s * (p.end_angle - p.free_angle)});
}

using std::numbers::pi;
constexpr double spring_mismatch = 0.05, loop_share = 15.0 / 70.0, loop_length = 2e-4;
constexpr double force_noise = 0.1, gauge_noise = 2e-6;  // N, m
constexpr double sample_period = 0.005;                  // s
constexpr long sample_count = 6000;

/// Three slow pulls and releases as the rig would log them. The loop follows the way with a length
/// of its own (Dahl's law).
Log calibration_log(const CompiledModel& lever, const TendonWithLever& parameters) {
  const LeverParameters& p = parameters.lever;
  const double compliance = parameters.tendon.free_length / parameters.tendon.axial_stiffness;
  Log log;
  log.file = "simulated calibration";
  log.period = sample_period;
  log.channels = {{"count", "1"}, {"force", "N"}, {"elongation", "m"}};
  Segment segment;
  segment.samples.resize(sample_count, 3);
  std::mt19937_64 random(11);
  std::normal_distribution<double> unit;
  double z = 0.0, before = 0.0;
  for (long i = 0; i < sample_count; ++i) {
    const double s = 0.5 - 0.5 * std::cos(2.0 * pi * 3.0 * static_cast<double>(i) / sample_count);
    const std::vector<double> state = state_at(lever, p, s);
    const double way = (state[elongation] - before) / loop_length;
    before = state[elongation];
    z = way > 0.0 ? 1.0 - (1.0 - z) * std::exp(-way) : (1.0 + z) * std::exp(way) - 1.0;
    const double pull = state[force] * (1.0 - spring_mismatch) * (1.0 + 0.5 * loop_share * z);
    segment.samples(i, 0) = std::round(p.count_free + s * (p.count_end - p.count_free));
    segment.samples(i, 1) = pull + force_noise * unit(random);
    segment.samples(i, 2) = state[elongation] + compliance * pull + gauge_noise * unit(random);
  }
  log.segments.push_back(std::move(segment));
  return log;
}

Series model_curve(const CompiledModel& lever, const TendonWithLever& parameters) {
  const double compliance = parameters.tendon.free_length / parameters.tendon.axial_stiffness;
  Series series{"model", {}, {}, Look::dashed};
  for (int i = 0; i <= 100; ++i) {
    const auto state = state_at(lever, parameters.lever, i / 100.0);
    series.x.push_back((state[elongation] + compliance * state[force]) * 1e3);
    series.y.push_back(state[force]);
  }
  return series;
}

Series measured_curve(const Eigen::ArrayXXd& rows) {
  Series series{"measured", {}, {}};
  for (long i = 0; i < rows.rows(); i += 4) {
    series.x.push_back(rows(i, 2) * 1e3);
    series.y.push_back(rows(i, 1));
  }
  return series;
}

Panel polynomial_panel(const LeverCalibrationResult& r, const Eigen::ArrayXXd& rows) {
  Series raw{"measured", {}, {}, Look::dots}, fitted{"polynomial", {}, {}, Look::thick},
      stiff{"stiffness [N/mm]", {}, {}};
  for (long i = 0; i < rows.rows(); i += 4) {
    raw.x.push_back(rows(i, 0));
    raw.y.push_back(rows(i, 1));
  }
  for (int i = -95; i <= 95; ++i) {
    const double u = i / 100.0;
    fitted.x.push_back(r.calibration.centre + u * r.calibration.half_range);
    fitted.y.push_back(r.force.at(u));
    stiff.x.push_back(fitted.x.back());
    stiff.y.push_back(-r.force.slope(u) / r.length.slope(u) * 1e-3);
  }
  return {"from the sensor's count", "count", "force [N], stiffness [N/mm]", {raw, fitted, stiff}};
}

}  // namespace

Figure figure_lever(const CompiledModel& lever, const LeverParameters& parameters) {
  Panel length{"tendon length", "lever angle [deg]", "dL [mm]", {{"", {}, {}}}},
      pull{"force", "elongation [mm]", "force [N]", {{"", {}, {}}}},
      stiff{"stiffness", "elongation [mm]", "stiffness [N/mm]", {{"", {}, {}}}};
  const auto add = [](Panel& panel, double x, double y) {
    panel.series[0].x.push_back(x);
    panel.series[0].y.push_back(y);
  };
  for (int i = 0; i <= 200; ++i) {
    const double s = i / 200.0;
    const auto state = state_at(lever, parameters, s);
    const double angle = parameters.free_angle + s * (parameters.end_angle - parameters.free_angle);
    add(length, angle * 180.0 / pi, state[path] * 1e3);
    add(pull, state[elongation] * 1e3, state[force]);
    add(stiff, state[elongation] * 1e3, state[stiffness] * 1e-3);
  }
  Figure figure{
      "figure_4_07", "4.7", "The lever's characteristics (model)", "", {length, pull, stiff}};
  figure.differs = fmt::format(
      "Computed by the emitted C of models/lever. Table 4.1 omits pivot, lever length, spring "
      "point "
      "and free length, so that all dimensions are assumed: 0 N to {:.3g} N over {:.3g} mm, "
      "{:.3g} N/mm to {:.3g} N/mm. The shape is the mechanism's; the numbers are not the source's.",
      pull.series[0].y.back(), pull.series[0].x.back(), stiff.series[0].y.front(),
      stiff.series[0].y.back());
  figure.numbers = {
      {"force over the travel", "a curve; no number is printed",
       fmt::format("0 to {:.3g} N", pull.series[0].y.back())},
      {"stiffness over the travel", "a curve; no number is printed",
       fmt::format("{:.3g} to {:.3g} N/mm", stiff.series[0].y.front(), stiff.series[0].y.back())}};
  return figure;
}

Figure figure_lever_calibration(const CompiledModel& lever, const TendonWithLever& parameters) {
  const Log log = calibration_log(lever, parameters);
  const LeverCalibrationResult r = calibrate_lever({log});
  const Eigen::ArrayXXd& rows = log.segments.front().samples;
  Figure figure{"figure_4_08", "4.8", "Calibration of the lever's sensor (simulated)", "", {}};
  figure.panels = {{"on the rig",
                    "elongation of lever and tendon [mm]",
                    "force [N]",
                    {measured_curve(rows), model_curve(lever, parameters)}},
                   polynomial_panel(r, rows)};
  figure.differs = fmt::format(
      "A simulated rig, not a measured one: the emitted C of models/lever with a spring {:.0f} % "
      "softer than the model's, a tendon in series, a loop of {:.2g} N at 70 N (the middle of the "
      "source's 10 N to 20 N), a 12-bit sensor and noise of {} N. The source's photograph of the "
      "rig (4.8a) is left out. Fitted: degree {} for the force and {} for the length, largest "
      "error {:.3g} N with the loop and {:.3g} N without it, loop {:.3g} N at {:.3g} N.",
      spring_mismatch * 100.0, loop_share * 70.0, force_noise, r.force.degree(), r.length.degree(),
      r.largest_force_error, r.force.largest_error, r.hysteresis, r.hysteresis_at);
  figure.numbers = {{"hysteresis at about 70 N", "10 N to 20 N",
                     fmt::format("{:.3g} N at {:.3g} N", r.hysteresis, r.hysteresis_at)},
                    {"sensor", "12 bits", "12 bits"}};
  return figure;
}

}  // namespace sinew
