// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/tendon_candidates.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/assemble.h"
#include "identification/logs/filter.h"
#include "identification/regression/flexible_families.h"
#include "identification/regression/standstill.h"
#include "identification/subjects/effect_candidate.h"
#include "identification/subjects/model_candidates.h"
#include "symbolic/effects/effects.h"
#include "symbolic/effects/model_effects.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Hz. A sensor's noise is in the joints' torques too: a term with all of it would find itself.
constexpr double slow_force_cutoff = 5.0;

/// Of the secants: a tendon's arm that much larger.
constexpr double kFarArm = 0.2;

/// The signals of an effect at a tendon, as a recording of one axis.
Recording at_tendon(const Recording& log, Index tendon, bool motor_side, const VectorXd& force) {
  const std::string end = motor_side ? "motor_side" : "tendon";
  Recording r;
  r.step = log.step;
  r.time = log.time;
  r.log_start = log.log_start;
  r.q = log.signals.at("bending").col(tendon);
  r.qd = log.signals.at(end + "_rate").col(tendon);
  r.qdd = MatrixXd::Zero(r.q.rows(), 1);
  r.load = force;
  r.signals["direction"] = log.signals.at(end + "_direction").col(tendon);
  r.signals["jounce"] = MatrixXd::Zero(r.q.rows(), 1);
  return r;
}

/// What a force in the tendon is multiplied with at a channel: the joints' moment arms; at its
/// motor, behind the joints, `motor_arm`.
VectorXd arm_at(const Recording& log, Index tendon, Index joints, int channel, double motor_arm) {
  if (channel < joints) return log.signals.at("moment_arm").col(tendon * joints + channel);
  return VectorXd::Constant(log.q.rows(), channel == joints + tendon ? motor_arm : 0.0);
}

/// Of so many joints those that one of some tendons passes, or the other way round.
template <class Passes>
std::vector<Index> passed(const std::vector<Index>& by, Index count, const Passes& passes) {
  std::vector<Index> found;
  for (Index i = 0; i < count; ++i)
    if (std::any_of(by.begin(), by.end(), [&](Index k) { return passes(k, i); }))
      found.push_back(i);
  return found;
}

}  // namespace

TendonColumns::TendonColumns(const DrivenModel& model, const std::filesystem::path& runtime)
    : names_(model.tendons.names),
      slip_speed_(model.tendons.slip_speed),
      coordinates_(model.tendons.coordinates()),
      compiled_(std::make_shared<CompiledModel>(
          assemble({model.name, "Motion of the tendons", "", {}}, {model.tendons.motion}, {}),
          runtime)) {
  if (model.tendons.motor) motor_radius_ = model.tendons.motor->pulley_radius;
  for (std::size_t t = 0; t < names_.size(); ++t)
    joined_.push_back(joined_to(model.tendons.motion, static_cast<Index>(t)));
}

/// Joints are joined by a tendon that passes both, tendons by a joint that both pass.
TendonColumns::Joined TendonColumns::joined_to(const Function& motion, Index tendon) const {
  const std::vector<GiNaC::ex>& arms = motion.outputs.front().values;
  const auto passes = [&](Index t, Index j) {
    return !arms[static_cast<std::size_t>(t * coordinates_ + j)].is_zero();
  };
  Joined joined{{}, {tendon}};
  for (std::size_t before = 0; joined.tendons.size() > before;) {
    before = joined.tendons.size();
    joined.joints = passed(joined.tendons, coordinates_, passes);
    joined.tendons = passed(joined.joints, static_cast<Index>(names_.size()),
                            [&](Index j, Index t) { return passes(t, j); });
  }
  return joined;
}

void TendonColumns::add_signals(Recording& log) const {
  const sinew_function& function = compiled_->find("tendon_motion");
  const Index n = coordinates_, m = static_cast<Index>(names_.size()), rows = log.q.rows();
  MatrixXd arms(rows, m * n), rates(rows, m), bending(rows, m);
  VectorXd in(function.input_size), out(function.output_size);
  for (Index k = 0; k < rows; ++k) {
    in << log.q.row(k).head(n).transpose(), log.qd.row(k).head(n).transpose();
    function.call(in.data(), out.data());
    arms.row(k) = out.head(m * n).transpose();
    rates.row(k) = out.segment(m * n, m).transpose();
    bending.row(k) = out.tail(m).transpose();
  }
  log.signals["slow_tension"] =
      differentiate(log.signals.at("tension"), log.step, slow_force_cutoff).q;
  const auto direction = [this](const MatrixXd& rate) -> MatrixXd {
    return rate.array() / (rate.array().square() + slip_speed_ * slip_speed_).sqrt();
  };
  log.signals["tendon_direction"] = direction(rates);
  if (motor_radius_) {
    const MatrixXd at_motors = -*motor_radius_ * log.qd.rightCols(m);
    log.signals["motor_side_direction"] = direction(at_motors);
    log.signals["motor_side_rate"] = at_motors;
  }
  log.signals["moment_arm"] = std::move(arms);
  log.signals["tendon_rate"] = std::move(rates);
  log.signals["bending"] = std::move(bending);
}

/// How much more force than measured in one tendon, whose moment arms are larger than the model's
/// by that share, is nearest to the measured ones and moves the joints as the model says.
VectorXd TendonColumns::lacking_tension(const Recording& log, Index tendon, double larger) const {
  const auto& [joints, tendons] = joined_[static_cast<std::size_t>(tendon)];
  const Index own = std::find(tendons.begin(), tendons.end(), tendon) - tendons.begin();
  std::vector<Index> columns;  // of the moment arms, tendon by tendon
  for (const Index t : tendons)
    for (const Index j : joints) columns.push_back(t * coordinates_ + j);
  const auto n = static_cast<Index>(joints.size()), m = static_cast<Index>(tendons.size());
  MatrixXd arms = log.signals.at("moment_arm")(Eigen::all, columns);
  arms.middleCols(own * n, n) *= 1.0 + larger;
  const MatrixXd tension = log.signals.at("tension")(Eigen::all, tendons);
  MatrixXd lacking(arms.rows(), n);  // of the joints
  for (Index j = 0; j < n; ++j)
    lacking.col(j) = -log.known[static_cast<std::size_t>(joints[static_cast<std::size_t>(j)])] -
                     arms(Eigen::all, Eigen::seqN(j, m, n)).cwiseProduct(tension).rowwise().sum();
  // What the tendon has of the least forces that make up for a unit of each joint's: there may be
  // fewer tendons than joints.
  const auto share = [&](Index row) -> VectorXd {
    const MatrixXd transposed = VectorXd(arms.row(row)).reshaped(n, m);  // P^T
    return transposed.completeOrthogonalDecomposition().pseudoInverse().row(own).transpose();
  };
  if ((arms.rowwise() - arms.row(0)).isZero(0.0)) return lacking * share(0);
  for (Index k = 0; k < arms.rows(); ++k) lacking(k, 0) = lacking.row(k).dot(share(k));
  return lacking.col(0);
}

VectorXd TendonColumns::agreeing_tension(const Recording& log, Index tendon, double larger) const {
  return log.signals.at("slow_tension").col(tendon) +
         differentiate(lacking_tension(log, tendon, larger), log.step, slow_force_cutoff).q;
}

void TendonColumns::add_agreeing_tension(Recording& log) const {
  MatrixXd agreeing(log.q.rows(), static_cast<Index>(names_.size()));
  MatrixXd within = log.signals.at("tension");
  for (Index t = 0; t < agreeing.cols(); ++t) {
    const VectorXd lacking = lacking_tension(log, t, 0.0);
    agreeing.col(t) = log.signals.at("slow_tension").col(t) +
                      differentiate(lacking, log.step, slow_force_cutoff).q;
    within.col(t) += 0.5 * lacking;
  }
  log.signals["agreeing_tension"] = std::move(agreeing);
  log.signals["tension_within_guide"] = std::move(within);
}

std::vector<Stillness> TendonColumns::stillness(const Recording& log, double cutoff) const {
  constexpr double kSlips = 3.0;  // times the speed over which friction turns: 95 % of its level
  const MatrixXd& arms = log.signals.at("moment_arm");
  const MatrixXd smooth = log.signals.at("smooth_qd").leftCols(coordinates_);
  std::vector<Stillness> all;
  for (Index t = 0; t < static_cast<Index>(names_.size()); ++t) {
    const VectorXd rate =
        arms.middleCols(t * coordinates_, coordinates_).cwiseProduct(smooth).rowwise().sum();
    all.push_back(find_stillness({log.signals.at("tendon_rate").col(t), rate}, log.step, cutoff,
                                 kSlips * slip_speed_));
  }
  return all;
}

/// What is known of the share before any log: the drawing's arms are right but for so much.
void TendonColumns::expect_drawn(const std::vector<Recording>& logs, Index tendon,
                                 Candidate& c) const {
  double arm = 0.0;
  for (const Recording& log : logs)
    arm = std::max(arm, log.signals.at("moment_arm")
                            .middleCols(tendon * coordinates_, coordinates_)
                            .cwiseAbs()
                            .maxCoeff());
  for (LinearParameter& p : c.linear) p.spread = kDrawnArm * (p.unit == "m" ? arm : 1.0);
}

MatrixXd TendonColumns::joint_torque(const Recording& log) const {
  const MatrixXd& arms = log.signals.at("moment_arm");
  const MatrixXd& tension = log.signals.at("tension");
  MatrixXd torque = MatrixXd::Zero(arms.rows(), coordinates_);
  for (Index t = 0; t < tension.cols(); ++t)
    torque -=
        (arms.middleCols(t * coordinates_, coordinates_).array().colwise() * tension.col(t).array())
            .matrix();
  return torque;
}

Candidate TendonColumns::candidate(const Effect& effect, Index tendon) const {
  // The regressor stands for the force lost; the joints feel it with the moment arms.
  const LogScale no_scale;
  Candidate c = effect_candidate(
      effect, {0, tendon_place(names_[static_cast<std::size_t>(tendon)]), false}, no_scale);
  c.channels.clear();
  c.is_value = effect.scales_force || effect.felt_by_motor;
  const Index n = coordinates_;
  const double motor_arm = effect.felt_by_motor ? motor_radius_.value_or(0.0) : 0.0;
  if (effect.scales_force && !effect.changes_arm) c.secant = kFarArm;
  c.columns = [regressor = Regressor(effect), tendon, n, motor_arm, motor_side = effect.motor_side,
               changes_arm = effect.changes_arm, scales_force = effect.scales_force,
               is_secant = c.secant != 0.0, columns = *this](const Recording& log, int channel,
                                                             const VectorXd& shape) -> MatrixXd {
    const VectorXd arm = arm_at(log, tendon, n, channel, motor_arm);
    if (arm.isZero(0.0)) return MatrixXd(log.q.rows(), 0);
    const bool away = is_secant && shape.size() > 0;
    const VectorXd force =
        away ? columns.agreeing_tension(log, tendon, shape(0))
             : log.signals.at(scales_force ? "agreeing_tension" : "tension_within_guide")
                   .col(tendon);
    Recording r = at_tendon(log, tendon, motor_side, force);
    if (changes_arm) {
      r.q = log.q.col(channel);
      return effect_columns(regressor, r, 0, shape);
    }
    const MatrixXd lost = effect_columns(regressor, r, 0, away ? VectorXd() : shape);
    return lost.array().colwise() * arm.array();
  };
  return c;
}

/// With one coefficient and one shape for all tendons.
Candidate TendonColumns::common_candidate(const Effect& effect) const {
  std::vector<Candidate> each;
  for (std::size_t t = 0; t < names_.size(); ++t)
    each.push_back(candidate(effect, static_cast<Index>(t)));
  Candidate all = each.front();
  all.place = "all tendons";
  all.of_all_places = true;
  all.columns = [each](const Recording& log, int channel, const VectorXd& shape) {
    MatrixXd sum;
    for (const Candidate& one : each) {
      const MatrixXd own = one.columns(log, channel, shape);
      if (own.cols() == 0) continue;
      if (sum.cols() == 0)
        sum = own;
      else
        sum += own;
    }
    return sum.cols() > 0 ? sum : MatrixXd(log.q.rows(), 0);
  };
  return all;
}

std::vector<TendonColumns::AtTendon> TendonColumns::candidates(
    const std::vector<Recording>& logs) const {
  std::vector<const Effect*> known;
  for (const Effect& effect : effects())
    if (effect.at_tendon && !(effect.motor_side && !motor_radius_)) known.push_back(&effect);
  std::vector<AtTendon> list;
  for (std::size_t t = 0; t < names_.size(); ++t)
    for (const Effect* effect : known) {
      const auto tendon = static_cast<Index>(t);
      list.push_back({candidate(*effect, tendon), effect->id, tendon_place(names_[t])});
      if (effect->scales_force) expect_drawn(logs, tendon, list.back().candidate);
    }
  for (const Effect* effect : known) {
    if (!effect->of_one_make || names_.size() < 2) continue;
    const Candidate all = common_candidate(*effect);
    list.push_back({all, effect->id, all.place, true});
  }
  return list;
}

/// What a force sensor says more or less, at the joints that its tendon passes and at its motor.
Candidate TendonColumns::at_sensor(Candidate c, Index tendon) const {
  c.place = tendon_place(names_[static_cast<std::size_t>(tendon)]);
  c.channels.clear();
  c.columns = [of_force = c.columns, tendon, n = coordinates_,
               motor_arm = motor_radius_.value_or(0.0)](const Recording& log, int channel,
                                                        const VectorXd& shape) -> MatrixXd {
    const VectorXd arm = arm_at(log, tendon, n, channel, motor_arm);
    if (arm.isZero(0.0)) return MatrixXd(log.q.rows(), 0);
    return arm.asDiagonal() * of_force(log, channel, shape);
  };
  return c;
}

std::vector<Candidate> TendonColumns::structure(const std::vector<Recording>& logs) const {
  std::vector<Candidate> list;
  const double duration = scale_of(logs, 0).duration;
  for (Index t = 0; t < static_cast<Index>(names_.size()); ++t) {
    const LogSignal force = [t](const Recording& log) -> VectorXd {
      return log.signals.at("agreeing_tension").col(t);
    };
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Recording& log : logs) {
      const VectorXd own = force(log);
      low = std::min(low, own.minCoeff());
      high = std::max(high, own.maxCoeff());
    }
    if (!(high > low)) continue;
    list.push_back(at_sensor(any_law("force", force, low, high, 0, 0), t));
    list.push_back(at_sensor(changing_in_time("time x force", force, duration, 0, 0), t));
  }
  return list;
}

Candidate pulley_radius_candidate(int axis, const std::string& place) {
  Candidate c = torque_constant_candidate({axis, place, true});
  const ModelEffect& e = *find_model_effect("pulley_radius");
  c.name = e.name;
  // The term scales the model's torque: 1 + gain is the model's radius over the true one. Beyond
  // this it is the links that are not as the model says.
  c.linear.front().low = -0.5;
  c.linear.front().high = 1.0;
  c.limit_meaning = e.limit;
  c.isolating_experiment = e.experiment;
  return c;
}

}  // namespace sinew::diagnosis
