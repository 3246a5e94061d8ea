// SPDX-License-Identifier: GPL-3.0-or-later
// Where functions compute the same at different places: at which numbers a part of a function could
// be called, and what of it another function computes at other numbers.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/calls/find_calls.h"

namespace sinew {

/// A function and numbers of it, in the order in which a part takes them.
struct Place {
  std::size_t function = 0;
  std::vector<Value> at;
};

/// The places of a function: none at all (the same arguments), and the angles that many of its
/// operations depend on, three at most. Angles are what sines, cosines and called parts are taken
/// of; both those that are computed from other angles and those that are not.
std::vector<std::vector<Value>> places_of(const CallingFunction& function);

/// By value of `base`: that of `other` which is the same, bit for bit, where the numbers `at` have
/// the values of `there`; no_value where there is none. Arguments are the same by name.
std::vector<Value> images(const CallingFunction& base, const std::vector<Value>& at,
                          const CallingFunction& other, const std::vector<Value>& there);

/// The number of a function's own arguments: the arrays of its calls follow them.
std::size_t own_ports(const CallingFunction& function);

/// The call that fills an input array, by array; nullptr for a function's own arguments.
std::vector<const Call*> calls_by_port(const CallingFunction& function);

bool same_argument(const Port& a, const Port& b);

/// What must be computed before a value: operands, or what is passed to the call that gives it.
std::vector<Value> needs_of(const Graph& graph, Value v);

}  // namespace sinew
