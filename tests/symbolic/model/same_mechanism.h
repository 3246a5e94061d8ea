// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two mechanisms hold the same values, bit by bit.
#pragma once

#include <string>

#include "symbolic/model/mechanism.h"

/// The first value in which two mechanisms differ (places of reading left out), or "".
std::string first_difference(const sinew::Mechanism& a, const sinew::Mechanism& b);
