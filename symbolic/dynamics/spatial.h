// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors and matrices of expressions whose elements are named as they are computed.
#pragma once

#include <ginac/ginac.h>

#include <array>
#include <string>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/expressions/number.h"
#include "symbolic/expressions/vector3.h"

namespace sinew {

using Vector3ex = std::array<GiNaC::ex, 3>;
using Matrix3ex = std::array<Vector3ex, 3>;

/// `value` under a name; numbers, symbols and negated symbols stay as they are.
GiNaC::ex named(DefinitionList& list, const std::string& name, const GiNaC::ex& value);

/// Named elements <name>x, <name>y, <name>z.
Vector3ex named(DefinitionList& list, const std::string& name, const Vector3ex& value);

/// The exact number nearest in double: what the emitted C will hold.
GiNaC::ex to_expression(const Number& value);
Vector3ex to_expression(const NumberVector3& value);

Vector3ex zero_vector();
Matrix3ex zero_matrix();

/// R * v and R^T * v for constant R.
Vector3ex times(const NumberMatrix3& R, const Vector3ex& v);
Vector3ex transpose_times(const NumberMatrix3& R, const Vector3ex& v);

/// A * v, element by element.
Vector3ex times(const Matrix3ex& A, const Vector3ex& v);

/// Cosine and sine of one angle, kept together.
struct CosSin {
  GiNaC::ex c, s;
};

/// v turned by the angle about z, and back.
Vector3ex turn(const CosSin& angle, const Vector3ex& v);
Vector3ex turn_back(const CosSin& angle, const Vector3ex& v);

}  // namespace sinew
