// SPDX-License-Identifier: GPL-3.0-or-later
// A part: a function of the file alone, which others call for what they compute alike.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generator/calls/find_calls.h"
#include "generator/calls/places.h"

namespace sinew {

/// A place at which a part is called, and what the part's values are there: by value of the
/// function that the part is taken from, no_value where nothing is the same.
struct PartInstance {
  Place place;
  std::vector<Value> image;
};

/// A part to be, in the function that it is taken from.
struct PartDraft {
  std::string name;
  const CallingFunction* base = nullptr;
  std::vector<Value> at;           ///< the angles of its place
  std::vector<std::string> names;  ///< what its numbers_of() are called
  std::vector<bool> belongs;       ///< by value
  std::vector<Value> results;
};

/// Whether each value of an instance's function is one of the part's there.
std::vector<bool> members_of(const Graph& graph, const std::vector<bool>& belongs,
                             const PartInstance& instance);

/// The part as a function: arrays first, then numbers, then one array of results.
CallingFunction made_part(const PartDraft& draft);

/// The arrays among the base's arguments that it takes.
std::set<std::size_t> arrays_of_part(const PartDraft& draft);

/// The numbers that it takes, as values of its base: angles of its place first, then what else it
/// needs and does not compute.
std::vector<Value> numbers_of(const PartDraft& draft);

/// A function with the part called at these instances, all of that function. Nothing where what is
/// passed needs what the call gives.
std::optional<CallingFunction> calling(const CallingFunction& function, const PartDraft& draft,
                                       const std::vector<const PartInstance*>& instances);

}  // namespace sinew
