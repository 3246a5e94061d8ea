// SPDX-License-Identifier: GPL-3.0-or-later
// What is possible and not plausible is told, and nothing that is built.
#include "symbolic/model/plausibility.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/read_urdf.h"
#include "symbolic/tendons/pulling.h"

using namespace sinew;

namespace {

const std::filesystem::path source = SINEW_SOURCE_DIR;

/// All suspicions of a mechanism, one a line.
std::string told(const Mechanism& mechanism) {
  std::string text;
  for (const auto& found : {implausible_bodies(mechanism), implausible_tendons(mechanism)})
    for (const Suspicion& each : found) text += to_text(each) + "\n";
  return text;
}

Mechanism index_finger() {
  return read_mechanism(source / "models/index");
}

Body& body_called(Mechanism& mechanism, const std::string& name) {
  for (Body& body : mechanism.bodies)
    if (body.name == name) return body;
  throw std::out_of_range(name);
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("no shipped model and no robot of tests and benchmarks is suspected", "[plausible]") {
  for (const char* name : {"index", "middle", "ring", "fifth", "thumb", "thumb_table_5_2"})
    CHECK(told(read_mechanism(source / "models" / name)) == "");
  for (const char* robot : {"benchmarks/robots/panda.urdf", "benchmarks/robots/finger.urdf",
                            "tests/cli/robots/found_hand.urdf"})
    CHECK(told(read_urdf(source / robot, {0, 0, -9.81})) == "");
}

TEST_CASE("slips of units are told", "[plausible]") {
  Mechanism pulley = index_finger();
  pulley.tendons[0].pulleys[0].radius = 5.5;
  CHECK(says(told(pulley), "radius of 5.5 m"));
  Mechanism centimetres = index_finger();
  centimetres.tendons[0].pulleys[0].radius = 0.2;  // larger than the whole finger
  CHECK(says(told(centimetres), "all links together"));
  Mechanism grams = index_finger();
  body_called(grams, "proximal").mass = 9.0;
  CHECK(says(told(grams), "body 'proximal' of 9 kg"));
  Mechanism all_grams = index_finger();
  for (Body& body : all_grams.bodies) body.mass *= 1000, body.inertia *= 1000;
  CHECK(says(told(all_grams), "no material is so dense"));
  Mechanism link = index_finger();
  link.joints[2].origin.translation = {40.38, 0, 0};
  CHECK(says(told(link), "reaches 40.38 m from its joint"));
  Mechanism millimetres = index_finger();
  for (Joint& joint : millimetres.joints) joint.origin.translation *= 1000;
  for (Body& body : millimetres.bodies) body.centre_of_mass *= 1000;
  CHECK(says(told(millimetres), "(and so"));
  Mechanism inertia = index_finger();
  body_called(inertia, "medial").inertia *= 1e4;  // kg cm^2
  CHECK(says(told(inertia), "is the inertia in another unit"));
}

TEST_CASE("one kilogram everywhere is what exporters write", "[plausible]") {
  Mechanism panda = read_urdf(source / "benchmarks/robots/panda.urdf", {0, 0, -9.81});
  for (Body& body : panda.bodies)
    if (body.mass > 0.0) body.mass = 1.0;
  CHECK(says(told(panda), "exporters write 1 kg"));
  body_called(panda, panda.bodies.front().name).mass = 1.1;
  CHECK_FALSE(says(told(panda), "exporters write 1 kg"));
}

TEST_CASE("products of inertia of the other sign are told", "[plausible]") {
  // Rods that lean in a plane of their frames: the joint at one end, the next one at the other.
  Mechanism arm = index_finger();
  for (std::size_t i = 0; i < arm.bodies.size(); ++i) {
    const Eigen::Vector3d along = Eigen::Vector3d(0.03, i % 2 ? 0.02 : -0.02, 0.0);
    Body& body = arm.bodies[i];
    body.mass = 0.01;
    body.centre_of_mass = along / 2;
    body.inertia = body.mass * ((along.squaredNorm() / 12 + 9e-6) * Eigen::Matrix3d::Identity() -
                                along * along.transpose() / 12);
    if (i + 1 < arm.joints.size()) arm.joints[i + 1].origin.translation = along;
  }
  arm.frames[0].pose.translation = arm.bodies.back().centre_of_mass * 2;
  CHECK(told(arm) == "");
  for (Body& body : arm.bodies)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (i != j) body.inertia(i, j) *= -1;
  CHECK(says(told(arm), "turn the signs"));
}

TEST_CASE("routing that cannot hold the joints is told", "[plausible]") {
  Mechanism flexors = index_finger();
  for (Tendon& tendon : flexors.tendons)
    for (PulleyRouting& pulley : tendon.pulleys) pulley.radius = std::abs(pulley.radius);
  CHECK(says(told(flexors), "no force closure"));
  Mechanism unreached = index_finger();
  for (Tendon& tendon : unreached.tendons)
    std::erase_if(tendon.pulleys, [](const PulleyRouting& each) { return each.joint == "q22"; });
  std::erase_if(unreached.tendons, [](const Tendon& each) { return each.pulleys.empty(); });
  CHECK(says(told(unreached), "no tendon reaches joint 'q22'"));
  CHECK_FALSE(says(told(unreached), "rank"));
  Mechanism together = index_finger();
  for (Tendon& tendon : together.tendons)
    for (PulleyRouting& pulley : tendon.pulleys)
      if (pulley.joint == "q20")
        for (const PulleyRouting& other : tendon.pulleys)
          if (other.joint == "q21") pulley.radius = other.radius;
  CHECK(says(told(together), "P has rank 3 for the 4 joints"));
}

TEST_CASE("tensions that balance are found, and what shows there are none", "[plausible]") {
  Eigen::MatrixXd P(3, 2);
  P << 1, 0, 0, 1, -1, -1e-3;
  CHECK_FALSE(motion_against_all(P));
  P(2, 1) = 0;  // the second joint is pulled one way only
  const auto motion = motion_against_all(P);
  REQUIRE(motion);
  CHECK((P * *motion).minCoeff() > -1e-12);
  CHECK((P * *motion).maxCoeff() > 0.5);
}
