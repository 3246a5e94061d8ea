// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/axis.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tests/blind/truth/random_draw.h"

namespace sinew::trials {
namespace {

const char* const on_axis[] = {"coulomb_level",
                               "viscous_level",
                               "viscous_asymmetry",
                               "coulomb_asymmetry",
                               "stribeck",
                               "concave_friction",
                               "load_friction",
                               "friction_drift",
                               "position_friction",
                               "input_ripple",
                               "output_ripple",
                               "load_ripple",
                               "inertia",
                               "offset",
                               "spring",
                               "cable_torque",
                               "speed_memory",
                               "latch",
                               "other_stage",
                               "tight_under_load",
                               "handling",
                               "grease",
                               "debris",
                               "unlogged_force"};

/// 0 or 1 in stretches of about `length` seconds, the same whenever it is asked.
double comes_and_goes(std::uint64_t seed, double time, double length) {
  const double at = std::floor(time / length);
  truth::Draw draw(seed + static_cast<std::uint64_t>(at < 0.0 ? 0.0 : at) * 7919u);
  return draw.chance(0.5) ? 1.0 : 0.0;
}

/// Somebody knocks against it: every other time or so, for a third of a second.
double push_of(const Hidden& h, const Instant& now) {
  const double pi = std::numbers::pi;
  constexpr double block = 2.1, begins = 0.9, length = 0.33;
  const double since = std::fmod(now.time, block) - begins;
  if (since < 0.0 || since > length) return 0.0;
  return h.dose * comes_and_goes(h.seed, now.time, block) * std::sin(pi * since / length);
}

}  // namespace

bool acts_on_axis(const std::string& cause) {
  return std::find(std::begin(on_axis), std::end(on_axis), cause) != std::end(on_axis);
}

Axis::Axis(AxisModel model, Bristle bristle, std::vector<Hidden> hidden)
    : model_(model), bristle_(bristle), hidden_(std::move(hidden)) {
  std::erase_if(hidden_, [](const Hidden& h) { return !acts_on_axis(h.cause); });
}

double Axis::sliding(double speed) const {
  if (model_.turning <= 0.0) return model_.level;
  return model_.level * 2.0 / pi * std::atan(speed / model_.turning);
}

void Axis::turn(double v, double step) {
  const double side = v < 0.0 ? -1.0 : 1.0, way = std::abs(v) * step / bristle_.way;
  memory_.last_z = memory_.z;
  if (bristle_.law == 1) {
    const double grip = side * memory_.z > 0.0 ? memory_.z * memory_.z : 0.0;
    memory_.z = std::clamp(memory_.z + side * way * (1.0 - grip) / (1.0 + way), -1.0, 1.0);
  } else {
    memory_.z = side + (memory_.z - side) * std::exp(-way);
  }
}

double Axis::slope(double v, double step) const {
  const double side = v < 0.0 ? -1.0 : 1.0, way = std::abs(v) * step / bristle_.way;
  const double s = model_.turning > 0.0 ? std::abs(v) / model_.turning : 0.0;
  const double over_speed =
      model_.turning > 0.0 ? model_.level * 2.0 / pi / (model_.turning * (1.0 + s * s)) : 0.0;
  const double g = std::max(sliding(std::abs(v)), 0.0);
  return model_.viscous + over_speed +
         g * std::max(0.0, 1.0 - side * memory_.z) * step / bristle_.way * std::exp(-way);
}

double Axis::resist(const Instant& now, double step) {
  turn(now.v, step);
  double z = memory_.z;
  // LuGre's bristles are damped: friction is a little ahead of their deflection.
  if (bristle_.law == 2) z = std::clamp(memory_.z + 0.3 * (memory_.z - memory_.last_z), -1.0, 1.0);
  double effort = sliding(std::abs(now.v)) * z + model_.viscous * now.v;
  if (memory_.last_v * now.v < 0.0) {
    if (std::abs(now.q - memory_.turned_at) > 0.3 * model_.range)
      memory_.latched = memory_.last_v > 0.0 ? 1.0 : -1.0;
    memory_.turned_at = now.q;
    ++memory_.strokes;
  }
  memory_.last_v = now.v;
  // Grease breaks down over a third of the way to and fro, and is stiff again after three seconds.
  memory_.sheared += step * ((1.0 - memory_.sheared) * std::abs(now.v) / (0.6 * model_.range) -
                             memory_.sheared / 3.0);
  memory_.fastest = std::max(std::abs(now.v), memory_.fastest * std::exp(-step / 4.0));
  for (const Hidden& h : hidden_) effort += of(h, now, step);
  return effort;
}

double Axis::would_resist(const Instant& now, double step) {
  const Memory before = memory_;
  const double effort = resist(now, step);
  memory_ = before;
  return effort;
}

double Axis::of(const Hidden& h, const Instant& now, double) {
  if (h.cause == "viscous_level") return h.dose * now.v;
  if (h.cause == "viscous_asymmetry") return h.dose * std::abs(now.v);
  if (h.cause == "inertia") return h.dose * now.a;
  if (h.cause == "offset") return h.dose;
  if (h.cause == "unlogged_force") return push_of(h, now);
  if (h.cause.find("ripple") != std::string::npos || h.cause == "spring" ||
      h.cause == "cable_torque")
    return place_of(h, now);
  if (h.cause == "speed_memory" || h.cause == "latch" || h.cause == "other_stage" ||
      h.cause == "tight_under_load" || h.cause == "handling" || h.cause == "grease" ||
      h.cause == "debris")
    return outside_of(h, now);
  return friction_of(h, now);
}

/// Everything that friction's direction turns.
double Axis::friction_of(const Hidden& h, const Instant& now) const {
  const double speed = std::abs(now.v), v = model_.top_speed;
  if (h.cause == "coulomb_level") return h.dose * memory_.z * (sliding(speed) / model_.level);
  if (h.cause == "coulomb_asymmetry")
    return h.dose * std::abs(memory_.z) * sliding(speed) / model_.level;
  if (h.cause == "load_friction") return h.dose * std::abs(now.load) * memory_.z;
  if (h.cause == "position_friction") return h.dose * memory_.z * now.q / model_.range;
  if (h.cause == "stribeck") {
    const double s = speed / (h.width * v);
    return h.dose * memory_.z *
           (h.law == 0   ? std::exp(-s * s)
            : h.law == 1 ? std::exp(-s)
                         : 1.0 / (1.0 + s * s));
  }
  if (h.cause == "concave_friction") {
    const double s = speed / v, bend = h.width;
    return h.dose * memory_.z *
           (h.law == 0   ? std::sqrt(s)
            : h.law == 1 ? std::tanh(s / bend)
                         : s / (s + bend));
  }
  // friction_drift
  const double t = now.time / h.width;
  return h.dose * memory_.z * (h.law == 0 ? 1.0 - std::exp(-t) : t / (1.0 + t));
}

/// Everything that the position makes.
double Axis::place_of(const Hidden& h, const Instant& now) const {
  const double turn = h.cause == "output_ripple" ? model_.output_turn : model_.motor_turn;
  const double angle = 2.0 * pi * static_cast<double>(h.law) * now.q / turn + h.phase;
  if (h.cause == "load_ripple") return h.dose * now.load * std::sin(angle);
  // A real ripple is no pure sine.
  if (h.cause == "input_ripple" || h.cause == "output_ripple")
    return h.dose * std::sin(angle + 0.12 * std::sin(angle));
  const double x = now.q / model_.range;
  if (h.cause == "spring") return h.dose * now.q;
  return h.dose * (h.law == 0 ? std::sinh(1.5 * x + h.phase * 0.2) - std::sinh(h.phase * 0.2)
                              : std::sin(1.3 * x + 0.3 * h.phase));
}

double Axis::outside_of(const Hidden& h, const Instant& now) {
  const double s = std::sin(h.phase) * 0.4;
  if (h.cause == "speed_memory")
    return h.dose * memory_.z * (1.0 - std::exp(-memory_.fastest / (0.4 * model_.top_speed)));
  if (h.cause == "latch") return h.dose * memory_.latched;
  if (h.cause == "other_stage") {
    // An order that no tooth count gives, swinging with a second one.
    const double x = 2.0 * pi * now.q / model_.motor_turn;
    return h.dose * std::sin(0.5857 * x + h.phase) * (1.0 + 0.5 * std::sin(0.1716 * x));
  }
  if (h.cause == "tight_under_load") {
    const double x = now.q / model_.range - s;
    return h.dose * memory_.z * std::abs(now.load) * std::exp(-8.0 * x * x);
  }
  if (h.cause == "handling") return h.dose * now.a * comes_and_goes(h.seed, now.time, 2.9);
  if (h.cause == "grease") return h.dose * now.v * (1.0 - memory_.sheared);
  // debris: a chip that is caught in one stroke and not in the next.
  truth::Draw draw(h.seed + memory_.strokes * 7919u);
  return h.dose * memory_.z * draw.uniform(0.0, 1.0);
}

}  // namespace sinew::trials
