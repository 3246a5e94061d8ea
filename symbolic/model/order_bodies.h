// SPDX-License-Identifier: GPL-3.0-or-later
// From bodies and joints in any order to depth-first order, with every mistake of the tree found.
#pragma once

#include <string>
#include <vector>

#include "symbolic/files/description_error.h"

namespace sinew {

struct TreeBody {
  std::string name;
  SourceLocation where;
};

/// A joint by the names of the bodies it connects.
struct TreeJoint {
  std::string name;
  std::string parent;
  std::string child;
  SourceLocation where;
  SourceLocation parent_where;
  SourceLocation child_where;
};

/// Indices of the joints in depth-first order from `base`, siblings in the order given, so that the
/// k-th entry carries body k. Reports unknown, unconnected and doubly carried bodies and cycles;
/// the order is then incomplete.
std::vector<std::size_t> order_depth_first(const std::string& base,
                                           const std::vector<TreeBody>& bodies,
                                           const std::vector<TreeJoint>& joints,
                                           Findings& findings);

}  // namespace sinew
