// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of three expressions.
#pragma once

#include <ginac/ginac.h>

#include <Eigen/Core>
#include <array>
#include <string>

#include "symbolic/expressions/definition_list.h"

namespace sinew {

using Vector3 = std::array<GiNaC::ex, 3>;

Vector3 operator+(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a, const Vector3& b);
Vector3 operator*(const GiNaC::ex& factor, const Vector3& a);
GiNaC::ex dot(const Vector3& a, const Vector3& b);
Vector3 cross(const Vector3& a, const Vector3& b);

/// Each component exactly as its shortest decimal text says.
Vector3 exact_vector(const Eigen::Vector3d& value);

/// Definitions name_x, name_y, name_z.
Vector3 define(DefinitionList& list, const std::string& name, const Vector3& value);

}  // namespace sinew
