// SPDX-License-Identifier: GPL-3.0-or-later
// What parts cost: instructions and stack of functions that call each other.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/calls/find_calls.h"
#include "generator/loops/plan.h"

namespace sinew {

/// What functions cost that call each other, as size_of estimates it: written, the functions that
/// they call left out; executed, those included.
class PartCosts {
 public:
  /// The first `emitted` may not grow, executed, by more than this factor.
  PartCosts(const std::vector<CallingFunction>& functions, double most_growth);

  void replace(std::size_t function, const CallingFunction& now);
  void add(const CallingFunction& part);

  PlanSize of(std::size_t function) const { return total(sizes_[function]); }
  /// Of a function that may call a part which is not among them yet and executes so much.
  PlanSize of(const CallingFunction& function, int new_part = 0) const;

  /// Instructions that its calls are, and the loads of what they give.
  static int written_for_calls(const CallingFunction& function);

  /// Elements of what calls give that are on the stack at once, those of what is called included.
  /// A part that is not among them yet has so many.
  std::size_t elements(const CallingFunction& function, std::size_t new_part = 0) const;

  /// Whether an emitted function would cost too much where this one executed so much more.
  bool is_dear(std::size_t function, int growth) const;
  /// Whether a function would have more than `most` elements at once where this one had so many.
  bool is_deep(std::size_t function, std::size_t elements, std::size_t most) const;

 private:
  /// Without what is called.
  struct Own {
    PlanSize size;
    std::vector<std::string> calls;
    std::size_t elements = 0;
  };

  static Own own(const CallingFunction& function);
  PlanSize total(const Own& own, int new_part = 0) const;
  std::size_t elements(const Own& own, std::size_t new_part) const;
  int executed_in(const std::string& name, int new_part) const;
  int runs(std::size_t caller, std::size_t callee) const;

  double most_growth_;
  std::vector<std::string> names_;
  std::vector<Own> sizes_;
  std::vector<int> allowed_;  ///< executed, of the emitted ones
};

}  // namespace sinew
