// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drives/drives.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Matrix = OtherBodies::Matrix;

bool of_force_sensor(const IdentifiedEffect& entry) {
  return entry.effect == "force_sensor_scale" || entry.effect == "force_sensor_offset";
}

/// Entries that are no part of the effort.
bool is_left_out(const IdentifiedEffect& entry, DriveSide side) {
  return entry.effect == "delay" || (of_force_sensor(entry) && !side.as_read);
}

Identified acting(Identified identified, DriveSide side) {
  std::erase_if(identified.effects,
                [&](const IdentifiedEffect& entry) { return is_left_out(entry, side); });
  return identified;
}

/// The joints' bodies ask for nothing; motors keep what is theirs.
DrivenModel without_bodies(DrivenModel model) {
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    if (!model.joints[j].motor) model.rigid.outputs.front().values[j] = 0;
  return model;
}

}  // namespace

Drives::Drives(const DrivenModel& model, const Identified& identified, DriveSide side,
               const std::filesystem::path& runtime)
    : Drives(model, identified, side, runtime, nullptr) {}

Drives::Drives(const DrivenModel& model, const Identified& identified, DriveSide side,
               const std::filesystem::path& runtime, std::shared_ptr<const CompiledModel> compiled)
    : side_(side),
      effort_(compiled && side.bodies &&
                      std::none_of(identified.effects.begin(), identified.effects.end(),
                                   [&](const auto& entry) { return is_left_out(entry, side); })
                  ? DrivenEffort(std::move(compiled))
                  : DrivenEffort(side.bodies ? model : without_bodies(model),
                                 acting(identified, side), runtime)) {
  const std::size_t count = model.joints.size();
  joints_ = static_cast<int>(std::count_if(model.joints.begin(), model.joints.end(),
                                           [](const DrivenJoint& j) { return !j.motor; }));
  delays_.assign(count, 0.0);
  gain_ = VectorXd::Ones(static_cast<Index>(count));
  sensors_.resize(model.tendons.names.size());
  for (const IdentifiedEffect& entry : identified.effects) {
    for (std::size_t j = 0; j < count; ++j) {
      if (model.joints[j].name != entry.place) continue;
      if (entry.effect == "delay") delays_[j] += entry.coefficient("delay");
      if (entry.effect == "torque_constant" || entry.effect == "pulley_radius")
        gain_(static_cast<Index>(j)) *= 1.0 + entry.coefficient("gain_change");
    }
    for (std::size_t t = 0; t < sensors_.size(); ++t) {
      if (tendon_place(model.tendons.names[t]) != entry.place) continue;
      if (side.as_read) continue;
      if (entry.effect == "force_sensor_scale")
        sensors_[t].excess += entry.coefficient("force_excess");
      if (entry.effect == "force_sensor_offset")
        sensors_[t].offset += entry.coefficient("force_offset");
    }
  }
}

bool Drives::needs_steps() const {
  return effort_.has_past() ||
         std::any_of(delays_.begin(), delays_.end(), [](double d) { return d != 0.0; });
}

void Drives::set(const DrivenInstant& now) const {
  effort_.set_time(now.time);
  effort_.set_step(now.step);
  effort_.set_load(now.load);
  effort_.set_tension(now.tension);
}

/// What the motion takes more than acts.
VectorXd Drives::missing(const DrivenInstant& now, const OtherBodies* others,
                         const VectorXd& acceleration) const {
  const Index own = coordinates();
  VectorXd result = -now.effort;
  result.head(own) += effort_(now.q.head(own), now.qd.head(own), acceleration.head(own));
  if (!others) return result;
  VectorXd bodies = others->mass * (acceleration - others->free);
  bodies.head(own).array() /= gain_.array();
  return result + bodies;
}

/// Effects are linear in the acceleration but for impacts: a difference as long as it is the slope.
Matrix Drives::inertia(const DrivenInstant& now, const VectorXd& acceleration) const {
  const Index own = coordinates();
  const VectorXd q = now.q.head(own), qd = now.qd.head(own), at = effort_(q, qd, acceleration);
  Matrix slopes(own, own);
  for (Index j = 0; j < own; ++j) {
    const double change = 1e-3 * std::max(1.0, std::abs(acceleration(j)));
    VectorXd moved = acceleration;
    moved(j) += change;
    slopes.col(j) = (effort_(q, qd, moved) - at) / change;
  }
  return slopes;
}

void Drives::accelerations(const DrivenInstant& now, const OtherBodies* others,
                           VectorXd& guess) const {
  constexpr int kMost = 12;
  constexpr double kEnough = 1e-10;
  set(now);
  const Index own = coordinates();
  if (guess.size() != now.q.size() || !guess.allFinite()) guess = VectorXd::Zero(now.q.size());
  VectorXd off = missing(now, others, guess);
  for (int i = 0; i < kMost; ++i) {
    Matrix slopes = others ? others->mass : Matrix(Matrix::Zero(guess.size(), guess.size()));
    if (others) slopes.topRows(own).array().colwise() /= gain_.array();
    slopes.topLeftCorner(own, own) += inertia(now, guess.head(own));
    const VectorXd change = slopes.partialPivLu().solve(off);
    // An impact has two sides: half a step may be on the right one.
    double share = 1.0;
    VectorXd next = guess - change, left = missing(now, others, next);
    while (share > 0.1 && left.norm() > off.norm()) {
      share *= 0.5;
      next = guess - share * change;
      left = missing(now, others, next);
    }
    guess = std::move(next);
    off = std::move(left);
    if (off.norm() <= kEnough * (1e-3 + now.effort.norm())) return;
  }
}

DrivenSlopes Drives::slopes(const DrivenInstant& now, const VectorXd& acceleration) const {
  set(now);
  const Index own = coordinates();
  const VectorXd q = now.q.head(own), qd = now.qd.head(own), a = acceleration.head(own);
  DrivenSlopes result;
  result.by_acceleration = inertia(now, a);
  result.by_position.resize(own, own);
  result.by_velocity.resize(own, own);
  constexpr double kChange = 1e-7;  // friction turns within less than that of nothing
  for (Index j = 0; j < own; ++j) {
    VectorXd up = q, down = q;
    up(j) += kChange;
    down(j) -= kChange;
    result.by_position.col(j) = (effort_(up, qd, a) - effort_(down, qd, a)) / (2.0 * kChange);
    up = down = qd;
    up(j) += kChange;
    down(j) -= kChange;
    result.by_velocity.col(j) = (effort_(q, up, a) - effort_(q, down, a)) / (2.0 * kChange);
  }
  return result;
}

void Drives::remember(const DrivenInstant& now, const VectorXd& acceleration) {
  set(now);
  const Index own = coordinates();
  effort_(now.q.head(own), now.qd.head(own), acceleration.head(own));
  effort_.remember();
}

}  // namespace sinew
