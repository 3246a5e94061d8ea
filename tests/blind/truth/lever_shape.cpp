// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/lever_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sinew::trials {
namespace {

struct Point {
  double x = 0.0, y = 0.0;
};

/// One straight run between two round pulleys, touched on the given sides.
struct Run {
  double length, direction;
};

Run run_between(Point a, double side_radius_a, Point b, double side_radius_b) {
  const double dx = b.x - a.x, dy = b.y - a.y, k = side_radius_a - side_radius_b;
  const double length = std::sqrt(dx * dx + dy * dy - k * k);
  return {length, std::atan2(dy, dx) + std::atan2(k, length)};
}

/// Tendon from the motor's pulley to the fixed one; straight parts and arcs, up to a constant.
double path_length(const LeverShape& m, double angle) {
  const Point c{m.pivot_x + m.arm * std::cos(angle), m.pivot_y + m.arm * std::sin(angle)};
  const double r1 = m.motor_radius, r2 = -m.lever_radius, r3 = m.fixed_radius;
  const Run first = run_between({0.0, 0.0}, r1, c, r2),
            second = run_between(c, r2, {m.fixed_x, 0.0}, r3);
  return first.length + second.length + r1 * first.direction +
         r2 * (second.direction - first.direction) - r3 * second.direction;
}

double spring_length(const LeverShape& m, double angle) {
  const double a = angle + m.spring_angle;
  return std::hypot(m.pivot_x + m.spring_arm * std::cos(a) - m.anchor_x,
                    m.pivot_y + m.spring_arm * std::sin(a) - m.anchor_y);
}

double read(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const bool up = x.back() > x.front();
  std::size_t low = 0, high = x.size() - 1;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    ((x[middle] <= at) == up ? low : high) = middle;
  }
  const double s = (at - x[low]) / (x[high] - x[low]);
  return (1.0 - s) * y[low] + s * y[high];
}

}  // namespace

LeverCurve::LeverCurve(const LeverShape& m, double stiffer, double preload) {
  const double free = spring_length(m, m.rest) - preload, start = path_length(m, m.rest);
  const double stiffness = m.stiffness * (1.0 + stiffer);
  // The lever gives way in the direction that shortens the path.
  const double h = 1.0e-6;
  const double sign = path_length(m, m.rest + h) < start ? 1.0 : -1.0;
  for (int i = 0; i < 6400; ++i) {
    const double angle = m.rest + sign * i * 2.5e-4;
    const double slope = (path_length(m, angle + h) - path_length(m, angle - h)) / (2.0 * h);
    const double stretch = spring_length(m, angle) - free;
    const double spring_slope =
        (spring_length(m, angle + h) - spring_length(m, angle - h)) / (2.0 * h);
    const double x = start - path_length(m, angle);
    if (!std::isfinite(x) || (i > 0 && x <= elongation_.back())) break;
    angle_.push_back(angle);
    elongation_.push_back(x);
    force_.push_back(-stiffness * stretch * spring_slope / slope);
    if (x > 1.6 * m.reach) break;
  }
}

double LeverCurve::angle(double x) const {
  return read(elongation_, angle_, x);
}
double LeverCurve::force(double x) const {
  return read(elongation_, force_, x);
}
double LeverCurve::elongation_at(double angle) const {
  return read(angle_, elongation_, angle);
}
double LeverCurve::force_at(double angle) const {
  return read(angle_, force_, angle);
}

std::string lever_part(const LeverShape& m, double travel, double first_count, double last_count) {
  const auto value = [](const char* key, double x, const char* unit) {
    return fmt::format("{} = {{ value = {:.12g}, unit = \"{}\", from = \"assumed\" }}\n", key, x,
                       unit);
  };
  const auto point = [](const char* key, double x, double y) {
    return fmt::format("{} = {{ value = [{:.12g}, {:.12g}], unit = \"m\", from = \"assumed\" }}\n",
                       key, x, y);
  };
  std::string text = "[part]\nname = \"lever\"\n\n[lever]\n";
  text += point("motor_centre", 0.0, 0.0) + value("motor_radius", m.motor_radius, "m");
  text += "motor_sense = \"counter_clockwise\"\n" + point("fixed_centre", m.fixed_x, 0.0);
  text += value("fixed_radius", m.fixed_radius, "m") + "fixed_sense = \"counter_clockwise\"\n";
  text += point("pivot", m.pivot_x, m.pivot_y) + value("lever_length", m.arm, "m");
  text += value("pulley_radius", m.lever_radius, "m") + "pulley_sense = \"clockwise\"\n";
  text += value("spring_arm", m.spring_arm, "m") + value("spring_angle", m.spring_angle, "rad");
  text += point("anchor", m.anchor_x, m.anchor_y);
  text += value("spring_stiffness", m.stiffness, "N/m") + value("free_angle", m.rest, "rad");
  text += value("travel", travel, "m") + value("count_free", first_count, "1");
  return text + value("count_end", last_count, "1");
}

}  // namespace sinew::trials
