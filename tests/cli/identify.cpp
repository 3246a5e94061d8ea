// SPDX-License-Identifier: GPL-3.0-or-later
// `sinew identify` from a user's side: logs from `sinew simulate`, with noise, to results.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.h"

using namespace sinew;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string source = SINEW_SOURCE_DIR;
const std::string motor = source + "/models/motor";

/// Log of a scenario of models/motor, as <scenario>.csv in the workplace.
void simulate(const Workplace& here, const std::string& scenario) {
  const Ended run =
      here.sinew({"simulate", motor, "--scenario", motor + "/scenarios/" + scenario + ".toml",
                  "--out", scenario + ".csv", "--runtime", source + "/runtime"});
  INFO(run.output);
  REQUIRE(run.status == 0);
}

Ended identify(const Workplace& here, const std::string& model, const std::string& experiment,
               const std::vector<std::string>& logs, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"identify", model,   "--experiment",
                                     experiment, "--out", "out.json"};
  for (const std::string& log : logs) arguments.insert(arguments.end(), {"--log", log});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return here.sinew(arguments);
}

json results(const Workplace& here) {
  return json::parse(here.text("out.json"))["results"];
}

/// Within 4 standard errors, which are at most `relative` of the truth.
void check_estimate(const json& e, double truth, double relative) {
  CAPTURE(e.dump(), truth);
  const double error = e["standard_error"];
  CHECK(std::abs(e["value"].get<double>() - truth) < 4.0 * error);
  CHECK(error > 0.0);
  CHECK(error < relative * std::abs(truth));
}

/// Line `row` (the first is 1) of a text replaced.
std::string with_row(const std::string& text, int row, const std::string& line) {
  std::istringstream in(text);
  std::string all, each;
  for (int i = 1; std::getline(in, each); ++i) all += (i == row ? line : each) + "\n";
  return all;
}

std::string row_of(const std::string& text, int row) {
  std::istringstream in(text);
  std::string each;
  for (int i = 1; i <= row; ++i) std::getline(in, each);
  return each;
}

/// Exit 2, the place named, and nothing written.
void check_refused(const Workplace& here, const Ended& run, const std::string& place) {
  CAPTURE(run.output, place);
  CHECK(run.status == 2);
  CHECK(run.says(place));
  CHECK(!fs::exists(here.path("out.json")));
}

}  // namespace

TEST_CASE("friction from a simulated log", "[identify]") {
  const Workplace here;
  simulate(here, "friction");
  const Ended run = identify(here, motor, "friction", {"friction.csv"});
  INFO(run.output);
  REQUIRE(run.status == 0);
  CHECK(run.says("gamma1_s_per_rad: "));
  const json r = results(here);
  check_estimate(r["gamma1_s_per_rad"], 10.0, 0.01);
  check_estimate(r["gamma2_Nm"], 0.5586, 0.01);
  check_estimate(r["gamma3_Nms_per_rad"], 0.0356, 0.02);
  CHECK(r["points"].size() >= 18);
  for (const json& p : r["points"]) CHECK(p["lowest_Nm"] < p["highest_Nm"]);
  // --json says what the file says.
  const Ended machine = identify(here, motor, "friction", {"friction.csv"}, {"--json"});
  CHECK(json::parse(machine.output) == json::parse(here.text("out.json")));
}

TEST_CASE("inertia from simulated impulses, and the bias of leaving friction out", "[identify]") {
  const Workplace here;
  simulate(here, "impulses");
  const Ended run = identify(here, motor, "inertia", {"impulses.csv"});
  INFO(run.output);
  REQUIRE(run.status == 0);
  const json r = results(here);
  check_estimate(r["inertia_kgm2"], 2.05e-3, 0.02);
  CHECK(r["bias_without_friction"] > 0.2);
  CHECK(r["without_friction_kgm2"]["interval_95"][0] > 2.05e-3);
}

TEST_CASE("ripple from simulated turns, and what compensation does", "[identify]") {
  const Workplace here;
  for (const char* scenario : {"ripple", "constant_velocity", "compensated_velocity"})
    simulate(here, scenario);
  REQUIRE(identify(here, motor, "ripple", {"ripple.csv"}).status == 0);
  const json ripple = results(here)["ripple"];
  REQUIRE(ripple.size() == 2);
  CHECK(ripple[0]["side"] == "input");
  check_estimate(ripple[0]["amplitude_Nm"], 0.04, 0.02);
  check_estimate(ripple[0]["phase_rad"], 1.1, 0.02);
  CHECK(ripple[1]["side"] == "output");
  check_estimate(ripple[1]["amplitude_Nm"], 0.02, 0.03);
  check_estimate(ripple[1]["phase_rad"], 0.3, 0.05);
  const Ended run =
      identify(here, motor, "ripple", {"constant_velocity.csv", "compensated_velocity.csv"});
  INFO(run.output);
  const json left = results(here)["velocity_at_motor_order_rad_s"]["against_the_first_log"];
  REQUIRE(left.size() == 1);
  // models/motor feeds 0.9 of it forward; less friction leaves the drive a little livelier.
  CHECK(left[0]["share_left"]["value"].get<double>() == Approx(0.1).epsilon(0.15));
  CHECK(left[0]["share_left"]["standard_error"] < 0.01);
}

TEST_CASE("logs that cannot identify: status 1, told so, with the experiment that would",
          "[identify]") {
  const Workplace here;
  simulate(here, "constant_velocity");
  const Ended friction = identify(here, motor, "friction", {"constant_velocity.csv"});
  INFO(friction.output);
  CHECK(friction.status == 1);
  CHECK(friction.says("not identified: only 1 constant velocities"));
  CHECK(friction.says("expected at least 6, in both directions"));
  CHECK(json::parse(here.text("out.json"))["identified"] == false);
  const Ended inertia = identify(here, motor, "inertia", {"constant_velocity.csv"});
  CHECK(inertia.status == 1);
  CHECK(inertia.says("expected torque impulses"));
  simulate(here, "impulses");
  const Ended ripple = identify(here, motor, "ripple", {"impulses.csv"});
  CHECK(ripple.status == 1);
  CHECK(ripple.says("expected constant velocities"));
}

TEST_CASE("bad logs: file, row and column, nothing written", "[identify]") {
  const Workplace here;
  simulate(here, "constant_velocity");
  const std::string good = here.text("constant_velocity.csv");
  REQUIRE(row_of(good, 1) ==
          "time [s],theta [rad],omega [rad/s],tau_m [N·m],theta_ref [rad],load [N·m]");
  const auto attempt = [&](const std::string& text, const std::vector<std::string>& more = {}) {
    reference::write_text(here.path("bad.csv"), text);
    return identify(here, motor, "ripple", {"bad.csv"}, more);
  };
  check_refused(here, attempt(with_row(good, 1, "time [s],theta,omega [rad/s],tau_m [N·m],a,b")),
                "bad.csv:1:2: ");
  check_refused(here,
                attempt(with_row(good, 1, "time [s],theta [N],omega [rad/s],tau_m [N·m],a,b")),
                "bad.csv:1:2: ");
  check_refused(here, attempt(with_row(good, 500, "0.498,nan,1,1,0.498,0")), "bad.csv:500:2: ");
  check_refused(here, attempt(with_row(good, 500, "0.498,0.498,1,,0.498,0")), "bad.csv:500:4: ");
  check_refused(here, attempt(with_row(good, 500, "0.498,0.498,1,word,0.498,0")),
                "bad.csv:500:4: ");
  check_refused(here, attempt(with_row(good, 500, "0.4,0.498,1,1,0.498,0")), "bad.csv:500:1: ");
  // A wrong column: one that is not there, and two exchanged.
  check_refused(here, attempt(good, {"--map", "tau_m=#9 [N*m]"}), "bad.csv:1:");
  check_refused(here, attempt(good, {"--map", "theta=#3 [rad]", "--map", "omega=#2 [rad/s]"}),
                "bad.csv:2:2: 'omega' is not the derivative of 'theta'");
  check_refused(here, identify(here, motor, "ripple", {"none.csv"}), "none.csv");
  CHECK(attempt(good).status == 0);
}

TEST_CASE("a log that lacks a cell is taken with --repair", "[identify]") {
  const Workplace here;
  simulate(here, "constant_velocity");
  reference::write_text(here.path("bad.csv"),
                        with_row(here.text("constant_velocity.csv"), 500, "0.498,nan,1,1,0.498,0"));
  CHECK(identify(here, motor, "ripple", {"bad.csv"}, {"--repair"}).status == 0);
  const json whole = json::parse(here.text("out.json"));
  CHECK(whole["logs"][0]["faults"].dump().find("bad.csv:500:2: ") != std::string::npos);
}

TEST_CASE("an experiment on another part's model is refused", "[identify]") {
  const Workplace here;
  reference::write_text(here.path("log.csv"), "time [s],count [1],force [N]\n0,1,1\n");
  check_refused(here, identify(here, source + "/models/lever", "friction", {"log.csv"}),
                "describes another part; expected a motor");
  check_refused(here, identify(here, motor, "lever", {"log.csv"}),
                "describes another part; expected a lever");
  check_refused(here, identify(here, motor, "guiding", {"log.csv"}),
                "describes another part; expected a tendon's guiding");
}

TEST_CASE("identify takes what channels.toml says of the recorder", "[identify]") {
  const Workplace here;
  simulate(here, "constant_velocity");
  fs::copy(motor, here.path("models/motor"), fs::copy_options::recursive);
  const std::string log = here.text("constant_velocity.csv");
  REQUIRE(log.starts_with("time [s],theta [rad],omega [rad/s],tau_m [N·m],"));
  reference::write_text(here.path("recorder.csv"),
                        with_row(log, 1, "time [s],Pos,Speed [rad/s],M soll,x,load [N*m]"));
  const auto channels = [&](const std::string& text) {
    reference::write_text(here.path("models/motor/channels.toml"), "[channels]\n" + text);
    return identify(here, "models/motor", "ripple", {"recorder.csv"});
  };
  const std::string fine = "theta = \"Pos [rad]\"\nomega = \"#3\"\n";
  const Ended run = channels(fine + "tau_m = \"M soll [N*m]\"\n");
  INFO(run.output);
  CHECK(run.status == 0);
  const std::string mapped = here.text("out.json");
  CHECK(identify(here, motor, "ripple", {"constant_velocity.csv"}).status == 0);
  CHECK(json::parse(mapped)["results"]["ripple"] == results(here)["ripple"]);
  fs::remove(here.path("out.json"));
  // A channel of another experiment is of no concern, one of none is a mistake.
  CHECK(channels(fine + "tau_m = \"M soll [N*m]\"\nforce = \"F [N]\"\n").status == 0);
  fs::remove(here.path("out.json"));
  check_refused(here, channels(fine + "torque = \"M soll [N*m]\"\n"), "'torque=M soll [N*m]'");
  // --map goes before the file.
  channels(fine + "tau_m = \"none [N*m]\"\n");
  CHECK(identify(here, "models/motor", "ripple", {"recorder.csv"}, {"--map", "tau_m=M soll [N*m]"})
            .status == 0);
}
