// SPDX-License-Identifier: GPL-3.0-or-later
// The lever's calibration from a log with noise and hysteresis to compiled C.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tests/cli/program.h"

using namespace sinew;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string source = SINEW_SOURCE_DIR;
constexpr double first_count = 300.0, counts = 3400.0, travel = 0.010;

/// A stiffening spring over the share s of the travel, 0 to 90 N.
double force_at(double s) {
  return 90.0 * (std::exp(1.6 * s) - 1.0) / (std::exp(1.6) - 1.0);
}
double stiffness_at(double s) {
  return 90.0 * 1.6 * std::exp(1.6 * s) / (std::exp(1.6) - 1.0) / travel;
}
double count_at(double s) {
  return first_count + counts * (s + 0.03 * std::sin(3.0 * s));
}

/// Four slow pulls and releases. The loop follows the way with a length of its own (Dahl), and is
/// as wide as `loop` of the force.
std::string pulled(double loop,
                   const std::string& columns = "time [s],count [1],force [N],elongation [mm]") {
  std::string text = columns + "\n";
  std::mt19937 random(7);
  std::normal_distribution<double> unit;
  double z = 0.0, before = 0.0;
  for (int i = 0; i < 8000; ++i) {
    const double phase = i / 2000.0, s = 0.5 - 0.5 * std::cos(2.0 * 3.14159265358979 * phase);
    const double way = (s - before) * travel / 2e-4;
    before = s;
    z = way > 0.0 ? 1.0 - (1.0 - z) * std::exp(-way) : (1.0 + z) * std::exp(way) - 1.0;
    const double force = force_at(s) * (1.0 + 0.5 * loop * z) + 0.05 * unit(random);
    text += fmt::format("{:.3f},{},{:.4f},{:.5f}\n", 0.005 * i, std::round(count_at(s)), force,
                        s * travel * 1e3 + 0.001 * unit(random));
  }
  return text;
}

Ended calibrate(const Workplace& here, const std::string& text,
                const std::vector<std::string>& more = {}) {
  reference::write_text(here.path("pull.csv"), text);
  std::vector<std::string> arguments{
      "identify",  source + "/models/lever", "--experiment", "lever", "--log", "pull.csv", "--out",
      "lever.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return here.sinew(arguments);
}

double horner(const json& coefficients, double u) {
  double sum = 0.0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * u + coefficients[k].get<double>();
  return sum;
}

/// What the emitted C gives at each count: length, force, stiffness.
std::vector<std::vector<double>> compiled(const Workplace& here, const std::vector<int>& at) {
  std::string program =
      "#include <stdio.h>\n#include \"lever_calibration.h\"\nint main(void) {\n"
      "  double out[3];\n";
  for (const int count : at)
    program += fmt::format(
        "  lever_calibration_calibrated_state({}, out);\n"
        "  printf(\"%.17g %.17g %.17g\\n\", out[0], out[1], out[2]);\n",
        count);
  reference::write_text(here.path("main.c"), program + "  return 0;\n}\n");
  const Ended built = here.shell("cc -std=c11 -Wall -Wextra -Werror -ffp-contract=off -Ic -I" +
                                 source + "/runtime main.c c/lever_calibration.c -o main");
  INFO(built.output);
  REQUIRE(built.status == 0);
  std::istringstream lines(here.shell("./main").output);
  std::vector<std::vector<double>> all(at.size(), std::vector<double>(3));
  for (auto& row : all) lines >> row[0] >> row[1] >> row[2];
  REQUIRE(lines);
  return all;
}

}  // namespace

TEST_CASE("a lever's calibration, with hysteresis and noise, and its C compiled", "[identify]") {
  const Workplace here;
  const Ended run = calibrate(here, pulled(0.2), {"--emit", "c"});
  INFO(run.output);
  REQUIRE(run.status == 0);
  const json r = json::parse(here.text("lever.json"))["results"];
  // 0.2 of the force, where the way has not just turned round.
  CHECK(r["hysteresis_N"].get<double>() ==
        Approx(0.2 * r["hysteresis_at_N"].get<double>()).epsilon(0.06));
  CHECK(r["hysteresis_at_N"] > 70.0);
  CHECK(r["largest_force_error_N"].get<double>() == Approx(9.0).margin(2.0));
  CHECK(r["largest_force_error_without_loop_N"] < 1.0);
  CHECK(r["largest_length_error_m"] < 2e-5);
  CHECK(r["force_validation_rms_N"].size() == 9);
  CHECK(r["force_N"].size() >= 4);
  std::vector<int> at;
  for (int count = 200; count <= 3900; count += 50) at.push_back(count);
  const auto emitted = compiled(here, at);
  const double centre = r["centre_counts"], half = r["half_range_counts"];
  for (std::size_t i = 0; i < at.size(); ++i) {
    CAPTURE(at[i]);
    const double u = std::clamp((at[i] - centre) / half, -1.0, 1.0);
    CHECK(emitted[i][0] == Approx(horner(r["length_m"], u)).epsilon(1e-13).margin(1e-17));
    CHECK(emitted[i][1] == Approx(horner(r["force_N"], u)).epsilon(1e-12).margin(1e-12));
    if (i == 0 || i + 1 == at.size() || std::abs(u) > 0.95) continue;
    // The stiffness is the derivative of the force along the length.
    const double h = 1e-5;
    const double slope = (horner(r["force_N"], u + h) - horner(r["force_N"], u - h)) /
                         (horner(r["length_m"], u - h) - horner(r["length_m"], u + h));
    CHECK(emitted[i][2] == Approx(slope).epsilon(1e-6));
  }
  // Against the truth: in the middle of the loop.
  for (double s = 0.1; s < 0.95; s += 0.1) {
    const auto near = compiled(here, {static_cast<int>(std::lround(count_at(s)))}).front();
    CAPTURE(s);
    CHECK(near[1] == Approx(force_at(s)).margin(0.6));
    CHECK(near[2] == Approx(stiffness_at(s)).epsilon(0.05));
  }
}

TEST_CASE("without a loop none is found", "[identify]") {
  const Workplace here;
  REQUIRE(calibrate(here, pulled(0.0)).status == 0);
  const json r = json::parse(here.text("lever.json"))["results"];
  CHECK(r["hysteresis_N"] < 0.5);
  CHECK(r["largest_force_error_N"] < 0.5);
  CHECK(r["stiffness_mismatch"] < 0.05);
  CHECK(!fs::exists(here.path("c")));
}

TEST_CASE("lever logs that say too little or are broken", "[identify]") {
  const Workplace here;
  const std::string good = pulled(0.2);
  const Ended short_one =
      calibrate(here, good.substr(0, good.find("\n1.")) + "\n", {"--emit", "c"});
  INFO(short_one.output);
  CHECK(short_one.status == 1);
  CHECK(short_one.says("expected the tendon pulled slowly over the whole travel"));
  CHECK(!fs::exists(here.path("c")));
  CHECK(short_one.says("of the sensor's range"));
  fs::remove(here.path("lever.json"));
  const Ended no_unit =
      calibrate(here, pulled(0.2, "time [s],count [1],force,elongation [mm]"), {"--emit", "c"});
  CHECK(no_unit.status == 2);
  CHECK(no_unit.says("pull.csv:1:3: "));
  CHECK(!fs::exists(here.path("lever.json")));
  CHECK(!fs::exists(here.path("c")));
}
