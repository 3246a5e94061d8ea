// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/scene_parts.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "symbolic/dynamics/coordinates.h"

namespace sinew {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Json numbers(const Vector3d& v) {
  return {v[0], v[1], v[2]};
}

Json pose_numbers(const Transform& pose) {
  Json row = Json::array();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) row.push_back(pose.rotation(i, j));
    row.push_back(pose.translation[i]);
  }
  return row;
}

Json path_point(int frame, const Vector3d& p) {
  return {{"f", frame}, {"p", numbers(p)}};
}

SceneWriter::SceneWriter() {
  for (const char* list : {"carriers", "bodies", "bones", "joints", "tendons", "tips"})
    scene_[list] = Json::array();
}

int SceneWriter::fixed_frame(const std::string& name, int parent, const Transform& pose) {
  return moving_frames(name, parent, pose, "", {}, 0, 0);
}

int SceneWriter::moving_frames(const std::string& name, int parent, const Transform& pose,
                               const std::string& function, const std::vector<int>& arguments,
                               int count, int rows) {
  Json carrier{{"name", name}, {"parent", parent}, {"base", pose_numbers(pose)}};
  if (count > 0) {
    carrier["fn"] = function;
    carrier["args"] = arguments;
    carrier["count"] = count;
    carrier["rows"] = rows;
  }
  scene_["carriers"].push_back(std::move(carrier));
  const int number = frames_;
  frames_ += 1 + count;
  return number;
}

void SceneWriter::bone(const std::string& name, int a, const Vector3d& p, int b, const Vector3d& q,
                       const std::string& kind) {
  Json bone{{"name", name}, {"a", a}, {"p", numbers(p)}, {"b", b}, {"q", numbers(q)}};
  if (!kind.empty()) bone["kind"] = kind;
  scene_["bones"].push_back(std::move(bone));
}

void SceneWriter::tendon(std::size_t number, const std::string& name, Json path) {
  Json& tendons = scene_["tendons"];
  while (tendons.size() <= number) tendons.push_back(nullptr);
  tendons[number] = {{"name", name}, {"path", std::move(path)}};
}

void SceneWriter::tip(const std::string& name, int frame, const Vector3d& p,
                      const std::string& jacobian, const std::vector<int>& arguments, int base) {
  Json tip{{"name", name}, {"frame", frame}, {"p", numbers(p)}, {"base", base}};
  tip["fn"] = jacobian.empty() ? Json(nullptr) : Json(jacobian);
  tip["args"] = arguments;
  scene_["tips"].push_back(std::move(tip));
}

void SceneWriter::body(const Body& body, const std::string& name, int frame) {
  if (body.mass <= 0.0) return;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(body.inertia);
  const Vector3d moments = principal.eigenvalues();
  const Matrix3d axes = principal.eigenvectors();
  Vector3d half;
  // Of a box I_x = m/3 (h_y^2 + h_z^2). A rod's or an impossible body's side is drawn as next to
  // nothing, so that it is seen at all.
  for (int k = 0; k < 3; ++k)
    half[k] = std::sqrt(std::max(1.5 / body.mass * (moments.sum() - 2.0 * moments[k]), 0.0));
  half = half.cwiseMax(0.03 * half.maxCoeff());
  if (half.maxCoeff() <= 0.0) return;
  Json turn = Json::array();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) turn.push_back(axes(i, j));
  scene_["bodies"].push_back({{"name", name},
                              {"frame", frame},
                              {"centre", numbers(body.centre_of_mass)},
                              {"axes", std::move(turn)},
                              {"half", numbers(half)},
                              {"mass", body.mass}});
}

void SceneWriter::joint(const std::string& name, int frame, const Vector3d& axis, double length) {
  scene_["joints"].push_back(
      {{"name", name}, {"frame", frame}, {"axis", numbers(axis)}, {"length", length}});
}

std::vector<DrawnCoordinate> coordinates_of(const Mechanism& mechanism, const std::string& group) {
  std::vector<DrawnCoordinate> all;
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    const std::string label = joint.source_name.empty() ? joint.name : joint.source_name;
    all.push_back({group, label, "", joint.type == JointType::prismatic ? "m" : "rad", joint.low,
                   joint.high, joint.reference.value_or(0.5 * (joint.low + joint.high))});
  }
  return all;
}

void add_wrist(SceneWriter& scene, const WristParameters& wrist, int first) {
  const double b = wrist.width, c = wrist.thickness;
  const int forearm = scene.fixed_frame("forearm", -1, {});
  const int palm =
      1 + scene.moving_frames("palm", forearm, {}, "wrist_pose", {first, first + 1}, 1, 4);
  const Vector3d A0(0, b / 2, c), B0(0, 0, 0), C0(0, b, 0);
  const Vector3d A(0, 0, -c / 2), B(0, b / 2, c / 2), C(0, -b / 2, c / 2);
  scene.bone("bar A0 to A", forearm, A0, palm, A);
  scene.bone("bar B0 to B", forearm, B0, palm, B);
  scene.bone("bar C0 to C", forearm, C0, palm, C);
  for (const auto& [p, q] : {std::pair(A0, B0), std::pair(B0, C0), std::pair(C0, A0)})
    scene.bone("forearm", forearm, p, forearm, q, "frame");
  for (const auto& [p, q] : {std::pair(A, B), std::pair(B, C), std::pair(C, A)})
    scene.bone("palm", palm, p, palm, q, "frame");
}

Json wrist_path(const WristParameters& wrist, std::size_t channel) {
  constexpr double into_the_forearm = 0.03;  // m
  const Vector3d point = wrist.forearm_points.at(channel);
  Json path = Json::array();
  path.push_back(path_point(0, point - into_the_forearm * Vector3d::UnitX()));
  path.push_back(path_point(0, point));
  path.push_back(path_point(2, wrist.palm_points.at(channel)));
  return path;
}

}  // namespace sinew
