// SPDX-License-Identifier: GPL-3.0-or-later
// What may be named at driven joints: the baseline's terms and the candidates beside them.
#include <numbers>

#include "identification/regression/flexible_families.h"
#include "identification/regression/position_noise.h"
#include "identification/subjects/driven_subject.h"
#include "identification/subjects/effect_candidate.h"
#include "identification/subjects/model_candidates.h"
#include "symbolic/effects/effects.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Lengths over which friction turns, as shares of the motion: from below any encoder's step to what
// would be a spring's.
constexpr double kLengthsOfReach[] = {1e-5, 1e-4, 1e-3, 1e-2};

/// Root mean square of what is measured at a joint.
double rms_of_target(const std::vector<Recording>& logs, std::size_t joint) {
  double sum = 0.0, count = 0.0;
  for (const Recording& log : logs) {
    sum += log.target[joint].squaredNorm();
    count += static_cast<double>(log.target[joint].size());
  }
  return std::sqrt(sum / std::max(count, 1.0));
}

}  // namespace

/// What acts on several joints at once.
void DrivenSubject::add_mechanism_candidates() {
  const auto take = [&](Candidate candidate, CandidateOrigin origin) {
    problem_.library.push_back(std::move(candidate));
    library_.push_back(std::move(origin));
  };
  if (model_.joints.size() > 1) take(common_delay_candidate(), {"delay", 0, {}, {}, true});
  if (rigid_)
    for (auto& [candidate, effect] : rigid_->candidates()) {
      if (effect == "payload" && is_lone_link()) add_free_payload(std::move(candidate));
      // What a lone joint carries is free in the baseline: there it is a deviation alone.
      else if (effect != "inertial_parameters" || !is_lone_link())
        take(std::move(candidate), {effect, 0, {}, {}});
    }
  if (!tendons_) return;
  for (TendonColumns::AtTendon& each : tendons_->candidates(problem_.training))
    take(std::move(each.candidate), {each.effect, 0, {}, each.place, each.everywhere});
  for (Candidate& each : tendons_->structure(problem_.training))
    take(std::move(each), {"", 0, {}, {}});
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
  if (find_effect(effect).links_react) let_others_react(joint, c);
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
  add("cable_torque", joint, {}, range);
  // A cubic is near the weight that a link carries over a part of a turn.
  if (!carries_links(joint)) add("cable_torque_cubic", joint, {}, range);
}

/// Bristles of one length are roughly how friction turns at a reversal: it has lengths of all
/// sizes, and a smoothed motion turns a little early or late. How much of which is fitted in any
/// case and names nothing.
void DrivenSubject::add_turning(std::size_t joint) {
  const auto axis = static_cast<int>(joint);
  const bool bristle = bristle_[joint];
  const LogScale s = scale(joint);
  Candidate c;
  c.name = "how friction turns at reversals";
  c.place = place(joint);
  c.kind = CandidateKind::flexible;
  c.depends_on = "way since the last reversal x direction";
  c.channels = {axis};
  c.nuisance = true;
  std::vector<double> lengths;
  // Friction is not expected to be more than what is measured at the joint.
  const double level = rms_of_target(problem_.training, joint);
  for (const double share : kLengthsOfReach) {
    lengths.push_back(share * (s.high - s.low));
    LinearParameter p;
    p.name = "level_" + std::to_string(lengths.size());
    p.spread = level;
    c.linear.push_back(std::move(p));
  }
  c.columns = [regressor = Regressor(find_effect(bristle ? "presliding" : "late_reversal")), axis,
               bristle,
               lengths](const Recording& log, int channel, const VectorXd&) -> Eigen::MatrixXd {
    if (channel != axis) return {};
    Eigen::MatrixXd x(log.q.rows(), static_cast<Index>(lengths.size()));
    for (std::size_t k = 0; k < lengths.size(); ++k)
      x.col(static_cast<Index>(k)) =
          effect_columns(regressor, log, axis, VectorXd::Constant(1, lengths[k]));
    if (bristle) x.colwise() -= log.signals.at("direction").col(axis);
    return x;
  };
  problem_.library.push_back(std::move(c));
  library_.push_back({"", joint, {}, {}});
}

/// A joint that tendons pull has no gear, and its effort is what they pull with.
void DrivenSubject::add_gear(std::size_t joint) {
  // A spring shows in the fourth derivative of the position. Where the motion has none worth
  // mentioning, that is the position's noise, and so is part of what the inertia leaves over.
  constexpr double kMostlyNoise = 0.5;
  const bool links = carries_links(joint);
  if (position_error_[joint].share_of_jounce < kMostlyNoise)
    for (const char* effect : {"elasticity", "resonance"})
      add((links ? "link_" : "gear_") + std::string(effect), joint);
  if (links) return add("link_backlash", joint);
  add("inertial_backlash", joint);
  if (scale(joint).load > 0.0) add("loaded_backlash", joint);
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
  take(sensor_hysteresis_candidate(where, known_, coupled, scale(joint)), "sensor_hysteresis");
  // What is in every measurement is fitted at its own joint. Through the masses it reaches the
  // others as noise does; with a column there it would make the products of all joints' columns
  // with each other, and with a coefficient there it would bend what is found.
  const std::vector<int> own = {where.axis};
  if (position_error_[joint].coarse) {
    const bool fine = fine_sensor(joint);
    take(sensor_quantisation_candidate(where, known_, fine ? own : coupled), "sensor_quantisation");
    problem_.library.back().nuisance = fine;
  } else if (position_error_[joint].hides_acceleration) {
    take(sensor_noise_candidate(where, known_, own), "sensor_noise");
    problem_.library.back().nuisance = true;
  }
  if (tendon_driven(joint))
    take(pulley_radius_candidate(where.axis, where.name), "pulley_radius");
  else if (!gain_is_only_deviation(joint))
    take(torque_constant_candidate(where), "torque_constant");
  if (moves_links(joint)) take(sensor_offset_candidate(where, known_, coupled), "sensor_offset");
  // One joint's scale is a deviation too (driven_deviations.cpp); here it meets what else bends
  // friction.
  take(sensor_scale_candidate(where, known_, coupled), "sensor_scale");
  const int axis = static_cast<int>(joint);
  for (auto* shapes : {flexible_families, varying_values, local_decoys})
    for (Candidate& c : shapes(ranges(joint), axis, axis)) {
      // A ripple of any period has a name there.
      if (is_periodic_in_position(c) && model_.joints[joint].motor_turn <= 0.0) continue;
      c.place = place(joint);
      take(std::move(c), "");
    }
}

}  // namespace sinew::diagnosis
