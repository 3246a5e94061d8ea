// SPDX-License-Identifier: GPL-3.0-or-later
// The index finger's model folder says what the source says.
#include <catch2/catch.hpp>

#include "symbolic/model/read_mechanism.h"

namespace {

sinew::Mechanism index_finger() {
  return sinew::read_mechanism(std::string(SINEW_SOURCE_DIR) + "/models/index");
}

Eigen::MatrixXd coupling_matrix(const sinew::Mechanism& mechanism) {
  Eigen::MatrixXd coupling = Eigen::MatrixXd::Zero(static_cast<int>(mechanism.tendons.size()), 4);
  for (std::size_t i = 0; i < mechanism.tendons.size(); ++i)
    for (const sinew::PulleyRouting& pulley : mechanism.tendons[i].pulleys)
      coupling(static_cast<int>(i), pulley.joint.back() - '0') = pulley.radius;
  return coupling;
}

}  // namespace

TEST_CASE("the index finger has the chain of Table 5.1", "[index]") {
  const sinew::Mechanism finger = index_finger();
  REQUIRE(finger.name == "index");
  REQUIRE(finger.gravity == Eigen::Vector3d(0, 0, -9.81));
  REQUIRE(finger.bodies.size() == 4);
  const std::vector<std::string> names{"q20", "q21", "q22", "q23"};
  for (int i = 0; i < 4; ++i) {
    const sinew::Joint& joint = finger.joints[static_cast<std::size_t>(i)];
    REQUIRE(joint.name == names[static_cast<std::size_t>(i)]);
    REQUIRE(joint.type == sinew::JointType::revolute);
    REQUIRE(joint.parent == i - 1);
    REQUIRE(joint.axis == Eigen::Vector3d::UnitZ());
    REQUIRE(joint.damping == 1e-4);
  }
  Eigen::Matrix3d quarter_turn;
  quarter_turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  REQUIRE(finger.joints[1].origin.rotation == quarter_turn);
  REQUIRE(finger.joints[1].origin.translation == Eigen::Vector3d(0.006, 0, 0));
  REQUIRE(finger.joints[2].origin.translation == Eigen::Vector3d(0.04038, 0, 0));
  REQUIRE(finger.joints[3].origin.translation == Eigen::Vector3d(0.0298, 0, -0.005));
  REQUIRE(finger.frames.at(0).name == "tip");
  REQUIRE(finger.frames.at(0).pose.translation == Eigen::Vector3d(0.0201, 0, -0.0007));
}

TEST_CASE("the index finger's inertias are rods of width 12 mm", "[index]") {
  const sinew::Mechanism finger = index_finger();
  const double masses[] = {0.002, 0.009, 0.006, 0.003};
  const double lengths[] = {0.006, 0.04038, 0.0298, 0.0201};
  for (std::size_t i = 0; i < 4; ++i) {
    const sinew::Body& body = finger.bodies[i];
    const double w = 0.012;
    const double along = masses[i] * w * w / 8;
    const double across = masses[i] * (lengths[i] * lengths[i] / 12 + w * w / 16);
    REQUIRE(body.mass == masses[i]);
    REQUIRE(body.centre_of_mass.x() == Approx(lengths[i] / 2).epsilon(1e-15));
    const Eigen::Matrix3d expected = Eigen::Vector3d(along, across, across).asDiagonal();
    REQUIRE((body.inertia - expected).cwiseAbs().maxCoeff() <= 1e-15 * across);
  }
}

TEST_CASE("the index finger's tendons are in the order of (5.5)", "[index]") {
  // The radii are the model's: a CAD change moves them, not the order and the signs.
  const Eigen::MatrixXd coupling = coupling_matrix(index_finger());
  const double r0 = coupling(0, 0), r1 = coupling(0, 1), r2 = coupling(4, 2), r3 = -coupling(6, 3);
  for (const double radius : {r0, r1, r2, r3}) REQUIRE(radius > 0.0);
  Eigen::MatrixXd expected(8, 4);
  expected << r0, r1, 0, 0, r0, -r1, 0, 0, -r0, r1, 0, 0, -r0, -r1, 0, 0,  //
      0, 0, r2, 0, 0, 0, -r2, 0, 0, 0, r2, -r3, 0, 0, -r2, r3;
  REQUIRE(coupling == expected);
}

TEST_CASE("every value of the index finger says where it is from", "[index]") {
  const sinew::Mechanism finger = index_finger();
  REQUIRE(finger.provenance.at("joint.q22.origin.xyz") == "text: Table 5.1");
  REQUIRE(finger.provenance.at("tendon.h7.pulleys[1].radius") == "assumed");
  for (const sinew::Body& body : finger.bodies)
    REQUIRE(finger.provenance.at("body." + body.name + ".mass_properties").starts_with("assumed"));
}
