// SPDX-License-Identifier: GPL-3.0-or-later
// The double inverted parallelogram, worked out point by point.
#pragma once

#include "tests/blind/truth/hidden.h"

namespace sinew::trials {

struct WristShape {
  double a = 0.050, b = 0.042, c = 0.036, motor_radius = 0.005;
};

struct PalmPose {
  Eigen::Matrix3d rotation;
  Vector3d origin;
};

/// Pose of the palm in the forearm's frame.
PalmPose palm_pose(const WristShape& wrist, double q71, double q73);
/// Angles of the reference pose: the palm parallel to the forearm.
double reference_71(const WristShape& wrist);
double reference_73(const WristShape& wrist);
/// Where the tendon of that number, from 0, leaves the forearm and enters the palm.
Vector3d forearm_point(int tendon);
Vector3d palm_point(int tendon);

/// part.toml of a wrist with so many tendons.
std::string wrist_part(const WristShape& wrist, int tendons);

}  // namespace sinew::trials
