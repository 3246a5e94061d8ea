// SPDX-License-Identifier: GPL-3.0-or-later
// Sensors as they are written: few digits, angles that are wrapped, values that are held, a drive
// that leads its reference; and header styles that name a channel.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "identification/logs/dequantise.h"
#include "identification/logs/read_csv.h"
#include "tests/identification/logs/planted_log.h"

namespace {

using namespace sinew;
using diagnosis::sensor_steps;
using diagnosis::SensorSteps;
using std::numbers::pi;
using Row = std::function<std::string(long)>;

/// time, theta, tau_m, theta_ref at 1 kHz.
Log read_rows(const Row& row, long rows = 12000) {
  std::string text = "time [s],theta [rad],tau_m [N*m],theta_ref [rad]\n";
  for (long k = 0; k < rows; ++k) text += fmt::format("{:.6f},{}\n", 0.001 * double(k), row(k));
  return read_csv(test::write_file("sensor.csv", text), rotary_drive_channels());
}

long count_of(const Log& log, FaultKind kind) {
  return std::count_if(log.faults.begin(), log.faults.end(),
                       [&](const DataFault& f) { return f.kind == kind; });
}

/// Strokes of constant acceleration with rests between them: rad, and rad/s^2.
struct Stroke {
  double position, acceleration;
};
Stroke stroke_at(double t) {
  const double s = std::fmod(std::max(t, 0.0), 4.0), length = 0.1;
  const auto half = [](double u) {
    return u < 0.5 ? 2.0 * u * u : 1.0 - 2.0 * (1.0 - u) * (1.0 - u);
  };
  const auto side = [&](double u) { return (u < 0.5 ? 4.0 : -4.0) / (length * length); };
  if (s < length) return {half(s / length), side(s / length)};
  if (s < 2.0) return {1.0, 0.0};
  const double back = s - 2.0;
  if (back < length) return {1.0 - half(back / length), -side(back / length)};
  return {0.0, 0.0};
}

double noise(long k) {
  return 0.03 * std::sin(1.0e4 * std::sin(double(k) * 12.9898));
}

}  // namespace

TEST_CASE(
    "one step of an encoder after a rest is no stuck sensor, however few digits are written") {
  // Seen to fail at 7 digits where quantum() takes the written digits' own step for the sensor's.
  const double step = 2.0 * pi / 524288.0;
  for (const int digits : {7, 8, 12}) {
    const Log log = read_rows([&](long k) {
      const double t = 0.001 * double(k);
      const double q = 1.7 * std::sin(0.9 * t) + 0.3 * std::sin(2.3 * t);
      return fmt::format("{:.{}g},{:.6f},{:.8f}", std::round(q / step) * step, digits,
                         -0.1 * q + noise(k), q);
    });
    INFO(digits << " digits");
    CHECK(count_of(log, FaultKind::stuck) == 0);
    CHECK(log.channels[0].quantum == Approx(step).epsilon(0.02));
  }
}

TEST_CASE("single precision and few digits are no second sensor") {
  // Seen to fail with the digits alone in last_digit(): the fourth kind, a float written in full,
  // looks like a sensor that was rounded again. Around 3 rad, since a float's own grid must be felt
  // there (around 0 the defect is not seen). The last kind is a sensor rounded again.
  const double step = 2.0 * pi / 131072.0, finer = 3.1e-6;
  const auto scatter_in_digits = [&](const std::function<std::string(double)>& written) {
    const Log log = read_rows([&](long k) {
      const double t = 0.001 * double(k);
      const double q = 3.0 + 0.7 * std::sin(0.9 * t) + 0.3 * std::sin(2.3 * t);
      return fmt::format("{},{:.6f},{:.8f}", written(std::round(q / step) * step),
                         -0.1 * q + noise(k), q);
    });
    const SensorSteps steps = sensor_steps(log.segments.front().samples.col(0).matrix());
    CHECK(steps.step == Approx(step).epsilon(0.001));
    return steps.scatter / log.channels[0].last_digit;
  };
  CHECK(scatter_in_digits([](double q) { return fmt::format("{:.6f}", q); }) < 1.0);
  CHECK(scatter_in_digits([](double q) { return fmt::format("{:.7g}", q); }) < 1.0);
  CHECK(scatter_in_digits([](double q) { return fmt::format("{:.17g}", q); }) < 1.0);
  CHECK(scatter_in_digits([](double q) { return fmt::format("{:.12g}", double(float(q))); }) < 1.0);
  CHECK(scatter_in_digits(
            [&](double q) { return fmt::format("{:.12g}", std::round(q / finer) * finer); }) > 1.0);
}

TEST_CASE("a triangle that turns round under a coarse sensor is not cut off") {
  // Seen to fail with turns_round() (data_faults.cpp) never true.
  for (const double bits : {12.0, 14.0, 16.0})
    for (const double hertz : {0.6, 1.3, 2.9}) {
      const double step = 2.0 * pi / std::exp2(bits);
      const Log log = read_rows([&](long k) {
        const double t = 0.001 * double(k);
        const double q = 0.24 * std::asin(0.995 * std::sin(2.0 * pi * hertz * t));
        return fmt::format("{:.8f},{:.6f},{:.8f}", std::round(q / step) * step, -0.1 * q + noise(k),
                           q);
      });
      INFO(bits << " bits, " << hertz << " Hz");
      CHECK(count_of(log, FaultKind::clipping) == 0);
    }
}

TEST_CASE("a load or a guide that is set and held is not cut off at its largest setting") {
  // Seen to fail without is_setting() (data_faults.cpp).
  std::string text = "time [s],theta [rad],tau_m [N*m],load [N*m]\n";
  const double settings[] = {0.4, 1.1, 0.7, 1.1};
  for (long k = 0; k < 12000; ++k) {
    const double t = 0.001 * double(k);
    text += fmt::format("{:.6f},{:.8f},{:.6f},{:.6f}\n", t, std::sin(1.7 * t),
                        0.2 * std::cos(1.7 * t) + noise(k), settings[k / 3000]);
  }
  const Log log = read_csv(test::write_file("setting.csv", text), rotary_drive_channels());
  CHECK(count_of(log, FaultKind::clipping) == 0);
}

TEST_CASE("a lever's log in other units than its model is refused with the channel's name") {
  // Seen to fail with channels of any range: nothing was told of either.
  const auto refused = [](const char* count, const char* bend) {
    std::string text = "time [s],count [1],force [N],bend [rad]\n";
    for (long k = 0; k < 4000; ++k) {
      const double t = 0.002 * double(k), angle = 0.5 - 0.5 * std::cos(1.3 * t);
      text += fmt::format("{:.6f},{},{:.6f},{}\n", t,
                          fmt::format(fmt::runtime(count), std::round(40.0 + 4000.0 * angle)),
                          30.0 + 90.0 * angle + noise(k), bend);
    }
    return test::write_file("lever.csv", text);
  };
  CHECK_NOTHROW(read_csv(refused("{:.0f}", "1.75"), lever_channels(40.0, 4040.0)));
  CHECK_THROWS_WITH(read_csv(refused("{:.0f}e-3", "1.75"), lever_channels(40.0, 4040.0)),
                    Catch::Contains("'count' never exceeds 4.04"));
  CHECK_THROWS_WITH(read_csv(refused("{:.0f}", "100.3"), lever_channels(40.0, 4040.0)),
                    Catch::Contains("'bend' reaches 100.3"));
}

TEST_CASE("a drive that leads a reference without noise is not exchanged with it") {
  // Seen to fail where the steps of the acceleration count as noise (noise_of()).
  const double step = 1.0e-6;
  const Log log = read_rows([&](long k) {
    const double t = 0.001 * double(k);
    double smooth = 0.0;  // the load rounds off what the reference asks
    for (int i = -6; i <= 6; ++i) smooth += stroke_at(t + 0.0022 + 0.001 * i).position / 13.0;
    return fmt::format("{:.8f},{:.6f},{:.10f}", std::round(smooth / step) * step,
                       0.001 * stroke_at(t).acceleration + noise(k), stroke_at(t).position);
  });
  CHECK(count_of(log, FaultKind::swapped_columns) == 0);
}

TEST_CASE("an angle that is wrapped is joined and told; a command of a full turn is left alone") {
  // Seen to fail where no FullTurns are followed: the jumps stay.
  for (const double turn : {2.0 * pi, 360.0}) {
    const bool degrees = turn > 100.0;
    std::string text = fmt::format("time [s],theta [{}],tau_m [N*m]\n", degrees ? "deg" : "rad");
    for (long k = 0; k < 8000; ++k) {
      const double q = 2.4 * std::sin(0.0019 * double(k));
      const double raw = q * turn / (2.0 * pi);
      text += fmt::format("{:.6f},{:.7g},{:.6f}\n", 0.001 * double(k),
                          raw - turn * std::floor(raw / turn), -q + noise(k));
    }
    const Log log = read_csv(test::write_file("wrapped.csv", text), rotary_drive_channels());
    REQUIRE(count_of(log, FaultKind::wrapped_angle) == 1);
    const auto fault = std::find_if(log.faults.begin(), log.faults.end(), [](const DataFault& f) {
      return f.kind == FaultKind::wrapped_angle;
    });
    CHECK(fault->column == 2);
    CHECK(fault->row > 1600);
    CHECK(fault->row < 1700);
    CHECK(log.channels[0].low == Approx(-2.4).margin(0.01));
    CHECK(log.channels[0].high == Approx(2.4).margin(0.01));
  }
  const Log log = read_rows([](long k) {
    const double t = 0.001 * double(k), since = std::fmod(t, 6.0);
    const double command = since < 3.0 ? 0.0 : 2.0 * pi;
    const double q = since < 3.0 ? 2.0 * pi * std::exp(-4.0 * since) * (t > 3.0)
                                 : 2.0 * pi * (1.0 - std::exp(-4.0 * (since - 3.0)));
    return fmt::format("{:.8f},{:.6f},{:.6f}", q, noise(k), command);
  });
  CHECK(count_of(log, FaultKind::wrapped_angle) == 0);
  CHECK(log.channels[2].high == Approx(2.0 * pi).margin(1e-5));
}

TEST_CASE("an effort that is fresh every tenth row is told, and not that it is clipped") {
  // Seen to fail where rows_a_value() is 1: clipped at its largest value, and nothing held.
  const Log log = read_rows([](long k) {
    const double t = 0.001 * double(k), fresh = 0.01 * double(k / 10);
    const double q = std::sin(1.7 * t), tau = std::round(400.0 * std::sin(3.1 * fresh)) / 400.0;
    return fmt::format("{:.8f},{:.6f},{:.8f}", q, tau, q);
  });
  CHECK(count_of(log, FaultKind::clipping) == 0);
  REQUIRE(count_of(log, FaultKind::held_samples) == 1);
  const auto fault = std::find_if(log.faults.begin(), log.faults.end(), [](const DataFault& f) {
    return f.kind == FaultKind::held_samples;
  });
  CHECK(fault->channel == "tau_m");
  CHECK(fault->meaning.find("every 10 rows") != std::string::npos);
}

TEST_CASE("a header names a channel with its unit in any of the styles") {
  // Seen to fail where the raw text is searched for "theta_1 " and "theta_1[".
  for (const char* cell :
       {"theta_1 [rad]", "theta_1[rad]", "theta_1(rad)", "theta_1_rad", "Theta_1"})
    CHECK(names_channel({"time [s]", cell}, {}, "theta_1"));
  CHECK(names_channel({"time [s]", "a"}, {"theta_1 = a [rad]"}, "theta_1"));
  CHECK_FALSE(names_channel({"time [s]", "theta_10 [rad]"}, {"theta_11=a"}, "theta_1"));
}
