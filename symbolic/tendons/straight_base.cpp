// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/straight_base.h"

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/tendons/tendons.h"

namespace sinew {
namespace {

using GiNaC::ex;

bool is_unturned(const Joint& joint, const Eigen::Vector3d& axis) {
  return joint.type == JointType::revolute && joint.axis == axis &&
         joint.origin.rotation == Eigen::Matrix3d::Identity();
}

/// One straight stretch between the base and a body, whichever way round.
std::optional<StraightRouting> base_stretch(const Tendon& tendon, const std::string& body) {
  if (!tendon.pulleys.empty() || tendon.straights.size() != 1) return std::nullopt;
  StraightRouting stretch = tendon.straights[0];
  if (stretch.to_body == "base") {
    std::swap(stretch.from_body, stretch.to_body);
    std::swap(stretch.from, stretch.to);
  }
  if (stretch.from_body != "base" || stretch.to_body != body) return std::nullopt;
  return stretch;
}

/// The joints behind the base, from the lengths of the tendons that are not the base's.
std::optional<Function> hinge_position(const Mechanism& mechanism, const StraightBase& base) {
  Mechanism hinges = mechanism;
  hinges.tendons.clear();
  for (const std::size_t i : base.other_tendons) hinges.tendons.push_back(mechanism.tendons[i]);
  const Argument q = joint_positions(hinges);
  if (hinges.tendons.empty() || q.rows <= 2) return std::nullopt;
  DefinitionList list;
  const std::vector<ex> lengths = tendon_lengths(list, hinges, build_joint_tree(hinges), q.symbols);
  const std::vector<GiNaC::symbol> others(q.symbols.begin() + 2, q.symbols.end());
  const std::vector<ex> P = coupling_matrix(list, lengths, others);
  Argument h = make_argument("h", static_cast<int>(lengths.size()), 1, "m",
                             "lengths of the tendons behind the base", {-0.03, 0.03});
  const auto position = link_position(hinges, P, h.symbols);
  if (!position) return std::nullopt;
  return Function{"hinge_position",
                  "Positions of the joints behind the base from their tendons' lengths.",
                  "(5.22)",
                  {h},
                  {},
                  {{"q", q.rows - 2, 1, *position, "rad", "joint positions from the third on"}}};
}

}  // namespace

std::optional<StraightBase> straight_base(const Mechanism& mechanism) {
  if (mechanism.joints.size() < 2) return std::nullopt;
  const Joint &first = mechanism.joints[0], &second = mechanism.joints[1];
  const Eigen::Vector3d& beside = second.origin.translation;
  if (first.parent != -1 || second.parent != 0 || !is_unturned(first, Eigen::Vector3d::UnitZ()) ||
      !is_unturned(second, -Eigen::Vector3d::UnitY()) || beside.y() != 0.0 || beside.z() != 0.0 ||
      Coordinates(mechanism).count() != coordinate_count(mechanism))
    return std::nullopt;
  StraightBase base;
  base.parameters.offset = beside.x();
  base.parameters.angle = {std::max(first.low, second.low), std::min(first.high, second.high)};
  for (std::size_t i = 0; i < mechanism.tendons.size(); ++i) {
    const auto stretch = base_stretch(mechanism.tendons[i], mechanism.bodies[1].name);
    (stretch ? base.base_tendons : base.other_tendons).push_back(i);
    if (!stretch) continue;
    base.parameters.base_points.push_back(stretch->from - first.origin.translation);
    base.parameters.distal_points.push_back(stretch->to);
    base.parameters.free_lengths.push_back(mechanism.tendons[i].h0);
  }
  if (base.base_tendons.size() < 2) return std::nullopt;
  return base;
}

std::vector<Function> straight_base_functions(const Mechanism& mechanism,
                                              const StraightBase& base) {
  const LinkPositionSettings settings;
  LinkPositionSettings one_step = settings;
  one_step.iterations = 1;
  Function warm = link_position(base.parameters, one_step);
  warm.name = "link_position_warm";
  warm.doc = "Angles of the base by one Levenberg-Marquardt iteration, from a start a tick away.";
  std::vector<Function> result{link_position(base.parameters, settings), warm,
                               link_position_gradient_step(base.parameters, settings),
                               link_position_status(base.parameters, settings),
                               link_position_covariance(base.parameters, settings)};
  if (const auto hinges = hinge_position(mechanism, base)) result.push_back(*hinges);
  return result;
}

}  // namespace sinew
