// SPDX-License-Identifier: GPL-3.0-or-later
// Interpreter of graphs: the tests' oracle for every pass and for the compiled C.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "generator/graph.h"

namespace sinew {

/// 50 decimal digits: stands for exact in comparisons with double and float.
using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                            boost::multiprecision::et_off>;

/// One operation. double and float use the runtime's functions and so give the bits of the emitted
/// C; Exact uses 50 digits. Instantiated for double, float and Exact.
template <class Real>
Real apply(const Node& node, const Real& a, const Real& b, const Real& c);

/// All results, one output after the other; `inputs` likewise. Throws std::invalid_argument where
/// the number of inputs is not the graph's.
template <class Real>
std::vector<Real> evaluate(const Graph& graph, const std::vector<Real>& inputs);

}  // namespace sinew
