// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/small_errors.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "identification/likelihood/decision_constants.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Columns that stand for a hypothesis among errors, and the share of it each carries.
void add_representatives(const Moments& m, const Hypothesis& h, std::vector<Index>& at,
                         std::vector<double>& variance) {
  std::vector<Index> own;
  const std::size_t count = h.shapes.size();
  std::vector<std::size_t> chosen{count / 3};
  if (count > 2) chosen.push_back(2 * count / 3);
  for (const std::size_t k : chosen) {
    const Moments::Range& range = m.of_shape[static_cast<std::size_t>(h.shapes[k])];
    for (Index c = 0; c < range.count; ++c) own.push_back(range.first + c);
  }
  for (const Index column : own) {
    at.push_back(column);
    variance.push_back(1.0 / static_cast<double>(own.size()));
  }
}

/// Errors of a law that was found, by columns, for a standard deviation of 1: each is one of its
/// relatives less what the law itself says of it, with its share of kFormError of the size at which
/// it says most of what the law says. `gram`: of the columns, the law's first, whose coefficients
/// are given.
MatrixXd weights_of(const MatrixXd& gram, const VectorXd& coefficients,
                    const std::vector<double>& variance) {
  const Index own = coefficients.size(), count = gram.rows() - own;
  MatrixXd weights = MatrixXd::Zero(count, gram.cols());
  const VectorXd with_law = gram.bottomLeftCorner(count, own) * coefficients;
  const double law = coefficients.dot(gram.topLeftCorner(own, own) * coefficients);
  for (Index i = 0; i < count; ++i) {
    const double alone = gram(own + i, own + i);
    if (!(law > 0.0) || !(alone > 0.0)) continue;
    const double size = kFormError * std::sqrt(variance[static_cast<std::size_t>(i)]) *
                        std::abs(with_law(i)) / alone;
    weights(i, own + i) = size;
    weights.row(i).head(own) -= size * with_law(i) / law * coefficients.transpose();
  }
  return weights;
}

}  // namespace

/// Columns that are noise besides.
struct SmallErrors::Errors {
  std::vector<Index> at;
  VectorXd size;  ///< standard deviation of each one's coefficient
};

SmallErrors::SmallErrors(const Moments& m, const Hypotheses& all, double share,
                         const std::vector<FoundLaw>& laws)
    : m_(m), target_(m.target), log_likelihood_(-0.5 * m.deviance) {
  if (share > 0.0) take_shares(all, share);
  for (const FoundLaw& law : laws) take_law(all, law);
}

/// What is linear in all its parameters is not off in its form, and its errors hide the weak ones
/// (scripts/study on 57 trials of one cause: 37 right with them, 39 without, and as many wrong
/// names).
void SmallErrors::take_shares(const Hypotheses& all, double share) {
  Errors errors;
  std::vector<double> variance;
  for (const Hypothesis& h : all.list)
    if (h.shapes.size() > 1) add_representatives(m_, h, errors.at, variance);
  const auto count = static_cast<Index>(errors.at.size());
  errors.size = share * VectorXd::Map(variance.data(), count).cwiseSqrt();
  std::vector<std::vector<std::size_t>> own(static_cast<std::size_t>(m_.regions().count()));
  std::vector<std::size_t> everywhere;
  for (std::size_t i = 0; i < errors.at.size(); ++i) {
    const int region = m_.regions().of(errors.at[i]);
    (region == Regions::kEverywhere ? everywhere : own[static_cast<std::size_t>(region)])
        .push_back(i);
  }
  // Cholesky's factor by blocks: regions do not meet, and what is everywhere comes after them.
  for (std::size_t r = 0; r < own.size(); ++r) take(errors, own[r], static_cast<int>(r));
  take(errors, everywhere, Regions::kEverywhere);
}

/// The law at one of its places, and another law of its name.
void SmallErrors::take_law(const Hypotheses& all, const FoundLaw& law) {
  const Moments::Range& range = m_.of_shape[static_cast<std::size_t>(law.shape)];
  if (range.count == 0) return;
  const Shape& shape = all.shapes[static_cast<std::size_t>(law.shape)];
  const std::string& name = all.list[static_cast<std::size_t>(shape.hypothesis)].source->name;
  std::vector<Index> columns;
  VectorXd coefficients(range.count);
  for (Index c = 0; c < range.count; ++c) {
    const Index column = range.first + c;
    columns.push_back(column);
    coefficients(c) =
        law.coefficients(m_.coefficient[static_cast<std::size_t>(column)]) / m_.scale(column);
  }
  std::vector<double> variance;
  for (const Hypothesis& h : all.list)
    if (h.source->name == name && !h.shapes.empty()) add_representatives(m_, h, columns, variance);
  const MatrixXd weights = weights_of(gram(columns, columns), coefficients, variance);
  const int region = m_.regions().of(columns);
  const MatrixXd cross = weights * gram(columns, m_.regions().columns(region));
  take(region, cross,
       MatrixXd(cross(Eigen::all, m_.regions().places(region, columns))) * weights.transpose(),
       weights * VectorXd(target_(columns)));
}

/// Errors `which`, all of one region, after those that were taken before.
void SmallErrors::take(const Errors& errors, const std::vector<std::size_t>& which, int region) {
  const auto count = static_cast<Index>(which.size());
  if (count == 0) return;
  std::vector<Index> at;
  VectorXd size(count);
  for (const std::size_t i : which) {
    size(static_cast<Index>(at.size())) = errors.size(static_cast<Index>(i));
    at.push_back(errors.at[i]);
  }
  const MatrixXd cross = size.asDiagonal() * gram(at, m_.regions().columns(region));
  take(region, cross,
       MatrixXd(cross(Eigen::all, m_.regions().places(region, at))) * size.asDiagonal(),
       size.cwiseProduct(VectorXd(target_(at))));
}

void SmallErrors::take(int region, const MatrixXd& cross, MatrixXd inner, const VectorXd& target) {
  inner += MatrixXd::Identity(inner.rows(), inner.cols());
  const Eigen::LLT<MatrixXd> factor(inner);
  const VectorXd own = factor.matrixL().solve(target);
  Taken taken{region, factor.matrixL().solve(cross)};
  target_(m_.regions().columns(region)) -= taken.rows.transpose() * own;
  taken_.push_back(std::move(taken));
  log_likelihood_ +=
      0.5 * own.squaredNorm() - MatrixXd(factor.matrixL()).diagonal().array().log().sum();
}

namespace {

/// Those of some columns that a region has: where they stand in the list, and among the region's.
struct OfRegion {
  OfRegion(const Regions& regions, int region, const std::vector<Index>& list) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (regions.has(region, list[i])) {
        in_list.push_back(static_cast<Index>(i));
        places.push_back(regions.place(region, list[i]));
      }
  }

  bool is_all_of(const MatrixXd& x) const {
    return static_cast<Index>(places.size()) == x.cols() &&
           std::is_sorted(places.begin(), places.end());
  }

  std::vector<Index> in_list, places;
};

}  // namespace

MatrixXd SmallErrors::gram(const std::vector<Index>& rows,
                           const std::vector<Index>& columns) const {
  MatrixXd g = m_.gram(rows, columns);
  for (const Taken& taken : taken_) {
    const OfRegion left(m_.regions(), taken.region, rows),
        right(m_.regions(), taken.region, columns);
    if (left.places.empty() || right.places.empty()) continue;
    const MatrixXd others = taken.rows(Eigen::all, right.places);
    if (left.is_all_of(taken.rows))
      g(left.in_list, right.in_list) -= taken.rows.transpose() * others;
    else
      g(left.in_list, right.in_list) -=
          MatrixXd(taken.rows(Eigen::all, left.places)).transpose() * others;
  }
  return g;
}

}  // namespace sinew::diagnosis
