// SPDX-License-Identifier: GPL-3.0-or-later
// Where the links of a run of parallel axes are in the run's frame {P}, and the integrals over
// their masses that every equation of the run is made of.
#pragma once

#include <array>
#include <vector>

#include "symbolic/dynamics/composite_inertia.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/runs.h"
#include "symbolic/dynamics/spatial.h"

namespace sinew {

/// One link of a run, in {P}; "beyond" includes the link itself.
struct RunLink {
  int link = 0;     ///< index in the tree
  int parent = -1;  ///< index in the run; -1 for the root
  CosSin angle;
  std::array<GiNaC::ex, 2> o;  ///< origin
  std::array<GiNaC::ex, 2> l;  ///< origin less the parent's origin
  PseudoInertia own;           ///< the link's own pseudo-inertia about its origin, {P} axes
  GiNaC::ex m;                 ///< mass beyond
  Vector3ex S;                 ///< integral beyond of (r - o) dm
  std::array<std::array<GiNaC::ex, 3>, 2> K;  ///< integral beyond of (r - o)_i r_j dm, i in x..y
  GiNaC::ex zz;                               ///< integral beyond of z^2 dm
  GiNaC::ex Z;  ///< integral beyond of |r - o|^2 in the plane: inertia about the axis
};

/// Positions and composites of a run. `inertias`: pseudo-inertia of each of its links about the
/// link's origin and in its axes.
std::vector<RunLink> run_geometry(DefinitionList& list, const JointTree& tree, const Run& run,
                                  const std::vector<CosSin>& angles,
                                  const std::vector<PseudoInertia>& inertias);

}  // namespace sinew
