// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/identify_experiments.h"

#include <fmt/format.h>

#include <cmath>

#include "generator/assemble.h"
#include "generator/write.h"
#include "identification/experiments/compensation_effect.h"
#include "identification/experiments/friction_curve.h"
#include "identification/experiments/inertia_impulse.h"
#include "identification/experiments/lever_calibration.h"
#include "identification/experiments/ripple_fit.h"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

constexpr double most_of_the_range = 0.8;

std::vector<DriveStretch> all_stretches(const std::vector<Log>& logs) {
  std::vector<DriveStretch> all;
  for (const Log& log : logs)
    for (DriveStretch& stretch : drive_stretches(log)) all.push_back(std::move(stretch));
  return all;
}

Json json_of(const MotorOrderEffect& effect) {
  Json speeds = Json::array();
  for (const MotorOrderAmplitude& a : effect.amplitudes)
    speeds.push_back({{"log", a.log},
                      {"velocity_rad_s", a.speed},
                      {"motor_periods", a.periods},
                      {"amplitude", json_of(a.amplitude)}});
  Json reductions = Json::array();
  for (const MotorOrderReduction& r : effect.reductions)
    reductions.push_back({{"log", r.log},
                          {"velocity_rad_s", r.speed},
                          {"share_left", json_of(r.share_left)},
                          {"reduction", 1.0 - r.share_left.value}});
  return {{"amplitudes", speeds}, {"against_the_first_log", reductions}};
}

}  // namespace

Json json_of(const Estimate& e) {
  return {{"value", e.value},
          {"standard_error", e.standard_error},
          {"interval_95", Json::array({e.low, e.high})}};
}

IdentifyReport report_friction(const std::vector<Log>& logs, const MotorParameters& motor) {
  const FrictionCurve curve = identify_friction(all_stretches(logs), motor.gear_ratio);
  Json points = Json::array();
  for (const FrictionPoint& p : curve.points)
    points.push_back({{"velocity_rad_s", p.velocity},
                      {"torque_Nm", p.torque},
                      {"lowest_Nm", p.low},
                      {"highest_Nm", p.high},
                      {"motor_periods", p.periods},
                      {"deviation_Nm", p.deviation}});
  Json results{{"points", points}};
  if (curve.gamma1.value > 0.0) {
    results["gamma1_s_per_rad"] = json_of(curve.gamma1);
    results["gamma2_Nm"] = json_of(curve.gamma2);
    results["gamma3_Nms_per_rad"] = json_of(curve.gamma3);
    results["plateau_Nm"] = json_of(curve.plateau);
    results["residual_Nm"] = curve.residual;
    results["passive_share"] = curve.passive_share;
    results["models_share"] = motor.friction_compensation;
  }
  IdentifyReport report{curve.identified, results, curve.missing, {}, {}};
  if (curve.identified && motor.friction_compensation > curve.passive_share)
    report.missing.push_back(fmt::format(
        "the model feeds {} of the friction forward, but the log vouches for {:.3g} only; expected "
        "a smaller friction_compensation, or longer and more constant velocities",
        motor.friction_compensation, curve.passive_share));
  return report;
}

IdentifyReport report_inertia(const std::vector<Log>& logs, const MotorParameters& motor) {
  const InertiaResult r = identify_inertia(all_stretches(logs), motor);
  return {r.identified,
          {{"inertia_kgm2", json_of(r.inertia)},
           {"without_friction_kgm2", json_of(r.without_friction)},
           {"bias_without_friction", r.bias},
           {"residual_Nm", r.residual},
           {"residual_without_friction_Nm", r.residual_without}},
          r.missing,
          {},
          {}};
}

IdentifyReport report_ripple(const std::vector<Log>& logs, const MotorParameters& motor) {
  const RippleResult r = identify_ripple(all_stretches(logs), motor);
  Json ripples = Json::array();
  for (const FittedRipple& f : r.ripples)
    ripples.push_back({{"side", f.order.input ? "input" : "output"},
                       {"order", f.order.order},
                       {"amplitude_Nm", json_of(f.amplitude)},
                       {"phase_rad", json_of(f.phase)}});
  Json results{{"ripple", ripples}, {"residual_Nm", r.residual}};
  results["velocity_at_motor_order_rad_s"] =
      json_of(motor_order_effect(logs, motor.gear_ratio, "omega"));
  const MotorOrderEffect torque = motor_order_effect(logs, motor.gear_ratio, "tau_c");
  if (!torque.amplitudes.empty()) results["controller_torque_at_motor_order_Nm"] = json_of(torque);
  return {r.missing.empty() || !r.ripples.empty(), results, r.missing, {}, {}};
}

IdentifyReport report_lever(const std::vector<Log>& logs, const LeverParameters& lever, bool emit) {
  LeverCalibrationResult r = calibrate_lever(logs);
  const double seen = 2.0 * r.calibration.half_range,
               range = std::abs(lever.count_end - lever.count_free);
  if (!r.calibration.force.empty() && seen < most_of_the_range * range)
    r.missing.push_back(fmt::format(
        "the log goes over {:.0f} % of the sensor's range of {:.0f} counts; expected the whole "
        "travel: beyond what was seen the emitted function holds its last values",
        100.0 * seen / range, range));
  const LeverCalibration& c = r.calibration;
  FileSet emitted;
  if (r.identified && emit)
    emitted = emit_files(assemble({"lever_calibration",
                                   "Lever sensor: length, force and stiffness from counts",
                                   logs.front().sha256,
                                   {}},
                                  {lever_calibrated_state(c)}, {}));
  return {r.identified,
          {{"centre_counts", c.centre},
           {"half_range_counts", c.half_range},
           {"force_N", c.force},
           {"length_m", c.length},
           {"force_validation_rms_N", r.force.validation_rms},
           {"length_validation_rms_m", r.length.validation_rms},
           {"largest_force_error_N", r.largest_force_error},
           {"largest_force_error_without_loop_N", r.force.largest_error},
           {"largest_length_error_m", r.largest_length_error},
           {"stiffness_mismatch", r.stiffness_mismatch},
           {"hysteresis_N", r.hysteresis},
           {"hysteresis_at_N", r.hysteresis_at}},
          r.missing,
          emitted,
          {}};
}

}  // namespace sinew
