// SPDX-License-Identifier: GPL-3.0-or-later
// The closed form of the wrist's pose, in the steps of 6.1, for the functions of wrist.h.
#pragma once

#include <ginac/ginac.h>

#include "symbolic/expressions/vector3.h"
#include "symbolic/parts/wrist.h"

namespace sinew {

/// Link lengths as expressions: numbers, or symbols.
struct WristLengths {
  GiNaC::ex a, b, c;
  GiNaC::ex r;          ///< |B0B| = |C0C|
  GiNaC::ex r_squared;  ///< a² + b² + c²
  GiNaC::ex margin;
};

/// Link lengths as exact numbers.
struct WristLinks {
  explicit WristLinks(const WristParameters& parameters);
  GiNaC::numeric a, b, c;
  GiNaC::numeric r;          ///< |B0B| = |C0C|
  GiNaC::numeric r_squared;  ///< a² + b² + c²
  GiNaC::numeric margin;
  WristLengths lengths() const { return {a, b, c, r, r_squared, margin}; }
};

/// Everything in {0}.
struct WristPose {
  Vector3 A, B, C;
  Vector3 origin;       ///< of {ABC}
  Vector3 x, y, z;      ///< axes of {ABC}: the columns of its rotation
  GiNaC::ex sine_flat;  ///< sin q73: 0 in the flat pose
  GiNaC::ex reach;      ///< √(p_y² + p_z²): A0's distance from the line BC
  GiNaC::ex projection;  ///< κ: A0-A-M is possible for |κ| <= reach; |κ| = reach is the dead centre
  GiNaC::ex root;        ///< √(reach² - κ²), at least margin * reach
};

/// `sin` and `cos` of both bar angles are given, so that the inverse map can use it as well.
struct BarAngles {
  GiNaC::ex cos_q71, sin_q71, cos_q73, sin_q73;
};

WristPose wrist_pose(DefinitionList& list, const WristLengths& links, const BarAngles& angles);

/// Inputs q71 and q73 with their ranges, and the pose defined on them: how most functions begin.
struct WristStart {
  explicit WristStart(const WristParameters& parameters);
  WristLinks links;
  std::vector<Argument> inputs;
  DefinitionList list;
  WristPose pose;
  const GiNaC::symbol& q71() const { return inputs[0].symbols[0]; }
  const GiNaC::symbol& q73() const { return inputs[1].symbols[0]; }
  Function finish(const std::string& name, const std::string& equation, const std::string& doc,
                  std::vector<Output> outputs) const;
};

}  // namespace sinew
