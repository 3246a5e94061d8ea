// SPDX-License-Identifier: GPL-3.0-or-later
// The robots that everybody is timed on, and states to time at.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/contestant.h"

namespace sinew::benchmarks {

/// Where a robot comes from; given on the command line as <urdf>,<gx>,<gy>,<gz>,<shared object>.
struct Subject {
  std::string name;
  std::string library;  ///< emitted_calls.c, compiled for this robot
  Mechanism mechanism;
  std::vector<Contestant> contestants;
};

/// Reads the robot and asks every maker. Throws std::runtime_error where one cannot be had.
Subject read_subject(const std::string& argument);

/// One state: n positions in +-pi, n rates in +-3, n accelerations in +-10, one after the other.
using State = std::vector<double>;
std::vector<State> random_states(int n, int count);

/// Largest error of a contestant over `states`, against Newton-Euler in long double, over the
/// largest entry of the result at that state.
double worst_error(const Subject& subject, const Contestant& contestant,
                   const std::vector<State>& states);

int result_size(Quantity quantity, int n);

}  // namespace sinew::benchmarks
