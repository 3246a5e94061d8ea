// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/slow_columns.h"

#include <algorithm>
#include <cmath>

#include "identification/logs/filter.h"
#include "identification/subjects/slow_recording.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kMost = 400;  // samples: a model is worked out there for every reading

}  // namespace

SlowColumns::SlowColumns(const DrivenColumns& columns, const Recording& recording,
                         const DrivenModel& model, const TendonColumns* tendons)
    : coordinates_(static_cast<Index>(columns.positions.size())),
      efforts_(static_cast<Index>(columns.efforts.size())),
      forces_(static_cast<Index>(columns.forces.size())),
      tendons_(tendons) {
  if (model.tendons.motor) pulley_radius_ = model.tendons.motor->pulley_radius;
  add_roles(Quantity::position, columns.positions);
  add_roles(Quantity::effort, columns.efforts);
  add_roles(Quantity::force, columns.forces);
  if (columns.load >= 0) add_roles(Quantity::load, {columns.load});
  for (ColumnRole& role : roles_)
    role.has_unit = std::count(columns.scaled_to_model.begin(), columns.scaled_to_model.end(),
                               role.channel) == 0;
  const auto end = static_cast<Index>(std::ceil(driven_edge / recording.step));
  const Index rows = recording.q.rows() - 2 * end;
  if (rows < kFewestPoints) return;
  const Index stride = std::max<Index>(1, rows / kMost), count = (rows - 1) / stride + 1;
  const auto thinned = [&](const MatrixXd& x) -> MatrixXd {
    return x(Eigen::seqN(end, count, stride), Eigen::all);
  };
  const double cutoff = column_cutoff(recording.step);
  const Motion all = differentiate(taken_from(recording), recording.step, cutoff);
  logged_ = {thinned(all.q), thinned(all.qd), thinned(all.qdd)};
  template_.step = recording.step * static_cast<double>(stride);
  template_.time = VectorXd::LinSpaced(count, 0.0, template_.step * static_cast<double>(count - 1));
  if (recording.payload.size() > 0) template_.payload = thinned(recording.payload);
  if (recording.payload_effort.size() > 0)
    template_.payload_effort = thinned(recording.payload_effort);
}

bool SlowColumns::is_long_enough() const {
  return logged_.x.rows() >= kFewestPoints;
}

void SlowColumns::add_roles(Quantity quantity, const std::vector<int>& channels) {
  for (std::size_t i = 0; i < channels.size(); ++i)
    roles_.push_back({quantity, static_cast<Index>(i), channels[i]});
}

Index SlowColumns::index_of(int channel) const {
  return std::find_if(roles_.begin(), roles_.end(),
                      [&](const ColumnRole& r) { return r.channel == channel; }) -
         roles_.begin();
}

const ColumnRole& SlowColumns::role_of(int channel) const {
  return roles_[static_cast<std::size_t>(index_of(channel))];
}

Index SlowColumns::count_of(Quantity quantity) const {
  return std::count_if(roles_.begin(), roles_.end(),
                       [&](const ColumnRole& r) { return r.quantity == quantity; });
}

MatrixXd SlowColumns::taken_from(const Recording& recording) const {
  MatrixXd all(recording.q.rows(), static_cast<Index>(roles_.size()));
  const std::size_t first_effort = recording.target.size() - static_cast<std::size_t>(efforts_);
  for (std::size_t r = 0; r < roles_.size(); ++r) {
    auto column = all.col(static_cast<Index>(r));
    const auto& [quantity, at, channel, has_unit] = roles_[r];
    if (quantity == Quantity::position) column = recording.q.col(at);
    if (quantity == Quantity::effort)
      column = recording.target[first_effort + static_cast<std::size_t>(at)];
    if (quantity == Quantity::force) column = recording.signals.at("tension").col(at);
    if (quantity == Quantity::load) column = recording.load.col(0);
  }
  return all;
}

void SlowColumns::Values::scale(Index role, double factor) {
  for (MatrixXd* m : {&x, &xd, &xdd}) m->col(role) *= factor;
}

void SlowColumns::Values::exchange(Index a, Index b) {
  for (MatrixXd* m : {&x, &xd, &xdd}) m->col(a).swap(m->col(b));
}

Recording SlowColumns::read_as(const ColumnReading* reading) const {
  if (!reading) return recording_of(logged_, 1.0);
  if (reading->column == ColumnReading::kClock) return recording_of(logged_, reading->factor);
  Values values = logged_;
  const Index own = index_of(reading->column);
  const Quantity quantity = roles_[static_cast<std::size_t>(own)].quantity;
  for (std::size_t r = 0; r < roles_.size(); ++r)
    if (static_cast<Index>(r) == own || (reading->all && roles_[r].quantity == quantity))
      values.scale(static_cast<Index>(r), 1.0 / reading->factor);
  if (reading->other >= 0) values.exchange(own, index_of(reading->other));
  return recording_of(values, 1.0);
}

/// clock: how many times too slow the log's is.
Recording SlowColumns::recording_of(const Values& values, double clock) const {
  Recording r = template_;
  r.time /= clock;
  r.step /= clock;
  r.q = values.x.leftCols(coordinates_);
  r.qd = values.xd.leftCols(coordinates_) * clock;
  r.qdd = values.xdd.leftCols(coordinates_) * (clock * clock);
  if (roles_.back().quantity == Quantity::load) r.load = values.x.rightCols(1);
  if (tendons_) {
    r.signals["tension"] = values.x.middleCols(coordinates_ + efforts_, forces_);
    tendons_->add_signals(r);
    const MatrixXd torque = tendons_->joint_torque(r);
    for (Index j = 0; j < torque.cols(); ++j) r.target.push_back(torque.col(j));
    r.load = MatrixXd::Zero(r.q.rows(), coordinates_);
    if (efforts_ > 0) r.load.rightCols(forces_) = pulley_radius_ * r.signals["tension"];
  }
  for (Index i = 0; i < efforts_; ++i) r.target.push_back(values.x.col(coordinates_ + i));
  return r;
}

}  // namespace sinew::diagnosis
