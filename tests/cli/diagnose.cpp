// SPDX-License-Identifier: GPL-3.0-or-later
// sinew diagnose from the command line: a slide whose friction is stronger one way than the other.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/cli/program.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

constexpr const char* slide = R"(<robot name="slide"><link name="base"/>
<link name="carriage"><inertial><mass value="2"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="x" type="prismatic"><parent link="base"/><child link="carriage"/>
<axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="50" velocity="3"/>
<dynamics damping="3" friction="4"/></joint></robot>)";

/// Sums of sines; force of the model, and `difference` * |v| that it has not.
std::string log_text(unsigned seed, double difference) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const double step = 0.002, phase = 0.7 * seed;
  std::string text = "time [s],x [m],f [N]\n";
  for (int k = 0; k < 8000; ++k) {
    const double t = step * k;
    double x = 0.0, v = 0.0, a = 0.0;
    for (const auto& [size, rate] : {std::pair{0.2, 1.9}, {0.1, 4.3}, {0.04, 9.1}}) {
      x += size * std::sin(rate * t + phase * rate);
      v += size * rate * std::cos(rate * t + phase * rate);
      a -= size * rate * rate * std::sin(rate * t + phase * rate);
    }
    const double f = 2.0 * a + 3.0 * v + 4.0 * std::tanh(v / 0.005) + difference * std::abs(v) +
                     0.2 * normal(random);
    text += fmt::format("{:.4f},{:.8f},{:.6f}\n", t, x + 1e-7 * normal(random), f);
  }
  return text;
}

struct Bench : Workplace {
  explicit Bench(double difference) {
    reference::write_text(path("slide.urdf"), slide);
    REQUIRE(sinew({"import", "slide.urdf", "--out", "models/slide"}).status == 0);
    reference::write_text(path("train.csv"), log_text(1, difference));
    reference::write_text(path("test.csv"), log_text(2, difference));
  }
  Ended diagnose(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"diagnose",  "models/slide", "--log", "train.csv",
                                       "--holdout", "test.csv",     "--out", "found"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return sinew(arguments);
  }
};

}  // namespace

TEST_CASE("a cause is named, the model extended and its C generated with it") {
  const Bench bench(1.5);
  const Ended ended = bench.diagnose();
  INFO(ended.output);
  CHECK(ended.status == 1);
  CHECK(ended.says("viscous asymmetry"));
  CHECK(ended.says("report.html"));
  const auto findings = nlohmann::json::parse(bench.text("found/findings.json"));
  CHECK(findings.at("extension").at("adopted") == true);
  CHECK(bench.text("models/slide/identified.toml").find("viscous_asymmetry") != std::string::npos);

  CHECK(bench.sinew({"generate", "models/slide"}).status == 0);
  const std::string c = bench.text("generated/slide/slide.c");
  CHECK(c.find("void slide_effort(") != std::string::npos);
  CHECK(c.find("void slide_compensation(") != std::string::npos);

  // The extended model leaves nothing over.
  const Ended again = bench.diagnose();
  INFO(again.output);
  CHECK(again.status == 0);
}

TEST_CASE("where the model is right nothing is named and nothing changes") {
  const Bench bench(0.0);
  const Ended ended = bench.diagnose();
  INFO(ended.output);
  CHECK(ended.status == 0);
  CHECK(fs::exists(bench.path("found/report.html")));
  CHECK_FALSE(fs::exists(bench.path("models/slide/identified.toml")));
}

TEST_CASE("a dry run leaves the model as it is") {
  const Bench bench(1.5);
  CHECK(bench.diagnose({"--dry-run"}).status == 1);
  CHECK_FALSE(fs::exists(bench.path("models/slide/identified.toml")));
  CHECK(fs::exists(bench.path("found/identified.toml")));
  CHECK(fs::exists(bench.path("found/generated/slide/slide.c")));
}

TEST_CASE("logs that cannot be used end with 2, say where, and nothing is written") {
  const Bench bench(0.0);
  bench.change("train.csv", "time [s],x [m],f [N]", "time [s],x [m],force");
  const Ended ended = bench.diagnose();
  CHECK(ended.status == 2);
  CHECK(ended.says("train.csv:1"));
  CHECK_FALSE(fs::exists(bench.path("found")));
  CHECK(bench.sinew({"diagnose", "models/slide", "--log", "none.csv", "--out", "found"}).status ==
        2);
  CHECK(bench.sinew({"diagnose", "models/none", "--log", "test.csv", "--out", "found"}).status ==
        2);
}

TEST_CASE("the manual's page of effects is what the program says") {
  const Workplace here;
  const Ended page = here.sinew({"effects"});
  CHECK(page.status == 0);
  CHECK(page.output == reference::read_text(SINEW_SOURCE_DIR "/docs/effects.md"));
}
