// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/fitted_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "identification/likelihood/decision_constants.h"
#include "identification/likelihood/shape_share.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double coordinate(const NonlinearParameter& range, double value) {
  return range.logarithmic ? std::log(value) : value;
}

/// Where a slot's shape is to be fitted from: its grid point, or between two by their coefficients.
VectorXd start_of(const FoundSlots& found, std::size_t slot) {
  const Entry& entry = found.search->entries()[static_cast<std::size_t>(found.slots.entries[slot])];
  const Hypothesis& h = found.all.list[static_cast<std::size_t>(entry.hypothesis)];
  if (h.source->kind == CandidateKind::delay)
    return VectorXd::Constant(1, found.search->coefficients(found.slots, slot).sum());
  const auto shape = [&](std::size_t i) {
    return found.all.shapes[static_cast<std::size_t>(entry.shapes[i])].nonlinear;
  };
  if (entry.shapes.size() == 1) return shape(0);
  const VectorXd b = found.search->coefficients(found.slots, slot).cwiseAbs();
  const double part = b(1) / std::max(b.sum(), 1e-300);
  const auto& ranges = h.source->nonlinear;
  VectorXd start = shape(0);
  for (Index p = 0; p < start.size(); ++p) {
    const NonlinearParameter& range = ranges[static_cast<std::size_t>(p)];
    const double between =
        (1.0 - part) * coordinate(range, shape(0)(p)) + part * coordinate(range, shape(1)(p));
    start(p) = range.logarithmic ? std::exp(between) : between;
  }
  return start;
}

/// A hypothesis with what its shape is fitted from.
struct Start {
  int hypothesis = 0;
  VectorXd nonlinear;
};

void append_start(const Design& design, const Start& start, FoundSlots& found) {
  const Hypothesis& h = found.all.list[static_cast<std::size_t>(start.hypothesis)];
  if (h.source->kind == CandidateKind::delay)
    append_term(design, found.whitening.training, *h.source, start.nonlinear, found.model);
  else if (h.candidate < 0)
    found.model.terms.push_back(term_of(found.all, h.shapes.front()));
  else
    found.model.terms.push_back(make_term(design, *h.source, start.nonlinear, false));
}

/// What lies between two shapes may explain less than either, and a fit knows no limits of a shape
/// and its size together: where a shape of its entry, as the search has tried it, explains more, or
/// is within limits that a term leaves by chance only, that one is taken. What the logs surely ask
/// for beyond the limits is another cause.
/// `slot_of`: of the model's last terms.
void keep_best(const Design& design, const std::vector<std::size_t>& slot_of, FoundSlots& found) {
  const double by_chance = -2.0 * std::log(1.0 - kCredible);
  const std::size_t count = slot_of.size(), first = found.model.terms.size() - count;
  const auto lost_by = [&](std::size_t i) {
    const LinearFit fit = solve(stack(found.model, found.whitening.training));
    return deviance(found.model, found.whitening.training) +
           (is_beyond_limits(design, found.model, fit, first + i) ? by_chance : 0.0);
  };
  for (std::size_t i = 0; i < count; ++i) {
    Term& term = found.model.terms[first + i];
    // A secant is one to its own coefficient, a delay the model's time.
    if (term.nonlinear.size() == 0 || term.candidate->secant != 0.0 ||
        term.candidate->kind == CandidateKind::delay)
      continue;
    double least = lost_by(i);
    const Entry& entry =
        found.search->entries()[static_cast<std::size_t>(found.slots.entries[slot_of[i]])];
    for (const int shape : entry.shapes) {
      const Term best = term;
      const VectorXd& tried = found.all.shapes[static_cast<std::size_t>(shape)].nonlinear;
      term = make_term(design, *best.candidate, tried, false);
      term.with_prior = true;
      const double here = lost_by(i);
      if (here < least)
        least = here;
      else
        term = best;
    }
  }
}

/// `of_slots`: the starts are those of what the search has found.
void fit_starts(const Design& design, const std::vector<Start>& starts, bool of_slots,
                FoundSlots& found) {
  found.model = found.all.parts.base;
  const std::size_t first = found.model.terms.size();
  std::vector<std::size_t> order;
  for (const bool delays : {false, true})
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const Hypothesis& h = found.all.list[static_cast<std::size_t>(starts[i].hypothesis)];
      if ((h.source->kind == CandidateKind::delay) != delays) continue;
      order.push_back(i);
      append_start(design, starts[i], found);
    }
  if (starts.empty()) return;
  for (std::size_t t = first; t < found.model.terms.size(); ++t)
    found.model.terms[t].with_prior = true;
  if (of_slots) keep_best(design, order, found);
  refine(design, found.whitening.training, found.model);
  if (of_slots) keep_best(design, order, found);
  std::vector<Term> sorted(starts.size());
  for (std::size_t k = 0; k < starts.size(); ++k) sorted[order[k]] = found.model.terms[first + k];
  std::move(sorted.begin(), sorted.end(),
            found.model.terms.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace

void fit_shapes(const Design& design, FoundSlots& found) {
  std::vector<Start> starts;
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i)
    starts.push_back(
        {found.search->entries()[static_cast<std::size_t>(found.slots.entries[i])].hypothesis,
         start_of(found, i)});
  fit_starts(design, starts, true, found);
  const auto terms = found.model.terms.end() - static_cast<std::ptrdiff_t>(starts.size());
  found.forms = slot_forms(found.all, *found.search, found.slots, {terms, found.model.terms.end()});
}

void fit_forms(const Design& design, const std::vector<SlotForm>& forms, FoundSlots& found) {
  std::vector<Start> starts;
  for (const SlotForm& form : forms) {
    const int hypothesis = hypothesis_of(found.all, form);
    if (hypothesis >= 0) starts.push_back({hypothesis, form.nonlinear});
  }
  fit_starts(design, starts, false, found);
}

namespace {

/// The shape of the fitted term at a place in the model: the grid's where it is one of its points,
/// else one more, with its share of the prior.
int shape_of(const FittedModel& fitted, std::size_t at, const Entry& e, Hypotheses& all) {
  const Term& term = fitted.model.terms[at];
  const int nearest = e.shapes.front();
  const VectorXd& known = all.shapes[static_cast<std::size_t>(nearest)].nonlinear;
  if (term.nonlinear.size() == 0 ||
      (e.shapes.size() == 1 && known.size() == term.nonlinear.size() &&
       (known - term.nonlinear).norm() <= 1e-3 * term.nonlinear.norm()))
    return nearest;
  add_shape(fitted.design, e.hypothesis, term.nonlinear, all);
  // A secant's and a delay's parameter is its coefficient, whose prior is counted.
  if (term.candidate->secant == 0.0 && term.candidate->kind != CandidateKind::delay)
    all.shapes.back().log_share = log_share_of_step(fitted, at);
  return static_cast<int>(all.shapes.size()) - 1;
}

}  // namespace

void add_fitted_shapes(const Design& design, FoundSlots& found) {
  const std::size_t first = found.model.terms.size() - found.slots.entries.size();
  const FittedModel fitted(design, found.whitening.training, found.model);
  const VectorXd& coefficients = fitted.fit.coefficients;
  const std::vector<Index> column = first_columns(found.model);
  found.laws.clear();
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) {
    const Term& term = found.model.terms[first + i];
    const Entry& e = found.search->entries()[static_cast<std::size_t>(found.slots.entries[i])];
    if (term.deviation >= 0) continue;
    const int shape = shape_of(fitted, first + i, e, found.all);
    if (term.candidate->of_all_places)
      found.laws.push_back(
          {shape, coefficients.segment(column[first + i],
                                       static_cast<Index>(term.candidate->linear.size()))});
  }
}

bool ban_impossible(const Design& design, const FoundSlots& found, std::vector<bool>& banned) {
  if (found.slots.entries.empty()) return false;
  const LinearFit fit = solve(stack(found.model, found.whitening.training));
  const std::size_t first = found.model.terms.size() - found.slots.entries.size();
  bool any = false;
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) {
    // The nearest body is taken where the one that was fitted is none (physical_links.h): where
    // much stands out of the noise, that is a matter of what the columns are off by.
    if (!is_beyond_limits(design, found.model, fit, first + i)) continue;
    banned[static_cast<std::size_t>(
        found.search->entries()[static_cast<std::size_t>(found.slots.entries[i])].hypothesis)] =
        true;
    any = true;
  }
  return any;
}

}  // namespace sinew::diagnosis
