// SPDX-License-Identifier: GPL-3.0-or-later
// What every function of a model gives in two states: what a change is measured by, and what a
// user's own build can be compared with.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/model.h"

namespace sinew {

/// Inputs of a function in its reference state, one argument after the other: the model's own
/// reference pose where an argument has one, else as in beside_inputs.
std::vector<double> reference_inputs(const Graph& graph);

/// A second state, away from the reference pose, where many results are 0: every number somewhere
/// between the middle and nine tenths of its range, no two elements alike, so that antagonists do
/// not cancel; 0 without a range.
std::vector<double> beside_inputs(const Graph& graph);

/// Results of a function in the arithmetic of the target's scalar type.
std::vector<double> results_at(const Graph& graph, const Target& target,
                               const std::vector<double>& inputs);

/// Text of reference.csv: a row for every argument and result in every state,
/// "function,state,argument,values..."; state is "reference" or "beside". Numbers are the shortest
/// decimals that read back to the same bits.
std::string emit_reference(const EmittedModel& model);

/// Argument or result -> values, by "function state". Rows that are no such rows are left out.
using ReferenceTable = std::map<std::string, std::map<std::string, std::vector<double>>>;
ReferenceTable read_reference(const std::string& text);

}  // namespace sinew
