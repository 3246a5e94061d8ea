// SPDX-License-Identifier: GPL-3.0-or-later
// Links that turn about parallel axes, written in one frame {P} that is fixed in their carrier.
//
// A point r of link k (in {P}, z along the axes) has the acceleration
//
//   a_P + U' r + 2 w' x dr + ddr,
//
// where w' = (w_x, w_y, 0) and U' belong to {P} relieved of its turning about z, which the links'
// absolute rates w_k take in. The links move in planes, so every integral over the run's masses is
// one of a few composites, gathered from the last link to the first:
//
//   S_k = integral over k and beyond of (r - o_k) dm,   K_k = integral of (r - o_k) r^T dm
//
// and the carrier's rates multiply these once per joint. Base parameters leave no mass, no first
// moment along z and no J(z,z) in any of these links.
#pragma once

#include <array>
#include <vector>

#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/link_motion.h"
#include "symbolic/dynamics/run_geometry.h"

namespace sinew {

/// A run in motion.
class ParallelRun {
 public:
  /// `base`: motion of {P}. `qd`, `qdd`: rates of the tree's coordinates.
  ParallelRun(DefinitionList& list, const JointTree& tree, std::vector<RunLink> geometry,
              bool pair_by_pair, Motion base, const std::vector<GiNaC::ex>& qd,
              const std::vector<GiNaC::ex>& qdd);

  /// Motion of a link of the run in its own axes, for links that carry further runs.
  Motion link_motion(int index) const;

  /// Joint torques into `tau` (by coordinate) and the wrench on the carrier in {P}, given the
  /// wrenches that further runs put on each link (in the link's axes; zero where there are none).
  Wrench close(const std::vector<Wrench>& external, std::vector<GiNaC::ex>& tau) const;

 private:
  struct Rates {
    GiNaC::ex w, alpha, rate;  ///< absolute rate and acceleration about z; rate against the parent
    std::array<GiNaC::ex, 2> e;  ///< second derivative of the link's x axis is (-e[0], e[1])
    std::array<GiNaC::ex, 2> a;  ///< acceleration of the origin by a_P and the run's own motion
  };
  struct Planar {
    std::vector<GiNaC::ex> torque;  ///< about each link's origin, from the run's own motion
    std::array<GiNaC::ex, 2> force;
  };

  std::array<GiNaC::ex, 2> second_derivative(int index, const GiNaC::ex& x,
                                             const GiNaC::ex& y) const;
  void set_rates(const std::vector<GiNaC::ex>& qd, const std::vector<GiNaC::ex>& qdd);
  /// Acceleration of the first axis by the carrier's turning about z, in the plane.
  std::array<GiNaC::ex, 2> root_acceleration() const;
  Planar planar_dynamics(const std::vector<Wrench>& external_in_P) const;
  /// Torques on the single links by pairs: link i's arm l towards link j and j's first moment s
  /// have the energy w_i w_j l.s, hence alpha_j l.s - w_j^2 l x s on i, alpha_i l.s + w_i^2 l x s
  /// on j.
  std::vector<GiNaC::ex> pair_torques(const std::vector<Wrench>& external_in_P) const;
  std::vector<GiNaC::ex> chained_torques(const std::vector<std::array<GiNaC::ex, 2>>& force,
                                         const std::vector<Wrench>& external_in_P) const;
  GiNaC::ex carrier_torque(int index) const;
  /// K and S of the whole run about {P}'s origin.
  RunLink whole_about_origin() const;
  Wrench carrier_wrench(const Planar& planar) const;
  GiNaC::ex J(int index, int row, int col) const;
  GiNaC::ex own_inertia(std::size_t index) const;
  GiNaC::ex square(std::size_t index) const;
  std::string tag(int index) const;

  DefinitionList& list_;
  const JointTree& tree_;
  std::vector<RunLink> links_;
  bool pair_by_pair_;
  Motion base_;
  std::vector<Rates> rates_;
};

}  // namespace sinew
