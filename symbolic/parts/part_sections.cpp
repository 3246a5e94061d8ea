// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/part_sections.h"

#include <fmt/format.h>

#include "symbolic/expressions/evaluate_function.h"

namespace sinew {
namespace {

/// A required number; 0 with the mistake reported where it is missing.
double number(TomlTable& table, std::string_view key, Dimension dimension) {
  const auto quantity = table.quantity(key, Shape::scalar, dimension, true);
  return quantity ? quantity->values[0] : 0.0;
}

double positive(TomlTable& table, std::string_view key, Dimension dimension) {
  const auto quantity = table.quantity(key, Shape::scalar, dimension, true);
  if (!quantity) return 1.0;
  if (!(quantity->values[0] > 0.0))
    table.report(key, table.path() + "." + std::string(key) + " is not positive",
                 "expected a number > 0");
  return quantity->values[0];
}

double not_negative(TomlTable& table, std::string_view key, Dimension dimension) {
  const double value = number(table, key, dimension);
  if (value < 0.0)
    table.report(key, table.path() + "." + std::string(key) + " is negative",
                 "expected a number >= 0");
  return value;
}

Range range(TomlTable& table, std::string_view key, Dimension dimension) {
  const auto quantity = table.quantity(key, Shape::pair, dimension, true);
  if (!quantity) return {0.0, 1.0};
  if (!(quantity->values[0] < quantity->values[1]))
    table.report(key, table.path() + "." + std::string(key) + " is empty", "expected low < high");
  return {quantity->values[0], quantity->values[1]};
}

Eigen::Vector2d point(TomlTable& table, std::string_view key) {
  const auto quantity = table.quantity(key, Shape::pair, Dimension::length, true);
  return quantity ? Eigen::Vector2d(quantity->values.data()) : Eigen::Vector2d::Zero();
}

Eigen::Vector3d point_in_space(TomlTable& table, std::string_view key) {
  const auto quantity = table.quantity(key, Shape::vector, Dimension::length, true);
  return quantity ? Eigen::Vector3d(quantity->values.data()) : Eigen::Vector3d::Zero();
}

/// "counter_clockwise" is +1.
int sense(TomlTable& table, std::string_view key) {
  const auto word = table.word(key, {"counter_clockwise", "clockwise"}, "");
  return word == "clockwise" ? -1 : 1;
}

Pulley pulley(TomlTable& table, const std::string& which) {
  return {point(table, which + "_centre"), positive(table, which + "_radius", Dimension::length),
          sense(table, which + "_sense")};
}

double share(TomlTable& table, std::string_view key) {
  const double value = number(table, key, Dimension::none);
  if (value < 0.0 || value >= 1.0)
    table.report(
        key,
        table.path() + "." + std::string(key) + " would feed in more energy than friction takes",
        "expected a share in 0..1, below 1");
  return value;
}

/// Every palm angle of the range of use must be one that the wrist reaches.
void check_reach(TomlTable& table, const WristParameters& p) {
  const Function inverse = wrist_bar_angles(p);
  const auto reached = [&](double flexion, double abduction) {
    const std::vector<double> q = evaluate(inverse, {flexion, abduction});
    return q[3] == 0.0 && q[2] < 1e-6;  // status, residual
  };
  const auto out = [&](const char* key) {
    table.report(key, table.path() + "." + key + " is out of the wrist's reach",
                 "expected palm angles that the links of these lengths allow");
  };
  if (!reached(p.flexion.low, 0) || !reached(p.flexion.high, 0)) return out("flexion");
  for (const double flexion : {0.0, p.flexion.low, p.flexion.high})
    for (const double abduction : {p.abduction.low, p.abduction.high})
      if (!reached(flexion, abduction)) return out("abduction");
}

}  // namespace

WristParameters read_wrist(TomlTable& table, std::vector<TomlTable> tendons) {
  WristParameters p;
  p.length = positive(table, "length", Dimension::length);
  p.width = positive(table, "width", Dimension::length);
  p.thickness = positive(table, "thickness", Dimension::length);
  p.motor_radius = positive(table, "motor_radius", Dimension::length);
  p.flexion = range(table, "flexion", Dimension::angle);
  p.abduction = range(table, "abduction", Dimension::angle);
  table.finish();
  if (tendons.empty())
    table.report("", "the wrist has no channel", "expected at least one [[channel]]");
  for (TomlTable& tendon : tendons) {
    p.forearm_points.push_back(point_in_space(tendon, "forearm"));
    p.palm_points.push_back(point_in_space(tendon, "palm"));
    tendon.finish();
  }
  if (!table.file().findings.any()) check_reach(table, p);
  return p;
}

FourBarParameters read_four_bar(TomlTable& table) {
  FourBarParameters p;
  p.ground = positive(table, "ground", Dimension::length);
  p.crank = positive(table, "crank", Dimension::length);
  p.coupler = positive(table, "coupler", Dimension::length);
  p.rocker = positive(table, "rocker", Dimension::length);
  p.branch = table.word("branch", {"open", "crossed"}, "") == "crossed" ? 1 : -1;
  p.pulley_radius = positive(table, "pulley_radius", Dimension::length);
  p.reference_theta2 = number(table, "reference_theta2", Dimension::angle);
  p.theta2 = range(table, "theta2", Dimension::angle);
  table.finish();
  if (table.file().findings.any()) return p;
  if (p.reference_theta2 < p.theta2.low || p.reference_theta2 > p.theta2.high)
    table.report("reference_theta2", "four_bar.reference_theta2 is outside theta2",
                 "expected a crank angle of the range of use");
  if (const auto angle = unreachable_crank_angle(p))
    table.report("theta2",
                 fmt::format("the four-bar locks or does not close at {:.6g} rad", *angle),
                 "expected links that close over the whole range of theta2");
  return p;
}

LeverParameters read_lever(TomlTable& table) {
  LeverParameters p;
  p.motor = pulley(table, "motor");
  p.fixed = pulley(table, "fixed");
  p.pivot = point(table, "pivot");
  p.lever_length = positive(table, "lever_length", Dimension::length);
  p.pulley_radius = positive(table, "pulley_radius", Dimension::length);
  p.pulley_sense = sense(table, "pulley_sense");
  p.spring_arm = positive(table, "spring_arm", Dimension::length);
  p.spring_angle = number(table, "spring_angle", Dimension::angle);
  p.anchor = point(table, "anchor");
  p.spring_stiffness = positive(table, "spring_stiffness", Dimension::stiffness);
  p.free_angle = number(table, "free_angle", Dimension::angle);
  const double travel = positive(table, "travel", Dimension::length);
  if (table.has("count_free")) p.count_free = number(table, "count_free", Dimension::none);
  if (table.has("count_end")) p.count_end = number(table, "count_end", Dimension::none);
  table.finish();
  if (table.file().findings.any()) return p;
  try {
    p.end_angle = lever_angle_at(p, travel);
  } catch (const std::exception&) {
    table.report("travel", "lever.travel is out of the lever's reach",
                 "expected an elongation that the lever can take up");
  }
  return p;
}

MotorParameters read_motor(TomlTable& table, std::vector<TomlTable> ripples) {
  MotorParameters p;
  p.gear_ratio = positive(table, "gear_ratio", Dimension::none);
  p.rotor_inertia = positive(table, "rotor_inertia", Dimension::inertia);
  p.gearbox_inertia = not_negative(table, "gearbox_inertia", Dimension::inertia);
  p.torque_constant = positive(table, "torque_constant", Dimension::torque_constant);
  p.pulley_radius = positive(table, "pulley_radius", Dimension::length);
  p.gamma1 = not_negative(table, "gamma1", Dimension::per_angular_velocity);
  p.gamma2 = not_negative(table, "gamma2", Dimension::torque);
  p.gamma3 = not_negative(table, "gamma3", Dimension::angular_damping);
  p.friction_compensation = share(table, "friction_compensation");
  p.ripple_compensation = share(table, "ripple_compensation");
  table.finish();
  for (TomlTable& ripple : ripples) {
    const bool input = ripple.word("side", {"output", "input"}, "") == "input";
    (input ? p.input_ripple : p.output_ripple)
        .push_back({positive(ripple, "order", Dimension::none),
                    not_negative(ripple, "amplitude", Dimension::torque),
                    number(ripple, "phase", Dimension::angle)});
    ripple.finish();
  }
  return p;
}

GuidingParameters read_fitted_guiding(TomlTable& table) {
  GuidingParameters p;
  p.C0 = not_negative(table, "C0", Dimension::force);
  p.C1 = not_negative(table, "C1", Dimension::per_angle);
  p.reversal_velocity = positive(table, "reversal_velocity", Dimension::velocity);
  table.finish();
  return p;
}

GuidingParameters read_capstan(TomlTable& table) {
  GuidingParameters p;
  p.friction_coefficient = not_negative(table, "friction_coefficient", Dimension::none);
  p.reversal_velocity = positive(table, "reversal_velocity", Dimension::velocity);
  table.finish();
  return p;
}

TendonParameters read_tendon(TomlTable& table) {
  TendonParameters p;
  p.axial_stiffness = positive(table, "axial_stiffness", Dimension::force);
  p.free_length = positive(table, "free_length", Dimension::length);
  table.finish();
  return p;
}

}  // namespace sinew
