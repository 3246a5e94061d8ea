// SPDX-License-Identifier: GPL-3.0-or-later
// What the logged positions of driven joints show: the smooth motion, its derivatives, and the
// errors of the sensors.
#include <algorithm>
#include <limits>

#include "identification/logs/dequantise.h"
#include "identification/logs/filter.h"
#include "identification/regression/position_noise.h"
#include "identification/subjects/driven_subject.h"
#include "identification/subjects/model_candidates.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Zero where a smoother reached beyond the log's ends.
MatrixXd without_ends(MatrixXd x, double step) {
  const Index edge = std::min<Index>(x.rows() / 2, std::lround(driven_edge / step));
  x.topRows(edge).setZero();
  x.bottomRows(edge).setZero();
  return x;
}

}  // namespace

void DrivenSubject::add_smooth_motion(Recording& log) const {
  const Motion smooth =
      differentiate(log.signals.at("logged_q"), log.step, smooth_cutoff(log.step));
  log.signals["smooth_q"] = log.q + without_ends(smooth.q - log.q, log.step);
  log.signals["smooth_qd"] = log.qd + without_ends(smooth.qd - log.qd, log.step);
  log.signals["smooth_qdd"] = log.qdd + without_ends(smooth.qdd - log.qdd, log.step);
}

/// What effects that act by the acceleration see of it: where all of it above the motion is noise
/// of the position, an effect that takes fast accelerations away would be collinear with that
/// noise.
void DrivenSubject::add_derivatives(Recording& log) const {
  const auto add = [&](double cutoff, const std::vector<Index>& joints) {
    const MatrixXd acceleration = differentiate(log.q(Eigen::all, joints), log.step, cutoff).qdd;
    const Motion motion = differentiate(acceleration, log.step, cutoff);
    log.signals["jerk"](Eigen::all, joints) = without_ends(motion.qd, log.step);
    log.signals["jounce"](Eigen::all, joints) = without_ends(motion.qdd, log.step);
  };
  MatrixXd& seen = log.signals["acceleration"] = log.qdd;
  log.signals["jerk"] = log.signals["jounce"] = MatrixXd::Zero(seen.rows(), seen.cols());
  std::vector<Index> clean, noisy;
  for (Index c = 0; c < seen.cols(); ++c) (hides_acceleration(c) ? noisy : clean).push_back(c);
  if (!clean.empty()) add(slow_cutoff(log.step), clean);
  if (noisy.empty()) return;
  add(smooth_cutoff(log.step), noisy);
  seen(Eigen::all, noisy) =
      differentiate(log.q(Eigen::all, noisy), log.step, smooth_cutoff(log.step)).qdd;
}

bool DrivenSubject::hides_acceleration(Index joint) const {
  return position_error_[static_cast<std::size_t>(joint)].hides_acceleration;
}

/// Of a sensor by all training logs: a held-out log whose motion is treated otherwise refutes what
/// they tell.
void DrivenSubject::learn_position_errors() {
  position_error_.clear();
  for (std::size_t j = 0; j < bristle_.size(); ++j)
    position_error_.push_back(
        {noise_of_position(training(), static_cast<Index>(j)), coarse_sensor(j), 0.0});
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) {
      add_derivatives(log);
      add_sensor_errors(log);
    }
  for (std::size_t j = 0; j < bristle_.size(); ++j) {
    PositionError& error = position_error_[j];
    error.share_of_jounce =
        noise_of_jounce(training(), static_cast<Index>(j), quantum_[j], error.hides_acceleration);
  }
}

/// Nothing is told from an effort at frequencies where all motion that it would need is noise of a
/// position: of its own joint's, and of every joint's where they carry each other. Where a log is
/// written finer than its sensor reads, the sensor's steps are the error, and known.
void DrivenSubject::set_bands() {
  std::vector<bool> noisy;
  for (std::size_t j = 0; j < bristle_.size(); ++j)
    noisy.push_back(position_error_[j].hides_acceleration &&
                    !(rounded_again_[j] && position_error_[j].coarse));
  const bool any = std::find(noisy.begin(), noisy.end(), true) != noisy.end();
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) {
      log.band_hz.clear();
      for (std::size_t j = 0; j < noisy.size(); ++j)
        log.band_hz.push_back(noisy[j] || (any && carries_links(j)) ? smooth_cutoff(log.step)
                                                                    : motion_cutoff(log.step));
    }
}

/// They count again, for what hides in them, beside what is named already.
void DrivenSubject::look_at_standstills(const std::vector<int>& named) {
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) log.standstills.clear();
  std::vector<Candidate> library;
  std::vector<CandidateOrigin> origins;
  for (std::size_t i = 0; i < library_.size(); ++i) {
    const bool keep = problem_.library[i].kind == CandidateKind::flexible ||
                      problem_.library[i].kind == CandidateKind::decoy ||
                      library_[i].effect == "sensor_hysteresis" ||
                      std::find(named.begin(), named.end(), static_cast<int>(i)) != named.end();
    if (!keep) continue;
    library.push_back(std::move(problem_.library[i]));
    origins.push_back(std::move(library_[i]));
  }
  problem_.library = std::move(library);
  library_ = std::move(origins);
}

void DrivenSubject::leave_out(const std::vector<std::vector<Standstill>>& disturbed) {
  std::size_t next = 0;
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) log.disturbed = disturbed[next++];
}

/// Where in its play a loose position sensor is, and the errors of one with steps: no error is
/// larger than half a step. Smoothed and differentiated as the position is.
void DrivenSubject::add_sensor_errors(Recording& log) const {
  const MatrixXd& reading = log.signals.at("logged_q");
  MatrixXd side(reading.rows(), reading.cols());
  MatrixXd steps = reading - log.signals.at("smooth_q");
  for (Index c = 0; c < side.cols(); ++c) {
    const double step = quantum_[static_cast<std::size_t>(c)];
    side.col(c) = side_of_play(reading.col(c), log.qd.col(c), step,
                               2e-3 * log.qd.col(c).cwiseAbs().maxCoeff());
    const SensorSteps known = sensor_steps(reading.col(c));
    if (known.step > 0.0)
      steps.col(c) = reading.col(c) -
                     consistent_motion(reading.col(c), known, log.step, smooth_cutoff(log.step));
    // More than that is motion, unless the motion is known to be smoother.
    if (!hides_acceleration(c))
      steps.col(c) = (steps.col(c).array().abs() < 0.55 * step).select(steps.col(c), 0.0);
  }
  const auto add = [&](const std::string& name, const MatrixXd& error) {
    Motion motion = differentiate(error, log.step, motion_cutoff(log.step));
    log.signals[name] = std::move(motion.q);
    log.signals[name + "_rate"] = std::move(motion.qd);
    log.signals[name + "_acceleration"] = std::move(motion.qdd);
  };
  add("side", side);
  add("steps", steps);
}

/// With steps as fine as any good drive has, 17 bits a turn or 10 um of a linear scale, or of one
/// of the log's last digits, which are no fault of the sensor.
bool DrivenSubject::fine_sensor(std::size_t joint) const {
  constexpr double kFinestAngle = 5e-5, kFinestWay = 1e-5;
  return quantum_[joint] <= (model_.joints[joint].revolute ? kFinestAngle : kFinestWay) ||
         quantum_[joint] < 2.0 * digits_[joint];
}

/// Joints whose effort feels what is wrong with a joint's logged motion, itself among them; the
/// logs get the signals for the others.
std::vector<int> DrivenSubject::coupled_joints(std::size_t joint) {
  const auto axis = static_cast<int>(joint);
  if (!moves_links(joint)) return {axis};
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) add_sensor_responses(known_, axis, log);
  std::vector<int> list;
  const MatrixXd& column = problem_.training.front().signals.at(mass_matrix_column(axis));
  for (Index c = 0; c < column.cols(); ++c)
    if (c == axis || !column.col(c).isZero(0.0)) list.push_back(static_cast<int>(c));
  return list;
}

std::vector<const Recording*> DrivenSubject::training() const {
  std::vector<const Recording*> logs;
  for (const Recording& log : problem_.training) logs.push_back(&log);
  return logs;
}

/// Half of the errors of a sensor with steps are below a quarter of a step, fast motion or not;
/// where they are much larger, it is other noise that they come from.
bool DrivenSubject::coarse_sensor(std::size_t joint) const {
  const auto c = static_cast<Index>(joint);
  std::vector<double> errors;
  for (const Recording& log : problem_.training) {
    const VectorXd error =
        (log.signals.at("logged_q").col(c) - log.signals.at("smooth_q").col(c)).cwiseAbs();
    errors.insert(errors.end(), error.begin(), error.end());
  }
  if (quantum_[joint] <= 0.0 || errors.empty()) return false;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle < 0.4 * quantum_[joint];
}

/// Most of what no motion explains of its reading is the rounding to its steps.
bool DrivenSubject::reads_in_steps(const Recording& log, Index joint) const {
  const double step = quantum_[static_cast<std::size_t>(joint)];
  VectorXd error =
      (log.signals.at("logged_q").col(joint) - log.signals.at("read_q").col(joint)).cwiseAbs();
  if (step <= 0.0 || error.size() == 0) return false;
  const auto middle = error.begin() + error.size() / 2;
  std::nth_element(error.begin(), middle, error.end());
  return *middle < 0.4 * step;
}

}  // namespace sinew::diagnosis
