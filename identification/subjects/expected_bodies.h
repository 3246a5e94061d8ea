// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a robot's bodies before any log.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/regression/candidate.h"
#include "symbolic/model/mechanism.h"

namespace sinew::diagnosis {

/// Of a body's ten parameters, those without moments of inertia.
inline constexpr int kMassAndFirstMoments = 4;

/// A body's mass is known to be within `mass` [kg], and its moments those of as much mass about
/// `radius` [m] from the origin. `parameters`: mass, first moments, moments of inertia.
void expect(double mass, double radius, std::vector<LinearParameter>& parameters);

/// A body's mass is unknown; its moments are those of as much mass about `radius` [m] from the
/// origin.
void expect_about(double radius, std::vector<LinearParameter>& parameters);

/// How far from its frame's origin a body's mass is [m], as a root of the mean square.
double radius_of(const Body& body);

/// What a change of a link's mass [kg] and of its first moments [kg m] makes of its moments of
/// inertia about its frame's origin [kg m^2] where it keeps its shape about its centre: to first
/// order, as the model is extended by it (symbolic/extension). 6 x 4.
Eigen::MatrixXd moments_as_drawn(const Body& link);

struct MovingBody {
  std::size_t body = 0;  ///< index of the mechanism's bodies
  bool leaf = true;      ///< carries no further one
};

/// All that some joint moves.
std::vector<MovingBody> moving_bodies(const Mechanism& mechanism);

/// kg.
double moving_mass(const Mechanism& mechanism);

/// Twice what the links can reach [m]: no mass of theirs is farther from its frame.
double reach_of(const Mechanism& mechanism);

}  // namespace sinew::diagnosis
