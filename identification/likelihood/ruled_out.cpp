// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/ruled_out.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "identification/likelihood/slot_verdict.h"
#include "identification/regression/pseudo_inverse.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Name and place: forms of one cause are told once.
using NameAtPlace = std::pair<std::string, std::string>;

NameAtPlace name_at_place(const Candidate& source) {
  return {source.name, source.place};
}

/// What columns would explain beside the slots, whose coefficients are as probable as the search
/// takes them to be.
class BesideSlots {
 public:
  explicit BesideSlots(const FoundSlots& found) : errors_(*found.errors) {
    std::vector<double> precision;
    for (std::size_t i = 0; i < found.slots.entries.size(); ++i) {
      const auto& own =
          found.search->entries()[static_cast<std::size_t>(found.slots.entries[i])].columns;
      columns_.insert(columns_.end(), own.begin(), own.end());
      precision.insert(precision.end(), own.size(), 1.0 / found.slots.variances[i]);
    }
    MatrixXd gram = errors_.gram(columns_, columns_);
    gram.diagonal() += VectorXd::Map(precision.data(), static_cast<Index>(precision.size()));
    factor_.compute(gram);
  }

  /// Best fit of an entry were there no limits, and what it would take of the whitened error.
  struct Fit {
    VectorXd coefficients, standard_errors;
    double drop = 0.0;
  };
  Fit fit(const Entry& entry) const {
    MatrixXd gram = entry.alone.gram;
    VectorXd target = errors_.target()(entry.columns);
    if (!columns_.empty()) {
      const MatrixXd cross = errors_.gram(columns_, entry.columns);
      const MatrixXd taken = factor_.solve(cross);
      gram -= cross.transpose() * taken;
      target -= taken.transpose() * VectorXd(errors_.target()(columns_));
    }
    const MatrixXd inverse = scaled_pseudo_inverse(gram);
    const VectorXd coefficients = inverse * target;
    return {coefficients, inverse.diagonal().cwiseMax(0.0).cwiseSqrt(), target.dot(coefficients)};
  }

 private:
  const SmallErrors& errors_;
  std::vector<Index> columns_;
  Eigen::LLT<MatrixXd> factor_;
};

/// A wrong side by chance alone is none.
bool is_beyond(const Entry& entry, const BesideSlots::Fit& fit) {
  constexpr double standard_errors = 2.0;
  const VectorXd slack = standard_errors * fit.standard_errors;
  return ((fit.coefficients + slack).array() < entry.alone.low.array()).any() ||
         ((fit.coefficients - slack).array() > entry.alone.high.array()).any();
}

/// Whether the shape of a hypothesis that would explain most lies beyond its limits.
std::vector<bool> beyond_limits(const FoundSlots& found) {
  const BesideSlots beside(found);
  std::vector<bool> beyond(found.all.list.size(), false);
  std::vector<double> most(beyond.size(), 0.0);
  for (const Entry& entry : found.search->entries()) {
    if (entry.shapes.size() > 1) continue;
    const auto h = static_cast<std::size_t>(entry.hypothesis);
    const BesideSlots::Fit fit = beside.fit(entry);
    if (fit.drop <= most[h]) continue;
    most[h] = fit.drop;
    beyond[h] = is_beyond(entry, fit);
  }
  return beyond;
}

/// Hypotheses that the search was not to take: a fit of theirs was beyond its limits.
std::vector<bool> taken_back(const FoundSlots& found) {
  std::vector<bool> none(found.all.list.size(), false);
  for (std::size_t s = 0; s < found.all.shapes.size(); ++s)
    if (found.moments.of_shape[s].count > 0)
      none[static_cast<std::size_t>(found.all.shapes[s].hypothesis)] = true;
  for (const Entry& entry : found.search->entries())
    none[static_cast<std::size_t>(entry.hypothesis)] = false;
  return none;
}

/// Free curves are nothing to be ruled out.
bool is_listed(const Hypothesis& h) {
  return h.source->kind != CandidateKind::flexible;
}

std::string limit_of(const Candidate& source) {
  return source.limit_meaning.empty() ? "outside its physical limits" : source.limit_meaning;
}

std::string reason_of(const Hypothesis& h, const Rival& rival, bool beyond) {
  // A name more probable than nothing, and not taken: physics does not allow it.
  if (beyond || (h.named && rival.log_odds > 0.0)) return limit_of(*h.source);
  return rival.log_odds > h.log_prior ? "too little beside the named causes to be told from noise"
                                      : "nothing beyond noise beside the named causes";
}

RuledOut ruled_out(const Hypothesis& h, std::string reason, double log_odds) {
  return {h.source->name, h.source->place, std::move(reason), log_odds};
}

/// A name in a slot that is not sure enough to be told.
void list_unsure(const FoundSlots& found, std::set<NameAtPlace>& listed, Verdict& verdict) {
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) {
    const Hypothesis& h = hypothesis_of(found, i);
    if (!h.named || !listed.insert(name_at_place(*h.source)).second) continue;
    double log_odds = h.log_prior;
    for (const Rival& rival : found.search->rivals(found.slots, i))
      if (&found.all.list[static_cast<std::size_t>(rival.hypothesis)] == &h)
        log_odds = rival.log_odds;
    verdict.ruled_out.push_back(
        ruled_out(h, "too little beside the named causes to be told from noise", log_odds));
  }
}

}  // namespace

void list_ruled_out(const FoundSlots& found, Verdict& verdict) {
  std::set<NameAtPlace> listed;
  for (const NamedCause& cause : verdict.causes)
    for (const RankedCause& member : cause.members) listed.insert({member.name, member.place});
  list_unsure(found, listed, verdict);
  const std::vector<bool> beyond = beyond_limits(found), banned = taken_back(found);
  for (const Rival& rival : found.search->on_top(found.slots)) {
    const auto index = static_cast<std::size_t>(rival.hypothesis);
    const Hypothesis& h = found.all.list[index];
    if (is_listed(h) && listed.insert(name_at_place(*h.source)).second)
      verdict.ruled_out.push_back(ruled_out(h, reason_of(h, rival, beyond[index]), rival.log_odds));
  }
  for (std::size_t i = 0; i < found.all.list.size(); ++i) {
    const Hypothesis& h = found.all.list[i];
    if (is_listed(h) && listed.insert(name_at_place(*h.source)).second)
      verdict.ruled_out.push_back(ruled_out(
          h, banned[i] ? limit_of(*h.source) : "not excited by these logs beside the model",
          h.log_prior));
  }
}

}  // namespace sinew::diagnosis
