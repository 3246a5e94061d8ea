// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/base_parameters.h"

namespace sinew {
namespace {

NumberMatrix4 movable_part(const TreeLink& link) {
  NumberMatrix4 part = NumberMatrix4::Zero();
  if (link.type == JointType::prismatic) {
    part.block<3, 3>(0, 0) = link.J.block<3, 3>(0, 0);
  } else {
    part(2, 2) = link.J(2, 2);
    part(2, 3) = part(3, 2) = link.J(2, 3);
    part(3, 3) = link.J(3, 3);
  }
  return part;
}

}  // namespace

void fold_base_parameters(JointTree& tree) {
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    TreeLink& link = tree.links[i];
    const NumberMatrix4 part = movable_part(link);
    link.J -= part;
    if (link.parent < 0) continue;
    NumberMatrix4 T = NumberMatrix4::Identity();
    T.block<3, 3>(0, 0) = link.R;
    T.block<3, 1>(0, 3) = link.p;
    tree.links[static_cast<std::size_t>(link.parent)].J += T * part * T.transpose();
  }
}

}  // namespace sinew
