// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/runtime_parameters.h"

#include <array>
#include <utility>

#include "symbolic/expressions/exact_number.h"
#include "symbolic/dynamics/symbols.h"

namespace sinew {
namespace {

using GiNaC::ex;
using Entry = std::pair<std::size_t, std::size_t>;

/// Elements of J that are base parameters behind a joint of this type.
std::vector<Entry> base_entries(JointType type) {
  if (type == JointType::prismatic) return {{0, 3}, {1, 3}, {2, 3}, {3, 3}};
  return {{0, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}};
}

Range around(double value) {
  const double width = value == 0.0 ? 1e-9 : 0.2 * (value < 0 ? -value : value);
  return {value - width, value + width};
}

void append(Argument& argument, double value) {
  argument.symbols.emplace_back("p" + std::to_string(argument.rows++));
  argument.ranges.push_back(around(value));
}

/// Pseudo-inertia of a body about its frame's origin, from its mass properties.
PseudoInertia body_inertia(const ex& m, const Vector3ex& c, const std::array<ex, 6>& I) {
  const ex half_trace = (I[0] + I[1] + I[2]) / 2;
  const ex about_centre[3][3] = {{half_trace - I[0], -I[3], -I[4]},
                                 {-I[3], half_trace - I[1], -I[5]},
                                 {-I[4], -I[5], half_trace - I[2]}};
  PseudoInertia J;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) J[i][j] = about_centre[i][j] + m * c[i] * c[j];
    J[i][3] = J[3][i] = m * c[i];
  }
  J[3][3] = m;
  return J;
}

/// The part of J that its own joint cannot move; the rest stays.
PseudoInertia take_movable(PseudoInertia& J, JointType type) {
  PseudoInertia part;
  const auto take = [&](std::size_t i, std::size_t j) {
    part[i][j] = part[j][i] = J[i][j];
    J[i][j] = J[j][i] = 0;
  };
  if (type == JointType::prismatic) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j) take(i, j);
  } else {
    take(2, 2);
    take(2, 3);
    take(3, 3);
  }
  return part;
}

PseudoInertia moved(DefinitionList& list, const std::string& name, const NumberMatrix3& R,
                    const NumberVector3& p, const PseudoInertia& J) {
  return shifted(list, name + "s", to_expression(p), rotated(list, name + "r", R, J));
}

}  // namespace

Argument parameter_argument(const JointTree& tree) {
  Argument argument{
      "parameters", 0, 1, {}, "SI", "gravity and base parameters, see base_parameters", {}};
  for (int i = 0; i < 3; ++i) append(argument, static_cast<double>(tree.gravity(i)));
  for (const TreeLink& link : tree.links)
    for (const auto& [i, j] : base_entries(link.type))
      append(argument, static_cast<double>(link.J(static_cast<int>(i), static_cast<int>(j))));
  return argument;
}

void use_parameters(JointTree& tree, const Argument& parameters) {
  std::size_t next = 0;
  for (ex& component : tree.gravity_vector) component = parameters.symbols[next++];
  for (std::size_t k = 0; k < tree.links.size(); ++k)
    for (const auto& [i, j] : base_entries(tree.links[k].type))
      tree.inertias[k][i][j] = tree.inertias[k][j][i] = parameters.symbols[next++];
}

Function base_parameters_function(const Mechanism& mechanism) {
  const JointTree tree = build_joint_tree(mechanism);
  const int n = static_cast<int>(mechanism.bodies.size());
  Argument mass = make_argument("mass", n, 1, "kg", "of each body", {0.01, 1.0});
  Argument com = make_argument("com", n, 3, "m", "centres of mass, body frames", {-0.05, 0.05});
  Argument inertia = make_argument(
      "inertia", n, 6, "kg m^2", "about the centres of mass: xx, yy, zz, xy, xz, yz", {1e-7, 1e-5});
  Argument gravity = make_argument("gravity", 3, 1, "m/s^2", "base frame", {-9.81, 9.81});
  DefinitionList list;
  std::vector<PseudoInertia> links(tree.links.size());
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const BodyPlace& place = tree.bodies[b];
    if (place.link < 0) continue;
    std::array<ex, 6> I;
    for (std::size_t k = 0; k < 6; ++k) I[k] = inertia.symbols[6 * b + k];
    const Vector3ex c{com.symbols[3 * b], com.symbols[3 * b + 1], com.symbols[3 * b + 2]};
    PseudoInertia& link = links[static_cast<std::size_t>(place.link)];
    link = link + moved(list, "B" + std::to_string(b), place.R, place.p,
                        body_inertia(mass.symbols[b], c, I));
  }
  for (std::size_t k = tree.links.size(); k-- > 0;) {
    const PseudoInertia part = take_movable(links[k], tree.links[k].type);
    if (tree.links[k].parent < 0) continue;
    PseudoInertia& parent = links[static_cast<std::size_t>(tree.links[k].parent)];
    parent = parent + moved(list, "L" + std::to_string(k), tree.links[k].R, tree.links[k].p, part);
  }
  std::vector<ex> values(gravity.symbols.begin(), gravity.symbols.end());
  for (std::size_t k = 0; k < tree.links.size(); ++k)
    for (const auto& [i, j] : base_entries(tree.links[k].type)) values.push_back(links[k][i][j]);
  const int count = static_cast<int>(values.size());
  return {
      "base_parameters",
      "Parameters of the dynamics from the bodies' mass properties.",
      "",
      {mass, com, inertia, gravity},
      list.items(),
      {{"parameters", count, 1, values, "SI", "gravity, then the base parameters of each link"}}};
}

}  // namespace sinew
