// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/joint_angles.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// An angle as a sum of coordinates, a constant and whole quarter turns.
struct Angle {
  ex sum = 0;
  int quarter_turns = 0;
};

Angle own_angle(const TreeLink& link, const std::vector<ex>& q) {
  return {link.sign * q[static_cast<std::size_t>(link.coordinate)] + to_expression(link.remainder),
          link.quarter_turns};
}

CosSin turned_by_quarters(CosSin angle, int quarters) {
  for (int k = 0; k < quarters % 4; ++k) angle = {-angle.s, angle.c};
  return angle;
}

CosSin cosine_and_sine(DefinitionList& list, const std::string& index, const Angle& angle) {
  const bool mirrored = GiNaC::is_a<GiNaC::symbol>(-angle.sum);
  const ex sum = named(list, "phi" + index, mirrored ? -angle.sum : angle.sum);
  CosSin result{list.define("c" + index, cos(sum)), list.define("s" + index, sin(sum))};
  if (mirrored) result.s = -result.s;
  return turned_by_quarters(result, angle.quarter_turns);
}

}  // namespace

std::vector<CosSin> joint_angles(DefinitionList& list, const JointTree& tree, const Runs& runs,
                                 const std::vector<ex>& q) {
  std::vector<CosSin> result;
  std::vector<Angle> angles;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink& link = tree.links[i];
    angles.emplace_back();
    if (link.type == JointType::prismatic) {
      result.push_back({ex(1), ex(0)});
      continue;
    }
    Angle& angle = angles.back();
    angle = own_angle(link, q);
    const Run& run = runs.runs[static_cast<std::size_t>(runs.run_of[i])];
    if (run.common_frame && run.links.front() != static_cast<int>(i)) {
      const Angle& before = angles[static_cast<std::size_t>(link.parent)];
      angle.sum = before.sum + angle.sum;
      angle.quarter_turns += before.quarter_turns;
    }
    if (!GiNaC::is_a<GiNaC::symbol>(-angle.sum))
      angle.sum = named(list, "phi" + std::to_string(i + 1), angle.sum);
    result.push_back(cosine_and_sine(list, std::to_string(i + 1), angle));
  }
  return result;
}

}  // namespace sinew
