// SPDX-License-Identifier: GPL-3.0-or-later
// A loop inside work that is itself done side by side.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace sinew::diagnosis {

/// function(0) .. function(count - 1), side by side. A thread that waits for the others here begins
/// no other work of the outer loop meanwhile: each holds what it works on.
template <class Function>
void inner_loop(std::size_t count, const Function& function) {
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, count, function); });
}

}  // namespace sinew::diagnosis
