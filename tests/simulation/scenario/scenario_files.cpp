// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario files that are wrong, and what becomes of the output then.
#include <catch2/catch.hpp>

#include "identification/logs/read_csv.h"
#include "symbolic/model/read_mechanism.h"
#include "tests/simulation/scenario_run.h"

using namespace sinew_tests;
using sinew::reference::read_text;
using sinew::reference::run_program;
using sinew::reference::TemporaryFolder;
using sinew::reference::write_text;

namespace {

const std::string good = R"([scenario]
duration = { value = 0.01, unit = "s" }
output_rate = { value = 1, unit = "kHz" }
[drive]
mode = "torque"
[[command]]
channel = "tau_m"
value = { value = 1, unit = "N*m" }
[commands]
file = "commands.csv"
)";
const std::string good_table = "time [s],load [N*m]\n0,0\n0.01,0.5\n";

struct Mistake {
  std::string before, after;  // in the scenario, or in the table where `in_table`
  bool in_table;
  std::string message;
};

const std::vector<Mistake> mistakes{
    {"value = 0.01, unit = \"s\"", "value = 0.01", false,
     "scenario.toml:2:12: scenario.duration has no unit"},
    {"unit = \"kHz\"", "unit = \"rad\"", false,
     "scenario.toml:3:35: scenario.output_rate has the unit 'rad' of angle"},
    {"value = 0.01", "value = nan", false,
     "scenario.toml:2:22: scenario.duration.value is not finite"},
    {"value = 0.01", "value = -1", false, "scenario.toml:2:12: scenario.duration is negative"},
    {"mode = \"torque\"", "mode = \"torqe\"", false,
     "scenario.toml:5:8: drive.mode is 'torqe' (did you mean 'torque'?)"},
    {"channel = \"tau_m\"", "channel = \"tau_1\"", false,
     "scenario.toml:7:11: the model has no command 'tau_1'"},
    {"unit = \"N*m\" }", "unit = \"N\" }", false,
     "scenario.toml:8:29: command[0].value has the unit 'N' of force"},
    {"[drive]\n", "[drive]\nweight_feedforward = true\n", false,
     "scenario.toml:5:22: weight_feedforward needs motors that follow positions; expected the mode "
     "servo or prescribed"},
    {"[drive]\n", "[drive]\nspeed = 1\n", false, "scenario.toml:5:1: unknown key 'speed' in drive"},
    {"[scenario]", "[scenario", false, "scenario.toml:1:"},
    {"load [N*m]", "load", true, "commands.csv:1:10: column 'load' has no unit"},
    {"load [N*m]", "lod [N*m]", true,
     "commands.csv:1:10: the model has no command 'lod' (did you mean 'load'?)"},
    {"load [N*m]", "load [m]", true, "commands.csv:1:10: column 'load' has the unit 'm' of length"},
    {"0.01,0.5", "0.01,nan", true, "commands.csv:3:6: load 'nan' is no finite number"},
    {"0.01,0.5", "-0.01,0.5", true, "commands.csv:3:1: the time -0.01 s is not after 0 s"},
    {"0.01,0.5", "0.01", true, "commands.csv:3:1: the row has 1 cells"},
};

struct Place {
  TemporaryFolder folder;
  std::filesystem::path scenario = folder.path() / "scenario.toml";
  std::filesystem::path table = folder.path() / "commands.csv";
  std::filesystem::path out = folder.path() / "out.csv";

  Place() {
    write_text(scenario, good);
    write_text(table, good_table);
  }
  int simulate(std::string& output, const std::string& model = "motor",
               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{SINEW_PROGRAM, "simulate",        source + "/models/" + model,
                                   "--scenario",  scenario.string(), "--out",
                                   out.string(),  "--runtime",       source + "/runtime"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words, output);
  }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder.path()), {}));
  }
};

}  // namespace

TEST_CASE("every mistake in a scenario is placed and nothing is written", "[scenario]") {
  for (const Mistake& mistake : mistakes) {
    const Place place;
    std::string text = mistake.in_table ? good_table : good;
    const std::size_t at = text.find(mistake.before);
    REQUIRE(at != std::string::npos);
    write_text(mistake.in_table ? place.table : place.scenario,
               text.replace(at, mistake.before.size(), mistake.after));
    std::string output;
    CAPTURE(mistake.message);
    CHECK(place.simulate(output) == 2);
    CAPTURE(output);
    CHECK(output.find(mistake.message) != std::string::npos);
    CHECK(place.files() == 2);
  }
}

TEST_CASE("a good scenario gives a log; one that fails leaves the old log", "[scenario]") {
  const Place place;
  std::string output;
  REQUIRE(place.simulate(output, "motor", {"--json"}) == 0);
  CHECK(output.find("\"rows\": 11") != std::string::npos);
  CHECK(output.find("\"power_residual\"") != std::string::npos);
  const std::string log = read_text(place.out);
  CHECK(log.substr(0, log.find('\n')) ==
        "time [s],theta [rad],omega [rad/s],tau_m [N·m],load [N·m]");
  CHECK(std::count(log.begin(), log.end(), '\n') == 12);
  write_text(place.scenario, good + "surprise = 1\n");
  CHECK(place.simulate(output) == 2);
  CHECK(read_text(place.out) == log);
  CHECK(place.files() == 3);
}

TEST_CASE("what cannot be simulated is refused", "[scenario][slow]") {
  const Place place;
  std::string output;
  CHECK(place.simulate(output, "guiding") == 2);
  CHECK(output.find("expected a motor, a mechanism or a hand") != std::string::npos);
  write_text(place.scenario, scenario_text(1, 10, "[drive]\nmode = \"prescribed\"\n"));
  CHECK(place.simulate(output) == 2);
  CHECK(output.find("a motor alone is driven by torque or servo") != std::string::npos);
  write_text(place.scenario,
             scenario_text(1, 10,
                           "[drive]\nmode = \"prescribed\"\npretension = { value = 200, unit "
                           "= \"N\" }\n"));
  CHECK(place.simulate(output, "index") == 2);
  CHECK(output.find("beyond the lever's travel") != std::string::npos);
  const auto weighed = [&](const std::string& gravity) {
    write_text(place.scenario,
               scenario_text(1, 10,
                             "gravity = { value = [" + gravity +
                                 "], unit = \"m/s^2\" }\n[drive]\nmode = \"prescribed\"\n"
                                 "weight_feedforward = true\npretension = { value = 2, unit = "
                                 "\"N\" }\n"));
    return place.simulate(output, "index");
  };
  CHECK(weighed("0, -9.81, 0") == 0);
  std::filesystem::remove(place.out);
  CHECK(weighed("0, -900, 0") == 2);
  CHECK(output.find("weight_feedforward: tendon") != std::string::npos);
  CHECK(output.find("would go slack at 0 s; expected more pretension") != std::string::npos);
  CHECK(place.files() == 2);
}

TEST_CASE("logs read back as the channels of docs/logs.md", "[scenario][slow]") {
  const Place place;
  write_text(place.scenario, scenario_text(0.5, 1000, R"(
[drive]
mode = "servo"
gain = { value = 40, unit = "N*m" }
rate_gain = { value = 1, unit = "N*m*s/rad" }
pretension = { value = 15, unit = "N" }
[noise]
seed = { value = 3, unit = "1" }
q = { value = 1e-4, unit = "rad" }
theta = { value = 1e-5, unit = "rad" }
tau = { value = 1e-3, unit = "N*m" }
[[command]]
channel = "theta_5_ref"
shape = "sine"
amplitude = { value = 0.3, unit = "rad" }
frequency = { value = 4, unit = "Hz" }
)"));
  std::string output;
  REQUIRE(place.simulate(output, "index") == 0);
  const std::string first = read_text(place.out);
  const sinew::Mechanism index = sinew::read_mechanism(source + "/models/index");
  sinew::ReadOptions options;
  options.check_consistency = false;
  const sinew::Log log =
      sinew::read_csv(place.out.string(), sinew::finger_channels(index), options);
  CHECK(log.sample_count() == 501);
  CHECK(log.period == Approx(0.001));
  CHECK(log.channel("q22") >= 0);
  CHECK(log.channel("theta_8") >= 0);
  CHECK(log.channels[static_cast<std::size_t>(log.channel("q22"))].noise_floor ==
        Approx(1e-4).epsilon(0.3));
  REQUIRE(place.simulate(output, "index") == 0);
  CHECK(read_text(place.out) == first);
  std::string other = read_text(place.scenario);
  other.replace(other.find("value = 3, unit = \"1\""), 9, "value = 4");
  write_text(place.scenario, other);
  REQUIRE(place.simulate(output, "index") == 0);
  CHECK(read_text(place.out) != first);
}
