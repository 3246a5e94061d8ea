// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/graph.h"
#include "generator/naming.h"
#include "generator/target.h"

namespace sinew {

/// Everything that goes into one folder of emitted C.
struct EmittedModel {
  std::string name;                ///< C identifier, prefix of every function
  std::string description;         ///< one paragraph
  std::string hash;                ///< SHA-256 of the model's files, lower-case hex
  std::vector<std::string> notes;  ///< lines for the header, for instance the joint order
  std::vector<Graph> functions;    ///< optimised; in the order of the header
  Target target;
  Naming naming = {};  ///< of joints, tendons and frames
};

}  // namespace sinew
