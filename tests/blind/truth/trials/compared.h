// SPDX-License-Identifier: GPL-3.0-or-later
// How large a cause is: what it adds to the compared channels behind the filter that
// `sinew diagnose` documents, beside what the program fits in any case, in units of the noise
// behind the same filter.
#pragma once

#include <vector>

#include "tests/blind/truth/trials/hidden.h"

namespace sinew::trials {

/// Symmetric windowed sinc (Kaiser, 60 dB), flat up to `band`, stopped from 1.5 times that on,
/// every sample of 2.5 times the band kept: docs/findings.md and the filter's own header say so.
class ComparedFilter {
 public:
  ComparedFilter(double step, double band);
  VectorXd operator()(const VectorXd& x) const;
  /// 1 where a whole window of `moving` (1 or 0) lies in motion.
  VectorXd mask(const VectorXd& moving) const;
  double band() const { return band_; }

 private:
  double band_;
  Index half_, every_;
  VectorXd kernel_;
};

/// The band of a log of that step: 60 Hz, a tenth of the rate at most.
double documented_band(double step);

struct Channel {
  VectorXd added;     ///< with the cause less without it, same motion
  VectorXd noise;     ///< measured less perfect, nothing hidden
  VectorXd moving;    ///< 1 where it counts, 0 at rest
  MatrixXd fitted;    ///< columns of what is always fitted; may have none
  double band = 0.0;  ///< Hz
};

struct Size {
  double excess = 0.0;  ///< beside what is always fitted
  double plain = 0.0;   ///< the same without projection
  int channel = -1;     ///< where excess is largest: the size is that channel's
};

Size size_of(const std::vector<Channel>& channels, double step);

/// Position, velocity and acceleration of a logged position behind a smoother that passes what is
/// below `cutoff` Hz.
struct Smoothed {
  VectorXd q, v, a;
};
Smoothed smoothed(const VectorXd& q, double step, double cutoff);

double rms(const VectorXd& x);

}  // namespace sinew::trials
