// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "symbolic/model/rotation.h"
#include "tests/symbolic/hand/invented_hand.h"

namespace sinew_tests {
namespace {

constexpr const char* mechanism = R"([mechanism]
name = "claw"
gravity = {{ value = [1.2, -3.4, -9.1], unit = "m/s^2", from = "assumed" }}

[values]
thumb_turn = {{ value = [-40, 10, 60], unit = "deg", from = "assumed" }}
r5 = {{ value = {r5}, unit = "mm", from = "assumed" }}
r6 = {{ value = {r6}, unit = "mm", from = "assumed" }}
r4 = {{ value = {r4}, unit = "mm", from = "assumed" }}
speed = {{ value = 6, unit = "rad/s", from = "assumed" }}

[[body]]
name = "knuckle"
[[body]]
name = "proximal"
[[body]]
name = "medial"
[[body]]
name = "distal"
[[body]]
name = "thumb"
[[body]]
name = "thumb_tip"
[[body]]
name = "link"

[[joint]]
name = "q1"
type = "revolute"
parent = "base"
child = "knuckle"
origin.xyz = {{ value = [70, 20, 3], unit = "mm", from = "assumed" }}
axis = [0, 0, 1]
range = {{ value = [-0.4, 0.4], unit = "rad", from = "assumed" }}
max_velocity = "speed"

[[joint]]
name = "q2"
type = "revolute"
parent = "knuckle"
child = "proximal"
origin.xyz = {{ value = [8, 0, 1], unit = "mm", from = "assumed" }}
origin.rpy = {{ value = [90, 0, 5], unit = "deg", from = "assumed" }}
axis = [0, 0, 1]
range = {{ value = [-0.2, 1.3], unit = "rad", from = "assumed" }}
max_velocity = "speed"

[[joint]]
name = "q3"
type = "revolute"
parent = "proximal"
child = "medial"
origin.xyz = {{ value = [{proximal}, 0, 2], unit = "mm", from = "assumed" }}
axis = [0, 0, 1]
range = {{ value = [-0.2, 1.3], unit = "rad", from = "assumed" }}
max_velocity = "speed"

[[joint]]
name = "q4"
type = "revolute"
parent = "medial"
child = "distal"
origin.xyz = {{ value = [30, 0, -4], unit = "mm", from = "assumed" }}
axis = [0, 0, 1]
range = {{ value = [-2, 2], unit = "rad", from = "assumed" }}

[[joint]]
name = "q5"
type = "revolute"
parent = "base"
child = "thumb"
origin.xyz = {{ value = [30, -40, 10], unit = "mm", from = "assumed" }}
origin.rpy = "thumb_turn"
axis = [0, 0, 1]
range = {{ value = [-0.5, 0.7], unit = "rad", from = "assumed" }}
max_velocity = "speed"

[[joint]]
name = "q6"
type = "revolute"
parent = "thumb"
child = "thumb_tip"
origin.xyz = {{ value = [{thumb}, 0, 0], unit = "mm", from = "assumed" }}
origin.rpy = {{ value = [0, 30, 0], unit = "deg", from = "assumed" }}
axis = [0, 1, 0]
range = {{ value = [-2, 2], unit = "rad", from = "assumed" }}

[[joint]]
name = "q7"
type = "revolute"
parent = "base"
child = "link"
origin.xyz = {{ value = [{link_x:.17g}, {link_y:.17g}, {link_z:.17g}], unit = "m", from = "assumed" }}
origin.rpy = "thumb_turn"
axis = [0, 0, 1]
range = {{ value = [-2, 2], unit = "rad", from = "assumed" }}

[[frame]]
name = "tip"
body = "distal"
pose.xyz = {{ value = [20, 1, -1], unit = "mm", from = "assumed" }}

[[coupling]]
dependent = "q6"
independent = "q5"
independent_radius = "r5"
dependent_radius = "-r6"
offset = {{ value = -14, unit = "deg", from = "assumed" }}

[[four_bar]]
dependent = "q4"
independent = "q3"
ground = {{ value = {g1}, unit = "mm", from = "assumed" }}
crank = {{ value = 30, unit = "mm", from = "assumed" }}
coupler = {{ value = {b1}, unit = "mm", from = "assumed" }}
rocker = {{ value = 30.5, unit = "mm", from = "assumed" }}
branch = "{branch}"
follows = "coupler"
crank_angle = {{ value = {crank1}, unit = "rad", from = "assumed" }}

[[four_bar]]
dependent = "q7"
independent = "q5"
ground = {{ value = 20, unit = "mm", from = "assumed" }}
crank = {{ value = {a2}, unit = "mm", from = "assumed" }}
coupler = {{ value = 20, unit = "mm", from = "assumed" }}
rocker = {{ value = 15, unit = "mm", from = "assumed" }}
branch = "open"
crank_angle = {{ value = 1.4, unit = "rad", from = "assumed" }}

[[tendon]]
name = "t1"
h0 = {{ value = 3, unit = "mm", from = "assumed" }}
pulleys = [{{ joint = "q1", radius = "r5" }}, {{ joint = "q2", radius = "r6" }}]
[[tendon]]
name = "t2"
pulleys = [{{ joint = "q1", radius = "-r5" }}, {{ joint = "q2", radius = "r6" }}]
[[tendon]]
name = "t3"
pulleys = [{{ joint = "q3", radius = "r4" }}, {{ joint = "q4", radius = "-r6" }}]
[[tendon]]
name = "t4"
straights = [{{ from_body = "base", from_point = {{ value = [5, 25, 12], unit = "mm", from = "assumed" }}, to_body = "proximal", to_point = {{ value = [15, 6, 4], unit = "mm", from = "assumed" }} }}]
[[tendon]]
name = "t5"
pulleys = [{{ joint = "q6", radius = "r4" }}]
straights = [{{ from_body = "medial", from_point = {{ value = [12, -5, 0], unit = "mm", from = "assumed" }}, to_body = "thumb_tip", to_point = {{ value = [9, 2, 5], unit = "mm", from = "assumed" }} }}]
[[tendon]]
name = "t6"
pulleys = [{{ joint = "q7", radius = "r6" }}, {{ joint = "q5", radius = "-r4" }}]
[[tendon]]
name = "t7"
straights = [
  {{ from_body = "link", from_point = {{ value = [10, 3, 1], unit = "mm", from = "assumed" }}, to_body = "thumb", to_point = {{ value = [11, 14, 7], unit = "mm", from = "assumed" }} }},
  {{ from_body = "thumb", from_point = {{ value = [11, 14, 7], unit = "mm", from = "assumed" }}, to_body = "distal", to_point = {{ value = [8, -4, 0], unit = "mm", from = "assumed" }} }},
]
)";

/// A solid body somewhere about its joint.
std::string mass_row(const char* body, std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double m = between(2, 9), a = between(5, 9), b = between(8, 20), c = between(10, 25);
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", body, m, between(5, 20), between(-3, 3),
                     between(-3, 3), m * (b * b + c * c) / 12, m * (a * a + c * c) / 12,
                     m * (a * a + b * b) / 12, 0.01 * m * a * b, -0.02 * m * a * c,
                     0.015 * m * a * b);
}

}  // namespace

InventedHand invented_hand(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  using sinew::rotation_from_rpy;
  const double degree = std::acos(-1.0) / 180;
  const Eigen::Vector3d link =
      Eigen::Vector3d(0.03, -0.04, 0.01) +
      rotation_from_rpy(Eigen::Vector3d(-40, 10, 60) * degree) * Eigen::Vector3d(0.020, 0, 0.004);
  InventedHand hand;
  hand.toml = fmt::format(mechanism, fmt::arg("r4", between(3, 7)), fmt::arg("r5", between(3, 7)),
                          fmt::arg("r6", between(3, 7)), fmt::arg("proximal", between(30, 50)),
                          fmt::arg("thumb", between(30, 50)), fmt::arg("link_x", link.x()),
                          fmt::arg("link_y", link.y()), fmt::arg("link_z", link.z()),
                          fmt::arg("g1", between(7.8, 8.2)), fmt::arg("b1", between(6.9, 7.1)),
                          fmt::arg("branch", random() % 2 ? "open" : "crossed"),
                          fmt::arg("crank1", between(1.18, 1.22)), fmt::arg("a2", between(11, 13)));
  hand.csv =
      "link,mass [g],com_x [mm],com_y [mm],com_z [mm],ixx [g*mm^2],iyy [g*mm^2],izz [g*mm^2],"
      "ixy [g*mm^2],ixz [g*mm^2],iyz [g*mm^2]\n";
  for (const char* body : {"knuckle", "proximal", "medial", "distal", "thumb", "thumb_tip", "link"})
    hand.csv += mass_row(body, random);
  return hand;
}

}  // namespace sinew_tests
