// SPDX-License-Identifier: GPL-3.0-or-later
// What is written reads back bit by bit.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "generator/outputs/outputs.h"
#include "symbolic/model/check_mechanism.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/read_urdf.h"
#include "symbolic/model/rotation.h"
#include "symbolic/model/write_mechanism.h"
#include "tests/symbolic/model/malformed_case.h"
#include "tests/symbolic/model/same_mechanism.h"

namespace fs = std::filesystem;

namespace {

/// A folder of its own, removed at the end.
class Scratch {
 public:
  Scratch() {
    std::string pattern = (fs::temp_directory_path() / "sinew_written_XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~Scratch() { fs::remove_all(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string content(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

sinew::Mechanism index_finger() {
  return sinew::read_mechanism(std::string(SINEW_SOURCE_DIR) + "/models/index");
}

sinew::Mechanism again(const sinew::Mechanism& mechanism) {
  const sinew::ModelText text = sinew::describe_mechanism(mechanism, "a comment");
  return sinew::parse_mechanism(
      {text.toml, text.csv, "mechanism.toml", "mass_properties.csv", text.names, "names.toml"});
}

Eigen::Vector3d vector(std::mt19937_64& random, double scale) {
  std::uniform_real_distribution<double> value(-scale, scale);
  return {value(random), value(random), value(random)};
}

/// A tree with every kind of joint, and numbers that use all their digits.
sinew::Mechanism random_tree(unsigned seed) {
  using namespace sinew;
  std::mt19937_64 random(seed);
  Mechanism tree;
  tree.name = "tree";
  tree.description = "quotes \" and \\ and\ttabs";
  tree.gravity = vector(random, 10.0);
  for (int i = 0; i < 6; ++i) {
    Body body{"b" + std::to_string(i), "", 0.1 + 0.01 * vector(random, 1.0)[0],
              vector(random, 0.1),     {}, {}};
    const Eigen::Matrix3d turn = rotation_from_rpy(vector(random, 3.0));
    const Eigen::Matrix3d raw =
        turn * Eigen::Vector3d(2e-3, 3e-3, 4e-3).asDiagonal() * turn.transpose();
    body.inertia = 0.5 * (raw + raw.transpose());
    Joint joint;
    joint.name = "j" + std::to_string(i);
    joint.type = i == 2 ? JointType::prismatic : i == 4 ? JointType::fixed : JointType::revolute;
    joint.parent = i == 0 ? -1 : i == 3 ? 0 : i - 1;
    joint.origin = {rotation_from_rpy(vector(random, 3.0)), vector(random, 0.3)};
    if (i == 5) joint.origin.rotation = turn * joint.origin.rotation;  // of no roll, pitch, yaw
    if (joint.type != JointType::fixed) {
      joint.axis = unit_axis(vector(random, 1.0));
      joint.low = -1.0 / 3.0;
      joint.high = 2.0 / 3.0;
      joint.damping = 1e-4 / 3.0;
      joint.friction = 0.1 / 3.0;
      joint.friction_speed = 0.2 / 3.0;
      joint.armature = 1e-3 / 3.0;
      joint.motor_turn = 0.05 / 3.0;
      joint.motor_poles = 14;
      joint.motor_slots = 12;
      joint.gear_teeth = 17;
    }
    tree.bodies.push_back(body);
    tree.joints.push_back(joint);
  }
  tree.frames.push_back(
      {"tip", "b5", {rotation_from_rpy(vector(random, 3.0)), vector(random, 0.1)}, {}});
  tree.couplings.push_back({"j3", "j1", 5.5 / 4.5, -0.1 / 3.0, {}});
  tree.provenance["body.b3.mass_properties"] = "measured: scale, \"pendulum\" # twice";
  tree.provenance["joint.j1.origin.xyz"] = "text: Table \"5.1\"";
  return tree;
}

}  // namespace

TEST_CASE("the index finger reads back as it was written", "[written]") {
  const sinew::Mechanism finger = index_finger();
  REQUIRE(first_difference(finger, again(finger)) == "");
}

TEST_CASE("a description with everything in it reads back as it was written", "[written]") {
  const sinew::Mechanism arm =
      sinew::parse_mechanism({malformed::sound_toml, malformed::sound_csv, "toml", "csv"});
  REQUIRE(first_difference(arm, again(arm)) == "");
}

TEST_CASE("an imported robot reads back as it was read", "[written]") {
  const sinew::Mechanism arm =
      sinew::parse_urdf(malformed::sound_urdf, "arm.urdf", {1.0 / 3.0, 0, -9.81});
  REQUIRE(first_difference(arm, again(arm)) == "");
}

TEST_CASE("numbers with all their digits read back", "[written]") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    sinew::Mechanism tree = random_tree(seed);
    sinew::require_sound(tree);
    sinew::Mechanism second = again(tree);
    second.provenance = tree.provenance;  // now says "assumed" where nothing was said
    REQUIRE(first_difference(tree, second) == "");
    REQUIRE(first_difference(second, again(second)).substr(0, 10) != "joints");
  }
}

TEST_CASE("a negative zero is written as zero", "[written]") {
  sinew::Mechanism finger = index_finger();
  finger.joints[0].low = -0.0;
  finger.joints[1].origin.translation[2] = -0.0;
  finger.bodies[1].centre_of_mass[1] = -0.0;
  REQUIRE(first_difference(finger, again(finger)) == "");
  const sinew::ModelText text = sinew::describe_mechanism(finger, "");
  REQUIRE(text.toml.find("-0,") == std::string::npos);
  REQUIRE(text.csv.find("-0,") == std::string::npos);
}

TEST_CASE("the comparison of mechanisms sees the last bit", "[written]") {
  const sinew::Mechanism tree = random_tree(1);
  sinew::Mechanism other = tree;
  other.joints[5].origin.rotation(2, 1) = std::nextafter(tree.joints[5].origin.rotation(2, 1), 2.0);
  REQUIRE(first_difference(tree, other) == "joints");
  other = tree;
  other.bodies[3].inertia(0, 2) = std::nextafter(tree.bodies[3].inertia(0, 2), 2.0);
  REQUIRE(first_difference(tree, other) == "bodies");
}

TEST_CASE("a model folder is written and read", "[written]") {
  const Scratch scratch;
  const sinew::Mechanism finger = index_finger();
  const fs::path folder = scratch.path() / "models" / "copy";
  sinew::Outputs outputs;
  outputs.into_folder(folder, sinew::mechanism_files(finger, "a comment"));
  outputs.commit();
  REQUIRE(first_difference(finger, sinew::read_mechanism(folder)) == "");
  REQUIRE(content(folder / "mechanism.toml").starts_with("# a comment\n[mechanism]\n"));
  REQUIRE(entries(folder.parent_path()) == 1);
}

TEST_CASE("a mechanism that cannot be described is not written", "[written]") {
  sinew::Mechanism finger = index_finger();
  finger.bodies[2].mass = std::nan("");
  REQUIRE_THROWS_AS(sinew::mechanism_files(finger, ""), std::runtime_error);
  finger = index_finger();
  finger.joints[1].name = "q 21";
  REQUIRE_THROWS_AS(sinew::mechanism_files(finger, ""), sinew::DescriptionError);
}
