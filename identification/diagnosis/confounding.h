// SPDX-License-Identifier: GPL-3.0-or-later
// Which candidates these logs cannot tell apart.
#pragma once

#include <string>
#include <vector>

#include "identification/diagnosis/select.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// Of two groups of columns beside a model's.
class CanonicalCorrelation {
 public:
  /// Keeps a reference to the weights.
  CanonicalCorrelation(const Model& model, const Weights& weights);

  /// The largest one in the weighted band, the model's columns projected out: 1 where one group can
  /// stand in for the other.
  double largest(const BandColumns& a, const BandColumns& b) const;

 private:
  const Weights& weights_;
  Stack stacked_;
  Eigen::MatrixXd inverse_;
};

/// Share of a cause's own statistic by which another one may be behind and still be the right one:
/// no model is perfect.
inline constexpr double kByImperfection = 0.04;

/// The cause in term `term` and every candidate that explains its part about as well, best first.
/// A rival belongs to the set where its deviance is behind by less than chance and the model's own
/// imperfection allow, or where the paired block differences do not speak against it.
struct Rivals {
  std::vector<RankedCause> members;
  double margin = 0.0;  ///< how far behind the best candidate outside the set is, deviance
  Model model;          ///< with the first member in the term's place
};
Rivals find_rivals(const Design& design, const Library& library, const Settings& settings,
                   const Selection& state, std::size_t term);

}  // namespace sinew::diagnosis
