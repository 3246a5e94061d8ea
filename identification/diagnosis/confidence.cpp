// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/confidence.h"

#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {

double confidence_of(const ConfidenceEvidence& evidence) {
  constexpr double kOffset = 0.2, kMargin = 1.1, kLeftOver = -3.0;
  const double margin = std::min(std::max(evidence.margin, 0.0), 1e6);
  const double logit =
      kOffset + kMargin * std::log1p(margin / 4.0) + kLeftOver * evidence.left_over;
  return kHighestConfidence * (1.0 - evidence.p_family) / (1.0 + std::exp(-logit));
}

}  // namespace sinew::diagnosis
