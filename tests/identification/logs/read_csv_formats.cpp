// SPDX-License-Identifier: GPL-3.0-or-later
// CSV as tools write it: separators, units, names, quotes, marks.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "identification/logs/read_csv.h"
#include "identification/logs/sha256.h"
#include "identification/logs/units.h"
#include "tests/identification/logs/planted_log.h"

using namespace sinew;
using sinew::test::write_file;

namespace {

struct Style {
  std::string header = "time [s],theta [rad],tau_m [N·m]\n";
  char delimiter = ',';
  char decimal = '.';
  std::string line_end = "\n";
  bool quotes = false;
  double time = 1.0, theta = 1.0, tau = 1.0;  // factors of the numbers written
};

std::string cell(double value, const Style& style) {
  std::string text = fmt::format("{:.10g}", value);
  for (char& c : text)
    if (c == '.') c = style.decimal;
  return style.quotes ? '"' + text + '"' : text;
}

double theta_at(int k) {
  return 0.5 * std::sin(0.02 * k) + 0.2 * std::sin(0.0311 * k);
}
double tau_at(int k) {
  return 0.3 * std::tanh(40.0 * std::cos(0.02 * k)) + 0.1 * std::sin(0.7 * k);
}

std::string body(const Style& style, int rows = 600) {
  std::string text = style.header;
  for (int k = 0; k < rows; ++k) {
    text += cell(0.002 * k * style.time, style) + style.delimiter;
    text += cell(theta_at(k) * style.theta, style) + style.delimiter;
    text += cell(tau_at(k) * style.tau, style) + style.line_end;
  }
  return text;
}

void check_read(const std::string& text, const std::vector<std::string>& map = {}) {
  ReadOptions options;
  options.map = map;
  const Log log = read_csv(write_file("format.csv", text), rotary_drive_channels(), options);
  REQUIRE(log.segments.size() == 1);
  REQUIRE(log.channel("theta") == 0);
  REQUIRE(log.channel("tau_m") == 1);
  REQUIRE(log.segments[0].samples.rows() == 600);
  CHECK(log.period == Approx(0.002));
  double worst = 0.0;
  for (int k = 0; k < 600; ++k) {
    worst = std::max(worst, std::abs(log.segments[0].samples(k, 0) - theta_at(k)));
    worst = std::max(worst, std::abs(log.segments[0].samples(k, 1) - tau_at(k)));
  }
  CHECK(worst < 1.0e-8);
}

std::string stop_message(const std::string& text, const std::vector<std::string>& map = {}) {
  ReadOptions options;
  options.map = map;
  try {
    read_csv(write_file("stop.csv", text), rotary_drive_channels(), options);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("units as people write them") {
  const auto factor = [](const char* text) {
    const auto unit = parse_unit(text);
    REQUIRE(unit);
    return unit->factor;
  };
  const double pi = 3.14159265358979323846;
  for (const char* text : {"N·m", "Nm", "N*m", "N m", "N.m", "kg*m^2/s^2", "kg m² s⁻²", "J"})
    CHECK(factor(text) == Approx(1.0));
  CHECK(factor("N*mm") == Approx(1.0e-3));
  CHECK(factor("Nmm") == Approx(1.0e-3));
  CHECK(factor("mNm") == Approx(1.0e-3));
  CHECK(factor("kgm2") == Approx(1.0));
  CHECK(factor("µm") == Approx(1.0e-6));
  CHECK(factor("\xB5m") == Approx(1.0e-6));  // Latin-1
  CHECK(factor("°") == Approx(pi / 180.0));
  CHECK(factor("deg/s") == Approx(pi / 180.0));
  CHECK(factor("rpm") == Approx(pi / 30.0));
  CHECK(factor("ms") == Approx(1.0e-3));
  CHECK(factor("mm/s") == Approx(1.0e-3));
  for (const char* text : {"", "furlong", "N·", "rad/", "[]", "s^"}) CHECK_FALSE(parse_unit(text));
  CHECK(convertible(*parse_unit("deg"), *parse_unit("rad")));
  CHECK_FALSE(convertible(*parse_unit("counts"), *parse_unit("rad")));
  CHECK_FALSE(convertible(*parse_unit("Hz"), *parse_unit("rad/s")));
  CHECK(convertible(*parse_unit("N*m/rad"), *parse_unit("N*m")));
}

TEST_CASE("the hash of a file's bytes") {
  const auto hash = [](const std::string& text) {
    Sha256 sha;
    for (size_t at = 0; at < text.size(); at += 37)
      sha.update(text.data() + at, std::min<size_t>(37, text.size() - at));
    return sha.finish();
  };
  CHECK(hash("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hash("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(hash(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("every separator, quotes, marks and line ends") {
  Style style;
  check_read(body(style));
  style.line_end = "\r\n";
  check_read("\xEF\xBB\xBF" + body(style));
  style.quotes = true;
  check_read("# a comment, with a comma\n# another\n" + body(style));
  style = {};
  style.header = "time [s]\ttheta [rad]\ttau_m [N·m]\n";
  style.delimiter = '\t';
  check_read(body(style));
  style.header = "time [s];\"theta [rad]\";tau_m [N·m]\n";
  style.delimiter = ';';
  style.decimal = ',';
  check_read(body(style));
  style.quotes = true;
  check_read(body(style));
  style = {};
  style.line_end = ",\n";
  check_read(body(style));
}

TEST_CASE("units and names are converted as the header or --map says") {
  const double degree = 3.14159265358979323846 / 180.0;
  Style style;
  style.header = "time [ms],theta [°],tau_m [N*mm]\n";
  style.time = 1000.0, style.theta = 1.0 / degree, style.tau = 1000.0;
  check_read(body(style));
  style.header = "t_ms,theta_deg,motor torque\n";
  check_read(body(style), {"tau_m=motor torque [N*mm]"});
  style.header = "clock,angle,torque\n";
  check_read(body(style), {"time=clock [ms]", "theta=#2 [deg]", "tau_m=torque [mNm]"});
  style.header = "Time (ms),Theta (deg),TAU_M (mNm)\n";
  check_read(body(style));
}

/// theta_at's rate by time, once every 2 ms.
double omega_at(int k) {
  return 500.0 * (0.5 * 0.02 * std::cos(0.02 * k) + 0.2 * 0.0311 * std::cos(0.0311 * k));
}

std::string body_with_speed(const std::string& header, double unit, int empty = -1) {
  std::string text = header;
  for (int k = 0; k < 600; ++k)
    text += fmt::format("{:.10g},{},{:.10g}\n", 0.002 * k,
                        k == empty ? "" : fmt::format("{:.10g}", omega_at(k) / unit), tau_at(k));
  return text;
}

// Planted, each seen red: rectangles, a unit's factor left out, the sum begun anew behind an empty
// cell, and an empty cell taken for a speed of 0.
TEST_CASE("a position that is not logged is the integral of the velocity") {
  const auto check = [](const std::string& text, const std::vector<std::string>& map = {}) {
    ReadOptions options;
    options.map = map;
    const Log log = read_csv(write_file("speed.csv", text), rotary_drive_channels(), options);
    REQUIRE(log.channel("theta") == 0);
    CHECK(log.channel("omega") < 0);
    REQUIRE(log.segments.size() == 1);
    double worst = 0.0;
    for (int k = 0; k < 600; ++k)
      worst = std::max(worst, std::abs(log.segments[0].samples(k, 0) - theta_at(k)));
    CHECK(worst < 1e-4);  // of trapezoids
    REQUIRE(!log.faults.empty());
    CHECK(log.faults[0].severity == Severity::doubtful);
    CHECK(message(log.faults[0]).find("its integral from 0 on") != std::string::npos);
  };
  const double rpm = 3.14159265358979323846 / 30.0;
  check(body_with_speed("time [s],omega [rad/s],tau_m [N·m]\n", 1.0));
  check(body_with_speed("time [s],omega [rpm],tau_m [N·m]\n", rpm));
  check(body_with_speed("time [s],omega [rad/s],tau_m [N·m]\n", 1.0, 300));
  check(body_with_speed("time [s],speed,tau_m [N·m]\n", rpm), {"theta=speed [rpm]"});
  check(body_with_speed("time [s],speed,tau_m [N·m]\n", 1.0), {"omega=speed [rad/s]"});
}

TEST_CASE("what cannot be understood stops with file, row and column") {
  Style style;
  style.header = "time [s],theta,tau_m [N·m]\n";
  CHECK(stop_message(body(style)).find("stop.csv:1:2: column 'theta' has no unit") !=
        std::string::npos);
  style.header = "time [s],theta [m],tau_m [N·m]\n";
  CHECK(stop_message(body(style)).find("1:2: 'm' cannot be a unit of channel 'theta'") !=
        std::string::npos);
  style.header = "time [s],angle [rad],tau_m [N·m]\n";
  CHECK(stop_message(body(style)).find("no column for channel 'theta [rad]'") != std::string::npos);
  style.header = "time [s],theta [rad],tau_m [N·m]\n";
  CHECK(stop_message(body(style), {"phi=theta [rad]"}).find("does not begin with a channel") !=
        std::string::npos);
  style.header = "time [s],theta [rad],theta [rad],tau_m [N·m]\n";
  CHECK(stop_message(body(style)).find("1:3: two columns (2 and 3)") != std::string::npos);
  style.header = "";
  CHECK(stop_message(body(style)).find("1:1: numbers where the header was expected") !=
        std::string::npos);
  CHECK(stop_message("").find("no header") != std::string::npos);
  CHECK(stop_message("time [s],theta [rad],tau_m [N·m]\n").find(":2:0: no data") !=
        std::string::npos);
  CHECK(stop_message("\xFF\xFEt").find("UTF-16") != std::string::npos);
  CHECK_THROWS_WITH(read_csv("no_such_file.csv", rotary_drive_channels()),
                    Catch::Contains("no_such_file.csv:0:0: cannot be opened"));
}
