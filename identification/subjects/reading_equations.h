// SPDX-License-Identifier: GPL-3.0-or-later
// How likely measured efforts are beside what a model says of them, with all that the machine may
// have otherwise than its drawing.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace sinew::diagnosis {

/// Something that the machine may have otherwise: how much of it is expected, in its own unit.
struct Unknown {
  enum class Kind {
    share,  ///< of what a drawing says, with tails as long as Cauchy's: a load that nobody noted;
            ///< half as much is as likely as twice as much, and nothing turns its sign
    drawn,  ///< beside what a drawing says, either way, with the same tails
    fixed,  ///< what a drawing says and no use of the machine changes (Gauss)
    added   ///< what a drawing may lack altogether, and never has too much of
  };
  Kind kind = Kind::drawn;
  double spread = 1.0;  ///< infinity: any size is as likely
};

/// One measured effort: what is measured and what the model says of it (samples), and what an
/// unknown makes of it for each unit.
struct EffortEquation {
  Eigen::VectorXd measured, said;
  double stretches = 0.0;  ///< of time that these samples cover, see evidence_of_share()
  struct Term {
    int unknown = 0;
    Eigen::VectorXd column;
  };
  std::vector<Term> terms;
};

struct Explained {
  double log_likelihood = 0.0;  ///< with the probability of the unknowns
  std::vector<double> left;     ///< of each effort's variance; one that never changes: nothing
};

/// With the likeliest values of the unknowns. Minus infinity, and all left, where something is not
/// finite.
Explained explained_by(const std::vector<EffortEquation>& equations,
                       const std::vector<Unknown>& unknowns);

}  // namespace sinew::diagnosis
