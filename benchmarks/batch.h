// SPDX-License-Identifier: GPL-3.0-or-later
// The batch form of the inverse dynamics, compiled for several instruction sets.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/calls.h"
#include "benchmarks/subjects.h"

namespace sinew::benchmarks {

/// States of one call; inputs and results of the larger robot fill half a first-level cache.
inline constexpr int batch_states = 128;

struct Batch {
  std::string robot;
  std::string instructions;  ///< instruction set and rules it was compiled for
  batch_call* call = nullptr;
  int n = 0;
};

/// From <instruction set>,<shared object>. Throws std::runtime_error where it cannot be loaded.
Batch load_batch(const Subject& subject, const std::string& argument);

/// batch_states states as a structure of arrays: q, qd, u after one another.
std::vector<double> batch_inputs(int n);

/// Largest error against Newton-Euler in long double, as worst_error.
double worst_error(const Subject& subject, const Batch& batch);

}  // namespace sinew::benchmarks
