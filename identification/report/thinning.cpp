// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/thinning.h"

#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {
namespace {

Series cleaned(const Series& series, bool logarithmic) {
  Series result{series.label, {}, {}, series.points};
  const std::size_t count = std::min(series.x.size(), series.y.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double x = series.x[i], y = series.y[i];
    if (!std::isfinite(x)) continue;
    if (logarithmic && (x <= 0.0 || !(y > 0.0))) continue;
    // A sample without a value is a gap in a line and nothing in a cloud.
    if (!std::isfinite(y) && series.points) continue;
    result.x.push_back(x);
    result.y.push_back(y);
  }
  return result;
}

Series every_nth(const Series& series, std::size_t most) {
  Series result{series.label, {}, {}, series.points};
  const std::size_t stride = (series.x.size() + most - 1) / most;
  for (std::size_t i = 0; i < series.x.size(); i += stride) {
    result.x.push_back(series.x[i]);
    result.y.push_back(series.y[i]);
  }
  return result;
}

/// Smallest and largest of samples [begin, end), in the order in which they come; a stretch with a
/// gap keeps the gap.
void append_extremes(const Series& series, std::size_t begin, std::size_t end, Series& result) {
  std::size_t low = begin, high = begin;
  bool gap = false;
  for (std::size_t i = begin; i < end; ++i) {
    if (!std::isfinite(series.y[i])) {
      gap = true;
      continue;
    }
    if (!std::isfinite(series.y[low]) || series.y[i] < series.y[low]) low = i;
    if (!std::isfinite(series.y[high]) || series.y[i] > series.y[high]) high = i;
  }
  const auto keep = [&](std::size_t i) {
    result.x.push_back(series.x[i]);
    result.y.push_back(series.y[i]);
  };
  keep(std::min(low, high));
  if (low != high) keep(std::max(low, high));
  if (gap && std::isfinite(result.y.back())) {
    result.x.push_back(series.x[end - 1]);
    result.y.push_back(std::nan(""));
  }
}

Series envelope(const Series& series, bool logarithmic, std::size_t most) {
  Series result{series.label, {}, {}, false};
  const auto along = [&](double x) { return logarithmic ? std::log(x) : x; };
  const double start = along(series.x.front()), span = along(series.x.back()) - start;
  const std::size_t stretches = most / 2;
  std::size_t begin = 0;
  for (std::size_t k = 1; k <= stretches; ++k) {
    const double limit = start + span * static_cast<double>(k) / static_cast<double>(stretches);
    std::size_t end = begin;
    while (end < series.x.size() && (k == stretches || along(series.x[end]) <= limit)) ++end;
    if (end > begin) append_extremes(series, begin, end, result);
    begin = end;
  }
  return result;
}

}  // namespace

Series thinned(const Series& series, bool logarithmic, std::size_t most) {
  const Series clean = cleaned(series, logarithmic);
  if (clean.x.size() <= most) return clean;
  const bool ordered = std::is_sorted(clean.x.begin(), clean.x.end());
  return ordered && !series.points ? envelope(clean, logarithmic, most) : every_nth(clean, most);
}

}  // namespace sinew::diagnosis
