// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/contacts/channelwise_fit.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// As solve() has it: what is more nearly dependent counts as dependent.
constexpr double kDependentInTime = 1e-10;
constexpr int kShared = -2, kNowhere = -1;

/// The channel whose segments alone have a column; of each coefficient.
std::vector<int> channels_of_columns(const Stack& stack, const std::vector<int>& channel) {
  std::vector<int> own(static_cast<std::size_t>(stack.coefficients), kNowhere);
  for (std::size_t s = 0; s < stack.at.size(); ++s)
    for (const Index c : stack.at[s]) {
      int& known = own[static_cast<std::size_t>(c)];
      known = known == kNowhere || known == channel[s] ? channel[s] : kShared;
    }
  return own;
}

/// Normal matrix of each segment, made at once and added in order: a sum's last bit depends on it.
MatrixXd normal_matrix(const Stack& stack) {
  std::vector<MatrixXd> own(stack.a.size());
  tbb::parallel_for(std::size_t{0}, own.size(), [&](std::size_t s) {
    const Index wide = stack.a[s].cols();
    own[s] = MatrixXd::Zero(wide, wide);
    if (wide > 0) own[s].selfadjointView<Eigen::Lower>().rankUpdate(stack.a[s].transpose());
  });
  MatrixXd sum = MatrixXd::Zero(stack.coefficients, stack.coefficients);
  for (std::size_t s = 0; s < own.size(); ++s)
    if (!stack.at[s].empty())
      sum(stack.at[s], stack.at[s]) += MatrixXd(own[s].selfadjointView<Eigen::Lower>());
  sum.diagonal() += stack.prior;
  return sum;
}

/// Pseudo-inverse in the scale of `whole`, the diagonal before other columns were eliminated: what
/// they leave of a column of theirs is rounding.
MatrixXd inverse_beside(const MatrixXd& gram, const VectorXd& whole) {
  if (gram.size() == 0) return gram;
  const VectorXd scale =
      whole.unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 0.0; });
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
      MatrixXd(scale.asDiagonal() * gram * scale.asDiagonal()));
  const double limit = kDependentInTime * std::max(eigen.eigenvalues().maxCoeff(), 1e-300);
  const VectorXd inverse =
      eigen.eigenvalues().unaryExpr([limit](double e) { return e > limit ? 1.0 / e : 0.0; });
  const MatrixXd v = scale.asDiagonal() * eigen.eigenvectors();
  return v * inverse.asDiagonal() * v.transpose();
}

}  // namespace

/// The normal matrix' pseudo-inverse by parts.
class ChannelwiseFit::Inverse {
 public:
  Inverse(const MatrixXd& gram, const std::vector<int>& channel) {
    for (std::size_t c = 0; c < channel.size(); ++c) {
      const auto at = static_cast<Index>(c);
      if (channel[c] == kShared) shared_.push_back(at);
      if (channel[c] < 0) continue;
      const auto group = static_cast<std::size_t>(channel[c]);
      if (group >= parts_.size()) parts_.resize(group + 1);
      parts_[group].at.push_back(at);
    }
    tbb::parallel_for(std::size_t{0}, parts_.size(), [&](std::size_t i) {
      Part& part = parts_[i];
      const MatrixXd own = gram(part.at, part.at);
      part.inverse = inverse_beside(own, own.diagonal());
      part.taken = part.inverse * MatrixXd(gram(part.at, shared_));
    });
    MatrixXd left = gram(shared_, shared_);
    const VectorXd whole = left.diagonal();
    for (const Part& part : parts_) left -= MatrixXd(gram(shared_, part.at)) * part.taken;
    inverse_ = inverse_beside(left, whole);
  }

  VectorXd operator*(const VectorXd& moment) const {
    VectorXd left = moment(shared_), solution = VectorXd::Zero(moment.size());
    for (const Part& part : parts_) left -= part.taken.transpose() * VectorXd(moment(part.at));
    const VectorXd shared = inverse_ * left;
    solution(shared_) = shared;
    for (const Part& part : parts_)
      solution(part.at) = part.inverse * VectorXd(moment(part.at)) - part.taken * shared;
    return solution;
  }

 private:
  /// One channel's own columns; what they take of the shared ones.
  struct Part {
    std::vector<Index> at;
    MatrixXd inverse, taken;
  };
  std::vector<Index> shared_;
  std::vector<Part> parts_;
  MatrixXd inverse_;
};

ChannelwiseFit::ChannelwiseFit(const Stack& stack, const std::vector<int>& channel)
    : inverse_(
          std::make_unique<Inverse>(normal_matrix(stack), channels_of_columns(stack, channel))),
      coefficients_(VectorXd::Zero(stack.coefficients)) {
  if (stack.coefficients == 0) return;
  VectorXd residual = stack.y;
  // Twice, for refinement, as solve() does.
  for (int round = 0; round < 2; ++round) {
    VectorXd moment = -stack.prior.cwiseProduct(coefficients_);
    for (std::size_t s = 0; s < stack.a.size(); ++s)
      if (!stack.at[s].empty())
        moment(stack.at[s]) +=
            stack.a[s].transpose() * residual.segment(stack.first_row[s], stack.a[s].rows());
    const VectorXd step = *inverse_ * moment;
    coefficients_ += step;
    for (std::size_t s = 0; s < stack.a.size(); ++s)
      if (!stack.at[s].empty())
        residual.segment(stack.first_row[s], stack.a[s].rows()) -= stack.a[s] * step(stack.at[s]);
  }
}

ChannelwiseFit::~ChannelwiseFit() = default;

double ChannelwiseFit::variance(const VectorXd& columns) const {
  return columns.dot(*inverse_ * columns);
}

}  // namespace sinew::diagnosis
