// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/partly_fixed_fit.h"

#include <cmath>

#include "identification/regression/inner_loop.h"
#include "identification/regression/pseudo_inverse.h"

namespace sinew::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Pseudo-inverse of what is left of columns whose own products had this diagonal: what is less
/// than rounding of those is nothing.
MatrixXd inverse_of_left(const MatrixXd& left, const VectorXd& diagonal) {
  const VectorXd scale =
      diagonal.unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 0.0; });
  MatrixXd unit = scale.asDiagonal() * left * scale.asDiagonal();
  for (Index c = 0; c < unit.cols(); ++c)
    if (unit(c, c) <= kDependent) {
      unit.row(c).setZero();
      unit.col(c).setZero();
    }
  return scale.asDiagonal() * scaled_pseudo_inverse(unit) * scale.asDiagonal();
}

}  // namespace

PartlyFixedFit::PartlyFixedFit(const Stack& stack, const std::vector<bool>& moves) {
  std::vector<Index> place(moves.size());
  for (std::size_t c = 0; c < moves.size(); ++c) {
    std::vector<Index>& own = moves[c] ? moving_ : fixed_;
    place[c] = static_cast<Index>(own.size());
    own.push_back(static_cast<Index>(c));
  }
  for (const std::vector<Index>& at : stack.at) {
    Part part;
    for (std::size_t k = 0; k < at.size(); ++k) {
      const auto c = static_cast<std::size_t>(at[k]);
      (moves[c] ? part.moving : part.fixed).push_back(static_cast<Index>(k));
      (moves[c] ? part.moving_at : part.fixed_at).push_back(place[c]);
    }
    parts_.push_back(std::move(part));
  }
  root_ = scaled_pseudo_root(stack.gram()(fixed_, fixed_));
}

PartlyFixedFit::Normal PartlyFixedFit::normal(const Stack& stack) const {
  const auto wide = static_cast<Index>(moving_.size());
  MatrixXd cross = MatrixXd::Zero(static_cast<Index>(fixed_.size()), wide);
  MatrixXd own = stack.prior(moving_).asDiagonal();
  for (std::size_t s = 0; s < parts_.size(); ++s) {
    const Part& part = parts_[s];
    if (part.moving.empty()) continue;
    const MatrixXd moving = stack.a[s](Eigen::all, part.moving);
    own(part.moving_at, part.moving_at) += moving.transpose() * moving;
    if (!part.fixed.empty())
      cross(part.fixed_at, part.moving_at) +=
          MatrixXd(stack.a[s](Eigen::all, part.fixed)).transpose() * moving;
  }
  Normal n;
  n.cross = root_.transpose() * cross;
  n.left = inverse_of_left(own - n.cross.transpose() * n.cross, own.diagonal());
  return n;
}

VectorXd PartlyFixedFit::step(const Normal& n, const VectorXd& moment) const {
  const VectorXd fixed = root_.transpose() * moment(fixed_);
  const VectorXd moving = n.left * (VectorXd(moment(moving_)) - n.cross.transpose() * fixed);
  VectorXd all(moment.size());
  all(moving_) = moving;
  all(fixed_) = root_ * (fixed - n.cross * moving);
  return all;
}

VectorXd PartlyFixedFit::residual(const Stack& stack) const {
  const Normal n = normal(stack);
  return refined_fit(stack, [&](const VectorXd& moment) { return step(n, moment); }).residual;
}

}  // namespace sinew::diagnosis
