// SPDX-License-Identifier: GPL-3.0-or-later
// That what is hidden in a trial has the size its seal says, and what no size of it can show.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/blind/seals.h"
#include "tests/blind/truth/compared.h"
#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

namespace {

using namespace sinew::trials;
using nlohmann::json;
namespace fs = std::filesystem;

}  // namespace

TEST_CASE("what a joint's cause makes its motors do is no size of it") {
  std::unique_ptr<TrialPlant> finger = plant_of("finger", 1);
  for (std::uint64_t seed = 2; finger->traits().at("motors") != "logged"; ++seed)
    finger = plant_of("finger", seed);
  const int joints = std::stoi(finger->traits().at("joints"));
  const int tendons = std::stoi(finger->traits().at("tendons"));
  const auto motor_shows = [&](const Hidden& hidden, int tendon) {
    return finger->shows(hidden, static_cast<std::size_t>(joints + tendon));
  };
  Hidden hidden;
  hidden.cause = "payload";
  hidden.at = joints - 1;
  CHECK(finger->shows(hidden, 0));
  for (int i = 0; i < tendons; ++i) CHECK_FALSE(motor_shows(hidden, i));
  hidden.cause = "force_sensor_scale";
  hidden.at = 2;
  CHECK(motor_shows(hidden, 2));
  CHECK_FALSE(motor_shows(hidden, 3));
  hidden.cause = "viscous_level";
  hidden.at = joints + 5;  // the sixth motor
  CHECK(motor_shows(hidden, 5));
  CHECK_FALSE(motor_shows(hidden, 2));
}

TEST_CASE("what a model has wrong of its bodies, gravity and coupling has the size asked for") {
  struct Case {
    const char *plant, *cause;
    std::uint64_t seed;
    double size;
  };
  // Planted defect: where true_chain gives back the chain as the model has it, no dose of the
  // second reaches any size: "the largest dose is too small", excess 0.
  for (const Case& c : {Case{"finger", "coupling_ratio", 1, 0.3},
                        {"finger", "gravity_left_out", 2, 1.0},
                        {"arm", "gravity_left_out", 2, 1.0},
                        {"arm", "link_centre", 3, 0.5},
                        {"arm", "link_products", 3, 0.3},
                        {"joint", "gravity_left_out", 7, 1.0}}) {
    const sinew::reference::TemporaryFolder folder;
    TrialRequest request;
    request.plant = c.plant;
    request.cause = c.cause;
    request.size = c.size;
    request.seed = c.seed;
    const json seal = seal_of(request, folder.path() / "trial");
    INFO(c.plant << " " << seal.dump());
    REQUIRE(seal.at("reachable"));
    CHECK(seal.at("hidden").at(0).at("cause") == c.cause);
    CHECK(seal.at("hidden").at(0).at("excess") == Approx(c.size).epsilon(0.045));
  }
}

TEST_CASE(
    "a size that a cause cannot reach makes an unreachable trial, and no other cause takes its "
    "place") {
  // Planted defect: where a cause that is not reached is passed over for another draw, as trials
  // once did, this one never ends.
  const sinew::reference::TemporaryFolder folder;
  TrialRequest request;
  request.plant = "joint";
  request.seed = 5;
  request.cause = "viscous_asymmetry";
  request.size = 1.0e5;
  const json seal = seal_of(request, folder.path() / "trial");
  CHECK_FALSE(seal.at("reachable"));
  REQUIRE(seal.at("hidden").size() == 1);
  CHECK(seal.at("hidden").at(0).at("cause") == "viscous_asymmetry");
  CHECK(seal.at("hidden").at(0).contains("unreachable"));
  CHECK_FALSE(fs::exists(folder.path() / "trial"));
}

TEST_CASE("the same size is the same share of the motion's effort, however heavy the joint") {
  const sinew::reference::TemporaryFolder folder;
  TrialRequest request;
  request.cause = "viscous_asymmetry";
  int compared = 0;
  for (request.seed = 1; request.seed < 6; ++request.seed) {
    request.plant = "joint";
    const json light = seal_of(request, folder.path() / "light");
    request.plant = "heavy_joint";
    const json heavy = seal_of(request, folder.path() / "heavy");
    REQUIRE(light.at("reachable") == heavy.at("reachable"));
    if (!light.at("reachable")) continue;
    ++compared;
    CHECK(heavy.at("hidden").at(0).at("value").get<double>() ==
          Approx(20.0 * light.at("hidden").at(0).at("value").get<double>()).epsilon(0.01));
  }
  CHECK(compared >= 3);
}

TEST_CASE("what is always fitted takes nothing of a cause's size twice") {
  // A column of what is fitted leaves nothing of itself; noise of unit rms is the unit.
  sinew::truth::Draw draw(1);
  Channel channel;
  const Index rows = 4000;
  channel.noise = VectorXd(rows);
  channel.added = VectorXd(rows);
  for (Index k = 0; k < rows; ++k) {
    channel.noise(k) = draw.normal();
    channel.added(k) = std::sin(0.01 * static_cast<double>(k));
  }
  channel.moving = VectorXd::Ones(rows);
  channel.band = 50.0;
  channel.fitted = MatrixXd(rows, 0);
  const Size alone = size_of({channel}, 0.002);
  CHECK(alone.excess == alone.plain);
  CHECK(alone.excess > 0.5);
  // One line of a white noise of variance 1, what is seen of it beyond the faded ends: 0.5 A^2 n / 2.
  CHECK(alone.nats == Approx(0.25 * rows).epsilon(0.4));
  channel.noise *= 2.0;
  CHECK(size_of({channel}, 0.002).nats == Approx(0.25 * alone.nats).epsilon(1e-9));
  channel.noise *= 0.5;
  channel.fitted = channel.added;
  CHECK(size_of({channel}, 0.002).excess < 1e-6 * alone.excess);
  // A tenth of the band is a tenth of the noise's power: the unit is the noise in the same band.
  channel.fitted = MatrixXd(rows, 0);
  channel.band = 5.0;
  CHECK(size_of({channel}, 0.002).excess == Approx(std::sqrt(10.0) * alone.excess).epsilon(0.2));
}

TEST_CASE("a fault that no channel can show is none to be found") {
  // Planted defect: all faults reachable: a wrist's clock, which its model does not read.
  const sinew::reference::TemporaryFolder place;
  std::map<std::string, int> of_clock, shown;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const char* plant : {"wrist", "drive"}) {
      TrialRequest request;
      request.plant = plant;
      request.family = "fault";
      request.seed = seed;
      const json seal = seal_of(request, place.path());
      const json& excess = seal["fault"]["excess"];
      REQUIRE(seal["reachable"].get<bool>() == (excess.is_null() || excess.get<double>() >= 1.0));
      REQUIRE(seal["fault"].contains("unreachable") != seal["reachable"].get<bool>());
      if (seal["fault"]["fault"] != "clock") continue;
      ++of_clock[plant];
      shown[plant] += seal["reachable"].get<bool>() ? 1 : 0;
    }
  CHECK(of_clock["wrist"] > 0);
  CHECK(shown["wrist"] == 0);
  CHECK(of_clock["drive"] > 0);
  CHECK(shown["drive"] == of_clock["drive"]);
}

TEST_CASE("a dose with which another simulator loses the motion is too large", "[slow][thorough]") {
  // Planted defect: MuJoCo's start anew taken for the motion, its warning in the seal's place.
  if (!mujoco_is_there()) return sinew::test::skip("this build has no MuJoCo");
  const sinew::reference::TemporaryFolder place;
  TrialRequest request;
  request.plant = "mujoco_finger";
  request.family = "outside";
  request.cause = "handling";
  request.size = 2.0;
  request.seed = 145038387461254;
  fs::remove("MUJOCO_LOG.TXT");
  const json hidden = seal_of(request, place.path())["hidden"].front();
  const std::string why = hidden.value("unreachable", "");
  CHECK(why != "the largest dose is too small");
  CHECK_FALSE(fs::exists("MUJOCO_LOG.TXT"));
}
