// SPDX-License-Identifier: GPL-3.0-or-later
// A user's own robot, from its URDF to the diagnosis of its log, as a user does it.
#include <fmt/format.h>

#include <Eigen/Core>
#include <array>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tuple>

#include "tests/cli/program.h"
#include "tests/cli/urdf_truth.h"
#include "tests/reference/emitted_model.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

const Eigen::Vector3d up(0, 0, 9.81);  // the hand hangs

struct FoundHand : Workplace {
  FoundHand() {
    fs::copy(SINEW_SOURCE_DIR "/tests/cli/robots/found_hand.urdf", path("found.urdf"));
    imported = sinew(
        {"import", "found.urdf", "--out", "models/found", "--gravity", "0", "0", "9.81", "--json"});
  }
  Ended imported;

  /// Torques by the joints' names in the URDF.
  void write_scenario(const std::string& file, double phase) const {
    std::string text =
        "[scenario]\nduration = { value = 8, unit = \"s\" }\n"
        "output_rate = { value = 500, unit = \"Hz\" }\n[drive]\nmode = \"joint_torques\"\n"
        "[noise]\nseed = { value = 3, unit = \"1\" }\nq = { value = 1e-6, unit = \"rad\" }\n"
        "tau = { value = 1e-5, unit = \"N*m\" }\n[initial]\n\"q_0\" = { value = 0.3, unit = "
        "\"rad\" "
        "}\n";
    const std::tuple<const char*, double, double, const char*> commands[] = {
        {"0", 0.012, 1.3, "N*m"},
        {"0", 0.008, 0.7, "N*m"},
        {"\u6307", 0.05, 1.5, "N"},
        {"wheel", 2e-4, 0.9, "N*m"}};
    for (const auto& [joint, amplitude, frequency, unit] : commands)
      text += fmt::format(
          "[[command]]\nchannel = \"tau_{}\"\nshape = \"sine\"\namplitude = {{ value = {}, unit = "
          "\"{}\" }}\nfrequency = {{ value = {}, unit = \"Hz\" }}\nphase = {{ value = {}, unit = "
          "\"rad\" }}\n",
          joint, amplitude, unit, frequency, 1.5707963 + (*joint == '0' ? phase : 0.0));
    reference::write_text(path(file), text);
  }
};

double relative(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected) {
  return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

TEST_CASE("a hand as hands are found is imported, and what it has is told", "[own]") {
  const FoundHand here;
  INFO(here.imported.output);
  REQUIRE(here.imported.status == 0);
  const auto report = nlohmann::json::parse(here.imported.output);
  CHECK(report.at("name") == "found_hand_v2");
  CHECK(report.at("coordinates") == std::vector<std::string>{"n0", "joint", "wheel"});
  CHECK(report.at("followers") == std::vector<std::string>{"a_b", "a_b_1"});
  REQUIRE(report.at("warnings").size() == 1);
  CHECK(report.at("warnings")[0].get<std::string>().find("floating joint 'world_joint' is held") !=
        std::string::npos);
  const std::string names = here.text("models/found/names.toml");
  for (const char* line : {"n0 = \"0\"", "a_b = \"a-b\"", "a_b_1 = \"a/b\"", "joint = \"\u6307\"",
                           "finger_1 = \"finger/1\""})
    CHECK(names.find(line) != std::string::npos);
  // A joint that cannot move as the file says is a warning, and a mistake with --strict.
  const Ended strict = here.sinew({"import", "found.urdf", "--out", "models/strict", "--strict"});
  CHECK(strict.status == 2);
  CHECK(strict.says("found.urdf:"));
  CHECK_FALSE(fs::exists(here.path("models/strict")));
  // Another robot in its place does not inherit its names.
  reference::write_text(here.path("plain.urdf"),
                        "<robot name='plain'><link name='a'/><link name='b'/><joint name='j' "
                        "type='continuous'><parent link='a'/><child link='b'/></joint></robot>");
  REQUIRE(here.sinew({"import", "plain.urdf", "--out", "models/found", "--force"}).status == 0);
  CHECK(here.sinew({"generate", "models/found"}).status == 0);
}

TEST_CASE("the emitted C of a found hand is what its URDF says", "[own]") {
  const FoundHand here;
  const Ended generated = here.sinew({"generate", "models/found"});
  INFO(generated.output);
  REQUIRE(generated.status == 0);
  const reference::EmittedModel model(here.path("generated/found_hand_v2"));
  const auto deviation = [&](const UrdfTruth& truth) {
    double worst = 0.0;
    for (const auto& values : {std::array{0.3, 0.01, 1.2}, {-0.2, 0.03, -2.0}, {1.4, 0.0, 0.1}}) {
      const std::vector<double> inputs(values.begin(), values.end());
      const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(inputs.data(), 3);
      const auto call = [&](const char* name, int rows, int cols) {
        const std::vector<double> out = model.call(name, inputs);
        return Eigen::MatrixXd(Eigen::Map<const RowMajor>(out.data(), rows, cols));
      };
      for (const double each :
           {relative(call("forward_kinematics", 4, 4), truth.pose("tip", q).matrix()),
            relative(call("mass_matrix", 3, 3), truth.mass_matrix(q)),
            relative(call("gravity", 3, 1), truth.gravity(q, up))})
        worst = std::max(worst, each);
    }
    return worst;
  };
  const std::vector<std::string> coordinates{"0", "\u6307", "wheel"};
  CHECK(deviation(UrdfTruth(here.path("found.urdf"), coordinates)) < 1e-7);
  // Planted, each in the truth: an offset, a multiplier, the value at which a joint stands.
  const std::string original = here.text("found.urdf");
  for (const auto& [from, to] :
       {std::pair{"offset=\"0.05\"", "offset=\"0\""},
        {"multiplier=\"1.13\"", "multiplier=\"1.14\""},
        {"lower=\"0.4\" upper=\"0.4\"", "lower=\"0.41\" upper=\"0.41\""}}) {
    here.change("found.urdf", from, to);
    CHECK(deviation(UrdfTruth(here.path("found.urdf"), coordinates)) > 1e-4);
    reference::write_text(here.path("found.urdf"), original);
  }
}

TEST_CASE("a found hand moves, and a payload shows in its log under the URDF's names",
          "[own][slow]") {
  const FoundHand here;
  fs::copy(here.path("models/found"), here.path("models/loaded"), fs::copy_options::recursive);
  std::string masses = here.text("models/loaded/mass_properties.csv");
  const std::size_t row = masses.find("\nfinger_2,0.018");
  REQUIRE(row != std::string::npos);
  masses.replace(row, 15, "\nfinger_2,0.038");
  reference::write_text(here.path("models/loaded/mass_properties.csv"), masses);
  for (const auto& [name, phase] : {std::pair{"train", 0.3}, {"test", 1.9}}) {
    here.write_scenario(fmt::format("{}.toml", name), phase);
    const std::string log = fmt::format("{}.csv", name);
    const Ended run = here.sinew(
        {"simulate", "models/loaded", "--scenario", fmt::format("{}.toml", name), "--out", log});
    INFO(run.output);
    REQUIRE(run.status == 0);
    // As the robot's own recorder calls them; the mimic joints have no column.
    std::string text = here.text(log);
    for (const auto& [own, source] : {std::pair{"_n0", "_0"}, {"_joint", "_\u6307"}})
      for (std::size_t at = text.find(own); at != std::string::npos && at < text.find('\n');
           at = text.find(own, at + 1))
        text.replace(at, std::string(own).size(), source);
    reference::write_text(here.path(log), text);
  }
  const Ended ended = here.sinew({"diagnose", "models/found", "--log", "train.csv", "--holdout",
                                  "test.csv", "--out", "found"});
  INFO(ended.output);
  CHECK(ended.status == 1);
  // The tip is fixed to the link that is heavier.
  CHECK(ended.says("The model lacks: payload (link tip)."));
  // The slider's acceleration is the noise of its position; by that the model that made the log
  // was told a gear elasticity and another inertia.
  const Ended own = here.sinew(
      {"diagnose", "models/loaded", "--log", "train.csv", "--holdout", "test.csv", "--out", "own"});
  INFO(own.output);
  CHECK(own.status == 0);
  CHECK(own.says("nothing over but noise"));
  // Planted: without names.toml the log's columns are unknown.
  fs::remove(here.path("models/found/names.toml"));
  const Ended nameless = here.sinew({"diagnose", "models/found", "--log", "train.csv", "--holdout",
                                     "test.csv", "--out", "again"});
  CHECK(nameless.status == 2);
  CHECK(nameless.says("no column for channel"));
}

TEST_CASE("a robot without masses has kinematics, and says why it has no more", "[own]") {
  const FoundHand here;
  std::string text = here.text("found.urdf");
  for (std::size_t at = text.find("<inertial>"); at != std::string::npos;
       at = text.find("<inertial>"))
    text.erase(at, text.find("</inertial>") + 11 - at);
  reference::write_text(here.path("light.urdf"), text);
  const Ended imported = here.sinew({"import", "light.urdf", "--out", "models/light"});
  CHECK(imported.status == 0);
  const std::string reason = "a description of kinematics alone";
  CHECK(imported.says(reason));
  const Ended generated = here.sinew({"generate", "models/light"});
  CHECK(generated.status == 0);
  CHECK(generated.says(reason));
  const reference::EmittedModel model(here.path("generated/found_hand_v2"));
  CHECK(model.find("forward_kinematics") != nullptr);
  CHECK(model.find("tip_jacobian") != nullptr);
  CHECK(model.find("mass_matrix") == nullptr);
  CHECK(model.find("gravity") == nullptr);
  here.write_scenario("run.toml", 0.0);
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"simulate", "models/light", "--scenario", "run.toml", "--out", "run.csv"},
           {"dump", "models/light", "--function", "mass_matrix"},
           {"cost", "models/light", "--methods"},
           {"cost", "models/light", "--reduced"}}) {
    const Ended ended = here.sinew(command);
    INFO(command.front() << "\n" << ended.output);
    CHECK(ended.status == 2);
    CHECK(ended.says(reason));
  }
}
