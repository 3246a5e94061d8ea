// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/confidence.h"

#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {

double confidence_of(double margin, double by_chance) {
  constexpr double kOffset = 0.2, kMargin = 1.1;
  const double logit = kOffset + kMargin * std::log1p(std::clamp(margin, 0.0, 1e6) / 4.0);
  return kHighestConfidence * (1.0 - by_chance) / (1.0 + std::exp(-logit));
}

}  // namespace sinew::diagnosis
