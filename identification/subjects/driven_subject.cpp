// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/driven_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "identification/logs/dequantise.h"
#include "identification/regression/baseline.h"
#include "identification/regression/expected_motion.h"
#include "identification/regression/noise_model.h"
#include "identification/regression/position_noise.h"
#include "identification/regression/refine.h"
#include "identification/regression/standstill.h"
#include "identification/regression/thinned_recording.h"
#include "identification/subjects/effect_candidate.h"
#include "symbolic/dynamics/dynamics_functions.h"
#include "symbolic/effects/effects.h"
#include "symbolic/extension/identified_mechanism.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd columns_of(const sinew::Segment& segment, const std::vector<int>& channels) {
  MatrixXd x(segment.samples.rows(), static_cast<Index>(channels.size()));
  for (std::size_t c = 0; c < channels.size(); ++c)
    x.col(static_cast<Index>(c)) = segment.samples.col(channels[c]).matrix();
  return x;
}

/// Friction whose law over the velocity is not known is fitted as a whole: its deviation, known, is
/// the baseline's nominal value.
DrivenModel without_open_friction(DrivenModel model) {
  for (DrivenJoint& joint : model.joints)
    if (joint.friction_speed == 0.0) joint.friction = 0.0;
  return model;
}

}  // namespace

namespace {

/// Joints that one tendon passes feel one sensor's noise, and so do those that are joined by
/// several; a motor's torque has a noise of its own, beside which that of the force is small.
std::vector<int> joined_by_tendons(const DrivenModel& model) {
  std::vector<int> group(model.joints.size());
  std::iota(group.begin(), group.end(), 0);
  const std::vector<GiNaC::ex>& arms = model.tendons.motion.outputs.front().values;
  const auto n = static_cast<std::size_t>(model.tendons.coordinates());
  for (std::size_t t = 0; t < model.tendons.names.size(); ++t) {
    int first = -1;
    for (std::size_t j = 0; j < n; ++j) {
      if (arms[t * n + j].is_zero()) continue;
      if (first < 0) first = group[j];
      std::replace(group.begin(), group.end(), int{group[j]}, first);
    }
  }
  return group;
}

}  // namespace

DrivenSubject::DrivenSubject(DrivenModel model, Identified identified,
                             std::filesystem::path runtime,
                             std::shared_ptr<const RigidColumns> rigid)
    : model_(std::move(model)),
      identified_(std::move(identified)),
      runtime_(std::move(runtime)),
      effort_(model_, identified_, runtime_),
      known_(without_open_friction(model_), identified_, runtime_),
      rigid_(std::move(rigid)) {
  for (const DrivenJoint& joint : model_.joints) bristle_.push_back(joint.friction_speed == 0.0);
  if (!model_.tendons.names.empty())
    tendons_ = std::make_shared<const TendonColumns>(model_, runtime_);
  presliding_.resize(bristle_.size(), 0.0);
  quantum_.resize(bristle_.size(), 0.0);
  digits_.resize(bristle_.size(), 0.0);
  rounded_again_.resize(bristle_.size(), false);
  problem_.channels = static_cast<int>(bristle_.size());
  if (tendons_) problem_.noise_groups = joined_by_tendons(model_);
}

EffortModel DrivenSubject::effort_with(const Identified& identified) const {
  if (!rigid_) return {model_, identified, runtime_};
  DrivenModel extended = model_;
  // What the model had learnt before is in its mechanism already.
  const Mechanism mechanism =
      with_identified(rigid_->mechanism(), mechanism_changes(identified_, identified));
  extended.rigid = tendons_ ? tendon_driven_model(mechanism, model_.tendons.motor).rigid
                            : inverse_dynamics_function(mechanism);
  return {extended, identified, runtime_};
}

const CandidateOrigin& DrivenSubject::origin_of(const Term& term) const {
  if (term.deviation >= 0) return deviation_origin(term.deviation);
  return library_[static_cast<std::size_t>(term.candidate - problem_.library.data())];
}

std::string DrivenSubject::place(std::size_t joint) const {
  const DrivenJoint& driven = model_.joints[joint];
  return driven.motor ? driven.name : "joint " + driven.name;
}

LogScale DrivenSubject::scale(std::size_t joint) const {
  LogScale scale = scale_of(problem_.training, static_cast<int>(joint));
  scale.turns_on_bristles = bristle_[joint];
  return scale;
}

/// Joints: torques of the tendons' forces. Motors: what they measure themselves, their tendon a
/// load.
void DrivenSubject::add_tendon_forces(const MatrixXd& forces, const MatrixXd& efforts,
                                      Recording& log) const {
  log.signals["tension"] = forces;
  tendons_->add_signals(log);
  const MatrixXd torque = tendons_->joint_torque(log);
  log.target.clear();
  for (Index j = 0; j < torque.cols(); ++j) log.target.push_back(torque.col(j));
  for (Index i = 0; i < efforts.cols(); ++i) log.target.push_back(efforts.col(i));
  if (efforts.cols() == 0) return;
  log.load = MatrixXd::Zero(log.q.rows(), log.q.cols());
  log.load.rightCols(efforts.cols()) = model_.tendons.motor->pulley_radius * forces;
}

/// Steps of a joint's sensor as this log shows them.
void DrivenSubject::learn_steps(const Log& log, int position, std::size_t joint) {
  const Channel& channel = log.channels[static_cast<std::size_t>(position)];
  quantum_[joint] = std::max(quantum_[joint], channel.quantum);
  digits_[joint] = std::max(digits_[joint], channel.last_digit);
  for (const sinew::Segment& segment : log.segments) {
    const SensorSteps steps = sensor_steps(columns_of(segment, {position}).col(0));
    quantum_[joint] = std::max(quantum_[joint], steps.step);
    // What writes a reading rounds it by no more than half the last digit.
    if (steps.scatter > channel.last_digit) rounded_again_[joint] = true;
  }
}

void DrivenSubject::add_log(const Log& log, const DrivenColumns& columns, bool held_out,
                            const CarriedPayload* carried) {
  for (std::size_t c = 0; c < quantum_.size(); ++c) learn_steps(log, columns.positions[c], c);
  int part = 0;
  for (const sinew::Segment& segment : log.segments) {
    if (segment.samples.rows() < shortest_segment(log.period)) continue;
    Recording r;
    r.name = log.segments.size() > 1 ? fmt::format("{} part {}", log.file, ++part) : log.file;
    r.log = log.file;
    r.step = log.period;
    const Index n = segment.samples.rows();
    r.time = VectorXd::LinSpaced(n, segment.start,
                                 segment.start + log.period * static_cast<double>(n - 1));
    r.log_start = log.segments.front().start;
    add_motion(columns_of(segment, columns.positions), r);
    const MatrixXd measured = columns_of(segment, columns.efforts);
    for (Index c = 0; c < measured.cols(); ++c) r.target.push_back(measured.col(c));
    if (columns.load >= 0) r.load = columns_of(segment, {columns.load});
    if (tendons_) add_tendon_forces(columns_of(segment, columns.forces), measured, r);
    add_standstills(r);
    add_payload(log, segment, columns, carried, r);
    (held_out ? problem_.holdout : problem_.training).push_back(std::move(r));
  }
}

/// Positions as logged, and what follows from them.
void DrivenSubject::add_motion(const MatrixXd& positions, Recording& log) const {
  const double cutoff = motion_cutoff(log.step);
  const Motion read = differentiate(positions, log.step, cutoff);
  log.signals["logged_q"] = positions;
  log.signals["read_q"] = log.q = read.q;
  log.signals["read_qd"] = log.qd = read.qd;
  log.signals["read_qdd"] = log.qdd = read.qdd;
  add_smooth_motion(log);
  expect_motion(log);
}

/// The motion to be expected takes the place of what was read: what noise of a position makes of
/// an acceleration is in the regressors and in what the model leaves over alike, and an effect that
/// takes fast accelerations away would be told for it. The errors of a sensor's steps are no white
/// noise, and known as they are.
void DrivenSubject::expect_motion(Recording& log) const {
  const double cutoff = motion_cutoff(log.step);
  std::vector<Index> noisy;
  for (Index c = 0; c < log.q.cols(); ++c)
    if (!reads_in_steps(log, c)) noisy.push_back(c);
  if (noisy.empty()) return;
  const MatrixXd expected =
      expected_position(log.signals.at("logged_q")(Eigen::all, noisy), log.step, 2.0 * cutoff);
  const Motion motion = differentiate(expected, log.step, cutoff);
  log.q(Eigen::all, noisy) = motion.q;
  log.qd(Eigen::all, noisy) = motion.qd;
  log.qdd(Eigen::all, noisy) = motion.qdd;
}

/// At rest friction is anything up to its level: a joint's, whatever its tendons do, and a guide's
/// at each joint that its tendon passes.
void DrivenSubject::add_standstills(Recording& log) const {
  const double cutoff = motion_cutoff(log.step);
  const auto at_tendons = tendons_ ? tendons_->stillness(log, cutoff) : std::vector<Stillness>{};
  const Index n = tendons_ ? tendons_->coordinates() : 0;
  for (Index j = 0; j < log.q.cols(); ++j) {
    std::vector<Stillness> parts = {
        find_stillness({log.qd.col(j), log.signals["smooth_qd"].col(j)}, log.step, cutoff)};
    for (std::size_t t = 0; j < n && t < at_tendons.size(); ++t)
      if (!log.signals.at("moment_arm").col(static_cast<Index>(t) * n + j).isZero(0.0))
        parts.push_back(at_tendons[t]);
    log.standstills.push_back(find_standstills(parts, log.time));
  }
}

/// What the model says.
void DrivenSubject::add_model(Recording& log) const {
  log.signals["direction"] = MatrixXd::Zero(log.q.rows(), log.q.cols());
  const MatrixXd said = known_(log);
  log.signals[effort_of_logged_motion] = said;
  log.signals["effort"] = effort_of_smooth_load(log);
  log.known.clear();
  for (Index c = 0; c < said.cols(); ++c) log.known.push_back(said.col(c));
  if (tendons_) tendons_->add_agreeing_tension(log);
}

/// The direction of each joint's friction, and the model's effort with it.
void DrivenSubject::set_directions(Recording& log) const {
  MatrixXd direction(log.q.rows(), log.q.cols());
  for (std::size_t j = 0; j < bristle_.size(); ++j) {
    const auto c = static_cast<Index>(j);
    if (bristle_[j])
      direction.col(c) = effect_columns(Regressor(find_effect("presliding")), log,
                                        static_cast<int>(j), VectorXd::Constant(1, presliding_[j]));
    else
      direction.col(c) =
          (log.qd.col(c).array() / model_.joints[j].friction_speed).atan() * 2.0 / std::numbers::pi;
  }
  log.signals["direction"] = direction;
  MatrixXd& effort = log.signals["effort"];
  for (std::size_t j = 0; j < bristle_.size(); ++j)
    if (bristle_[j])
      effort.col(static_cast<Index>(j)) +=
          model_.joints[j].friction * direction.col(static_cast<Index>(j));
}

/// What candidates act by that the mechanism asks for.
void DrivenSubject::add_mechanism_signals(Recording& log) const {
  if (!rigid_) return;
  rigid_->add_signals(log);
  if (!model_.joints.front().carries_links) return;
  MatrixXd& carried = log.signals["carried"] = rigid_->effort(log);
  if (log.load.size() > 0) carried += log.load;
  if (log.payload_effort.size() > 0) carried += log.payload_effort;
  add_link_signals(log);
}

/// Baseline alone first: the length over which friction turns has to be known before effects are
/// written that act in its direction.
void DrivenSubject::fit_directions(const Settings& settings) {
  const Design design(problem_, settings);
  Model model = baseline_model(design);
  refine(design, own_noise(design, model).weights, model);
  for (std::size_t t = 0; t < baseline_.size(); ++t)
    if (baseline_[t].effect == "presliding")
      presliding_[baseline_[t].joint] = model.terms[t].nonlinear(0);
}

/// What the model says, of a tendon's force the slow part alone: a gain on it would find the force
/// sensor's noise, which is in the target's error, too.
MatrixXd DrivenSubject::effort_of_smooth_load(Recording& log) const {
  if (!tendons_ || !model_.tendons.motor) return known_(log, log.q, log.qd, log.acceleration());
  const MatrixXd measured = log.load;
  const MatrixXd& tension = log.signals.at("slow_tension");
  log.load.rightCols(tension.cols()) = model_.tendons.motor->pulley_radius * tension;
  MatrixXd effort = known_(log, log.q, log.qd, log.acceleration());
  log.load = measured;
  return effort;
}

namespace {

/// What is kept of a log at its own rate.
void keep_logged(Recording& log) {
  Signals kept;
  for (const char* name : {fast_acceleration, effort_of_fast_motion, "read_q", "read_qd",
                           "read_qdd", "acceleration", "jerk", "jounce", "tension"})
    if (const MatrixXd* signal = log.signals.find(name)) kept[name] = *signal;
  log.signals = std::move(kept);
}

}  // namespace

std::vector<std::string> DrivenSubject::complete_loads() {
  std::vector<std::string> without;
  Index columns = 0;
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (const Recording& log : *logs) columns = std::max(columns, log.load.cols());
  if (columns == 0) return without;
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) {
      if (log.load.size() > 0) continue;
      log.load = MatrixXd::Zero(log.q.rows(), columns);
      without.push_back(log.name);
    }
  return without;
}

void DrivenSubject::thin_logs(const Settings& settings) {
  for (auto [compared, logged] : {std::pair{&problem_.training, &logged_training_},
                                  std::pair{&problem_.holdout, &logged_holdout_}})
    for (Recording& log : *compared) {
      const DecimatingFilter filter = thinning_filter(log.step, highest_compared(log, settings));
      Recording thin = filter.factor > 1 ? thinned(log, filter) : log;
      if (filter.factor > 1) thin.signals[effort_of_logged_motion] = known_(thin);
      add_fast_motion(log);
      keep_logged(log);
      logged->push_back(std::exchange(log, std::move(thin)));
    }
}

void DrivenSubject::prepare(const Settings& settings) {
  learn_position_errors();
  set_bands();
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) add_model(log);
  problem_.baseline.clear();
  problem_.library.clear();
  baseline_.clear();
  library_.clear();
  lines_.clear();
  deviations_.clear();
  problem_.deviations.clear();
  for (std::size_t j = 0; j < bristle_.size(); ++j) add_baseline(j);
  for (const KnownPayload& payload : payloads_) {
    if (!payload.is_free) continue;
    problem_.baseline.push_back(free_centre(payload));
    baseline_.push_back({"payload_centre", 0, {}, {}});
  }
  if (std::any_of(bristle_.begin(), bristle_.end(), [](bool b) { return b; }))
    fit_directions(settings);
  // Friction turns between two samples of a thinned log.
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) set_directions(log);
  thin_logs(settings);
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) add_mechanism_signals(log);
  add_mechanism_candidates();
  for (std::size_t j = 0; j < bristle_.size(); ++j) {
    add_library(j);
    add_turning(j);
    if (!tendon_driven(j)) add_ripples(j);
    add_model_candidates(j);
    add_deviations(j);
  }
  add_mechanism_deviations();
}

FlexibleRanges DrivenSubject::ranges(std::size_t joint) const {
  const LogScale s = scale(joint);
  double effort = 0.0;
  for (const Recording& log : problem_.training)
    effort = std::max(
        effort, log.signals.at("effort").col(static_cast<Index>(joint)).cwiseAbs().maxCoeff());
  const auto stretches = static_cast<int>(problem_.training.size());
  return {s.low, s.high, s.speed, s.load, s.duration, effort, stretches};
}

bool DrivenSubject::moves_links(std::size_t joint) const {
  return carries_links(joint) || (rigid_ && tendon_driven(joint));
}

bool DrivenSubject::is_lone_link() const {
  return model_.joints.size() == 1 && carries_links(0);
}

bool DrivenSubject::carries_links(std::size_t joint) const {
  return rigid_ && model_.joints[joint].carries_links;
}

}  // namespace sinew::diagnosis
