// SPDX-License-Identifier: GPL-3.0-or-later
// Units as people write them in column headers, and what they are in SI.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace sinew {

/// A unit: one of it is `factor` SI units. Exponents of m, kg, s, A, K, rad.
struct Unit {
  double factor = 1.0;
  std::array<int, 6> dimension{};
};

/// Reads "N·m", "Nm", "N*mm", "deg/s", "µm", "°", "rad/s^2", "kg m²", "rpm", "1", ...; UTF-8 or
/// Latin-1. Nothing when the text is no unit.
std::optional<Unit> parse_unit(std::string_view text);

/// The unit of a column whose file says only that it is in SI units, such as a message of ROS 2.
inline constexpr std::string_view kWhateverSi = "SI";

/// Whether a value in `given` can be converted to `wanted`. Radians count as a dimension except in
/// units with mass (N·m/rad is N·m), so that counts are never taken for an angle.
bool convertible(const Unit& given, const Unit& wanted);

/// "theta [rad]" -> {"theta", "rad"}; also "theta (rad)". The unit is empty where there is none.
struct NameAndUnit {
  std::string name;
  std::string unit;
};
NameAndUnit split_name_and_unit(std::string_view cell);

/// "q_deg" -> {"q", "deg"}, "force_N" -> {"force", "N"}; nothing where the last part is no unit.
std::optional<NameAndUnit> split_unit_suffix(std::string_view name);

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace sinew
