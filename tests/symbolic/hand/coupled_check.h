// SPDX-License-Identifier: GPL-3.0-or-later
// All functions of a mechanism, whether couplings or not, against independent numerics.
#pragma once

#include <functional>

#include "tests/symbolic/hand/emitted_call.h"
#include "tests/symbolic/hand/invented_hand.h"

namespace sinew_tests {

struct State {
  Values q, qd, qdd, f, kt;
};

/// A function by its name and all inputs: committed C, or an interpreter.
using Model = std::function<Values(const std::string&, const Values&)>;

CoupledReference::Vector exact(const Values& values);

/// Worst deviation of every function of rigid bodies and tendons from a reference, relative to its
/// largest element, by name.
std::vector<std::pair<std::string, double>> deviations(const Model& emitted,
                                                       const CoupledReference& reference,
                                                       const State& state);

}  // namespace sinew_tests
