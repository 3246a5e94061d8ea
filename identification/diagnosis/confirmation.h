// SPDX-License-Identifier: GPL-3.0-or-later
// When a name stands that was found in the training logs.
#pragma once

#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// What is left over is that many times the noise, and no noise.
inline constexpr double kExcess = 3.0;

/// No fluke of the training logs: it helps in their left-out blocks as well, or what they leave
/// without it is far above the noise.
bool is_plain(const NamedCause& cause);

/// Whether the held-out logs confirm it or, where it is plain, do at least not speak against it: a
/// slow log tells a delay or a friction at speed hardly from nothing.
bool is_confirmed(const NamedCause& cause);

}  // namespace sinew::diagnosis
