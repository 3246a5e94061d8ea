// SPDX-License-Identifier: GPL-3.0-or-later
// The former place of starting_values().
#pragma once

#include "identification/regression/starting_values.h"
