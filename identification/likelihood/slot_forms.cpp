// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_forms.h"

#include <cmath>
#include <limits>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// How far apart two shapes are, in ranges of their parameters. A delay's and a value's are none.
double distance(const Candidate& of, const VectorXd& a, const VectorXd& b) {
  if (a.size() != b.size()) return 0.0;
  double sum = 0.0;
  for (Index p = 0; p < a.size() && p < static_cast<Index>(of.nonlinear.size()); ++p) {
    const NonlinearParameter& range = of.nonlinear[static_cast<std::size_t>(p)];
    const auto at = [&](double value) { return range.logarithmic ? std::log(value) : value; };
    sum += std::abs(at(a(p)) - at(b(p))) / (at(range.high) - at(range.low));
  }
  return sum;
}

}  // namespace

int hypothesis_of(const Hypotheses& all, const SlotForm& form) {
  int found = -1;
  for (std::size_t h = 0; h < all.list.size(); ++h) {
    const Hypothesis& one = all.list[h];
    if (one.source->name != form.name || one.source->place != form.place) continue;
    if (one.candidate == form.candidate) return static_cast<int>(h);
    if (found < 0) found = static_cast<int>(h);
  }
  return found;
}

namespace {

/// The entry of one shape that is nearest to a form; -1: there is none.
int nearest_entry(const Hypotheses& all, const SlotSearch& search, const SlotForm& form) {
  const int hypothesis = hypothesis_of(all, form);
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < search.entries().size(); ++e) {
    const Entry& entry = search.entries()[e];
    if (entry.hypothesis != hypothesis || entry.shapes.size() != 1) continue;
    const double away = distance(
        *all.list[static_cast<std::size_t>(hypothesis)].source,
        all.shapes[static_cast<std::size_t>(entry.shapes.front())].nonlinear, form.nonlinear);
    if (away >= least) continue;
    least = away;
    nearest = static_cast<int>(e);
  }
  return nearest;
}

}  // namespace

std::vector<SlotForm> slot_forms(const Hypotheses& all, const SlotSearch& search,
                                 const Slots& slots, const std::vector<Term>& terms) {
  std::vector<SlotForm> forms;
  for (std::size_t i = 0; i < slots.entries.size(); ++i) {
    const Entry& entry = search.entries()[static_cast<std::size_t>(slots.entries[i])];
    const Hypothesis& h = all.list[static_cast<std::size_t>(entry.hypothesis)];
    forms.push_back(
        {h.candidate, h.source->name, h.source->place, terms[i].nonlinear, slots.variances[i]});
  }
  return forms;
}

Slots slots_of_forms(const Hypotheses& all, const SlotSearch& search,
                     const std::vector<SlotForm>& forms) {
  Slots slots;
  for (const SlotForm& form : forms) {
    const int entry = nearest_entry(all, search, form);
    if (entry < 0) continue;
    slots.entries.push_back(entry);
    slots.variances.push_back(form.variance);
  }
  return slots;
}

}  // namespace sinew::diagnosis
