// SPDX-License-Identifier: GPL-3.0-or-later
// A user of the installed index finger in C++: the tip and its Jacobian agree with each other.
#include <array>
#include <cmath>
#include <cstdio>

#include "index.h"
#include "index_catalogue.h"

namespace {

std::array<double, 3> tip(const std::array<double, 4>& q) {
  std::array<double, 16> pose{};
  index_forward_kinematics(q.data(), pose.data());
  return {pose[3], pose[7], pose[11]};
}

/// Largest difference of the linear rows of the Jacobian (6x4, row-major) from central differences.
double jacobian_error(const std::array<double, 4>& q) {
  constexpr double step = 1e-6;
  std::array<double, 24> jacobian{};
  index_tip_jacobian(q.data(), jacobian.data());
  double worst = 0.0;
  for (std::size_t joint = 0; joint < q.size(); ++joint) {
    auto ahead = q;
    auto behind = q;
    ahead[joint] += step;
    behind[joint] -= step;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double slope = (tip(ahead)[axis] - tip(behind)[axis]) / (2.0 * step);
      worst = std::fmax(worst, std::fabs(slope - jacobian[axis * q.size() + joint]));
    }
  }
  return worst;
}

}  // namespace

int main() {
  const double error = jacobian_error({0.1, 0.4, 0.5, 0.2});
  std::printf("%s: tip Jacobian and central differences differ by %g m/rad\n", index_catalogue.model,
              error);
  return error < 1e-9 ? 0 : 1;
}
