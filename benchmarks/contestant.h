// SPDX-License-Identifier: GPL-3.0-or-later
// What is timed: functions of one robot by several makers, all behind one calling convention.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "symbolic/model/mechanism.h"

namespace sinew::benchmarks {

enum class Quantity { inverse_dynamics, bias, mass_matrix, both, forward_dynamics };

/// "inverse_dynamics", ...
const char* name_of(Quantity quantity);

/// One function of one maker. `call(q, qd, u, out)`; u: accelerations, or torques for forward
/// dynamics; out: n numbers, n*n for the mass matrix (row-major), n*n + n for both.
struct Contestant {
  std::string maker;
  Quantity quantity = Quantity::inverse_dynamics;
  std::function<void(const double*, const double*, const double*, double*)> call;
};

/// Functions that a shared object of emitted_calls.c offers; prefix: "sinew_", "sympy_".
/// Throws std::runtime_error where the object cannot be loaded.
std::vector<Contestant> from_library(const std::string& maker, const std::string& file,
                                     const std::string& prefix);

/// MuJoCo's: kinematics and what the quantity needs, no constraints, no contacts.
std::vector<Contestant> from_mujoco(const Mechanism& mechanism);

/// Orocos KDL's: recursive Newton-Euler, and the mass matrix of its ChainDynParam. Chains only.
std::vector<Contestant> from_kdl(const Mechanism& mechanism);

}  // namespace sinew::benchmarks
