// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/hand/hand_table.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "runtime/sinew_checksum.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/hand/hand_members.h"

namespace sinew {
namespace {

constexpr int lever_samples = 129;
constexpr int digits = 12;  // that a fit's coefficients have on every machine

struct Composed {
  const char* name;
  int joints, tendons;
};
constexpr std::array<Composed, HAND_FINGERS> composed{
    {{"thumb", 4, 8}, {"index", 4, 8}, {"middle", 4, 8}, {"ring", 3, 6}, {"fifth", 3, 6}}};

/// The rounding of a fit's last digits differs between machines.
double rounded(double value) {
  return std::stod(fmt::format("{:.{}g}", value, digits));
}

void check_composition(const Hand& hand) {
  bool same = hand.fingers.size() == composed.size() && hand.has_four_bar() &&
              hand.wrist.forearm_points.size() == HAND_TENDONS;
  for (std::size_t f = 0; same && f < composed.size(); ++f) {
    const Mechanism& finger = hand.fingers[f].mechanism;
    same = finger.name == composed[f].name && Coordinates(finger).count() == composed[f].joints &&
           static_cast<int>(finger.tendons.size()) == composed[f].tendons;
  }
  if (!same)
    throw std::invalid_argument(
        hand.name +
        ": firmware/hand is composed for thumb, index, middle (4 joints, 8 tendons), ring, fifth "
        "(3 joints, 6 tendons), a four-bar and a wrist of 38 channels; for another hand change "
        "firmware/hand/hand_fingers.c and hand_parameters.h with it");
}

/// Least squares over the samples, in extended precision.
std::vector<double> fitted(const std::vector<double>& u, const std::vector<double>& values) {
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const auto rows = static_cast<Eigen::Index>(u.size());
  Matrix A(rows, HAND_LEVER_TERMS);
  Eigen::Matrix<long double, Eigen::Dynamic, 1> b(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    long double power = 1.0L;
    for (Eigen::Index j = 0; j < HAND_LEVER_TERMS;
         ++j, power *= static_cast<long double>(u[static_cast<std::size_t>(i)]))
      A(i, j) = power;
    b(i) = static_cast<long double>(values[static_cast<std::size_t>(i)]);
  }
  const auto x = A.householderQr().solve(b).eval();
  std::vector<double> result;
  for (const long double c : x) result.push_back(rounded(static_cast<double>(c)));
  return result;
}

double value_at(const double* c, double u) {
  double value = 0.0;
  for (int i = HAND_LEVER_TERMS; i-- > 0;) value = value * u + c[i];
  return value;
}

/// Polynomials of one lever and its tendon over the sensor's counts, from their closed forms.
hand_lever lever_of(const TendonWithLever& from, HandTable& table) {
  const LeverParameters& p = from.lever;
  const double softness = from.tendon.free_length / from.tendon.axial_stiffness;
  const Function state = lever_state(p), series = tendon_series_stiffness(from.tendon);
  std::vector<double> u, force, elongation, stiffness;
  for (int i = 0; i < lever_samples; ++i) {
    u.push_back(-std::cos(std::numbers::pi * (i + 0.5) / lever_samples));
    const double share = 0.5 * (u.back() + 1.0);
    const auto at = rounded_values(state, {p.free_angle + share * (p.end_angle - p.free_angle)});
    elongation.push_back(at[1] + softness * at[2]);
    force.push_back(at[2]);
    stiffness.push_back(rounded_values(series, {at[3]})[0]);
  }
  hand_lever lever{};
  lever.centre = 0.5 * (p.count_free + p.count_end);
  lever.inverse = 2.0 / (p.count_end - p.count_free);
  const auto put = [&](const std::vector<double>& values, double* to, double& error) {
    const std::vector<double> c = fitted(u, values);
    std::copy(c.begin(), c.end(), to);
    for (std::size_t i = 0; i < u.size(); ++i)
      error = std::max(error, std::abs(value_at(to, u[i]) - values[i]));
  };
  put(force, lever.force, table.force_error);
  put(elongation, lever.elongation, table.elongation_error);
  put(stiffness, lever.stiffness, table.stiffness_error);
  return lever;
}

/// Of lever and tendon at a force, on the polynomials [m].
double elongation_at(const hand_lever& lever, double force) {
  double low = -1.0, high = 1.0;
  if (value_at(lever.force, low) > force || value_at(lever.force, high) < force)
    throw std::invalid_argument("the pretension is beyond the lever's travel");
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (value_at(lever.force, middle) < force ? low : high) = middle;
  }
  return value_at(lever.elongation, low);
}

std::uint32_t ticks_of(double time, double period) {
  return static_cast<std::uint32_t>(std::lround(time / period));
}

sinew_channel_limits limits_of(const SensorSettings& s, double period, double safe) {
  sinew_channel_limits limits{};
  limits.low = s.low;
  limits.high = s.high;
  limits.largest_step = s.largest_step;
  limits.safe = safe;
  limits.hold_ticks = ticks_of(s.hold, period);
  limits.frozen_ticks = ticks_of(s.frozen, period);
  limits.settle_ticks = std::max(1U, ticks_of(s.settle, period));
  return limits;
}

void put_wrist(const HandTableSources& from, hand_parameters& t) {
  const std::vector<double> reference = rounded_reference(from.hand.wrist);
  const std::vector<Range> ranges = bar_ranges(from.hand.wrist);
  const SensorSettings& s = from.settings.wrist;
  for (std::size_t i = 0; i < 2; ++i) {
    t.wrist_reference[i] = reference[i];
    t.wrist_low[i] = ranges[i].low;
    t.wrist_high[i] = ranges[i].high;
    const double low = ranges[i].low - from.settings.wrist_margin,
                 high = ranges[i].high + from.settings.wrist_margin;
    t.wrist_scale[i] = (high - low) / (s.high - s.low);
    t.wrist_offset[i] = low - s.low * t.wrist_scale[i];
  }
  t.wrist_limits = limits_of(s, t.period, 0.5 * (s.low + s.high));
}

/// Channels, coordinates and joint ranges.
void put_groups(const Hand& hand, hand_parameters& t) {
  std::uint32_t tendon = 0, coordinate = 0;
  const HandStart start(hand);
  for (std::size_t group = 0; group < HAND_GROUPS; ++group) {
    const bool crank = group == HAND_FINGERS;
    t.first_tendon[group] = tendon;
    t.first_coordinate[group] = coordinate;
    for (const int channel : crank ? hand.four_bar_channels : hand.fingers[group].channels)
      t.channel[tendon++] = static_cast<std::uint32_t>(channel);
    if (!crank) coordinate += static_cast<std::uint32_t>(composed[group].joints);
  }
  for (std::size_t j = 0; j < HAND_COORDINATES; ++j) {
    t.joint_low[j] = start.q.ranges[j].low;
    t.joint_high[j] = start.q.ranges[j].high;
  }
}

/// R theta + h - x of every tendon, motors at 0, joints at 0 and the crank at its reference.
void put_closure(const HandTableSources& from, hand_parameters& t) {
  const double first = elongation_at(t.lever[0], t.pretension);
  std::vector<double> at(HAND_COORDINATES, 0.0);
  at.back() = t.crank_reference;
  at.insert(at.end(), t.wrist_reference, t.wrist_reference + 2);
  const std::vector<double> h = rounded_values(hand_tendon_lengths(from.hand), at);
  for (std::size_t i = 0; i < HAND_TENDONS; ++i) t.closure[i] = rounded(h[i] - first);
}

class Writer {
 public:
  void line(const std::string& text) { text_ += "    " + text + "\n"; }
  void numbers(const char* name, const double* values, int count) {
    list(name, count, [&](int i) { return fmt::format("{:.17g}", values[i]); });
  }
  void numbers(const char* name, const std::uint32_t* values, int count) {
    list(name, count, [&](int i) { return fmt::format("{}U", values[i]); });
  }
  void number(const char* name, double value) { line(fmt::format(".{} = {:.17g},", name, value)); }
  void number(const char* name, std::uint32_t value) {
    line(fmt::format(".{} = {}U,", name, value));
  }
  const std::string& text() const { return text_; }

 private:
  template <typename Each>
  void list(const char* name, int count, Each each) {
    std::string row = fmt::format(".{} = {{", name);
    for (int i = 0; i < count; ++i) {
      const std::string next = each(i) + (i + 1 < count ? ", " : "},");
      if (row.size() + next.size() > 90) {
        line(row);
        row = "    ";
      }
      row += next;
    }
    line(row);
  }
  std::string text_;
};

std::string limits_text(const sinew_channel_limits& l) {
  return fmt::format("{{{:.17g}, {:.17g}, {:.17g}, {:.17g}, {}U, {}U, {}U, 0U}},", l.low, l.high,
                     l.largest_step, l.safe, l.hold_ticks, l.frozen_ticks, l.settle_ticks);
}

}  // namespace

HandTable hand_table(const HandTableSources& from) {
  check_composition(from.hand);
  HandTable result{};
  hand_parameters& t = result.parameters;
  const StepSettings& s = from.settings;
  t.period = s.period;
  t.motor_radius = from.motor.pulley_radius;
  t.pretension = s.pretension;
  t.rate_share = rounded(1.0 - std::exp(-2.0 * std::numbers::pi * s.rate_filter * s.period));
  t.servo_gain = s.servo_gain;
  t.servo_rate_gain = s.servo_rate_gain;
  t.torque_limit = s.torque_limit;
  t.reference_rate = s.reference_rate;
  t.crank_reference = from.hand.four_bar.reference_theta2;
  const LeverParameters& lever = from.tendon.lever;
  t.lever[0] = lever_of(from.tendon, result);
  for (hand_lever& each : t.lever) each = t.lever[0];
  t.least_stiffness = rounded(value_at(t.lever[0].stiffness, -1.0));
  t.motor_limits = limits_of(s.motor, t.period, 0.0);
  t.lever_limits = limits_of(s.lever, t.period, lever.count_free);
  put_wrist(from, t);
  put_groups(from.hand, t);
  put_closure(from, t);
  t.turns = static_cast<std::uint32_t>(s.turns);
  t.restart_ticks = std::max(1U, ticks_of(s.restart, t.period));
  t.version = HAND_TABLE_VERSION;
  t.checksum = sinew_checksum(0U, &t, offsetof(hand_parameters, checksum));
  return result;
}

std::string hand_table_text(const hand_parameters& t, const std::string& origin) {
  Writer w;
  w.number("period", t.period);
  w.number("motor_radius", t.motor_radius);
  w.number("pretension", t.pretension);
  w.number("least_stiffness", t.least_stiffness);
  w.number("rate_share", t.rate_share);
  w.number("servo_gain", t.servo_gain);
  w.number("servo_rate_gain", t.servo_rate_gain);
  w.number("torque_limit", t.torque_limit);
  w.number("reference_rate", t.reference_rate);
  w.numbers("wrist_offset", t.wrist_offset, 2);
  w.numbers("wrist_scale", t.wrist_scale, 2);
  w.numbers("wrist_reference", t.wrist_reference, 2);
  w.numbers("wrist_low", t.wrist_low, 2);
  w.numbers("wrist_high", t.wrist_high, 2);
  w.number("crank_reference", t.crank_reference);
  w.line(".motor_limits = " + limits_text(t.motor_limits));
  w.line(".lever_limits = " + limits_text(t.lever_limits));
  w.line(".wrist_limits = " + limits_text(t.wrist_limits));
  w.numbers("closure", t.closure, HAND_TENDONS);
  for (int i = 0; i < HAND_TENDONS; ++i) {
    const std::string at = fmt::format("lever[{}]", i);
    w.number((at + ".centre").c_str(), t.lever[i].centre);
    w.number((at + ".inverse").c_str(), t.lever[i].inverse);
    w.numbers((at + ".force").c_str(), t.lever[i].force, HAND_LEVER_TERMS);
    w.numbers((at + ".elongation").c_str(), t.lever[i].elongation, HAND_LEVER_TERMS);
    w.numbers((at + ".stiffness").c_str(), t.lever[i].stiffness, HAND_LEVER_TERMS);
  }
  w.numbers("joint_low", t.joint_low, HAND_COORDINATES);
  w.numbers("joint_high", t.joint_high, HAND_COORDINATES);
  w.numbers("channel", t.channel, HAND_TENDONS);
  w.numbers("first_tendon", t.first_tendon, HAND_GROUPS);
  w.numbers("first_coordinate", t.first_coordinate, HAND_GROUPS);
  w.number("turns", t.turns);
  w.number("restart_ticks", t.restart_ticks);
  w.line(".version = HAND_TABLE_VERSION,");
  w.line(fmt::format(".checksum = 0x{:08x}U}};", t.checksum));
  return "/* SPDX-License-Identifier: BSD-2-Clause\n *\n" + origin +
         " * Do not edit: change the model or real_time.toml and make it again.\n */\n"
         "#include \"hand_parameters.h\"\n\nconst hand_parameters hand_parameters_table = {\n" +
         w.text();
}

}  // namespace sinew
