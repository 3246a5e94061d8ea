// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/explain_sums.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "identification/diagnosis/materiality.h"
#include "identification/likelihood/ruled_out.h"
#include "identification/likelihood/slot_estimates.h"
#include "identification/likelihood/slot_evidence.h"
#include "identification/likelihood/slot_verdict.h"
#include "identification/likelihood/sums_fit.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// As the sums count them: the moments leave out those that are zero.
std::vector<Index> columns_of_slot(const FoundSlots& found, const ColumnSums& sums,
                                   std::size_t slot) {
  const Entry& entry = found.search->entries()[static_cast<std::size_t>(found.slots.entries[slot])];
  std::vector<Index> columns;
  std::size_t k = 0;
  for (const int shape : entry.shapes) {
    const auto s = static_cast<std::size_t>(shape);
    const Index first =
        sums.free + std::accumulate(sums.width.begin(), sums.width.begin() + shape, Index{0});
    for (Index c = 0; c < found.moments.of_shape[s].count; ++c)
      columns.push_back(first +
                        found.moments.coefficient[static_cast<std::size_t>(entry.columns[k++])]);
  }
  return columns;
}

/// The free part's columns, and those of all causes but one (-1: of all).
std::vector<Index> columns_without(const ColumnSums& sums,
                                   const std::vector<std::vector<Index>>& causes, int left_out) {
  std::vector<Index> columns(static_cast<std::size_t>(sums.free));
  std::iota(columns.begin(), columns.end(), Index{0});
  for (std::size_t i = 0; i < causes.size(); ++i)
    if (static_cast<int>(i) != left_out)
      columns.insert(columns.end(), causes[i].begin(), causes[i].end());
  return columns;
}

double least_error(const ColumnSums& sums, const std::vector<Index>& columns) {
  return error_left(sums, columns, fitted_to(sums, columns));
}

struct CauseOfSlot {
  NamedCause cause;
  std::vector<Index> columns;
};

/// Names with parameters and the share of the training error that each takes away, largest first.
void tell_causes(const LogSums& training, ExplainedSums& e) {
  const FoundSlots& found = *e.found;
  const std::vector<NamedCause> of_slot = name_slots(found);
  std::vector<std::size_t> slots;
  std::vector<std::vector<Index>> columns;
  for (std::size_t i = 0; i < of_slot.size(); ++i) {
    if (of_slot[i].members.empty()) continue;
    slots.push_back(i);
    columns.push_back(columns_of_slot(found, training.columns, i));
  }
  const auto parameters = slot_estimates(found, slots);
  const double with = least_error(training.columns, columns_without(training.columns, columns, -1));
  std::vector<CauseOfSlot> list;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    NamedCause cause = of_slot[slots[k]];
    cause.parameters = parameters[k];
    const double share =
        1.0 - with / least_error(training.columns,
                                 columns_without(training.columns, columns, static_cast<int>(k)));
    cause.cross_validated = {share, 0.0, 0.0};
    list.push_back({std::move(cause), columns[k]});
  }
  std::stable_sort(list.begin(), list.end(), [](const CauseOfSlot& a, const CauseOfSlot& b) {
    return a.cause.cross_validated.share > b.cause.cross_validated.share;
  });
  for (CauseOfSlot& each : list) {
    e.verdict.causes.push_back(std::move(each.cause));
    e.columns.push_back(std::move(each.columns));
  }
  e.whitened_error_left =
      with / least_error(training.columns, columns_without(training.columns, {}, -1));
}

/// Errors before any cause; what is not material is taken back.
void tell_size(const ReferenceColumns& reference, const LogSums& training, ExplainedSums& e) {
  const ChannelSquares squares{training.error, training.columns.measured, training.columns.samples};
  e.verdict.relative_error_before =
      std::sqrt(squares.error.sum() / std::max(squares.measured.sum(), 1e-300));
  const Problem& problem = reference.problem();
  const std::vector<NamedCause> before = e.verdict.causes;
  remove_immaterial(problem,
                    immaterial_channels(problem, squares, VectorXd::Zero(problem.channels),
                                        reference.settings().material_share),
                    e.verdict);
  std::vector<std::vector<Index>> kept;
  std::size_t next = 0;
  for (std::size_t i = 0; i < before.size() && next < e.verdict.causes.size(); ++i)
    if (before[i].candidate == e.verdict.causes[next].candidate) {
      kept.push_back(e.columns[i]);
      ++next;
    }
  e.columns = std::move(kept);
}

}  // namespace

ExplainedSums explain_sums(const ReferenceColumns& reference, const LogSums& training) {
  ExplainedSums e;
  e.found = std::make_unique<FoundSlots>();
  FoundSlots& found = *e.found;
  found.all = reference.hypotheses();
  found.moments = moments_of(training.columns, found.all);
  const int most = std::max(reference.settings().most_causes, reference.problem().channels);
  search_slots({most, std::vector<bool>(found.all.list.size(), false), {}}, found);
  tell_causes(training, e);
  tell_unnamed(found, e.verdict.unexplained);
  list_ruled_out(found, e.verdict);
  tell_size(reference, training, e);
  return e;
}

HeldOutErrors::HeldOutErrors(const ExplainedSums& explained, const ColumnSums& training) {
  const auto fit = [&](std::vector<Index> columns) {
    VectorXd coefficients = fitted_to(training, columns);
    return Fit{std::move(columns), std::move(coefficients), {}};
  };
  with_ = fit(columns_without(training, explained.columns, -1));
  without_any_ = fit(columns_without(training, {}, -1));
  for (std::size_t i = 0; i < explained.columns.size(); ++i)
    without_.push_back(fit(columns_without(training, explained.columns, static_cast<int>(i))));
}

void HeldOutErrors::add(const ColumnSums& log) {
  const auto take = [&](Fit& fit) {
    fit.errors.push_back(error_left(log, fit.columns, fit.coefficients));
  };
  take(with_);
  take(without_any_);
  for (Fit& fit : without_) take(fit);
}

void HeldOutErrors::tell(unsigned seed, Verdict& verdict) const {
  constexpr double level = 0.95;
  const auto gain = [&](const Fit& without) {
    const auto count = static_cast<Index>(with_.errors.size());
    return block_bootstrap_gain(VectorXd::Map(without.errors.data(), count),
                                VectorXd::Map(with_.errors.data(), count), level, seed);
  };
  for (std::size_t i = 0; i < verdict.causes.size(); ++i)
    verdict.causes[i].held_out = verdict.causes[i].confirmed = gain(without_[i]);
  verdict.held_out = gain(without_any_);
}

}  // namespace sinew::diagnosis
