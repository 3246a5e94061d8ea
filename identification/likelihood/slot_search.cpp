// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_search.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "identification/likelihood/decision_constants.h"
#include "identification/regression/body_limits.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNever = -std::numeric_limits<double>::infinity();

// A slot's coefficients have no other prior than that they are no larger than that.
constexpr double kLeastPrecision = 1.0 / (kLargestSize * kLargestSize);

// A wrong side of a limit is forgiven by chance only.
constexpr double kStandardErrors = 2.0;

constexpr std::size_t kRivals = 6;

std::vector<int> without(std::vector<int> list, std::size_t at) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
  return list;
}

double log_sum(double a, double b) {
  const double high = std::max(a, b);
  return high == kNever ? kNever : high + std::log(std::exp(a - high) + std::exp(b - high));
}

}  // namespace

/// The model with some entries.
struct SlotSearch::Fit {
  std::vector<Index> columns;  ///< the entries', then those of the errors of their forms
  Index own = 0;               ///< how many are the entries'
  MatrixXd cross;              ///< Gram matrix of all columns with those of the model
  MatrixXd inverse;            ///< of the model's
  VectorXd coefficients;
  VectorXd target;  ///< products of all columns with what is left over
};

SlotSearch::SlotSearch(const Hypotheses& all, const SmallErrors& errors, int most,
                       const std::vector<bool>& banned)
    : all_(all),
      errors_(errors),
      most_(static_cast<std::size_t>(most)),
      form_error_(kFormErrors[0]),
      entries_(make_entries(all, errors, banned)) {}

/// Prior precision of every column of a fit; appends the columns of the errors of form. Those are
/// in proportion to what each entry is fitted to without them.
VectorXd SlotSearch::precisions(const std::vector<int>& entries, Fit& f) const {
  const Index own = f.own;
  MatrixXd gram = errors_.gram(f.columns, f.columns);
  gram.diagonal().array() += kLeastPrecision;
  const VectorXd plain = gram.llt().solve(VectorXd(errors_.target()(f.columns)));
  std::vector<double> more;
  Index first = 0;
  for (const int i : entries) {
    const Entry& e = entries_[static_cast<std::size_t>(i)];
    const auto wide = static_cast<Index>(e.columns.size());
    const double size = form_error_ * plain.segment(first, wide).norm();
    first += wide;
    if (size <= 0.0) continue;
    for (const Kin& kin : e.kin) {
      const auto at = std::find(f.columns.begin() + own, f.columns.end(), kin.column);
      const double precision = 1.0 / (kin.share * size * size);
      if (at == f.columns.end()) {
        f.columns.push_back(kin.column);
        more.push_back(precision);
      } else {  // errors of two forms add
        double& known = more[static_cast<std::size_t>(at - f.columns.begin() - own)];
        known = 1.0 / (1.0 / known + 1.0 / precision);
      }
    }
  }
  VectorXd all(own + static_cast<Index>(more.size()));
  all.head(own).setConstant(kLeastPrecision);
  all.tail(static_cast<Index>(more.size())) =
      VectorXd::Map(more.data(), static_cast<Index>(more.size()));
  return all;
}

SlotSearch::Fit SlotSearch::fit(const std::vector<int>& entries) const {
  Fit f;
  for (const int e : entries) {
    const auto& own = entries_[static_cast<std::size_t>(e)].columns;
    f.columns.insert(f.columns.end(), own.begin(), own.end());
  }
  f.target = errors_.target();
  f.own = static_cast<Index>(f.columns.size());
  if (f.columns.empty()) return f;
  const VectorXd precision = precisions(entries, f);
  f.cross = errors_.gram_with_all(f.columns);
  MatrixXd gram = f.cross(f.columns, Eigen::all);
  gram.diagonal() += precision;
  f.inverse = gram.llt().solve(MatrixXd::Identity(precision.size(), precision.size()));
  f.coefficients = f.inverse * VectorXd(errors_.target()(f.columns));
  f.target -= f.cross * f.coefficients;
  return f;
}

BayesFactor SlotSearch::factor(int entry, const Fit& given) const {
  const Entry& e = entries_[static_cast<std::size_t>(entry)];
  ConditionalMoments m = e.alone;
  m.target = given.target(e.columns);
  if (!given.columns.empty()) {
    const MatrixXd cross = given.cross(e.columns, Eigen::all);
    m.gram -= cross * given.inverse * cross.transpose();
  }
  // What the model spans already has nothing to say for itself.
  constexpr double kExcited = 1e-5;
  if (m.gram.diagonal().maxCoeff() < kExcited * e.alone.gram.diagonal().maxCoeff())
    return {kNever, 0.0};
  BayesFactor plain = bayes_factor_of(m);
  if (plain.logarithm > 0.0 && !e.kin.empty())
    plain.logarithm += form_error(e, given, m, plain.variance);
  return plain;
}

/// What the error of its form adds to an entry's log Bayes factor.
double SlotSearch::form_error(const Entry& e, const Fit& given, const ConditionalMoments& m,
                              double variance) const {
  std::vector<Index> kin;
  VectorXd share(static_cast<Index>(e.kin.size()));
  for (std::size_t k = 0; k < e.kin.size(); ++k) {
    kin.push_back(e.kin[k].column);
    share(static_cast<Index>(k)) = e.kin[k].share;
  }
  MatrixXd gram = errors_.gram(kin, kin), cross = errors_.gram(kin, e.columns);
  if (!given.columns.empty()) {
    const MatrixXd beside = given.cross(kin, Eigen::all);
    gram -= beside * given.inverse * beside.transpose();
    cross -= beside * given.inverse * MatrixXd(given.cross(e.columns, Eigen::all)).transpose();
  }
  MatrixXd own = m.gram;
  own.diagonal().array() += 1.0 / variance;
  const Eigen::LLT<MatrixXd> factor(own);
  const VectorXd fitted = factor.solve(m.target);
  gram -= cross * factor.solve(MatrixXd(cross.transpose()));
  const VectorXd left = VectorXd(given.target(kin)) - cross * fitted;
  const VectorXd error = form_error_ * fitted.norm() * share.cwiseSqrt();
  MatrixXd inner = error.asDiagonal() * gram * error.asDiagonal();
  inner.diagonal().array() += 1.0;
  const Eigen::LLT<MatrixXd> whole(inner);
  const VectorXd taken = whole.matrixL().solve(VectorXd(error.cwiseProduct(left)));
  return 0.5 * taken.squaredNorm() - MatrixXd(whole.matrixL()).diagonal().array().log().sum();
}

std::vector<double> SlotSearch::log_odds(const std::vector<int>& given) const {
  const Fit f = fit(given);
  std::vector<bool> taken(all_.list.size(), false);
  for (const int g : given) {
    const Candidate& held =
        *all_.list[static_cast<std::size_t>(entries_[static_cast<std::size_t>(g)].hypothesis)]
             .source;
    // One cause is named once, whatever its forms.
    for (std::size_t h = 0; h < all_.list.size(); ++h)
      if (all_.list[h].source->name == held.name && all_.list[h].source->place == held.place)
        taken[h] = true;
  }
  std::vector<double> odds(entries_.size(), kNever);
  tbb::parallel_for(0, static_cast<int>(entries_.size()), [&](int i) {
    const Entry& e = entries_[static_cast<std::size_t>(i)];
    if (!taken[static_cast<std::size_t>(e.hypothesis)])
      odds[static_cast<std::size_t>(i)] = factor(i, f).logarithm + e.log_prior;
  });
  return odds;
}

bool SlotSearch::is_possible(int entry, const VectorXd& coefficients,
                             const VectorXd& errors) const {
  const Entry& e = entries_[static_cast<std::size_t>(entry)];
  for (Index c = 0; c < coefficients.size(); ++c)
    if (coefficients(c) < e.alone.low(c) - kStandardErrors * errors(c) ||
        coefficients(c) > e.alone.high(c) + kStandardErrors * errors(c))
      return false;
  // Between two shapes lies one only where both act the same way.
  if (e.shapes.size() > 1) return coefficients(0) * coefficients(1) >= 0.0;
  const Candidate& source = *all_.list[static_cast<std::size_t>(e.hypothesis)].source;
  if (!source.body_within && !source.possible) return true;
  const Moments& m = errors_.moments();
  VectorXd own = VectorXd::Zero(static_cast<Index>(source.linear.size())), spread = own;
  for (std::size_t c = 0; c < e.columns.size(); ++c) {
    const Index column = e.columns[c];
    const Index at = m.coefficient[static_cast<std::size_t>(column)];
    if (at >= own.size()) return true;  // a nuisance per log
    own(at) = m.scale(column) * coefficients(static_cast<Index>(c));
    spread(at) = m.scale(column) * errors(static_cast<Index>(c));
  }
  if (source.body_within && !is_body(own, spread, *source.body_within)) return false;
  return !source.possible ||
         source.possible(own, all_.shapes[static_cast<std::size_t>(e.shapes.front())].nonlinear);
}

bool SlotSearch::is_possible(const std::vector<int>& entries) const {
  const Fit f = fit(entries);
  const VectorXd errors = f.inverse.diagonal().cwiseMax(0.0).cwiseSqrt();
  Index first = 0;
  for (const int e : entries) {
    const auto wide = static_cast<Index>(entries_[static_cast<std::size_t>(e)].columns.size());
    if (!is_possible(e, f.coefficients.segment(first, wide), errors.segment(first, wide)))
      return false;
    first += wide;
  }
  return true;
}

/// The entry with the largest odds above 0 that leaves every slot within its limits.
std::optional<int> SlotSearch::best_possible(const std::vector<int>& given,
                                             const std::vector<double>& odds) const {
  constexpr std::size_t most_tried = 40;
  std::vector<int> order;
  for (std::size_t e = 0; e < odds.size(); ++e)
    if (odds[e] > 0.0) order.push_back(static_cast<int>(e));
  const auto by_odds = [&](int a, int b) {
    return odds[static_cast<std::size_t>(a)] > odds[static_cast<std::size_t>(b)];
  };
  const std::size_t count = std::min(most_tried, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    by_odds);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<int> more = given;
    more.push_back(order[k]);
    if (is_possible(more)) return order[k];
  }
  return std::nullopt;
}

/// Every slot given the others: its best rival, or nothing. False: nothing has changed.
bool SlotSearch::polish(std::vector<int>& entries) const {
  bool changed = false;
  for (std::size_t i = 0; i < entries.size();) {
    const std::vector<int> others = without(entries, i);
    const std::optional<int> best = best_possible(others, log_odds(others));
    if (!best) {
      entries = others;
      changed = true;
      continue;
    }
    changed |= *best != entries[i];
    entries[i] = *best;
    ++i;
  }
  return changed;
}

Slots SlotSearch::weighed(const std::vector<int>& entries) const {
  Slots slots;
  slots.entries = entries;
  if (entries.empty()) return slots;
  Fit whole;
  for (const int e : entries) {
    const auto& own = entries_[static_cast<std::size_t>(e)].columns;
    whole.columns.insert(whole.columns.end(), own.begin(), own.end());
  }
  whole.own = static_cast<Index>(whole.columns.size());
  VectorXd variance = precisions(entries, whole).cwiseInverse();
  Index first = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& e = entries_[static_cast<std::size_t>(entries[i])];
    slots.variances.push_back(factor(entries[i], fit(without(entries, i))).variance);
    variance.segment(first, static_cast<Index>(e.columns.size()))
        .setConstant(std::max(slots.variances[i], kSmallestSize * kSmallestSize));
    first += static_cast<Index>(e.columns.size());
    slots.log_posterior += e.log_prior;
  }
  const VectorXd size = variance.cwiseSqrt();
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

Slots SlotSearch::grown(std::vector<int> entries) const {
  constexpr int most_sweeps = 4;
  while (entries.size() < most_) {
    const std::optional<int> best = best_possible(entries, log_odds(entries));
    if (!best) break;
    const std::size_t before = entries.size();
    entries.push_back(*best);
    for (int sweep = 0; sweep < most_sweeps && polish(entries); ++sweep) {
    }
    if (entries.size() <= before) break;
  }
  return weighed(entries);
}

Slots SlotSearch::find() const {
  return grown({});
}

Slots SlotSearch::from_rivals(const Slots& found) const {
  std::vector<std::vector<int>> starts;
  for (std::size_t i = 0; i < found.entries.size(); ++i) {
    const std::vector<int> others = without(found.entries, i);
    const int own = entries_[static_cast<std::size_t>(found.entries[i])].hypothesis;
    std::size_t tried = 0;
    for (const Rival& rival : rivals(found, i)) {
      if (tried == kRivals || rival.log_odds <= 0.0) break;
      if (rival.hypothesis == own) continue;
      ++tried;
      starts.push_back(others);
      starts.back().push_back(rival.entry);
    }
  }
  std::vector<Slots> ends(starts.size());
  tbb::parallel_for(0, static_cast<int>(starts.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    ends[k] = is_possible(starts[k]) ? grown(starts[k]) : Slots{};
  });
  Slots best = found;
  for (const Slots& end : ends)
    if (end.log_posterior > best.log_posterior + 1e-6) best = end;
  return best;
}

std::vector<Rival> SlotSearch::ranked(const std::vector<double>& odds) const {
  std::vector<Rival> list(all_.list.size());
  for (std::size_t h = 0; h < list.size(); ++h) list[h] = {static_cast<int>(h), -1, kNever, 0.0};
  for (std::size_t e = 0; e < odds.size(); ++e) {
    Rival& rival = list[static_cast<std::size_t>(entries_[e].hypothesis)];
    if (odds[e] == kNever) continue;
    if (rival.entry < 0 || odds[e] > odds[static_cast<std::size_t>(rival.entry)])
      rival.entry = static_cast<int>(e);
    rival.log_odds = log_sum(rival.log_odds, odds[e]);
  }
  std::erase_if(list, [](const Rival& r) { return r.entry < 0; });
  std::stable_sort(list.begin(), list.end(),
                   [](const Rival& a, const Rival& b) { return a.log_odds > b.log_odds; });
  double total = 0.0;  // nothing has odds of 1
  for (const Rival& r : list) total = log_sum(total, r.log_odds);
  for (Rival& r : list) r.probability = std::exp(r.log_odds - total);
  return list;
}

std::vector<Rival> SlotSearch::rivals(const Slots& slots, std::size_t slot) const {
  const std::vector<int> others = without(slots.entries, slot);
  std::vector<double> odds = log_odds(others);
  for (std::size_t e = 0; e < odds.size(); ++e) {
    // Far from the best the limits need no look.
    if (odds[e] <= 0.0) continue;
    std::vector<int> more = others;
    more.push_back(static_cast<int>(e));
    if (!is_possible(more)) odds[e] = kNever;
  }
  return ranked(odds);
}

std::vector<Rival> SlotSearch::credible(const Slots& slots, std::size_t slot) const {
  std::vector<Rival> list = rivals(slots, slot);
  double sum = 0.0;
  std::size_t count = 0;
  while (count < list.size() && sum < kCredible && list[count].log_odds > 0.0)
    sum += list[count++].probability;
  list.resize(sum < kCredible ? 0 : count);
  return list;
}

Slots SlotSearch::with_names(Slots slots) const {
  const auto is_named = [&](int hypothesis) {
    return all_.list[static_cast<std::size_t>(hypothesis)].named;
  };
  for (std::size_t i = 0; i < slots.entries.size(); ++i) {
    const std::vector<Rival> set = credible(slots, i);
    const auto named = std::find_if(set.begin(), set.end(),
                                    [&](const Rival& r) { return is_named(r.hypothesis); });
    if (named != set.end()) slots.entries[i] = named->entry;
  }
  return weighed(slots.entries);
}

std::vector<Rival> SlotSearch::on_top(const Slots& slots) const {
  return ranked(log_odds(slots.entries));
}

VectorXd SlotSearch::coefficients(const Slots& slots, std::size_t slot) const {
  const Fit f = fit(slots.entries);
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
