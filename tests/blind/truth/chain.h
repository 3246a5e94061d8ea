// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid links in a chain or a tree, worked out in the base frame by Newton and Euler, and the files
// that describe them as a user of the program would.
#pragma once

#include <filesystem>

#include "tests/blind/truth/hidden.h"

namespace sinew::trials {

struct Link {
  std::string name, joint;
  int parent = -1;  ///< -1: the base
  bool slides = false;
  Vector3d axis{0, 0, 1}, xyz{0, 0, 0}, rpy{0, 0, 0};  ///< rpy as URDF's, rad
  double mass = 1.0;
  Vector3d com{0, 0, 0};
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();  ///< about the centre of mass
  double low = -3.0, high = 3.0;
  double follows = 0.0;  ///< turns this many times as far as the link before; 0: by itself
  double damping = 0.0, friction = 0.0, friction_speed = 0.0, armature = 0.0, motor_turn = 0.0;
};

struct Tendon {
  std::string name;
  VectorXd radius;  ///< a joint; the path grows by radius * q
};

struct Chain {
  std::string name;
  Vector3d gravity{0, 0, -9.81};
  std::vector<Link> links;
  std::vector<Tendon> tendons;
  double payload = 0.0;  ///< kg, a small ball at `tip` of the last link
  Vector3d tip{0, 0, 0};

  /// Joints that move by themselves: the axes.
  Index size() const;
  /// The link that an axis moves first, and the axis that moves a link.
  std::size_t link_of(Index axis) const;
  Index axis_of(std::size_t link) const;
  /// Torques (forces) of the joints for a motion, armatures apart.
  VectorXd torque(const VectorXd& q, const VectorXd& v, const VectorXd& a) const;
  /// Inertia that joint j carries.
  double carried(const VectorXd& q, Index j) const;

 private:
  VectorXd torque_of_each(const VectorXd& q, const VectorXd& v, const VectorXd& a) const;
};

/// mechanism.toml and mass_properties.csv.
void write_mechanism(const Chain& chain, const std::filesystem::path& folder);

void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace sinew::trials
