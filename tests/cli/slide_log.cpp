// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/slide_log.h"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <utility>

namespace sinew::test {

const char* const slide_urdf = R"(<robot name="slide"><link name="base"/>
<link name="carriage"><inertial><mass value="2"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="x" type="prismatic"><parent link="base"/><child link="carriage"/>
<axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="50" velocity="3"/>
<dynamics damping="3" friction="4"/></joint></robot>)";

std::string slide_log(unsigned seed, double difference, int rows, double sign) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const double step = 0.002, phase = 0.7 * seed;
  std::string text = "time [s],x [m],f [N]\n";
  for (int k = 0; k < rows; ++k) {
    const double t = step * k;
    double x = 0.0, v = 0.0, a = 0.0;
    for (const auto& [size, rate] : {std::pair{0.2, 1.9}, {0.1, 4.3}, {0.04, 9.1}}) {
      x += size * std::sin(rate * t + phase * rate);
      v += size * rate * std::cos(rate * t + phase * rate);
      a -= size * rate * rate * std::sin(rate * t + phase * rate);
    }
    const double f = 2.0 * a + 3.0 * v + 4.0 * std::tanh(v / 0.005) + difference * std::abs(v) +
                     0.2 * normal(random);
    text += fmt::format("{:.4f},{:.8f},{:.6f}\n", t, x + 1e-7 * normal(random), sign * f);
  }
  return text;
}

}  // namespace sinew::test
