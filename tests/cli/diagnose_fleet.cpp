// SPDX-License-Identifier: GPL-3.0-or-later
// sinew diagnose by sums of logs from the command line: a slide whose friction is stronger one way.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/cli/slide_log.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

constexpr int kSummedRows = 4000;

/// Logs a, b, c of one slide.
struct Fleet : Workplace {
  explicit Fleet(double difference) {
    reference::write_text(path("slide.urdf"), test::slide_urdf);
    REQUIRE(sinew({"import", "slide.urdf", "--out", "models/slide"}).status == 0);
    unsigned seed = 1;
    for (const char* name : {"a.csv", "b.csv", "c.csv"})
      reference::write_text(path(name), test::slide_log(seed++, difference, kSummedRows));
  }
  Ended summarise(const std::string& log, const std::string& out,
                  const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"diagnose",    "models/slide", "--log",       log,
                                       "--reference", "a.csv",        "--summarise", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return sinew(arguments);
  }
  void summarise_all() const {
    for (const std::string name : {"a", "b", "c"}) {
      const Ended ended = summarise(name + ".csv", name + ".sums");
      INFO(ended.output);
      REQUIRE(ended.status == 0);
      REQUIRE(ended.says(name + ".sums: sums of "));
    }
  }
  Ended add(const std::vector<std::string>& sums, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"diagnose", "models/slide", "--reference", "a.csv",
                                       "--sums"};
    arguments.insert(arguments.end(), sums.begin(), sums.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return sinew(arguments);
  }
};

}  // namespace

TEST_CASE("sums of logs name the cause that the logs name, and adopt nothing") {
  const Fleet fleet(1.5);
  fleet.summarise_all();
  const Ended told = fleet.add({"a.sums", "b.sums"}, {"--sums-holdout", "c.sums"});
  INFO(told.output);
  CHECK(told.status == 1);
  CHECK(told.says("The model lacks: viscous asymmetry (joint x)."));
  CHECK(told.says("one log: no interval"));
  CHECK_FALSE(fs::exists(fleet.path("models/slide/identified.toml")));
  const Ended json = fleet.add({"a.sums", "b.sums"}, {"--json"});
  const auto found = nlohmann::json::parse(json.output);
  CHECK(json.status == 1);
  CHECK(found.at("outcome") == "causes named");
  const auto& parameter = found.at("causes").at(0).at("parameters").at(0);
  const double value = parameter.at("value"), error = parameter.at("standard_error");
  CHECK(std::abs(value - 1.5) < 4.0 * error);
  CHECK(error < 0.1);
  CHECK(found.at("logs").size() == 2);
}

TEST_CASE("sums of logs that the model explains say so") {
  const Fleet fleet(0.0);
  fleet.summarise_all();
  const Ended told = fleet.add({"a.sums", "b.sums", "c.sums"});
  INFO(told.output);
  CHECK(told.status == 0);
}

// Every refusal plants its own defect.
TEST_CASE("sums that do not belong together are refused by name") {
  const Fleet fleet(1.5);
  fleet.summarise_all();
  const auto refused = [](const Ended& ended, const std::string& what) {
    INFO(ended.output);
    CHECK(ended.status == 2);
    CHECK(ended.says(what));
  };
  fs::copy_file(fleet.path("b.csv"), fleet.path("again.csv"));
  REQUIRE(fleet.summarise("again.csv", "again.sums").status == 0);
  refused(fleet.add({"a.sums", "b.sums", "again.sums"}),
          "again.sums: is of the same log as b.sums");
  refused(fleet.add({"a.sums"}, {"--sums-holdout", "a.sums"}), "is of the same log as a.sums");
  std::string bytes = fleet.text("b.sums");
  reference::write_text(fleet.path("cut.sums"), bytes.substr(0, bytes.size() / 2));
  refused(fleet.add({"a.sums", "cut.sums"}), "cut.sums: ");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  reference::write_text(fleet.path("changed.sums"), bytes);
  refused(fleet.add({"a.sums", "changed.sums"}), "changed.sums: its content is not what");
  REQUIRE(fleet.summarise("b.csv", "slow.sums", {"--band", "20"}).status == 0);
  refused(fleet.add({"a.sums", "slow.sums"}), "band 60 Hz");
  refused(fleet.sinew({"diagnose", "models/slide", "--reference", "b.csv", "--sums", "a.sums"}),
          "reference logs");
  fleet.change("models/slide/mechanism.toml", "\n", "\n# changed\n");
  refused(fleet.add({"a.sums"}), "the model");
}

TEST_CASE(
    "a log that a diagnosis refuses is not summed, and options that go together are asked for") {
  const Fleet fleet(1.5);
  reference::write_text(fleet.path("wrong.csv"), test::slide_log(4, 1.5, kSummedRows, -1.0));
  const Ended wrong = fleet.summarise("wrong.csv", "wrong.sums");
  INFO(wrong.output);
  CHECK(wrong.status == 2);
  CHECK(wrong.says("wrong.csv"));
  CHECK_FALSE(fs::exists(fleet.path("wrong.sums")));
  CHECK(fleet.summarise("a.csv", "a.csv").status == 2);
  CHECK(fleet.sinew({"diagnose", "models/slide", "--sums", "a.sums"}).says("--reference"));
  CHECK(fleet.sinew({"diagnose", "models/slide", "--log", "a.csv"}).says("--out is required"));
  CHECK(fleet.sinew({"diagnose", "models/slide", "--out", "found"}).says("--log is required"));
  const Ended lever = fleet.sinew(
      {"diagnose", SINEW_SOURCE_DIR "/models/lever", "--log", "a.csv", "--summarise", "a.sums"});
  CHECK(lever.status == 2);
}
