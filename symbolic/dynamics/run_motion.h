// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "symbolic/dynamics/inner_motion.h"
#include "symbolic/dynamics/run_geometry.h"

namespace sinew {

/// How one link of a run of parallel axes moves in the run's frame {P} relieved of its turning
/// about z, and sums over the masses beyond the link's joint: r and its rate dr from the joint's
/// origin.
struct RunLinkMotion {
  GiNaC::ex w;                   ///< rate of the link about z, rad/s
  std::array<GiNaC::ex, 2> v;    ///< velocity of the joint's origin, m/s
  std::array<GiNaC::ex, 2> G;    ///< integral of (-dy, dx) dm
  GiNaC::ex Y;                   ///< integral of x dx + y dy: half the rate of the moment about z
  std::array<GiNaC::ex, 2> T;    ///< integral of -z (dx, dy) dm
  std::array<GiNaC::ex, 2> Q_z;  ///< integral of (x, y) dz dm
  GiNaC::ex p_z;                 ///< integral of dz dm
};

/// `carried`: inner motion that other runs give each link, in the link's axes; `w_z`: {P}'s own
/// turning about z; `qd`: rates of the run's joints against their parents, about +z.
std::vector<RunLinkMotion> run_motion(DefinitionList& list, const std::vector<RunLink>& links,
                                      const std::vector<InnerMotion>& carried, const GiNaC::ex& w_z,
                                      const std::vector<GiNaC::ex>& qd);

/// Inner motion of the whole run in {P}.
InnerMotion whole_motion(DefinitionList& list, const std::vector<RunLink>& links,
                         const std::vector<InnerMotion>& carried, const std::vector<GiNaC::ex>& qd);

}  // namespace sinew
