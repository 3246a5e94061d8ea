// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/inner_motion.h"

namespace sinew {
namespace {

using GiNaC::ex;

InnerMotion named_motion(DefinitionList& list, const std::string& name, const InnerMotion& motion) {
  InnerMotion result;
  for (std::size_t i = 0; i < 3; ++i) result.Q[i] = named(list, name + "Q" + "xyz"[i], motion.Q[i]);
  result.p = named(list, name + "p", motion.p);
  return result;
}

}  // namespace

InnerMotion operator+(const InnerMotion& a, const InnerMotion& b) {
  InnerMotion sum;
  for (std::size_t i = 0; i < 3; ++i) sum.Q[i] = a.Q[i] + b.Q[i];
  sum.p = a.p + b.p;
  return sum;
}

InnerMotion turned(DefinitionList& list, const std::string& name, const CosSin& angle,
                   const InnerMotion& motion) {
  const Matrix3ex& Q = motion.Q;
  const ex u =
      named(list, name + "Qu", (Q[0][0] - Q[1][1]) * angle.c - (Q[0][1] + Q[1][0]) * angle.s);
  const Vector3ex column = turn(angle, {Q[0][2], Q[1][2], ex(0)});
  const Vector3ex row = turn(angle, {Q[2][0], Q[2][1], ex(0)});
  InnerMotion result;
  result.Q[0] = {Q[1][1] + angle.c * u, Q[0][1] + angle.s * u, column[0]};
  result.Q[1] = {Q[1][0] + angle.s * u, Q[0][0] - angle.c * u, column[1]};
  result.Q[2] = {row[0], row[1], Q[2][2]};
  result.p = turn(angle, motion.p);
  return named_motion(list, name, result);
}

InnerMotion rotated(DefinitionList& list, const std::string& name, const NumberMatrix3& R,
                    const InnerMotion& motion) {
  Matrix3ex half;  // rows of Q R^T
  for (std::size_t i = 0; i < 3; ++i)
    half[i] = named(list, name + "QR" + "xyz"[i], times(R, motion.Q[i]));
  InnerMotion result;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector3ex column = times(R, {half[0][j], half[1][j], half[2][j]});
    for (std::size_t i = 0; i < 3; ++i) result.Q[i][j] = column[i];
  }
  result.p = times(R, motion.p);
  return named_motion(list, name, result);
}

InnerMotion shifted(DefinitionList& list, const std::string& name, const Vector3ex& offset,
                    const InnerMotion& motion) {
  InnerMotion result = motion;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result.Q[i][j] += offset[i] * motion.p[j];
  return named_motion(list, name, result);
}

InnerMotion turning(DefinitionList& list, const std::string& name, const ex& rate,
                    const PseudoInertia& J) {
  InnerMotion result;  // dr = rate * (-y, x, 0)
  for (std::size_t i = 0; i < 3; ++i) {
    result.Q[i][0] = -named(list, name + "rJ", rate * J[i][1]);
    result.Q[i][1] = named(list, name + "rJ", rate * J[i][0]);
  }
  result.p = {-named(list, name + "rs", rate * J[1][3]), named(list, name + "rs", rate * J[0][3]),
              ex(0)};
  return result;
}

InnerMotion sliding(DefinitionList& list, const std::string& name, const ex& q, const ex& rate,
                    const InnerMotion& before, const PseudoInertia& slid) {
  InnerMotion result = before;
  for (std::size_t j = 0; j < 3; ++j) result.Q[2][j] += q * before.p[j];
  for (std::size_t i = 0; i < 3; ++i) result.Q[i][2] += rate * slid[i][3];
  result.p[2] += rate * slid[3][3];
  return named_motion(list, name, result);
}

}  // namespace sinew
