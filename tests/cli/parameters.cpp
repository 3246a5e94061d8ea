// SPDX-License-Identifier: GPL-3.0-or-later
// `sinew parameters`: the table of the real-time step follows from the model.
#include <catch2/catch.hpp>

#include "tests/cli/program.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

void copy_models(const Workplace& here) {
  fs::copy(SINEW_SOURCE_DIR "/models", here.path("models"),
           fs::copy_options::recursive | fs::copy_options::skip_existing);
}

}  // namespace

TEST_CASE("the committed table of the hand's step is what the model gives", "[parameters]") {
  const Workplace here;
  copy_models(here);
  const Ended made = here.sinew({"parameters", "models/hand", "--out", "table.c"});
  INFO(made.output);
  REQUIRE(made.status == 0);
  INFO("to accept: sinew parameters models/hand --out generated/hand_step/hand_parameters.c");
  CHECK(here.text("table.c") ==
        reference::read_text(SINEW_SOURCE_DIR "/generated/hand_step/hand_parameters.c"));
}

TEST_CASE("a change of the model or of the settings changes the table", "[parameters]") {
  const Workplace here;
  copy_models(here);
  here.change("models/tendon/part.toml", "value = 6400", "value = 6000");
  here.change("models/hand/real_time.toml", "value = 60, unit = \"N*m\"",
              "value = 50, unit = \"N*m\"");
  REQUIRE(here.sinew({"parameters", "models/hand", "--out", "table.c"}).status == 0);
  const std::string table = here.text("table.c");
  CHECK(table.find(".servo_gain = 50,") != std::string::npos);
  CHECK(table != reference::read_text(SINEW_SOURCE_DIR "/generated/hand_step/hand_parameters.c"));
}

TEST_CASE("mistakes in the settings are told with their place, and nothing is written",
          "[parameters]") {
  const Workplace here;
  copy_models(here);
  CHECK(here.sinew({"parameters", "models/index", "--out", "table.c"}).says("is no hand"));
  here.change("models/hand/real_time.toml", "turns = { value = 6", "turns = { value = 4");
  here.change("models/hand/real_time.toml", "range = { value = [0, 4095]",
              "range = { value = [4095, 0]");
  const Ended refused = here.sinew({"parameters", "models/hand", "--out", "table.c"});
  CHECK(refused.status == 2);
  CHECK(refused.says("real_time.toml:15:"));
  CHECK(refused.says("there is no schedule of so many turns"));
  CHECK(refused.says("the range is empty"));
  CHECK_FALSE(fs::exists(here.path("table.c")));
}

}  // namespace sinew
