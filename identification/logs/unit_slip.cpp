// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>

#include "identification/logs/data_faults.h"

namespace sinew {
namespace {

using std::numbers::pi;

}  // namespace

UnitSlip unit_slip_of(double ratio, const std::string& unit, double tolerance) {
  struct Known {
    double factor;
    const char* unit;  // text that the channel's SI unit has to contain
    const char* meaning;
  };
  static constexpr std::array<Known, 14> known = {{
      {180.0 / pi, "rad", "degrees taken for radians"},
      {pi / 180.0, "rad", "radians taken for degrees"},
      {30.0 / pi, "rad/s", "rpm taken for rad/s"},
      {pi / 30.0, "rad/s", "rad/s taken for rpm"},
      {1000.0, "rad", "milliradians taken for radians"},
      {0.001, "rad", "radians taken for milliradians"},
      {1000.0, "m", "millimetres taken for metres"},
      {0.001, "m", "metres taken for millimetres"},
      {1000.0, "N", "millinewtons (or N·mm) taken for newtons (N·m)"},
      {0.001, "N", "newtons (N·m) taken for millinewtons (or N·mm)"},
      {0.001, "rad", "a time in milliseconds taken for seconds"},
      {1000.0, "A", "milliamperes taken for amperes"},
      {0.001, "A", "amperes taken for milliamperes"},
      {1.0e6, "m", "micrometres taken for metres"},
  }};
  for (const Known& k : known) {
    const bool suits =
        unit == k.unit ||
        (unit.starts_with(k.unit) && unit.find('/') != unit.npos && std::string(k.unit) != "N") ||
        (std::string(k.unit) == "N" && unit.starts_with("N"));
    if (suits && std::abs(std::log(ratio / k.factor)) < std::log1p(tolerance))
      return {k.factor, k.meaning};
  }
  return {};
}

}  // namespace sinew
