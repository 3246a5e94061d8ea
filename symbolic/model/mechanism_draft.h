// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism as mechanism.toml lists it: bodies without masses, in the file's order.
#pragma once

#include <toml++/toml.h>

#include <vector>

#include "symbolic/model/check_mechanism.h"
#include "symbolic/model/mechanism.h"
#include "symbolic/model/order_bodies.h"
#include "symbolic/files/toml_reader.h"

namespace sinew {

struct BodyEntry {
  Body body;
  bool is_massless = false;
  InertiaCheck check = InertiaCheck::physical;
};

struct JointEntry {
  Joint joint;
  TreeJoint ends;
};

struct MechanismDraft {
  Mechanism mechanism;   ///< without bodies and joints
  SourceLocation where;  ///< of [mechanism]
  std::vector<BodyEntry> bodies;
  std::vector<JointEntry> joints;
};

/// Reads all sections of a parsed mechanism.toml; mistakes go to the file's findings. Whether the
/// bodies form a tree and names are different is for the caller.
void read_sections(const toml::table& root, TomlFile& file, MechanismDraft& draft);

}  // namespace sinew
