// SPDX-License-Identifier: GPL-3.0-or-later
// What a mechanism can be and hardly ever is: slips of units, of signs and of exporters that every
// other check lets pass. Each threshold is far from what is built, so that nothing built is
// suspected.
#pragma once

#include <string>
#include <vector>

#include "symbolic/files/source_location.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// Something that is possible and not plausible.
struct Suspicion {
  SourceLocation where;
  std::string text;  ///< what is seen; why it is not plausible; what to look at
};

/// "file:line:column: text", as mistakes are reported.
std::string to_text(const Suspicion& suspicion);

namespace plausible {

/// m. Links of the largest industrial arms are 2 m long, those of hands below 0.1 m; 40 m is 40 mm
/// written in metres.
inline constexpr double longest_link = 3.0;
/// m. Drums of cable-driven arms have radii below 0.1 m, pulleys of hands below 0.02 m.
inline constexpr double largest_pulley = 0.25;
/// kg/m^3. Osmium, the densest material there is, has 22 600. Of all bodies with given mass and
/// moments of inertia the uniform ellipsoid is the least dense at its densest point.
inline constexpr double densest = 23.0e3;
/// A body's radius of gyration over the length of all links together: a body lies within the
/// mechanism, give or take. The unit above (kg cm^2 for kg mm^2) makes the radius 10 times as
/// large.
inline constexpr double widest_gyration = 5.0;
/// kg. What exporters and templates write where no mass was set; a robot of several links that
/// weigh just this is none.
inline constexpr double default_mass = 1.0;
/// Turning the signs of the products of inertia brings a body's joints so much nearer to its mass
/// (squared distances, in standard deviations of the mass along its principal axes) ...
inline constexpr double sign_evidence = 2.0;
/// ... while with the signs given they are so far from it. On the surface of a uniform ellipsoid
/// it is 5; joints are at most a little outside of their bodies.
inline constexpr double far_from_mass = 12.0;

}  // namespace plausible

/// Lengths, masses and inertias that are not plausible, at most one a kind, with the bodies that
/// show it and the place of the first.
std::vector<Suspicion> implausible_bodies(const Mechanism& mechanism);

}  // namespace sinew
