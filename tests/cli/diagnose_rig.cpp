// SPDX-License-Identifier: GPL-3.0-or-later
// sinew diagnose on a lever's calibration, and what the model's folder is good for afterwards.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <random>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/parts/part.h"
#include "symbolic/extension/part_observation.h"
#include "tests/cli/program.h"

using namespace sinew;

namespace {

/// The lever of models/lever drawn to and fro by its tendon, with one value that its model has not.
class Calibration {
 public:
  explicit Calibration(const IdentifiedEffect& hidden)
      : observation_(*observation_of(read_part(SINEW_SOURCE_DIR "/models/lever"))),
        reading_(closed_observation(observation_, {{hidden}, {}})) {}

  std::string log(unsigned seed, bool with_elongation) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::string text = with_elongation ? "time [s],count [1],force [N],elongation [mm]\n"
                                       : "time [s],count [1],force [N]\n";
    std::vector<double> memory{0.0, 0.0};
    for (int k = 0; k < 6000; ++k) {
      const double t = 0.005 * k, phase = 0.4 * seed;
      const double count = std::round(2040.0 + 1500.0 * std::sin(0.9 * t + phase) +
                                      300.0 * std::sin(2.3 * t + 2.0 * phase));
      const double rate =
          1350.0 * std::cos(0.9 * t + phase) + 690.0 * std::cos(2.3 * t + 2.0 * phase);
      const std::vector<double> out =
          evaluate(reading_, {count, rate, 0.0, 0.005, memory[0], memory[1]});
      memory = {out[2], out[3]};
      text += fmt::format("{:.3f},{:.0f},{:.4f}", t, count, out[0] + 0.05 * normal(random));
      if (with_elongation) text += fmt::format(",{:.5f}", 1e3 * out[1] + 0.005 * normal(random));
      text += "\n";
    }
    return text;
  }

 private:
  Observation observation_;
  Function reading_;
};

/// A copy of models/lever beside two logs of the lever as it really is.
Workplace lever_that_has(const IdentifiedEffect& hidden, bool with_elongation) {
  Workplace place;
  std::filesystem::copy(SINEW_SOURCE_DIR "/models/lever", place.path("lever"));
  const Calibration calibration(hidden);
  for (const auto& [name, seed] : {std::pair{"a.csv", 1u}, {"b.csv", 2u}})
    std::ofstream(place.path(name)) << calibration.log(seed, with_elongation);
  return place;
}

const std::vector<std::string> diagnose{"diagnose",  "lever", "--log", "a.csv",
                                        "--holdout", "b.csv", "--out", "d"};

}  // namespace

TEST_CASE("a lever that has learnt from its logs is generated and diagnosed again") {
  // Planted defect: identified.toml read as a drive's (no observation given): both ends with 2.
  const Workplace place =
      lever_that_has({"spring_constant", "lever", {}, {{"spring_change", 0.1, 0.0, "1"}}}, true);
  const Ended first = place.sinew(diagnose);
  INFO(first.output);
  REQUIRE(first.status == 1);
  CHECK(first.says("spring constant (lever)"));
  CHECK(place.text("lever/identified.toml").find("spring_change") != std::string::npos);
  const Ended generated = place.sinew({"generate", "lever", "--out", "c"});
  INFO(generated.output);
  CHECK(generated.status == 0);
  const Ended again = place.sinew(diagnose);
  INFO(again.output);
  CHECK(again.status == 0);
  CHECK(again.says("leaves nothing over but noise"));
  // What no lever can have learnt is a mistake with its place.
  place.change("lever/identified.toml", "spring_constant", "stribeck");
  const Ended wrong = place.sinew({"generate", "lever", "--out", "c"});
  CHECK(wrong.status == 2);
  CHECK(wrong.says("no effect 'stribeck' at 'lever'"));
}

TEST_CASE("a lever's log without elongation is enough for its force") {
  // Planted defect: as many channels as the model says (set_units, set_known): a write behind the
  // end, seen to crash.
  const Workplace place =
      lever_that_has({"spring_constant", "lever", {}, {{"spring_change", 0.1, 0.0, "1"}}}, false);
  const Ended told = place.sinew(diagnose);
  INFO(told.output);
  REQUIRE(told.status == 1);
  CHECK(told.says("spring constant (lever)"));
  CHECK(told.says("Extension  extended"));
}

TEST_CASE("slack is named, which changes nothing but a mean") {
  const Workplace place =
      lever_that_has({"slack", "tendon", {}, {{"slack", 1e-4, 0.0, "m"}}}, true);
  const Ended told = place.sinew(diagnose);
  INFO(told.output);
  CHECK(told.says("The model lacks: slack (tendon)."));
}

TEST_CASE("a wrist's log without motors is named with what its header has") {
  const Workplace place =
      lever_that_has({"slack", "tendon", {}, {{"slack", 1e-4, 0.0, "m"}}}, false);
  const Ended ended = place.sinew(
      {"diagnose", SINEW_SOURCE_DIR "/models/wrist", "--log", "a.csv", "--out", "found"});
  INFO(ended.output);
  CHECK(ended.status == 2);
  CHECK(ended.says("a.csv:1: "));
  CHECK(ended.says("the header has: time"));
  CHECK(ended.says("--map theta_1="));
}
