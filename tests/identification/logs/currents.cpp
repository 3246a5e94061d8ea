// SPDX-License-Identifier: GPL-3.0-or-later
// Efforts that are logged as the currents of their motors.
#include <catch2/catch.hpp>
#include <filesystem>

#include "identification/logs/model_channels.h"
#include "identification/logs/read_csv.h"
#include "tests/identification/logs/planted_log.h"
#include "tests/reference/temporary_folder.h"

namespace {

using namespace sinew;

const std::vector<std::string> header{"time [s]", "q_elbow [rad]", "i_elbow [mA]"};

std::vector<ChannelSpec> elbow() {
  Mechanism arm;
  arm.bodies.resize(1);
  arm.joints.resize(1);
  arm.joints[0].name = "elbow";
  return robot_channels(arm);
}

ChannelSpec& effort_of(std::vector<ChannelSpec>& specs) {
  for (ChannelSpec& spec : specs)
    if (spec.role == ChannelRole::effort) return spec;
  throw std::logic_error("no effort");
}

const MappedColumn& mapped_effort(const ColumnMap& map) {
  for (const MappedColumn& m : map.channels)
    if (m.spec.role == ChannelRole::effort) return m;
  throw std::logic_error("no effort");
}

}  // namespace

TEST_CASE("a current becomes an effort by the joint's torque constant") {
  // Planted defect, seen to fail: without Mapper::current() "'mA' cannot be a unit of channel".
  std::vector<ChannelSpec> specs = elbow();
  effort_of(specs).per_ampere = 11.13;
  const ColumnMap map = map_columns(header, specs, {}, "arm.csv", 1);
  CHECK(mapped_effort(map).factor == Approx(0.01113));
  CHECK(mapped_effort(map).is_current);
  REQUIRE(map.notes.size() == 1);
  CHECK(map.notes.front().action == "'tau_elbow' is 11.13 N*m/A of it");
}

TEST_CASE("an effort goes before a current of the same joint") {
  std::vector<ChannelSpec> specs = elbow();
  effort_of(specs).per_ampere = 11.13;
  const ColumnMap map = map_columns({"time [s]", "q_elbow [rad]", "i_elbow [A]", "tau_elbow [N*m]"},
                                    specs, {}, "arm.csv", 1);
  CHECK(mapped_effort(map).column == 4);
  CHECK(mapped_effort(map).factor == 1.0);
  CHECK_FALSE(mapped_effort(map).is_current);
}

TEST_CASE("a current without a torque constant says what to give") {
  std::vector<ChannelSpec> specs = elbow();
  try {
    map_columns(header, specs, {}, "arm.csv", 1);
    FAIL("a current was taken for an effort");
  } catch (const LogError& error) {
    CHECK_THAT(error.what(), Catch::Contains("arm.csv:1:3") &&
                                 Catch::Contains("--torque-constant \"elbow=VALUE\" in N*m/A"));
  }
  effort_of(specs).keep_ampere = true;
  CHECK(mapped_effort(map_columns(header, specs, {}, "arm.csv", 1)).factor == Approx(0.001));
}

TEST_CASE("torque constants stand beside the model, and the command line goes before them") {
  const reference::TemporaryFolder folder;
  const auto write = [&](const std::string& text) {
    reference::write_text(folder.path() / "channels.toml", text);
  };
  write("[torque_constants]\nelbow = 11.13\nwrist = 10\n");
  const auto constants = torque_constants(folder.path(), {"wrist=9.5"});
  CHECK(constants.at("elbow") == 11.13);
  CHECK(constants.at("wrist") == 9.5);
  CHECK(mapped_channels(folder.path(), {}).empty());
  for (const char* bad : {"wrist", "wrist=", "wrist=-1", "=3", "wrist=3 A"})
    CHECK_THROWS_WITH(torque_constants(folder.path(), {bad}),
                      Catch::Contains("expected joint=VALUE"));
  write("[torque_constants]\nelbow = 0\n");
  CHECK_THROWS_WITH(torque_constants(folder.path(), {}),
                    Catch::Contains("torque_constants.elbow is no number above 0"));
}
