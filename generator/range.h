// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sinew {

/// Interval a value is expected in, in the value's own unit.
struct Range {
  double low;
  double high;
};

}  // namespace sinew
