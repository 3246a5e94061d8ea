// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/tendon_motion.h"

#include "symbolic/expressions/inline_function.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/tendons/tendon_bending.h"
#include "symbolic/tendons/tendons.h"

namespace sinew {

using GiNaC::ex;

Function tendon_motion_function(const Mechanism& mechanism) {
  const Argument q = joint_positions(mechanism), qd = joint_velocities(mechanism);
  const std::size_t m = mechanism.tendons.size(), n = q.symbols.size();
  DefinitionList list;
  const JointTree tree = build_joint_tree(mechanism);
  const std::vector<ex> P =
      coupling_matrix(list, tendon_lengths(list, mechanism, tree, q.symbols), q.symbols);
  std::vector<ex> rate(m, 0);
  for (std::size_t t = 0; t < m; ++t)
    for (std::size_t j = 0; j < n; ++j) rate[t] += P[t * n + j] * qd.symbols[j];
  const std::vector<ex> bending =
      inlined(list, tendon_bending_angles(mechanism), {q.symbols.begin(), q.symbols.end()}).front();
  const int rows = static_cast<int>(m);
  return {"tendon_motion",
          "Moment arms of the tendons, the rate of their lengths and how far they are bent.",
          "(5.9)",
          {q, qd},
          list.items(),
          {{"P", rows, q.rows, P, "m/" + q.unit, "coupling matrix"},
           {"rate", rows, 1, rate, "m/s", "of the path lengths"},
           {"bending", rows, 1, bending, "rad", "as bending_angles gives it"}}};
}

}  // namespace sinew
