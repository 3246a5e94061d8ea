// SPDX-License-Identifier: GPL-3.0-or-later
// One mechanism of a scene, and the wrist.
#pragma once

#include <map>

#include "cli/report/scene.h"

namespace sinew {

using Json = nlohmann::ordered_json;

Json numbers(const Eigen::Vector3d& v);
Json pose_numbers(const Transform& pose);

/// A frame of the scene that others are attached to.
class SceneWriter {
 public:
  SceneWriter();

  /// A frame fixed to another (parent -1: the drawing's own).
  int fixed_frame(const std::string& name, int parent, const Transform& pose);
  /// The same, with frames behind it that a function gives: `count` poses of `rows` rows each, of
  /// the state's elements `arguments`. The number of the fixed frame.
  int moving_frames(const std::string& name, int parent, const Transform& pose,
                    const std::string& function, const std::vector<int>& arguments, int count,
                    int rows);
  void bone(const std::string& name, int a, const Eigen::Vector3d& p, int b,
            const Eigen::Vector3d& q, const std::string& kind = "");
  /// `number`: the tendon's in the force vector.
  void tendon(std::size_t number, const std::string& name, Json path);
  void tip(const std::string& name, int frame, const Eigen::Vector3d& p,
           const std::string& jacobian, const std::vector<int>& arguments, int base);
  /// A body's box of the same mass and inertia; nothing of one without mass.
  void body(const Body& body, const std::string& name, int frame);
  void joint(const std::string& name, int frame, const Eigen::Vector3d& axis, double length);

  Json take() { return std::move(scene_); }

 private:
  Json scene_;
  int frames_ = 0;
};

/// A point of a path.
Json path_point(int frame, const Eigen::Vector3d& p);

/// Where a mechanism stands in a scene.
struct MechanismPlace {
  std::string group;            ///< before its bodies' names; "" for none
  std::string poses, jacobian;  ///< names of the functions body_poses and tip_jacobian
  int parent = -1;              ///< frame that its base is fixed to
  Transform base;
  std::vector<int> arguments;          ///< its coordinates in the state
  std::vector<std::size_t> channels;   ///< number of each of its tendons
  std::map<std::size_t, Json> before;  ///< by number: the path before it reaches the mechanism
};

void add_mechanism(SceneWriter& scene, const Mechanism& mechanism, const MechanismPlace& place);

/// Forearm, palm and bars; the frames 0 (forearm) and 1 with 2 (palm). `first`: number of q71 in
/// the state.
void add_wrist(SceneWriter& scene, const WristParameters& wrist, int first);
/// A tendon through the forearm's and the palm's point.
Json wrist_path(const WristParameters& wrist, std::size_t channel);

/// Sliders of a mechanism's coordinates.
std::vector<DrawnCoordinate> coordinates_of(const Mechanism& mechanism, const std::string& group);

}  // namespace sinew
