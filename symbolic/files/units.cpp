// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/units.h"

#include <array>
#include <numbers>
#include <utility>

namespace sinew {
namespace {

using std::numbers::pi;

// The first unit of a dimension is its SI unit.
constexpr std::array<MeasureUnit, 45> all_units{{
    {"1", Dimension::none, 1, 1},
    {"m", Dimension::length, 1, 1},
    {"cm", Dimension::length, 1, 100},
    {"mm", Dimension::length, 1, 1000},
    {"rad", Dimension::angle, 1, 1},
    {"deg", Dimension::angle, pi, 180},
    {"kg", Dimension::mass, 1, 1},
    {"g", Dimension::mass, 1, 1000},
    {"kg*m^2", Dimension::inertia, 1, 1},
    {"kg*cm^2", Dimension::inertia, 1, 1e4},
    {"kg*mm^2", Dimension::inertia, 1, 1e6},
    {"g*m^2", Dimension::inertia, 1, 1e3},
    {"g*cm^2", Dimension::inertia, 1, 1e7},
    {"g*mm^2", Dimension::inertia, 1, 1e9},
    {"m/s", Dimension::velocity, 1, 1},
    {"mm/s", Dimension::velocity, 1, 1000},
    {"rad/s", Dimension::angular_velocity, 1, 1},
    {"deg/s", Dimension::angular_velocity, pi, 180},
    {"m/s^2", Dimension::acceleration, 1, 1},
    {"mm/s^2", Dimension::acceleration, 1, 1000},
    {"rad/s^2", Dimension::angular_acceleration, 1, 1},
    {"deg/s^2", Dimension::angular_acceleration, pi, 180},
    {"N", Dimension::force, 1, 1},
    {"mN", Dimension::force, 1, 1000},
    {"kN", Dimension::force, 1000, 1},
    {"N/m", Dimension::stiffness, 1, 1},
    {"N/mm", Dimension::stiffness, 1000, 1},
    {"kN/m", Dimension::stiffness, 1000, 1},
    {"N*s/m", Dimension::damping, 1, 1},
    {"N*s/mm", Dimension::damping, 1000, 1},
    {"N*m*s/rad", Dimension::angular_damping, 1, 1},
    {"N*mm*s/rad", Dimension::angular_damping, 1, 1000},
    {"N*m", Dimension::torque, 1, 1},
    {"N*mm", Dimension::torque, 1, 1000},
    {"mN*m", Dimension::torque, 1, 1000},
    {"N*m/A", Dimension::torque_constant, 1, 1},
    {"mN*m/A", Dimension::torque_constant, 1, 1000},
    {"1/rad", Dimension::per_angle, 1, 1},
    {"s/rad", Dimension::per_angular_velocity, 1, 1},
    {"s", Dimension::time, 1, 1},
    {"ms", Dimension::time, 1, 1000},
    {"us", Dimension::time, 1, 1e6},
    {"min", Dimension::time, 60, 1},
    {"Hz", Dimension::frequency, 1, 1},
    {"kHz", Dimension::frequency, 1000, 1},
}};

void replace_all(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

std::string normalised(std::string_view spelling) {
  std::string text(spelling);
  while (!text.empty() && text.back() == ' ') text.pop_back();
  text.erase(0, text.find_first_not_of(' ') == std::string::npos ? 0 : text.find_first_not_of(' '));
  using Pair = std::pair<std::string_view, std::string_view>;
  for (const auto& [what, with] :
       {Pair{"²", "^2"}, Pair{"·", "*"}, Pair{"⋅", "*"}, Pair{" * ", "*"}, Pair{" / ", "/"},
        Pair{" ", "*"}, Pair{".", "*"}})
    replace_all(text, what, with);
  return text;
}

}  // namespace

std::optional<MeasureUnit> find_unit(std::string_view spelling) {
  const std::string wanted = normalised(spelling);
  for (const MeasureUnit& unit : all_units)
    if (unit.spelling == wanted) return unit;
  return std::nullopt;
}

bool same_spelling(std::string_view a, std::string_view b) {
  return normalised(a) == normalised(b);
}

double to_si(double value, const MeasureUnit& unit) {
  return value * unit.times / unit.over;
}

std::string_view name_of(Dimension dimension) {
  static constexpr std::array<std::string_view, 19> names{"pure number",
                                                          "length",
                                                          "angle",
                                                          "mass",
                                                          "inertia",
                                                          "velocity",
                                                          "angular velocity",
                                                          "acceleration",
                                                          "angular acceleration",
                                                          "force",
                                                          "stiffness",
                                                          "damping",
                                                          "angular damping",
                                                          "torque",
                                                          "torque constant",
                                                          "inverse angle",
                                                          "inverse angular velocity",
                                                          "time",
                                                          "frequency"};
  return names[static_cast<std::size_t>(dimension)];
}

std::string units_of(Dimension dimension) {
  std::string list;
  for (const MeasureUnit& unit : all_units)
    if (unit.dimension == dimension)
      list += (list.empty() ? "" : ", ") + std::string(unit.spelling);
  return list;
}

std::string_view si_unit(Dimension dimension) {
  for (const MeasureUnit& unit : all_units)
    if (unit.dimension == dimension) return unit.spelling;
  return "1";
}

}  // namespace sinew
