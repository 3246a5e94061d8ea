// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/model.h"

namespace sinew {

/// Longest function, in operations, that gets a batch form: beyond, a loop body no longer pays.
inline constexpr int longest_batch_function = 2000;

/// Where the batch files lie among a model's files: who takes the C of a folder for a board gets
/// none.
inline constexpr std::string_view host_folder = "host/";

/// Text of <model>_batch.h and <model>_batch.c: every function over `count` states at once, as a
/// structure of arrays (element k of state i at [k * count + i]), in a loop without branch or call
/// that compilers vectorise whole. The results are the bits of the single functions; a status is an
/// int, as there.
std::string emit_batch_header(const EmittedModel& model);
std::string emit_batch(const EmittedModel& model);

}  // namespace sinew
