// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/wrist.h"

#include <cmath>
#include <tuple>

#include "symbolic/expressions/piecewise.h"
#include "symbolic/parts/wrist_geometry.h"

namespace sinew {

using GiNaC::ex;

double reference_q71(const WristParameters& parameters) {
  return std::atan2(parameters.thickness, parameters.length);
}

double reference_q73(const WristParameters& parameters) {
  return std::atan2(std::hypot(parameters.length, parameters.thickness), parameters.width);
}

std::vector<double> rounded_reference(const WristParameters& parameters) {
  const auto rounded = [](double angle) { return std::round(angle * 1e6) / 1e6; };
  return {rounded(reference_q71(parameters)), rounded(reference_q73(parameters))};
}

Function wrist_pose(const WristParameters& parameters) {
  const WristStart start(parameters);
  const auto& [x, y, z, p] = std::tie(start.pose.x, start.pose.y, start.pose.z, start.pose.origin);
  std::vector<ex> T;
  for (std::size_t i = 0; i < 3; ++i) T.insert(T.end(), {x[i], y[i], z[i], p[i]});
  T.insert(T.end(), {0, 0, 0, 1});
  return start.finish("pose", "(6.8)", "Pose of the palm: maps {ABC} to the forearm frame.",
                      {{"T", 4, 4, T, "1 and m", "homogeneous transform"}});
}

Function wrist_points(const WristParameters& parameters) {
  const WristStart start(parameters);
  std::vector<ex> rows;
  for (const Vector3& point : {start.pose.A, start.pose.B, start.pose.C})
    rows.insert(rows.end(), point.begin(), point.end());
  return start.finish("points", "(6.4), (6.5)", "The palm's points A, B, C in the forearm frame.",
                      {{"ABC", 3, 3, rows, "m", "rows A, B, C"}});
}

Function wrist_palm_angles(const WristParameters& parameters) {
  const WristStart start(parameters);
  const Vector3& x = start.pose.x;
  return start.finish("palm_angles", "", "Direction of the palm from the bar angles.",
                      {{"angles",
                        2,
                        1,
                        {GiNaC::atan2(x[2], x[0]), GiNaC::asin(clamped(x[1], -1, 1))},
                        "rad",
                        "flexion, abduction"}});
}

Function wrist_singularity(const WristParameters& parameters) {
  WristStart start(parameters);
  const ex cos_q73 = GiNaC::cos(start.q73());
  const ex flat = GiNaC::atan2(magnitude(start.pose.sine_flat), magnitude(cos_q73));
  // Without the margin that keeps the pose defined: this distance does reach 0.
  const ex height = start.list.define(
      "height",
      GiNaC::sqrt(maximum(
          start.pose.reach * start.pose.reach - start.pose.projection * start.pose.projection, 0)));
  const ex dead = GiNaC::atan2(height, magnitude(start.pose.projection));
  return start.finish(
      "singularity", "", "Distance to the singular poses.",
      {{"distance", 2, 1, {flat, dead}, "rad", "to the flat pose, to the dead centre"}});
}

Function wrist_status(const WristParameters& parameters) {
  const WristStart start(parameters);
  const ex& margin = start.links.margin;
  const ex slack = start.pose.reach * start.pose.reach * (1 - margin * margin) -
                   start.pose.projection * start.pose.projection;
  // Written so that a comparison that fails, whatever the reason, says 1.
  const ex status = choose(start.pose.sine_flat - margin, choose(slack, 0, 1), 1);
  return start.finish("status", "", "Whether the pose is regular.",
                      {{"status",
                        1,
                        1,
                        {status},
                        "1",
                        "0 fine, 1 at or beyond a singular pose",
                        {"fine", "singular"}}});
}

std::vector<Function> wrist_functions(const WristParameters& p) {
  return {wrist_pose(p),           wrist_points(p),          wrist_palm_angles(p),
          wrist_bar_angles(p),     wrist_singularity(p),     wrist_status(p),
          wrist_tendon_lengths(p), wrist_tendon_jacobian(p), wrist_tendon_hessian(p),
          wrist_bending_angles(p), wrist_feedforward(p),     wrist_feedforward_rate(p),
          wrist_joint_torque(p),   wrist_joint_stiffness(p)};
}

}  // namespace sinew
