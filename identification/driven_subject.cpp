// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/driven_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "identification/baseline.h"
#include "identification/dequantise.h"
#include "identification/effect_candidate.h"
#include "identification/model_candidates.h"
#include "identification/position_noise.h"
#include "identification/refine.h"
#include "identification/select.h"
#include "identification/standstill.h"
#include "identification/trial.h"
#include "symbolic/dynamics_functions.h"
#include "symbolic/effects/effects.h"
#include "symbolic/identified_mechanism.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What fast effects have to explain where all fast motion is noise of the position.
constexpr double kFastShare = 0.2;

VectorXd number(double value) {
  return VectorXd::Constant(1, value);
}

MatrixXd columns_of(const sinew::Segment& segment, const std::vector<int>& channels) {
  MatrixXd x(segment.samples.rows(), static_cast<Index>(channels.size()));
  for (std::size_t c = 0; c < channels.size(); ++c)
    x.col(static_cast<Index>(c)) = segment.samples.col(channels[c]).matrix();
  return x;
}

/// Friction whose law over the velocity is not known is fitted as a whole: its level, known, is the
/// baseline's nominal value.
DrivenModel without_open_friction(DrivenModel model) {
  for (DrivenJoint& joint : model.joints)
    if (joint.friction_speed == 0.0) joint.friction = 0.0;
  return model;
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
  rounded_again_.resize(bristle_.size(), false);
  problem_.channels = static_cast<int>(bristle_.size());
  problem_.shared_noise = tendons_ != nullptr;
}

EffortModel DrivenSubject::effort_with(const Identified& identified) const {
  if (!rigid_) return {model_, identified, runtime_};
  // What the model had learnt before is in its mechanism already.
  Identified added = identified;
  std::erase_if(added.effects, [&](const IdentifiedEffect& e) {
    return std::any_of(identified_.effects.begin(), identified_.effects.end(),
                       [&](const IdentifiedEffect& old) {
                         return old.effect == e.effect && old.place == e.place;
                       });
  });
  DrivenModel extended = model_;
  const Mechanism mechanism = with_identified(rigid_->mechanism(), added);
  extended.rigid = tendons_ ? tendon_driven_model(mechanism, model_.tendons.motor).rigid
                            : inverse_dynamics_function(mechanism);
  return {extended, identified, runtime_};
}

std::string DrivenSubject::place(std::size_t joint) const {
  const DrivenJoint& driven = model_.joints[joint];
  return driven.motor ? driven.name : "joint " + driven.name;
}

LogScale DrivenSubject::scale(std::size_t joint) const {
  return scale_of(problem_.training, static_cast<int>(joint));
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
  for (const sinew::Segment& segment : log.segments) {
    const SensorSteps steps = sensor_steps(columns_of(segment, {position}).col(0));
    quantum_[joint] = std::max(quantum_[joint], steps.step);
    // The digits it is written with round a reading by no more than half the last one.
    if (steps.scatter > channel.last_digit) rounded_again_[joint] = true;
  }
}

void DrivenSubject::add_log(const Log& log, const DrivenColumns& columns, bool held_out) {
  for (std::size_t c = 0; c < quantum_.size(); ++c) learn_steps(log, columns.positions[c], c);
  int part = 0;
  for (const sinew::Segment& segment : log.segments) {
    if (segment.samples.rows() < shortest_segment(log.period)) continue;
    Recording r;
    r.name = log.segments.size() > 1 ? fmt::format("{} part {}", log.file, ++part) : log.file;
    r.step = log.period;
    const Index n = segment.samples.rows();
    r.time = VectorXd::LinSpaced(n, segment.start,
                                 segment.start + log.period * static_cast<double>(n - 1));
    Motion motion = differentiate(columns_of(segment, columns.positions), log.period,
                                  motion_cutoff(log.period));
    r.q = std::move(motion.q);
    r.qd = std::move(motion.qd);
    r.qdd = std::move(motion.qdd);
    const MatrixXd measured = columns_of(segment, columns.efforts);
    for (Index c = 0; c < measured.cols(); ++c) r.target.push_back(measured.col(c));
    if (columns.load >= 0) r.load = columns_of(segment, {columns.load});
    if (tendons_) add_tendon_forces(columns_of(segment, columns.forces), measured, r);
    r.signals["logged_q"] = columns_of(segment, columns.positions);
    add_smooth_motion(r);
    add_derivatives(r);
    add_sensor_errors(r);
    add_standstills(r);
    (held_out ? problem_.holdout : problem_.training).push_back(std::move(r));
  }
}

/// A joint turns round while its tendons go on: what is lost in their guides is then as well known
/// as ever. It is not where one of its tendons rests with it.
void DrivenSubject::add_standstills(Recording& log) const {
  const double cutoff = motion_cutoff(log.step);
  for (Index c = 0; c < log.q.cols(); ++c) {
    log.standstills.push_back(
        find_standstills(log.time, {log.qd.col(c), log.signals["smooth_qd"].col(c)}, cutoff));
    if (!tendon_driven(static_cast<std::size_t>(c))) continue;
    std::vector<Standstill> of_tendons;
    const MatrixXd& rates = log.signals.at("tendon_rate");
    const MatrixXd& arms = log.signals.at("moment_arm");
    const Index n = arms.cols() / rates.cols();
    for (Index t = 0; t < rates.cols(); ++t) {
      if (arms.col(t * n + c).isZero(0.0)) continue;
      const auto own = find_standstills(log.time, {rates.col(t)}, cutoff);
      of_tendons.insert(of_tendons.end(), own.begin(), own.end());
    }
    log.standstills.back() = overlapping(log.standstills.back(), of_tendons);
  }
}

void DrivenSubject::set_signals(Recording& log) const {
  MatrixXd direction(log.q.rows(), log.q.cols());
  for (std::size_t j = 0; j < bristle_.size(); ++j) {
    const auto c = static_cast<Index>(j);
    if (bristle_[j])
      direction.col(c) = effect_columns(Regressor(find_effect("presliding")), log,
                                        static_cast<int>(j), number(presliding_[j]));
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

/// Baseline alone first: the length over which friction turns has to be known before effects are
/// written that act in its direction.
void DrivenSubject::fit_directions(const Settings& settings) {
  const Design design(problem_, settings);
  Model model = baseline_model(design);
  refine(design, own_noise(design, model, settings.threads).weights, RefineScope::all_terms, model);
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

void DrivenSubject::prepare(const Settings& settings) {
  set_bands();
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) {
      log.signals["direction"] = MatrixXd::Zero(log.q.rows(), log.q.cols());
      const MatrixXd said = known_(log);
      log.signals[effort_of_logged_motion] = said;
      log.signals["effort"] = effort_of_smooth_load(log);
      log.known.clear();
      for (Index c = 0; c < said.cols(); ++c) log.known.push_back(said.col(c));
    }
  problem_.baseline.clear();
  problem_.library.clear();
  baseline_.clear();
  library_.clear();
  levels_.clear();
  problem_.levels.clear();
  for (std::size_t j = 0; j < bristle_.size(); ++j) add_baseline(j);
  if (std::any_of(bristle_.begin(), bristle_.end(), [](bool b) { return b; }))
    fit_directions(settings);
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) {
      set_signals(log);
      if (!rigid_) continue;
      rigid_->add_signals(log);
      if (!model_.joints.front().carries_links) continue;
      MatrixXd& carried = log.signals["carried"] = rigid_->effort(log);
      if (log.load.size() > 0) carried += log.load;
    }
  add_mechanism_candidates();
  for (std::size_t j = 0; j < bristle_.size(); ++j) {
    add_library(j);
    if (!tendon_driven(j)) add_ripples(j);
    add_model_candidates(j);
    add_levels(j);
  }
  add_mechanism_levels();
}

/// What acts on several joints at once.
void DrivenSubject::add_mechanism_candidates() {
  const auto take = [&](Candidate candidate, CandidateOrigin origin) {
    problem_.library.push_back(std::move(candidate));
    library_.push_back(std::move(origin));
  };
  if (model_.joints.size() > 1) take(common_delay_candidate(), {"delay", 0, {}, {}, true});
  if (rigid_)
    for (Candidate& c : rigid_->candidates()) {
      const std::string effect = c.place == "base" ? "gravity"
                                 : c.unlikely      ? "inertial_parameters"
                                                   : "payload";
      if (effect == "payload" && is_lone_link()) {
        add_free_payload(std::move(c));
        continue;
      }
      // A lone link's payloads and offset make every weight that a leaning base would.
      if (effect == "gravity" && model_.joints.size() == 1) c.unlikely = true;
      take(std::move(c), {effect, 0, {}, {}});
    }
  if (tendons_)
    for (TendonColumns::AtTendon& each : tendons_->candidates())
      take(std::move(each.candidate), {each.effect, 0, {}, each.place});
}

/// A gain, a leaning base and a payload all make another weight of a lone joint: which of them it
/// is shows against the model's values alone, the moment of inertia among them.
void DrivenSubject::add_free_payload(Candidate payload) {
  for (LinearParameter& p : payload.linear) {
    p.low = -std::numeric_limits<double>::infinity();
    p.nominal = 0.0;
  }
  problem_.baseline.push_back(std::move(payload));
  baseline_.push_back({"payload", 0, {}, {}});
}

void DrivenSubject::add_baseline(std::size_t joint) {
  const EffectPlace where{static_cast<int>(joint), place(joint), model_.joints[joint].revolute};
  std::vector<const char*> terms{"inertia", "viscous_level", "coulomb_level", "offset"};
  // How friction turns is no cause by itself, and must not pass for one.
  terms.push_back(bristle_[joint] ? "soft_reversal" : "late_reversal");
  for (const char* id : terms) {
    const std::string effect =
        id == std::string("coulomb_level") && bristle_[joint] ? "presliding" : id;
    Candidate c = effect_candidate(find_effect(effect), where, scale(joint));
    for (LinearParameter& p : c.linear) {
      if (effect == "soft_reversal" || effect == "late_reversal") continue;
      p.low = -std::numeric_limits<double>::infinity();
      p.nominal = effect == "presliding" ? model_.joints[joint].friction : 0.0;
    }
    problem_.baseline.push_back(std::move(c));
    baseline_.push_back({effect, joint, {}, {}});
  }
}

void DrivenSubject::add(const std::string& effect, std::size_t joint, const std::string& name,
                        const VectorXd& fixed, CandidateKind kind) {
  const EffectPlace where{static_cast<int>(joint), place(joint), model_.joints[joint].revolute};
  Candidate c = effect_candidate(find_effect(effect), where, scale(joint),
                                 fixed.size() ? std::optional(fixed) : std::nullopt);
  if (!name.empty()) c.name = name;
  c.kind = kind;
  // Impacts are as short as a sample; what they leave in the band is enough.
  const bool impacts = effect == "inertial_backlash" || effect == "loaded_backlash";
  c.broadband = impacts;
  if ((impacts || effect == "gear_elasticity" || effect == "gear_resonance") &&
      noise_of_position(training(), static_cast<Index>(joint)))
    c.least_share = kFastShare;
  if (kind == CandidateKind::decoy) c.depends_on = "position, periodic at no known order";
  problem_.library.push_back(std::move(c));
  library_.push_back({kind == CandidateKind::decoy ? "" : effect, joint, fixed, {}});
}

void DrivenSubject::add_library(std::size_t joint) {
  for (const char* effect :
       {"viscous_asymmetry", "coulomb_asymmetry", "stribeck", "concave_friction", "concave_power",
        "quadratic_friction", "friction_drift", "offset_drift"})
    add(effect, joint);
  const LogScale s = scale(joint);
  if (s.load > 0.0 || carries_links(joint)) add("load_friction", joint);
  if (!tendon_driven(joint)) add_gear(joint);
  if (model_.joints[joint].motor) return;
  // A joint carries cables and springs; a motor's own shaft does not.
  add("position_friction", joint);
  add("torsion_spring", joint);
  const Eigen::Vector2d range(0.5 * (s.low + s.high), 0.5 * (s.high - s.low));
  for (const char* cable : {"cable_torque", "cable_torque_cubic"}) {
    // A cubic is near the weight that a link carries over a part of a turn.
    if (carries_links(joint) && cable == std::string("cable_torque_cubic")) continue;
    add(cable, joint, {}, range);
    problem_.library.back().contains = find_effect("offset").name;
  }
}

/// A joint that tendons pull has no gear, and its effort is what they pull with.
void DrivenSubject::add_gear(std::size_t joint) {
  // A spring shows in the fourth derivative of the position. Where the motion has none worth
  // mentioning, that is the position's noise, and so is part of what the inertia leaves over.
  constexpr double kMostlyNoise = 0.5;
  const double noise = noise_of_jounce(training(), static_cast<Index>(joint), quantum_[joint]);
  if (noise < kMostlyNoise)
    for (const char* effect : {"gear_elasticity", "gear_resonance"}) add(effect, joint);
  add("inertial_backlash", joint);
  if (scale(joint).load > 0.0) add("loaded_backlash", joint);
}

FlexibleRanges DrivenSubject::ranges(std::size_t joint) const {
  const LogScale s = scale(joint);
  return {s.low, s.high, s.speed, s.load, s.duration};
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

/// Where the model does not say how far a turn of the motor moves the joint.
void DrivenSubject::add_ripple_of_any_period(std::size_t joint) {
  const EffectPlace where{static_cast<int>(joint), place(joint), model_.joints[joint].revolute};
  Candidate c = effect_candidate(find_effect("ripple"), where, scale(joint));
  const NonlinearParameter visible = visible_periods(ranges(joint));
  NonlinearParameter& wavenumber = c.nonlinear.front();
  wavenumber.low = 2.0 * std::numbers::pi * visible.low;
  wavenumber.high = 2.0 * std::numbers::pi * visible.high;
  wavenumber.grid = visible.grid;
  wavenumber.logarithmic = false;
  problem_.library.push_back(std::move(c));
  library_.push_back({"ripple", joint, {}, {}});
}

void DrivenSubject::add_ripples(std::size_t joint) {
  const auto orders = [&](double turn, const std::string& shaft) {
    if (turn <= 0.0) return;
    const double rate = 2.0 * std::numbers::pi / turn;
    // A link that turns under gravity has its weight once a turn.
    const bool weight = is_lone_link() && shaft == "output";
    for (const int k : {1, 2, 3}) {
      add("ripple", joint,
          k == 1 ? fmt::format("ripple once per {} turn", shaft)
                 : fmt::format("ripple {} times per {} turn", k, shaft),
          number(rate * k));
      problem_.library.back().unlikely = weight && k == 1;
    }
    for (const double k : {0.73, 1.37, 2.41})
      add("ripple", joint, fmt::format("ripple off every order of the {}", shaft), number(rate * k),
          CandidateKind::decoy);
    if (scale(joint).load > 0.0 || carries_links(joint))
      add("load_ripple", joint, fmt::format("ripple proportional to load, once per {} turn", shaft),
          number(rate));
  };
  if (model_.joints[joint].motor_turn > 0.0)
    orders(model_.joints[joint].motor_turn, "motor");
  else
    add_ripple_of_any_period(joint);
  // An output that never makes a good part of a turn shows no order of its own.
  const LogScale s = scale(joint);
  if (s.high - s.low > 0.4 * model_.joints[joint].output_turn)
    orders(model_.joints[joint].output_turn, "output");
}

void DrivenSubject::add_model_candidates(std::size_t joint) {
  const EffectPlace where{static_cast<int>(joint), place(joint), model_.joints[joint].revolute};
  const auto take = [&](Candidate candidate, const std::string& effect) {
    problem_.library.push_back(std::move(candidate));
    library_.push_back({effect, joint, {}, {}});
  };
  take(delay_candidate(where), "delay");
  const std::vector<int> coupled = coupled_joints(joint);
  take(sensor_low_pass_candidate(where, known_, coupled,
                                 bristle_[joint] ? model_.joints[joint].friction : 0.0),
       "sensor_low_pass");
  take(sensor_hysteresis_candidate(where, known_, scale(joint)), "sensor_hysteresis");
  if (coarse_sensor(joint)) {
    take(sensor_quantisation_candidate(where, known_, coupled), "sensor_quantisation");
    problem_.library.back().aside = fine_sensor(joint);
  } else if (noise_of_position(training(), static_cast<Index>(joint))) {
    take(sensor_noise_candidate(where, known_, coupled), "sensor_noise");
    problem_.library.back().aside = true;
  }
  if (tendon_driven(joint))
    take(pulley_radius_candidate(where.axis, where.name), "pulley_radius");
  else if (!gain_is_only_level(joint))
    take(torque_constant_candidate(where), "torque_constant");
  if (moves_links(joint)) take(sensor_offset_candidate(where, known_, coupled), "sensor_offset");
  // One joint's scale is a level too (driven_levels.cpp); here it meets what else bends friction.
  take(sensor_scale_candidate(where, known_, coupled), "sensor_scale");
  const int axis = static_cast<int>(joint);
  for (auto* shapes : {flexible_families, local_decoys})
    for (Candidate& c : shapes(ranges(joint), axis, axis)) {
      c.place = place(joint);
      take(std::move(c), "");
    }
}

}  // namespace sinew::diagnosis
