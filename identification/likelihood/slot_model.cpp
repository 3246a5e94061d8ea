// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_model.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "identification/likelihood/decision_constants.h"
#include "identification/regression/body_limits.h"
#include "identification/regression/inner_loop.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A wrong side of a limit is forgiven by chance only.
constexpr double kStandardErrors = 2.0;

MatrixXd lower_times(const MatrixXd& lower, const MatrixXd& right) {
  constexpr Index width = 128;
  MatrixXd product(right.rows(), right.cols());
  if (product.size() == 0) return product;
  inner_loop(static_cast<std::size_t>((right.cols() + width - 1) / width), [&](std::size_t i) {
    const Index first = static_cast<Index>(i) * width;
    const Index count = std::min(width, right.cols() - first);
    product.middleCols(first, count).noalias() =
        lower.triangularView<Eigen::Lower>() * right.middleCols(first, count);
  });
  return product;
}

}  // namespace

SlotModel::SlotModel(const Hypotheses& all, const SmallErrors& errors,
                     const std::vector<bool>& banned)
    : all_(all), errors_(errors), entries_(make_entries(all, errors, banned)) {
  first_gram_.push_back(0);
  for (const Entry& e : entries_) {
    regions_.push_back(errors.moments().regions().of(e.columns));
    first_gram_.push_back(first_gram_.back() + e.alone.gram.size());
  }
  std::map<std::pair<std::string, std::string>, int> known;
  // What a link carries and what its drawing has wrong are the same columns: only their sum shows.
  for (const Hypothesis& h : all.list)
    causes_.push_back(
        known
            .emplace(std::pair{h.source->of_body ? "" : h.source->name, h.source->place},
                     static_cast<int>(known.size()))
            .first->second);
}

const Hypothesis& SlotModel::hypothesis_of(int entry) const {
  return all_.list[static_cast<std::size_t>(entries_[static_cast<std::size_t>(entry)].hypothesis)];
}

/// Whether one of a region's columns can meet the entry's.
bool SlotModel::meets(int entry, int region) const {
  return region == Regions::kEverywhere || region_of(entry) == Regions::kEverywhere ||
         region_of(entry) == region;
}

/// Prior precision of the entries' columns: one over each slot's variance.
VectorXd SlotModel::precisions(const Slots& slots) const {
  std::vector<double> list;
  for (std::size_t i = 0; i < slots.entries.size(); ++i)
    list.insert(list.end(), entries_[static_cast<std::size_t>(slots.entries[i])].columns.size(),
                1.0 / slots.variances[i]);
  return VectorXd::Map(list.data(), static_cast<Index>(list.size()));
}

SlotModel::Posterior SlotModel::posterior(const Slots& slots) const {
  Posterior p;
  for (const int e : slots.entries) {
    const auto& own = entries_[static_cast<std::size_t>(e)].columns;
    p.columns.insert(p.columns.end(), own.begin(), own.end());
  }
  p.precision = precisions(slots);
  MatrixXd gram = errors_.gram(p.columns, p.columns);
  gram.diagonal() += p.precision;
  const Eigen::LLT<MatrixXd> factor(gram);
  p.root = factor.matrixL().solve(MatrixXd::Identity(gram.rows(), gram.cols()));
  p.inverse = p.root.transpose() * p.root;
  p.coefficients = p.inverse * VectorXd(errors_.target()(p.columns));
  return p;
}

const MatrixXd& SlotModel::products(int region, int entry) const {
  const std::pair<int, int> key{region, entry};
  {
    const std::shared_lock lock(guard_);
    const auto known = products_.find(key);
    if (known != products_.end()) return *known->second;
  }
  auto made =
      std::make_unique<MatrixXd>(errors_.gram(entries_[static_cast<std::size_t>(entry)].columns,
                                              errors_.moments().regions().columns(region)));
  const std::unique_lock lock(guard_);
  return *products_.emplace(key, std::move(made)).first->second;
}

SlotModel::Fit SlotModel::fit(const Slots& slots, int region) const {
  const std::vector<Index>& columns = errors_.moments().regions().columns(region);
  Fit f;
  static_cast<Posterior&>(f) = posterior(slots);
  f.region = region;
  f.target = errors_.target()(columns);
  const auto count = static_cast<Index>(f.columns.size());
  f.of_cross.resize(f.columns.size());
  std::iota(f.of_cross.begin(), f.of_cross.end(), Index{0});
  MatrixXd cross(count, static_cast<Index>(columns.size()));
  Index first = 0;
  for (const int e : slots.entries) {
    const MatrixXd& own = products(region, e);
    cross.middleRows(first, own.rows()) = own;
    first += own.rows();
  }
  f.given_back.resize(0, cross.cols());
  f.target.noalias() -= cross.transpose() * f.coefficients;
  f.taken = std::make_shared<const MatrixXd>(lower_times(f.root, cross));
  f.grams = std::make_shared<const VectorXd>(conditional_grams(region, *f.taken));
  f.cross = std::make_shared<const MatrixXd>(std::move(cross));
  return f;
}

SlotModel::Fit SlotModel::fit_without(const Fit& whole, const Slots& slots,
                                      std::size_t slot) const {
  Index first = 0;
  for (std::size_t i = 0; i < slot; ++i)
    first += static_cast<Index>(columns_of(slots.entries[i]).size());
  const auto wide = static_cast<Index>(columns_of(slots.entries[slot]).size());
  // The directions, among all that the model takes, that are the slot's alone.
  const Eigen::HouseholderQR<MatrixXd> qr(whole.root.middleCols(first, wide));
  const MatrixXd alone = qr.householderQ() * MatrixXd::Identity(whole.root.rows(), wide);
  const VectorXd size =
      qr.matrixQR().topRows(wide).triangularView<Eigen::Upper>().transpose().solve(
          whole.coefficients.segment(first, wide));
  const MatrixXd of_others = whole.root.transpose() * alone;
  std::vector<Index> kept;
  for (Index c = 0; c < whole.root.cols(); ++c)
    if (c < first || c >= first + wide) kept.push_back(c);
  Fit f;
  f.region = whole.region;
  f.cross = whole.cross;
  f.taken = whole.taken;
  f.grams = whole.grams;
  f.given_back.noalias() = alone.transpose() * *whole.taken;
  f.target = whole.target + f.given_back.transpose() * size;
  f.coefficients = (whole.coefficients - of_others * size)(kept);
  f.inverse = (whole.inverse - of_others * of_others.transpose())(kept, kept);
  f.precision = whole.precision(kept);
  for (const Index c : kept) {
    f.columns.push_back(whole.columns[static_cast<std::size_t>(c)]);
    f.of_cross.push_back(c);
  }
  return f;
}

VectorXd SlotModel::conditional_grams(int region, const MatrixXd& taken) const {
  VectorXd grams(first_gram_.back());
  inner_loop(entries_.size(), [&](std::size_t i) {
    if (!meets(static_cast<int>(i), region)) return;
    const Entry& e = entries_[i];
    const auto wide = static_cast<Index>(e.columns.size());
    const MatrixXd own = taken(Eigen::all, errors_.moments().regions().places(region, e.columns));
    MatrixXd::Map(grams.data() + first_gram_[i], wide, wide).noalias() =
        e.alone.gram - own.transpose() * own;
  });
  return grams;
}

/// An entry given the model, which is fitted in a region that the entry meets.
ConditionalMoments SlotModel::conditional(int entry, const Fit& given) const {
  const Entry& e = entries_[static_cast<std::size_t>(entry)];
  const std::vector<Index> at = errors_.moments().regions().places(given.region, e.columns);
  const auto wide = static_cast<Index>(at.size());
  ConditionalMoments m{
      MatrixXd::Map(given.grams->data() + first_gram_[static_cast<std::size_t>(entry)], wide, wide),
      given.target(at), e.alone.low, e.alone.high};
  if (given.given_back.rows() == 0) return m;
  const MatrixXd back = given.given_back(Eigen::all, at);
  m.gram.noalias() += back.transpose() * back;
  return m;
}

/// What the model spans already has nothing to say for itself.
bool SlotModel::has_something_to_say(const ConditionalMoments& m, int entry) const {
  constexpr double kExcited = 1e-5;
  const MatrixXd& alone = entries_[static_cast<std::size_t>(entry)].alone.gram;
  return m.gram.diagonal().maxCoeff() >= kExcited * alone.diagonal().maxCoeff();
}

BayesFactor SlotModel::factor(int entry, const Fit& given) const {
  const ConditionalMoments m = conditional(entry, given);
  return has_something_to_say(m, entry) ? bayes_factor_of(m) : BayesFactor{kNoOdds, 0.0};
}

template <class Odds>
std::vector<double> SlotModel::of_entries(const Slots& given, const Fit& f, bool names_alone,
                                          const Odds& odds) const {
  std::vector<bool> taken(causes_.size(), false);  // one cause is named once, whatever its forms
  for (const int g : given.entries) taken[static_cast<std::size_t>(cause_of(g))] = true;
  std::vector<double> all(entries_.size(), kNoOdds);
  inner_loop(entries_.size(), [&](std::size_t i) {
    const auto entry = static_cast<int>(i);
    if (!taken[static_cast<std::size_t>(cause_of(entry))] && meets(entry, f.region) &&
        (hypothesis_of(entry).named || !names_alone))
      all[i] = odds(entry) + entries_[i].log_prior;
  });
  return all;
}

std::vector<double> SlotModel::log_odds(const Slots& given, const Fit& f, bool names_alone) const {
  return of_entries(given, f, names_alone, [&](int entry) { return factor(entry, f).logarithm; });
}

std::vector<EntryOdds> SlotModel::odds_at_most(const Slots& given, const Fit& f,
                                               bool names_alone) const {
  const std::vector<double> most = of_entries(given, f, names_alone, [&](int entry) {
    const ConditionalMoments m = conditional(entry, f);
    return has_something_to_say(m, entry) ? most_by_fit(m) : kNoOdds;
  });
  std::vector<EntryOdds> above;
  for (std::size_t i = 0; i < most.size(); ++i)
    if (most[i] > 0.0) above.push_back({static_cast<int>(i), most[i]});
  std::stable_sort(above.begin(), above.end(),
                   [](const EntryOdds& a, const EntryOdds& b) { return a.log_odds > b.log_odds; });
  return above;
}

bool SlotModel::is_possible(int entry, const VectorXd& coefficients, const VectorXd& errors) const {
  const Entry& e = entries_[static_cast<std::size_t>(entry)];
  for (Index c = 0; c < coefficients.size(); ++c)
    if (coefficients(c) < e.alone.low(c) - kStandardErrors * errors(c) ||
        coefficients(c) > e.alone.high(c) + kStandardErrors * errors(c))
      return false;
  // Between two shapes lies one only where both act the same way.
  if (e.shapes.size() > 1) return coefficients(0) * coefficients(1) >= 0.0;
  const std::optional<double>& body_within = hypothesis_of(entry).body_within;
  const Candidate& source = *hypothesis_of(entry).source;
  if (!body_within && !source.possible) return true;
  const Moments& m = errors_.moments();
  VectorXd own = VectorXd::Zero(static_cast<Index>(source.linear.size())), spread = own;
  for (std::size_t c = 0; c < e.columns.size(); ++c) {
    const Index column = e.columns[c];
    const Index at = m.coefficient[static_cast<std::size_t>(column)];
    if (at >= own.size()) return true;  // a nuisance per log
    own(at) = m.scale(column) * coefficients(static_cast<Index>(c));
    spread(at) = m.scale(column) * errors(static_cast<Index>(c));
  }
  if (body_within && !is_body(own, spread, *body_within)) return false;
  return !source.possible ||
         source.possible(own, all_.shapes[static_cast<std::size_t>(e.shapes.front())].nonlinear);
}

bool SlotModel::is_possible(const std::vector<int>& entries, const VectorXd& coefficients,
                            const VectorXd& variances) const {
  const VectorXd errors = variances.cwiseMax(0.0).cwiseSqrt();
  Index first = 0;
  for (const int e : entries) {
    const auto wide = static_cast<Index>(entries_[static_cast<std::size_t>(e)].columns.size());
    if (!is_possible(e, coefficients.segment(first, wide), errors.segment(first, wide)))
      return false;
    first += wide;
  }
  return true;
}

bool SlotModel::is_possible(const Slots& slots) const {
  const Posterior f = posterior(slots);
  return is_possible(slots.entries, f.coefficients, f.inverse.diagonal());
}

/// Whether the slots, whose fit that is, are within their limits with one more entry: what it
/// changes of their coefficients, by blocks of the inverse.
bool SlotModel::stays_possible(const Slots& given, const Fit& f, int entry, double variance) const {
  ConditionalMoments m = conditional(entry, f);
  m.gram.diagonal().array() += 1.0 / variance;
  const Eigen::LLT<MatrixXd> factor(m.gram);
  const VectorXd own = factor.solve(m.target);
  const VectorXd own_variance = factor.solve(MatrixXd::Identity(own.size(), own.size())).diagonal();
  if (!is_possible(entry, own, own_variance.cwiseSqrt())) return false;
  if (given.entries.empty()) return true;
  const std::vector<Index> at = errors_.moments().regions().places(
      f.region, entries_[static_cast<std::size_t>(entry)].columns);
  // What of the model's coefficients one of the entry's takes.
  const MatrixXd taken = f.inverse * (*f.cross)(f.of_cross, at);
  const VectorXd more =
      taken.cwiseProduct(factor.solve(taken.transpose()).transpose()).rowwise().sum();
  return is_possible(given.entries, f.coefficients - taken * own, f.inverse.diagonal() + more);
}

/// log posterior odds of the slots together against none.
Slots SlotModel::weighed(Slots slots) const {
  slots.log_posterior = 0.0;
  if (slots.entries.empty()) return slots;
  for (const int e : slots.entries)
    slots.log_posterior += entries_[static_cast<std::size_t>(e)].log_prior;
  const Posterior whole = posterior(slots);
  const VectorXd size = whole.precision.cwiseInverse().cwiseSqrt();
  MatrixXd inner =
      size.asDiagonal() * errors_.gram(whole.columns, whole.columns) * size.asDiagonal();
  inner.diagonal().array() += 1.0;
  const Eigen::LLT<MatrixXd> factor(inner);
  const VectorXd own = factor.matrixL().solve(
      VectorXd(size.cwiseProduct(VectorXd(errors_.target()(whole.columns)))));
  slots.log_posterior +=
      0.5 * own.squaredNorm() - MatrixXd(factor.matrixL()).diagonal().array().log().sum();
  return slots;
}

VectorXd SlotModel::coefficients(const Slots& slots, std::size_t slot) const {
  const Posterior f = posterior(slots);
  Index first = 0;
  for (std::size_t i = 0; i < slot; ++i)
    first +=
        static_cast<Index>(entries_[static_cast<std::size_t>(slots.entries[i])].columns.size());
  const Entry& e = entries_[static_cast<std::size_t>(slots.entries[slot])];
  VectorXd own = f.coefficients.segment(first, static_cast<Index>(e.columns.size()));
  for (Index c = 0; c < own.size(); ++c)
    own(c) *= errors_.moments().scale(e.columns[static_cast<std::size_t>(c)]);
  return own;
}

}  // namespace sinew::diagnosis
