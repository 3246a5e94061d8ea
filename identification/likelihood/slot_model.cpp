// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
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

/// Of columns that mostly stand side by side.
MatrixXd inner_products(const MatrixXd& rows, const std::vector<Index>& at) {
  const auto wide = static_cast<Index>(at.size());
  if (at.back() - at.front() + 1 != wide || !std::is_sorted(at.begin(), at.end())) {
    const MatrixXd own = rows(Eigen::all, at);
    return own.transpose() * own;
  }
  const auto own = rows.middleCols(at.front(), wide);
  return own.transpose() * own;
}

/// Of all slots one below the other.
MatrixXd cross_rows(const std::vector<const MatrixXd*>& cross) {
  Index rows = 0;
  for (const MatrixXd* own : cross) rows += own->rows();
  MatrixXd all(rows, cross.front()->cols());
  Index first = 0;
  for (const MatrixXd* own : cross) {
    all.middleRows(first, own->rows()) = *own;
    first += own->rows();
  }
  return all;
}

}  // namespace

SlotModel::SlotModel(const Hypotheses& all, const SmallErrors& errors,
                     const std::vector<bool>& banned)
    : all_(all), errors_(errors), entries_(make_entries(all, errors, banned)) {
  for (const Entry& e : entries_) regions_.push_back(errors.moments().regions().of(e.columns));
  for (int region = Regions::kEverywhere; region < regions(); ++region)
    region_entries_.push_back(entries_meeting(region));
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

/// Those whose columns can meet one of the region's.
SlotModel::RegionEntries SlotModel::entries_meeting(int region) const {
  RegionEntries list;
  list.places.resize(entries_.size());
  Index next = 0;
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    list.first.push_back(next);
    const int own = regions_[e];
    if (region != Regions::kEverywhere && own != Regions::kEverywhere && own != region) continue;
    list.entries.push_back(static_cast<int>(e));
    list.places[e] = errors_.moments().regions().places(region, entries_[e].columns);
    next += entries_[e].alone.gram.size();
  }
  list.first.push_back(next);
  return list;
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
  Posterior p = posterior(slots);
  Fit f;
  f.slots = slots;
  f.region = region;
  for (const int e : slots.entries) f.cross.push_back(&products(region, e));
  const RegionEntries& own = entries_in(region);
  f.grams.resize(own.first.back());
  for (const int e : own.entries) {
    const MatrixXd& alone = entries_[static_cast<std::size_t>(e)].alone.gram;
    VectorXd::Map(f.grams.data() + own.first[static_cast<std::size_t>(e)], alone.size()) =
        alone.reshaped();
  }
  f.target = errors_.target()(columns);
  if (!slots.entries.empty()) {
    f.target -= combined(f, p.coefficients.transpose()).transpose();
    take(lower_times(p.root, cross_rows(f.cross)), 1.0, f);
  }
  f.inverse = std::move(p.inverse);
  f.coefficients = std::move(p.coefficients);
  return f;
}

SlotModel::Fit SlotModel::fit_with(Fit f, int entry, double variance) const {
  const MatrixXd cross = cross_of(f, entry);
  ConditionalMoments m =
      meets(f.region, entry) ? conditional(entry, f) : elsewhere(entry, cross, f);
  m.gram.diagonal().array() += 1.0 / variance;
  const Eigen::LLT<MatrixXd> factor(m.gram);
  const Index count = f.coefficients.size(), wide = m.target.size();
  const MatrixXd& own = products(f.region, entry);
  // What of the model's coefficients one of the entry's takes.
  const MatrixXd taken = f.inverse * cross;
  const MatrixXd rows = factor.matrixL().solve(own - combined(f, taken.transpose()));
  f.target -= rows.transpose() * factor.matrixL().solve(m.target);
  take(rows, 1.0, f);
  const VectorXd size = factor.solve(m.target);
  VectorXd coefficients(count + wide);
  coefficients << f.coefficients - taken * size, size;
  const MatrixXd own_inverse = factor.solve(MatrixXd::Identity(wide, wide));
  const MatrixXd across = taken * own_inverse;
  MatrixXd inverse(count + wide, count + wide);
  inverse << f.inverse + across * taken.transpose(), -across, -across.transpose(), own_inverse;
  f.coefficients = std::move(coefficients);
  f.inverse = std::move(inverse);
  f.cross.push_back(&own);
  f.slots.entries.push_back(entry);
  f.slots.variances.push_back(variance);
  return f;
}

SlotModel::Fit SlotModel::fit_without(Fit f, std::size_t slot) const {
  const auto at = static_cast<std::ptrdiff_t>(slot);
  Index first = 0;
  for (std::size_t i = 0; i < slot; ++i) first += f.cross[i]->rows();
  const Index wide = f.cross[slot]->rows();
  // The directions, among all that the model takes, that are the slot's alone.
  const Eigen::LLT<MatrixXd> factor(f.inverse.block(first, first, wide, wide));
  const MatrixXd alone = factor.matrixL().solve(f.inverse.middleRows(first, wide));
  const VectorXd size = factor.matrixL().solve(f.coefficients.segment(first, wide));
  const MatrixXd rows = combined(f, alone);
  f.target += rows.transpose() * size;
  take(rows, -1.0, f);
  std::vector<Index> kept;
  for (Index c = 0; c < f.inverse.cols(); ++c)
    if (c < first || c >= first + wide) kept.push_back(c);
  f.coefficients = VectorXd((f.coefficients - alone.transpose() * size)(kept));
  f.inverse = MatrixXd((f.inverse - alone.transpose() * alone)(kept, kept));
  ++f.given_back;
  f.cross.erase(f.cross.begin() + at);
  f.slots.entries.erase(f.slots.entries.begin() + at);
  f.slots.variances.erase(f.slots.variances.begin() + at);
  return f;
}

MatrixXd SlotModel::cross_of(const Fit& f, int entry) const {
  const int region = meets(f.region, entry) ? f.region : region_of(entry);
  const std::vector<Index>& at = places(region, entry);
  MatrixXd cross(f.coefficients.size(), static_cast<Index>(at.size()));
  Index first = 0;
  for (const int slot : f.slots.entries) {
    const MatrixXd& own = products(region, slot);
    cross.middleRows(first, own.rows()) = own(Eigen::all, at);
    first += own.rows();
  }
  return cross;
}

MatrixXd SlotModel::combined(const Fit& f, const MatrixXd& weights) const {
  MatrixXd sum = MatrixXd::Zero(weights.rows(), f.target.size());
  Index first = 0;
  for (const MatrixXd* own : f.cross) {
    sum.noalias() += weights.middleCols(first, own->rows()) * *own;
    first += own->rows();
  }
  return sum;
}

void SlotModel::take(const MatrixXd& rows, double sign, Fit& f) const {
  const RegionEntries& list = entries_in(f.region);
  inner_loop(list.entries.size(), [&](std::size_t i) {
    const auto e = static_cast<std::size_t>(list.entries[i]);
    const std::vector<Index>& at = list.places[e];
    double* const left = f.grams.data() + list.first[e];
    const auto wide = static_cast<Index>(at.size());
    if (wide == 1)
      *left -= sign * rows.col(at.front()).squaredNorm();
    else
      MatrixXd::Map(left, wide, wide) -= sign * inner_products(rows, at);
  });
}

/// An entry given the model, which is fitted in a region that the entry meets.
ConditionalMoments SlotModel::conditional(int entry, const Fit& given) const {
  const auto e = static_cast<std::size_t>(entry);
  const ConditionalMoments& alone = entries_[e].alone;
  const std::vector<Index>& at = places(given.region, entry);
  const auto wide = static_cast<Index>(at.size());
  return {MatrixXd::Map(given.grams.data() + entries_in(given.region).first[e], wide, wide),
          given.target(at), alone.low, alone.high};
}

/// The same of an entry that the fit's region does not meet. `cross`: cross_of() it.
ConditionalMoments SlotModel::elsewhere(int entry, const MatrixXd& cross, const Fit& given) const {
  const ConditionalMoments& alone = entries_[static_cast<std::size_t>(entry)].alone;
  return {alone.gram - cross.transpose() * given.inverse * cross,
          alone.target - cross.transpose() * given.coefficients, alone.low, alone.high};
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
std::vector<double> SlotModel::of_entries(const Fit& f, bool names_alone, const Odds& odds) const {
  std::vector<bool> taken(causes_.size(), false);  // one cause is named once, whatever its forms
  for (const int g : f.slots.entries) taken[static_cast<std::size_t>(cause_of(g))] = true;
  std::vector<double> all(entries_.size(), kNoOdds);
  const std::vector<int>& list = entries_in(f.region).entries;
  inner_loop(list.size(), [&](std::size_t i) {
    const auto e = static_cast<std::size_t>(list[i]);
    if (!taken[static_cast<std::size_t>(cause_of(list[i]))] &&
        (hypothesis_of(list[i]).named || !names_alone))
      all[e] = odds(list[i]) + entries_[e].log_prior;
  });
  return all;
}

std::vector<double> SlotModel::log_odds(const Fit& f, bool names_alone) const {
  return of_entries(f, names_alone, [&](int entry) { return factor(entry, f).logarithm; });
}

std::vector<EntryOdds> SlotModel::odds_at_most(const Fit& f, bool names_alone) const {
  const std::vector<double> most = of_entries(f, names_alone, [&](int entry) {
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
bool SlotModel::stays_possible(const Fit& f, int entry, double variance) const {
  ConditionalMoments m = conditional(entry, f);
  m.gram.diagonal().array() += 1.0 / variance;
  const Eigen::LLT<MatrixXd> factor(m.gram);
  const VectorXd own = factor.solve(m.target);
  const VectorXd own_variance = factor.solve(MatrixXd::Identity(own.size(), own.size())).diagonal();
  if (!is_possible(entry, own, own_variance.cwiseSqrt())) return false;
  if (f.slots.entries.empty()) return true;
  // What of the model's coefficients one of the entry's takes.
  const MatrixXd taken = f.inverse * cross_of(f, entry);
  const VectorXd more =
      taken.cwiseProduct(factor.solve(taken.transpose()).transpose()).rowwise().sum();
  return is_possible(f.slots.entries, f.coefficients - taken * own, f.inverse.diagonal() + more);
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
