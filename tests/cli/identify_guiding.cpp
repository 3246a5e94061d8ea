// SPDX-License-Identifier: GPL-3.0-or-later
// Designers' tables of guiding friction from a table that a user brings.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

using namespace sinew;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string model = std::string(SINEW_SOURCE_DIR) + "/models/guiding";

Ended identify(const Workplace& here, const std::string& table,
               const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"identify", model, "--experiment", "guiding",
                                     "--log",    table, "--out",        "guiding.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return here.sinew(arguments);
}

}  // namespace

TEST_CASE("designers' tables from the shipped example", "[identify]") {
  const Workplace here;
  const Ended run = identify(here, model + "/assumed_measurements.csv", {"--tables", "tables"});
  INFO(run.output);
  REQUIRE(run.status == 0);
  const json series = json::parse(here.text("guiding.json"))["results"]["series"];
  REQUIRE(series.size() == 10);
  CHECK(series[0]["tendon"] == "Dyneema 0.8 mm");
  CHECK(series[0]["friction_coefficient"]["value"].get<double>() == Approx(0.066).margin(0.01));
  // A smaller radius rubs more, and so does sliding.
  CHECK(series[0]["friction_coefficient"]["value"] > series[2]["friction_coefficient"]["value"]);
  const std::string friction = here.text("tables/friction_by_angle.csv"),
                    choice = here.text("tables/pulley_or_sliding.csv");
  CHECK(friction.rfind("tendon,guide,surface,radius [mm],tension [N],bending [deg],", 0) == 0);
  CHECK(friction.find("\"Dyneema 0.8 mm\",pulley,\"aluminium\",4,20,90,") != std::string::npos);
  CHECK(friction.find(",beyond\n") != std::string::npos);  // the sliding surfaces end at 180 deg
  CHECK(choice.find("\"steel 0.6 mm\",\"aluminium\",6,\"polymer\",6,20,90,") != std::string::npos);
  for (const char* plot :
       {"tables/friction_by_angle_plot.svg", "tables/pulley_or_sliding_plot.svg"})
    CHECK(here.text(plot).find("</svg>") != std::string::npos);
}

TEST_CASE("a table that is broken or says too little", "[identify]") {
  const Workplace here;
  const std::string header =
      "tendon,guide,surface,radius [mm],tension [N],bending [deg],friction [N]\n";
  reference::write_text(here.path("bad.csv"), header + "a,pulley,b,6,20,x,1\n");
  const Ended broken = identify(here, "bad.csv", {"--tables", "tables"});
  CHECK(broken.status == 2);
  CHECK(broken.says("bad.csv:2:17: 'x' is no number"));
  CHECK(!fs::exists(here.path("guiding.json")));
  CHECK(!fs::exists(here.path("tables")));
  reference::write_text(here.path("few.csv"), header + "a,pulley,b,6,20,90,1\n");
  const Ended few = identify(here, "few.csv");
  CHECK(few.status == 1);
  CHECK(
      few.says("not identified: a, pulley, b: 1 measurements at 1 bending angles; expected four"));
}
