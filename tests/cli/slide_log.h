// SPDX-License-Identifier: GPL-3.0-or-later
// A slide as a robot description, and logs of it whose friction is stronger one way.
#pragma once

#include <string>

namespace sinew::test {

/// URDF: 2 kg on one prismatic joint x, with damping 3 N s/m and friction 4 N.
extern const char* const slide_urdf;

/// CSV of `rows` rows at 500 Hz, along sums of sines: the model's force, noise of 0.2 N, and
/// `difference` [N s/m] * |v| that the model has not. `sign`: of the force column.
std::string slide_log(unsigned seed, double difference, int rows, double sign = 1.0);

}  // namespace sinew::test
