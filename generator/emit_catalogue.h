// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/model.h"

namespace sinew {

/// Text of <model>_catalogue.h: the declaration of <model>_catalogue.
std::string emit_catalogue_header(const EmittedModel& model);

/// Text of <model>_catalogue.c: every function behind one calling convention (sinew_catalogue.h).
std::string emit_catalogue(const EmittedModel& model);

}  // namespace sinew
