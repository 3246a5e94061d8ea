// SPDX-License-Identifier: GPL-3.0-or-later
// How large a cause is: what it adds to the compared channels behind the filter that
// `sinew diagnose` documents, beside what the program fits in any case, in units of the noise
// behind the same filter.
#pragma once

#include <vector>

#include "tests/blind/truth/hidden.h"

namespace sinew::trials {

/// Symmetric windowed sinc (Kaiser, 60 dB), of which as few samples are kept as the band allows:
/// flat to 0.4 of their rate, stopped from 0.6 on, as docs/diagnosis_rules.md states.
class ComparedFilter {
 public:
  ComparedFilter(double step, double band);
  VectorXd operator()(const VectorXd& x) const;
  /// The samples on which what is kept is centred.
  VectorXd at_instants(const VectorXd& x) const;
  /// Of kept samples what is compared: their spectrum up to the band, as real numbers.
  VectorXd in_band(const VectorXd& kept) const;
  /// What the kept samples count for at the ends.
  VectorXd ends(const VectorXd& x) const;
  double band() const { return band_; }

 private:
  Index kept(const VectorXd& x) const;
  double band_, step_;
  Index every_, half_, edge_;
  VectorXd kernel_;
};

/// The band of a log of that step: 60 Hz, a tenth of the rate at most.
double documented_band(double step);
/// The same of a rig, whose readings are compared as they are.
double rig_band(double step);

struct Channel {
  VectorXd added;     ///< with the cause less without it, same motion
  VectorXd noise;     ///< measured less perfect, nothing hidden
  VectorXd moving;    ///< how much it counts: 1 in motion, 0 at rest
  MatrixXd fitted;    ///< columns of what is always fitted; may have none
  double band = 0.0;  ///< Hz
};

struct Size {
  double excess = 0.0;  ///< beside what is always fitted
  double plain = 0.0;   ///< the same without projection
  int channel = -1;     ///< where excess is largest: the size is that channel's
  double nats = 0.0;    ///< log likelihood ratio of the excess, of all channels, to an observer who
                        ///< knows it and the noise's spectrum
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
