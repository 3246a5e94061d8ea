// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/entries.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Limits of a column's coefficient in the columns' scale.
void add_limits(const Hypothesis& h, const Moments& m, Index column, ConditionalMoments& alone,
                Index at) {
  double low = -kUnlimited, high = kUnlimited;
  if (h.source->kind == CandidateKind::delay) {
    low = h.source->nonlinear.front().low;
    high = h.source->nonlinear.front().high;
  } else {
    // A nuisance per log has no limits; all others stand in the order of the coefficients.
    const auto& linear = h.source->linear;
    const auto p = static_cast<std::size_t>(m.coefficient[static_cast<std::size_t>(column)]);
    const bool per_log = std::any_of(linear.begin(), linear.end(),
                                     [](const LinearParameter& l) { return l.per_log; });
    if (!per_log && p < linear.size()) {
      low = linear[p].low;
      high = linear[p].high;
    }
  }
  alone.low(at) = low / m.scale(column);
  alone.high(at) = high / m.scale(column);
}

Entry make_entry(const Hypotheses& all, const SmallErrors& errors, int hypothesis,
                 std::vector<int> shapes) {
  const Moments& m = errors.moments();
  Entry e;
  e.hypothesis = hypothesis;
  for (const int shape : shapes) {
    const Moments::Range& range = m.of_shape[static_cast<std::size_t>(shape)];
    for (Index c = 0; c < range.count; ++c) e.columns.push_back(range.first + c);
  }
  e.shapes = std::move(shapes);
  const auto wide = static_cast<Index>(e.columns.size());
  e.alone.low.resize(wide);
  e.alone.high.resize(wide);
  for (Index c = 0; c < wide; ++c)
    add_limits(all.list[static_cast<std::size_t>(hypothesis)], m,
               e.columns[static_cast<std::size_t>(c)], e.alone, c);
  e.alone.target = errors.target()(e.columns);
  return e;
}

}  // namespace

std::vector<Entry> make_entries(const Hypotheses& all, const SmallErrors& errors,
                                const std::vector<bool>& banned) {
  std::vector<Entry> entries;
  for (std::size_t h = 0; h < all.list.size(); ++h) {
    if (banned[h]) continue;
    const std::size_t first = entries.size();
    const auto add = [&](std::vector<int> shapes) {
      Entry e = make_entry(all, errors, static_cast<int>(h), std::move(shapes));
      if (!e.columns.empty()) entries.push_back(std::move(e));
    };
    for (const int shape : all.list[h].shapes) {
      add({shape});
      for (const int next : all.shapes[static_cast<std::size_t>(shape)].neighbours)
        add({shape, next});
    }
    for (std::size_t e = first; e < entries.size(); ++e)
      entries[e].log_prior =
          all.list[h].log_prior - std::log(static_cast<double>(entries.size() - first)) +
          all.shapes[static_cast<std::size_t>(entries[e].shapes.front())].log_share;
  }
  tbb::parallel_for(0, static_cast<int>(entries.size()), [&](int i) {
    Entry& e = entries[static_cast<std::size_t>(i)];
    e.alone.gram = errors.gram(e.columns, e.columns);
  });
  return entries;
}

}  // namespace sinew::diagnosis
