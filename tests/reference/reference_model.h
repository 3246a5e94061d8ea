// SPDX-License-Identifier: GPL-3.0-or-later
// The reference behind the emitted functions' names, so that both take the same inputs.
#pragma once

#include <string>
#include <vector>

#include "tests/reference/newton_euler.h"
#include "tests/reference/tendon_paths.h"

namespace sinew::reference {

/// Every input an emitted function may take, at one state.
struct State {
  Eigen::VectorXd q, qd, qdd;  ///< n values each
  Eigen::VectorXd tau;         ///< n, the torques that give about qdd
  Eigen::VectorXd f, kt, h;    ///< m tendon forces, stiffnesses, lengths (measured: not quite h(q))
};

/// Names (without prefix) of the functions offered for every mechanism of this kind: the dynamics,
/// the tip's where it has a frame, the tendons' where it has tendons, link_position where besides
/// all radii are constant and reach every joint.
std::vector<std::string> offered_functions(const Mechanism& mechanism);

/// The inputs of a function, one after the other. Throws std::out_of_range for an unknown name.
std::vector<double> inputs_of(const std::string& function, const State& state);

/// Seeded states over the mechanism's ranges, chosen as sample_box does.
std::vector<State> sample_states(const Mechanism& mechanism, int count, std::uint64_t seed);

template <class Scalar>
class ReferenceModel {
 public:
  explicit ReferenceModel(const Mechanism& mechanism) : dynamics(mechanism), tendons(mechanism) {}

  /// The results of an emitted function, row-major. Throws std::out_of_range for an unknown name.
  VectorX<Scalar> evaluate(const std::string& function, const State& state) const;

  NewtonEuler<Scalar> dynamics;
  TendonPaths<Scalar> tendons;
};

}  // namespace sinew::reference
