// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/projected_residual.h"

#include <Eigen/QR>
#include <algorithm>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Differences to both sides of every parameter come back to a point again and again.
constexpr std::size_t kRemembered = 3;

}  // namespace

ProjectedResidual::ProjectedResidual(const Design& design, const Weights& weights,
                                     const Model& model, const std::vector<bool>& moving)
    : design_(design), weights_(weights) {
  const Stack whole = stack(model, weights);
  condensed_.coefficients = whole.coefficients;
  condensed_.prior = whole.prior;
  condensed_.first_row = {0};
  const std::vector<Index> first = first_columns(model);
  std::vector<bool> moves(static_cast<std::size_t>(first.back()), false);
  for (std::size_t t = 0; t < moving.size(); ++t)
    for (Index c = first[t]; moving[t] && c < first[t + 1]; ++c)
      moves[static_cast<std::size_t>(c)] = true;
  const auto is_moving = [&](Index c) { return moves[static_cast<std::size_t>(c)]; };
  for (std::size_t s = 0; s < whole.a.size(); ++s) {
    if (whole.a[s].rows() == 0) continue;
    const VectorXd y = whole.y.segment(whole.first_row[s], whole.a[s].rows());
    if (std::any_of(whole.at[s].begin(), whole.at[s].end(), is_moving))
      touch(s, whole.a[s], whole.at[s], y, moves);
    else
      condense(whole.a[s], whole.at[s], y);
  }
  find_places(model, moving);
  fit_.emplace(condensed_, moves);
}

void ProjectedResidual::append(MatrixXd a, std::vector<Index> at, const VectorXd& y) {
  const Index rows = condensed_.first_row.back();
  condensed_.y.conservativeResize(rows + y.size());
  condensed_.y.tail(y.size()) = y;
  condensed_.first_row.push_back(rows + y.size());
  condensed_.a.push_back(std::move(a));
  condensed_.at.push_back(std::move(at));
}

/// Of the columns and the target only the triangle counts.
void ProjectedResidual::condense(const MatrixXd& a, const std::vector<Index>& at,
                                 const VectorXd& y) {
  MatrixXd all(a.rows(), a.cols() + 1);
  all << a, y;
  const Index kept = std::min(all.rows(), all.cols());
  const Eigen::HouseholderQR<MatrixXd> factor(std::move(all));
  const MatrixXd triangle =
      factor.matrixQR().topRows(kept).triangularView<Eigen::Upper>().toDenseMatrix();
  append(triangle.leftCols(a.cols()), at, triangle.rightCols(1));
}

void ProjectedResidual::touch(std::size_t segment, const MatrixXd& a, const std::vector<Index>& at,
                              const VectorXd& y, const std::vector<bool>& moves) {
  std::vector<Index> stay, move, stay_at, move_at;
  for (std::size_t c = 0; c < at.size(); ++c) {
    const bool moving = moves[static_cast<std::size_t>(at[c])];
    (moving ? move : stay).push_back(static_cast<Index>(c));
    (moving ? move_at : stay_at).push_back(at[c]);
  }
  const auto fixed = static_cast<Index>(stay.size());
  const auto wide = static_cast<Index>(move.size());
  const MatrixXd columns = a(Eigen::all, stay);
  const Index kept = std::min(a.rows(), fixed);
  Touched t{segment, MatrixXd(a.rows(), 0), condensed_.a.size(), condensed_.a.size() + 1, fixed};
  MatrixXd along = MatrixXd::Zero(kept, fixed + wide);
  if (kept > 0) {
    const Eigen::HouseholderQR<MatrixXd> factor(columns);
    t.basis = factor.householderQ() * MatrixXd::Identity(a.rows(), kept);
    along.leftCols(fixed) =
        factor.matrixQR().topRows(kept).triangularView<Eigen::Upper>().toDenseMatrix();
  }
  const VectorXd y_along = t.basis.transpose() * y;
  std::vector<Index> all_at = stay_at;
  all_at.insert(all_at.end(), move_at.begin(), move_at.end());
  append(std::move(along), std::move(all_at), y_along);
  append(MatrixXd::Zero(a.rows(), wide), std::move(move_at), y - t.basis * y_along);
  touched_.push_back(std::move(t));
}

void ProjectedResidual::find_places(const Model& model, const std::vector<bool>& moving) {
  const std::vector<Index> first = first_columns(model);
  terms_.resize(model.terms.size());
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    if (!moving[t]) continue;
    Moving& term = terms_[t];
    term.candidate = model.terms[t].candidate;
    term.segments.assign(design_.segments().size(), false);
    for (std::size_t k = 0; k < touched_.size(); ++k) {
      if (model.terms[t].columns[touched_[k].segment].cols() == 0) continue;
      term.segments[touched_[k].segment] = true;
      const std::vector<Index>& at = condensed_.at[touched_[k].across];
      term.places.push_back({k, std::lower_bound(at.begin(), at.end(), first[t]) - at.begin()});
    }
    move(model.terms[t].nonlinear, term);
  }
}

ProjectedResidual::Columns ProjectedResidual::columns_of(const Moving& term,
                                                         const VectorXd& nonlinear) const {
  Columns columns{nonlinear, {}, {}};
  const BandColumns band = design_.columns_at(term.segments, *term.candidate, nonlinear);
  for (const Place& place : term.places) {
    const Touched& t = touched_[place.touched];
    const MatrixXd x = weights_[t.segment].asDiagonal() * band[t.segment];
    columns.along.push_back(t.basis.transpose() * x);
    columns.across.push_back(x - t.basis * columns.along.back());
  }
  return columns;
}

void ProjectedResidual::move(const VectorXd& nonlinear, Moving& term) {
  const auto known = std::find_if(term.before.begin(), term.before.end(),
                                  [&](const Columns& c) { return c.nonlinear == nonlinear; });
  Columns next;
  if (known != term.before.end()) {
    next = std::move(*known);
    term.before.erase(known);
  } else {
    next = columns_of(term, nonlinear);
  }
  if (!term.now.along.empty()) term.before.insert(term.before.begin(), std::move(term.now));
  if (term.before.size() > kRemembered) term.before.pop_back();
  term.now = std::move(next);
  for (std::size_t p = 0; p < term.places.size(); ++p) {
    const Touched& t = touched_[term.places[p].touched];
    const Index wide = term.now.across[p].cols(), first = term.places[p].first;
    condensed_.a[t.along].middleCols(t.fixed + first, wide) = term.now.along[p];
    condensed_.a[t.across].middleCols(first, wide) = term.now.across[p];
  }
}

VectorXd ProjectedResidual::operator()(const std::vector<VectorXd>& nonlinear) {
  for (std::size_t t = 0; t < terms_.size(); ++t)
    if (terms_[t].candidate && nonlinear[t] != terms_[t].now.nonlinear)
      move(nonlinear[t], terms_[t]);
  return fit_->residual(condensed_);
}

}  // namespace sinew::diagnosis
