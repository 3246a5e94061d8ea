// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/scene.h"

#include <numeric>

#include "cli/report/scene_parts.h"
#include "symbolic/dynamics/body_poses.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/parts/four_bar.h"
#include "symbolic/tendons/functions.h"

namespace sinew {
namespace {

using Eigen::Vector3d;

Function named(Function function, const std::string& name) {
  function.name = name;
  return function;
}

std::vector<int> counted_from(int first, int count) {
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), first);
  return all;
}

/// The palm's angles, of which the bars' follow.
std::vector<DrawnCoordinate> palm_coordinates(const WristParameters& wrist) {
  return {{"Palm", "flexion", "q71", "rad", wrist.flexion.low, wrist.flexion.high, 0.0},
          {"Palm", "abduction", "q73", "rad", wrist.abduction.low, wrist.abduction.high, 0.0}};
}

std::vector<Function> palm_functions(const WristParameters& wrist) {
  return {named(wrist_pose(wrist), "wrist_pose"),
          named(wrist_bar_angles(wrist), "wrist_bar_angles"),
          named(wrist_palm_angles(wrist), "wrist_palm_angles")};
}

/// Sliders, bodies and functions of a hand's fingers; `first` coordinate of the next one.
void add_finger(DrawnScene& drawn, SceneWriter& scene, const Hand& hand, const HandFinger& finger,
                int parent) {
  const Mechanism& mechanism = finger.mechanism;
  const int first = static_cast<int>(drawn.coordinates.size());
  MechanismPlace place;
  place.group = mechanism.name;
  place.poses = mechanism.name + "_body_poses";
  place.jacobian = mechanism.name + "_tip_jacobian";
  place.parent = parent;
  place.base = finger.base;
  place.arguments = counted_from(first, Coordinates(mechanism).count());
  for (const int channel : finger.channels) {
    place.channels.push_back(static_cast<std::size_t>(channel));
    place.before[place.channels.back()] = wrist_path(hand.wrist, place.channels.back());
  }
  add_mechanism(scene, mechanism, place);
  scene.bone("palm", parent, Vector3d::Zero(), parent, finger.base.translation, "palm");
  for (DrawnCoordinate& each : coordinates_of(mechanism, mechanism.name))
    drawn.coordinates.push_back(std::move(each));
  drawn.functions.push_back(named(body_poses_function(mechanism), place.poses));
  drawn.functions.push_back(named(kinematics_functions(mechanism)[1], place.jacobian));
}

int finger_coordinates(const Hand& hand) {
  int count = 0;
  for (const HandFinger& finger : hand.fingers) count += Coordinates(finger.mechanism).count();
  return count;
}

/// The linkage; its coupler's frame.
int add_four_bar(DrawnScene& drawn, SceneWriter& scene, const Hand& hand, int crank) {
  const FourBarParameters& bars = hand.four_bar;
  const std::string pose = hand.four_bar_name + "_coupler_pose";
  const int ground =
      scene.moving_frames(hand.four_bar_name, 2, hand.four_bar_base, pose, {crank}, 1, 4);
  const int coupler = ground + 1;
  const Vector3d end(bars.coupler, 0, 0), pivot(bars.ground, 0, 0), none = Vector3d::Zero();
  scene.bone("palm", 2, none, 2, hand.four_bar_base.translation, "palm");
  scene.bone(hand.four_bar_name + " ground", ground, none, ground, pivot, "frame");
  scene.bone(hand.four_bar_name + " crank", ground, none, coupler, none);
  scene.bone(hand.four_bar_name + " coupler", coupler, none, coupler, end);
  scene.bone(hand.four_bar_name + " rocker", coupler, end, ground, pivot);
  for (std::size_t i = 0; i < hand.four_bar_channels.size(); ++i) {
    const auto channel = static_cast<std::size_t>(hand.four_bar_channels[i]);
    Json path = wrist_path(hand.wrist, channel);
    path.push_back(
        path_point(ground, Vector3d(0, i ? -bars.pulley_radius : bars.pulley_radius, 0)));
    scene.tendon(channel, hand.four_bar_name + " " + std::to_string(i + 1), std::move(path));
  }
  drawn.functions.push_back(named(four_bar_coupler_pose(bars), pose));
  return coupler;
}

}  // namespace

DrawnScene scene_of(const Mechanism& mechanism, const std::string& tip_jacobian) {
  DrawnScene drawn;
  SceneWriter scene;
  MechanismPlace place;
  place.poses = "body_poses";
  place.jacobian = tip_jacobian;
  place.arguments = counted_from(0, Coordinates(mechanism).count());
  add_mechanism(scene, mechanism, place);
  drawn.coordinates = coordinates_of(mechanism, "");
  drawn.functions = {body_poses_function(mechanism)};
  drawn.scene = scene.take();
  return drawn;
}

DrawnScene scene_of(const WristParameters& wrist) {
  DrawnScene drawn;
  SceneWriter scene;
  add_wrist(scene, wrist, 0);
  for (std::size_t i = 0; i < wrist.forearm_points.size(); ++i) {
    Json path = wrist_path(wrist, i);
    path.push_back(path_point(2, wrist.palm_points[i] + Vector3d(0.02, 0, 0)));
    scene.tendon(i, std::to_string(i + 1), std::move(path));
  }
  scene.tip("palm", 2, Vector3d::Zero(), "", {0, 1}, 0);
  drawn.coordinates = palm_coordinates(wrist);
  drawn.functions = palm_functions(wrist);
  drawn.palm = {0, 1};
  drawn.scene = scene.take();
  return drawn;
}

DrawnScene scene_of(const Hand& hand) {
  DrawnScene drawn;
  SceneWriter scene;
  const int count = finger_coordinates(hand), q71 = count + (hand.has_four_bar() ? 1 : 0);
  add_wrist(scene, hand.wrist, q71);
  const int coupler = hand.has_four_bar() ? add_four_bar(drawn, scene, hand, count) : 2;
  for (const HandFinger& finger : hand.fingers)
    add_finger(drawn, scene, hand, finger, finger.on_coupler ? coupler : 2);
  if (hand.has_four_bar())
    drawn.coordinates.push_back({hand.four_bar_name, "theta2", "", "rad", hand.four_bar.theta2.low,
                                 hand.four_bar.theta2.high, hand.four_bar.reference_theta2});
  for (DrawnCoordinate& each : palm_coordinates(hand.wrist))
    drawn.coordinates.push_back(std::move(each));
  for (Function& each : palm_functions(hand.wrist)) drawn.functions.push_back(std::move(each));
  drawn.palm = {q71, q71 + 1};
  drawn.yaw = -1.35;
  drawn.pitch = 0.85;
  drawn.scene = scene.take();
  return drawn;
}

}  // namespace sinew
