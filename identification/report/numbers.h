// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and units as people read them: few digits, SI prefixes, a real minus sign. UTF-8.
#pragma once

#include <string>

#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// `digits` significant digits; powers of ten only beyond 1e-4 .. 1e6. NaN: an en dash.
std::string shown_number(double value, int digits = 3);

/// "N*m*s/rad^2" or "N m s/rad^2" as "N·m·s/rad²"; "1" as nothing.
std::string shown_unit(const std::string& unit);

/// Number and unit with the natural SI prefix: 0.00087, "s" is "0.870 ms".
std::string shown_quantity(double value, const std::string& unit, int digits = 3);

/// The unit of an axis whose largest value is `largest`, as it is shown: a prefix, or a power of
/// ten before units that take none, so that no tick needs more than a few digits.
struct AxisUnit {
  double factor = 1.0;  ///< value shown / value
  std::string unit;     ///< "mN·m", "10⁻⁵ kg·m²"
};
AxisUnit axis_unit(double largest, const std::string& unit);

/// Value ± standard error in one prefix, the error with two digits. An error that is zero or not
/// known is left out.
std::string shown_estimate(double value, double standard_error, const std::string& unit);

/// A share as percentage: "4.1 %", "71 %", "99.8 %".
std::string shown_share(double share);

/// A share with three digits: "4.08 %".
std::string shown_percent(double share);

/// "66 to 75 %".
std::string shown_interval(const Gain& gain);

/// A confidence, never rounded up to certainty: "97 %", "> 99 %".
std::string shown_confidence(double confidence);

/// Duration: "0.8 s", "12 min".
std::string shown_duration(double seconds);

}  // namespace sinew::diagnosis
