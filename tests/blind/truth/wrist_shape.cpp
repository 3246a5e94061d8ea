// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/wrist_shape.h"

#include <fmt/format.h>

#include <cmath>

namespace sinew::trials {

Vector3d forearm_point(int tendon) {
  return {0.004, 0.007 + 0.0015 * tendon, 0.008};
}

Vector3d palm_point(int tendon) {
  return {-0.004, -0.011 + 0.0015 * tendon, 0.010};
}

double reference_71(const WristShape& m) {
  return std::atan2(m.c, m.a);
}

double reference_73(const WristShape& m) {
  return std::acos(m.b / std::sqrt(m.a * m.a + m.b * m.b + m.c * m.c));
}

PalmPose palm_pose(const WristShape& m, double q71, double q73) {
  const double r2 = m.a * m.a + m.b * m.b + m.c * m.c, r = std::sqrt(r2);
  const Vector3d y(0.0, 1.0, 0.0), e(std::cos(q71), 0.0, std::sin(q71));
  const double tb = 0.5 * pi - q73;
  // Bars B0-B and C0-C cross: the angle of the second follows from the coupler's length.
  const double tc =
      std::atan2((r2 + m.b * m.b) * std::sin(tb) - 2.0 * r * m.b, (r2 - m.b * m.b) * std::cos(tb));
  const Vector3d B = r * (std::cos(tb) * e + std::sin(tb) * y);
  const Vector3d C = m.b * y + r * (std::cos(tc) * e + std::sin(tc) * y);
  const Vector3d M = 0.5 * (B + C);
  const Vector3d x_axis = (C - M).normalized(), z_axis(-std::sin(q71), 0.0, std::cos(q71));
  const Vector3d y_axis = z_axis.cross(x_axis);
  // A lies |AM| from M across BC and |AA0| from A0; of the two points the crossed one.
  const Vector3d A0(0.0, 0.5 * m.b, m.c), d = A0 - M;
  const double py = y_axis.dot(d), pz = z_axis.dot(d);
  const double am = m.c, aa0 = std::sqrt(m.a * m.a + m.c * m.c);
  const double k = (d.squaredNorm() + am * am - aa0 * aa0) / (2.0 * am);
  const double ta = std::atan2(pz, py) + std::acos(k / std::hypot(py, pz));
  const Vector3d A = M + am * (std::cos(ta) * y_axis + std::sin(ta) * z_axis);
  PalmPose pose;
  const Vector3d v = (B - C).normalized(), w = (M - A).normalized();
  pose.rotation.col(0) = v.cross(w);
  pose.rotation.col(1) = v;
  pose.rotation.col(2) = w;
  pose.origin = 0.5 * (A + M);
  return pose;
}

std::string wrist_part(const WristShape& m, int tendons) {
  std::string text = fmt::format(
      "[part]\nname = \"wrist\"\n\n[wrist]\n"
      "length = {{ value = {:.12g}, unit = \"m\", from = \"assumed\" }}\n"
      "width = {{ value = {:.12g}, unit = \"m\", from = \"assumed\" }}\n"
      "thickness = {{ value = {:.12g}, unit = \"m\", from = \"assumed\" }}\n"
      "motor_radius = {{ value = {:.12g}, unit = \"m\", from = \"assumed\" }}\n"
      "flexion = {{ value = [-28, 28], unit = \"deg\", from = \"assumed\" }}\n"
      "abduction = {{ value = [-17, 17], unit = \"deg\", from = \"assumed\" }}\n",
      m.a, m.b, m.c, m.motor_radius);
  for (int i = 0; i < tendons; ++i)
    for (const auto& [key, p] :
         {std::pair{"[[channel]]\nforearm", forearm_point(i)}, std::pair{"palm", palm_point(i)}})
      text += fmt::format(
          "{} = {{ value = [{:.12g}, {:.12g}, {:.12g}], unit = \"m\", from = "
          "\"assumed\" }}\n",
          key, p.x(), p.y(), p.z());
  return text;
}

}  // namespace sinew::trials
