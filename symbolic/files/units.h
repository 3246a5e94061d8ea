// SPDX-License-Identifier: GPL-3.0-or-later
// The units a description may use, and their conversion to SI.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sinew {

enum class Dimension {
  none,
  length,
  angle,
  mass,
  inertia,
  velocity,
  angular_velocity,
  acceleration,
  angular_acceleration,
  force,
  stiffness,
  damping,
  angular_damping,
  torque,
  torque_constant,
  per_angle,
  per_angular_velocity,
  time,
  frequency
};

/// A unit: value in SI = value * times / over. Two factors, because 6 / 1000 is the double nearest
/// to 0.006 while 6 * 0.001 need not be.
struct MeasureUnit {
  std::string_view spelling;
  Dimension dimension;
  double times;
  double over;
};

/// The unit of that spelling; `kg*m^2`, `kg m^2`, `kg·m²` and `kg.m^2` are the same.
std::optional<MeasureUnit> find_unit(std::string_view spelling);

/// Whether both spell one unit, known or not: `N*m*s^2/rad^2` and `N m s²/rad²`.
bool same_spelling(std::string_view a, std::string_view b);

double to_si(double value, const MeasureUnit& unit);

/// For messages: the name of a dimension and the units it may be given in.
std::string_view name_of(Dimension dimension);
std::string units_of(Dimension dimension);

/// The SI unit's spelling.
std::string_view si_unit(Dimension dimension);

}  // namespace sinew
