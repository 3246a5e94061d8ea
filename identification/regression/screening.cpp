// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/screening.h"

#include <tbb/parallel_for.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::VectorXd;

constexpr double kInBand = 0.5;    // least share of a column's energy that must lie in the band
constexpr double kExcited = 1e-5;  // least share of a column's energy outside the model's span

double grid_value(const NonlinearParameter& p, int i) {
  if (p.grid <= 1) return p.logarithmic ? std::sqrt(p.low * p.high) : 0.5 * (p.low + p.high);
  const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(p.grid);
  return p.logarithmic ? p.low * std::pow(p.high / p.low, share) : p.low + share * (p.high - p.low);
}

/// The model's whitened columns, fit and projected surrogates, shared by all candidates.
struct Projected {
  std::vector<MatrixXd> columns;       ///< per segment: those that act there
  std::vector<std::vector<Index>> at;  ///< their coefficients
  std::vector<VectorXd> residual;      ///< per segment
  std::vector<MatrixXf> surrogates;    ///< per segment, model projected out
  MatrixXd inverse;                    ///< pseudo-inverse of the normal matrix
  VectorXd coefficients;               ///< the fit's
};

Projected project(const Design& design, const Model& model, const Weights& weights,
                  const std::vector<MatrixXf>& surrogates) {
  Stack stacked = stack(model, weights);
  const LinearFit fit = solve(stacked);
  Projected p;
  p.inverse = fit.covariance;
  p.coefficients = fit.coefficients;
  const auto count = design.segments().size();
  p.columns.resize(count);
  p.residual.resize(count);
  p.surrogates.resize(count);
  const bool with_surrogates = !surrogates.empty();
  Index draws = 0;
  for (const MatrixXf& part : surrogates) draws = std::max(draws, part.cols());
  p.at = stacked.at;
  MatrixXd moments = MatrixXd::Zero(stacked.coefficients, draws);
  for (std::size_t s = 0; s < count; ++s) {
    const Index rows = stacked.first_row[s + 1] - stacked.first_row[s];
    if (rows == 0) continue;
    p.columns[s] = std::move(stacked.a[s]);
    p.residual[s] = fit.residual.segment(stacked.first_row[s], rows);
    if (with_surrogates && !p.at[s].empty())
      moments(p.at[s], Eigen::all) +=
          (p.columns[s].transpose().cast<float>() * surrogates[s]).cast<double>();
  }
  if (!with_surrogates) return p;
  const MatrixXf solution = (p.inverse * moments).cast<float>();
  tbb::parallel_for(0, static_cast<int>(count), [&](int i) {
    const auto s = static_cast<std::size_t>(i);
    if (p.columns[s].rows() == 0) return;
    p.surrogates[s] = surrogates[s];
    if (!p.at[s].empty())
      p.surrogates[s] -= p.columns[s].cast<float>() * solution(p.at[s], Eigen::all);
  });
  return p;
}

/// Schur complement of one slot: what is left of it beside the model.
struct Left {
  MatrixXd gram;    ///< projected
  VectorXd whole;   ///< diagonal of the normal matrix before that
  VectorXd moment;  ///< projected columns' product with the residual
  MatrixXd null_moments;
  double excitation = 0.0;
};

Left leave(const Projected& p, const LibraryColumns& columns, const Weights& weights) {
  Left left;
  MatrixXd gram, cross;
  for (std::size_t s = 0; s < columns.size(); ++s) {
    if (columns[s].cols() == 0 || p.columns[s].rows() == 0) continue;
    const MatrixXd x = weights[s].asDiagonal() * columns[s].cast<double>();
    if (gram.size() == 0) {
      gram = MatrixXd::Zero(x.cols(), x.cols());
      cross = MatrixXd::Zero(x.cols(), p.inverse.cols());
      left.moment = VectorXd::Zero(x.cols());
      if (p.surrogates[s].cols() > 0)
        left.null_moments = MatrixXd::Zero(x.cols(), p.surrogates[s].cols());
    }
    gram += x.transpose() * x;
    if (!p.at[s].empty()) cross(Eigen::all, p.at[s]) += x.transpose() * p.columns[s];
    left.moment += x.transpose() * p.residual[s];
    if (left.null_moments.size() > 0)
      left.null_moments += (x.transpose().cast<float>() * p.surrogates[s]).cast<double>();
  }
  if (gram.size() == 0) return left;
  left.whole = gram.diagonal();
  left.gram = gram - cross * p.inverse * cross.transpose();
  for (Index c = 0; c < gram.cols(); ++c)
    if (gram(c, c) > 0.0) left.excitation = std::max(left.excitation, left.gram(c, c) / gram(c, c));
  return left;
}

/// Statistics of one group for many moments: its normal matrix is inverted once. What of a group is
/// in the model's span but for a millionth of its energy is not the group's: surrogates are single
/// precision, and their rounding would count for it.
class GroupStatistic {
 public:
  GroupStatistic(const MatrixXd& gram, const VectorXd& whole)
      : gram_(gram), scale_(whole.cwiseMax(0.0).cwiseSqrt()) {
    for (Index c = 0; c < gram.cols(); ++c)
      if (gram(c, c) > 0.0) all_.push_back(c);
    inverse_ = inverse_of(all_);
  }

  /// Statistic and coefficients within the limits: coefficients outside are held at their limit of
  /// zero (an active set of at most two rounds; groups are small).
  double limited(const VectorXd& moment, const VectorXd& low, const VectorXd& high,
                 VectorXd* coefficients) const {
    VectorXd beta = VectorXd::Zero(moment.size());
    for (std::vector<Index> free = all_; !free.empty();) {
      const VectorXd own = moment(free);
      const VectorXd part =
          free.size() == all_.size() ? VectorXd(inverse_ * own) : VectorXd(inverse_of(free) * own);
      beta.setZero();
      for (std::size_t i = 0; i < free.size(); ++i) beta(free[i]) = part(static_cast<Index>(i));
      std::vector<Index> inside;
      for (const Index c : free)
        if (beta(c) >= low(c) && beta(c) <= high(c)) inside.push_back(c);
      if (inside.size() == free.size()) break;
      free = inside;
      beta.setZero();
    }
    if (coefficients) *coefficients = beta;
    return std::max(0.0, 2.0 * beta.dot(moment) - beta.dot(gram_ * beta));
  }

 private:
  MatrixXd inverse_of(const std::vector<Index>& columns) const {
    constexpr double kDependent = 1e-6;
    const VectorXd scale = scale_(columns).cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
        scale.asDiagonal() * gram_(columns, columns) * scale.asDiagonal());
    const VectorXd inverses = eigen.eigenvalues().unaryExpr(
        [](double value) { return value > kDependent ? 1.0 / value : 0.0; });
    const MatrixXd directions = scale.asDiagonal() * eigen.eigenvectors();
    return directions * inverses.asDiagonal() * directions.transpose();
  }

  const MatrixXd& gram_;
  VectorXd scale_;
  std::vector<Index> all_;
  MatrixXd inverse_;
};

struct Limits {
  VectorXd low, high;
};

/// Coefficients that the training logs have.
std::vector<Design::Coefficient> trained(const Design& design, const Candidate& candidate) {
  const auto logs = static_cast<int>(design.problem().training.size());
  std::vector<Design::Coefficient> layout = design.coefficients(candidate);
  std::erase_if(layout, [&](const Design::Coefficient& c) { return c.recording >= logs; });
  return layout;
}

Limits limits_of(const Design& design, const Candidate& candidate) {
  const auto layout = trained(design, candidate);
  Limits limits{VectorXd(static_cast<Index>(layout.size())),
                VectorXd(static_cast<Index>(layout.size()))};
  for (std::size_t c = 0; c < layout.size(); ++c) {
    const LinearParameter& p = candidate.linear[static_cast<std::size_t>(layout[c].parameter)];
    limits.low(static_cast<Index>(c)) = p.low;
    limits.high(static_cast<Index>(c)) = p.high;
  }
  return limits;
}

/// One slot's result: the data's and, where drawn, every surrogate's statistic.
struct SlotResult {
  Screened data;
  VectorXd null;
};

SlotResult test_slot(const Design& design, const Projected& p, const Candidate& candidate,
                     const VectorXd& nonlinear, const LibraryColumns& columns,
                     const Weights& weights) {
  SlotResult result;
  const Left left = leave(p, columns, weights);
  result.data.excitation = left.excitation;
  result.data.nonlinear = nonlinear;
  if (left.gram.size() == 0 || left.excitation < kExcited) return result;
  const Limits limits = limits_of(design, candidate);
  const VectorXd open =
      VectorXd::Constant(left.moment.size(), std::numeric_limits<double>::infinity());
  const GroupStatistic group(left.gram, left.whole);
  result.data.statistic =
      group.limited(left.moment, limits.low, limits.high, &result.data.coefficients);
  result.data.unrestricted = group.limited(left.moment, -open, open, nullptr);
  result.data.gate = result.data.statistic > 0.0 ? Gate::open : Gate::limit_violated;
  result.null.resize(left.null_moments.cols());
  for (Index i = 0; i < result.null.size(); ++i)
    result.null(i) = group.limited(left.null_moments.col(i), limits.low, limits.high, nullptr);
  return result;
}

LibraryColumns in_single(const BandColumns& columns) {
  LibraryColumns single;
  for (const MatrixXd& part : columns) single.push_back(part.cast<float>());
  return single;
}

LibraryColumns as_library(const Design& design, const Candidate& candidate,
                          const BandColumns& columns) {
  const auto logs = static_cast<int>(design.problem().training.size());
  const auto layout = design.coefficients(candidate);
  std::vector<Index> kept;
  for (std::size_t c = 0; c < layout.size(); ++c)
    if (layout[c].recording < logs) kept.push_back(static_cast<Index>(c));
  LibraryColumns result(columns.size());
  for (std::size_t s = 0; s < columns.size(); ++s)
    if (columns[s].cols() > 0) result[s] = columns[s](Eigen::all, kept).cast<float>();
  return result;
}

}  // namespace

std::vector<VectorXd> starting_values(const Candidate& candidate) {
  std::vector<VectorXd> values{VectorXd(static_cast<Index>(candidate.nonlinear.size()))};
  for (std::size_t k = 0; k < candidate.nonlinear.size(); ++k) {
    std::vector<VectorXd> more;
    for (const VectorXd& value : values)
      for (int i = 0; i < std::max(1, candidate.nonlinear[k].grid); ++i) {
        more.push_back(value);
        more.back()(static_cast<Index>(k)) = grid_value(candidate.nonlinear[k], i);
      }
    values = std::move(more);
  }
  return values;
}

Library::Library(const Design& design) {
  const std::vector<Candidate>& library = design.problem().library;
  for (std::size_t c = 0; c < library.size(); ++c) {
    if (library[c].kind == CandidateKind::delay) continue;
    for (const VectorXd& value : starting_values(library[c]))
      slots_.push_back({static_cast<int>(c), value, {}, 1.0});
  }
  tbb::parallel_for(0, static_cast<int>(slots_.size()), [&](int i) {
    Slot& slot = slots_[static_cast<std::size_t>(i)];
    const Candidate& candidate = library[static_cast<std::size_t>(slot.candidate)];
    slot.columns = as_library(design, candidate,
                              design.training_columns(candidate, slot.nonlinear, slot.in_band));
  });
}

std::vector<const LibraryColumns*> Library::representatives() const {
  std::vector<const LibraryColumns*> chosen;
  for (std::size_t first = 0; first < slots_.size();) {
    std::size_t last = first;
    while (last < slots_.size() && slots_[last].candidate == slots_[first].candidate) ++last;
    const std::size_t count = last - first;
    chosen.push_back(&slots_[first + count / 3].columns);
    if (count > 2) chosen.push_back(&slots_[first + (2 * count) / 3].columns);
    first = last;
  }
  return chosen;
}

Screening screen(const Design& design, const Library& library, const Model& model,
                 const Weights& weights, const std::vector<MatrixXf>& surrogates, Scope scope) {
  const std::vector<Candidate>& candidates = design.problem().library;
  const Projected projected = project(design, model, weights, surrogates);
  std::vector<Slot> delays;
  std::vector<SharedColumns> rates;  // the same for every delay
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (candidates[c].kind == CandidateKind::delay) {
      if (rates.empty()) rates = term_rates(design, model);
      delays.push_back(
          {static_cast<int>(c), VectorXd(),
           in_single(prediction_rate(design, model, rates, projected.coefficients, candidates[c])),
           1.0});
    }
  const auto fixed = library.slots().size();
  std::vector<SlotResult> results(fixed + delays.size());
  const auto slot_at = [&](std::size_t i) -> const Slot& {
    return i < fixed ? library.slots()[i] : delays[i - fixed];
  };
  tbb::parallel_for(0, static_cast<int>(results.size()), [&](int i) {
    const Slot& slot = slot_at(static_cast<std::size_t>(i));
    if (scope == Scope::nameable &&
        candidates[static_cast<std::size_t>(slot.candidate)].kind == CandidateKind::flexible)
      return;
    const Candidate& source = candidates[static_cast<std::size_t>(slot.candidate)];
    if (slot.in_band < kInBand && !source.broadband && !source.exact) {
      results[static_cast<std::size_t>(i)].data.gate = Gate::out_of_band;
      return;
    }
    results[static_cast<std::size_t>(i)] =
        test_slot(design, projected, candidates[static_cast<std::size_t>(slot.candidate)],
                  slot.nonlinear, slot.columns, weights);
  });

  Screening screening;
  screening.candidates.resize(candidates.size());
  std::vector<VectorXd> nulls(candidates.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto c = static_cast<std::size_t>(slot_at(i).candidate);
    Screened& best = screening.candidates[c];
    const double unrestricted = std::max(best.unrestricted, results[i].data.unrestricted);
    const double excitation = std::max(best.excitation, results[i].data.excitation);
    if (best.nonlinear.size() == 0 || results[i].data.statistic > best.statistic)
      best = results[i].data;
    best.candidate = static_cast<int>(c);
    best.unrestricted = unrestricted;
    best.excitation = excitation;
    if (results[i].null.size() == 0) continue;
    nulls[c] =
        nulls[c].size() == 0 ? results[i].null : VectorXd(nulls[c].cwiseMax(results[i].null));
  }
  VectorXd largest;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (nulls[c].size() == 0) continue;
    const NullDistribution null(nulls[c]);
    Screened& s = screening.candidates[c];
    s.null = null;
    s.freedom = std::max(0.5, null.mean());
    s.surprise = null.surprise(s.statistic);
    const VectorXd surprises = nulls[c].unaryExpr([&](double v) { return null.surprise(v); });
    largest = largest.size() == 0 ? surprises : VectorXd(largest.cwiseMax(surprises));
  }
  screening.family = FamilyNull(largest);
  return screening;
}

}  // namespace sinew::diagnosis
