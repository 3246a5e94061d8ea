// SPDX-License-Identifier: GPL-3.0-or-later
// What a mechanism learns leaves it one that there can be: bodies with pseudo-inertias that are
// positive, and a mass matrix that accelerates the way it is pushed.
#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/extension/learnt_mass_matrix.h"
#include "symbolic/files/description_error.h"
#include "symbolic/model/pseudo_inertia.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/singular_mass_matrix.h"
#include "tests/reference/newton_euler.h"

using namespace sinew;

namespace {

/// Two links in a plane.
Mechanism two_links() {
  Mechanism arm;
  arm.name = "arm";
  for (int i = 0; i < 2; ++i) {
    const Eigen::Matrix3d I = Eigen::Vector3d(1e-4, 1e-3, 1e-3).asDiagonal();
    arm.bodies.push_back({i ? "tip" : "root", "", 0.3, {0.1, 0, 0}, I, {}});
    Joint joint;
    joint.name = i ? "q2" : "q1";
    joint.parent = i - 1;
    joint.origin.translation[0] = 0.2 * i;
    joint.low = 0.3;
    joint.high = 1.5;
    joint.armature = 1e-4;
    arm.joints.push_back(joint);
  }
  return arm;
}

IdentifiedEffect entry(const std::string& effect, const std::string& place,
                       const std::vector<std::pair<std::string, double>>& values) {
  IdentifiedEffect result;
  result.effect = effect;
  result.place = place;
  for (const auto& [name, value] : values) result.coefficients.push_back({name, value, 0.0, ""});
  return result;
}

Identified learnt(const IdentifiedEffect& one) {
  return {{one}, {}};
}

std::string refusal(const Mechanism& arm, const IdentifiedEffect& one) {
  try {
    const Mechanism changed = with_identified(arm, learnt(one));
    return why_not_definite(changed, {}, learnt(one)).value_or("");
  } catch (const DescriptionError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a point of mass has the moments of inertia that its place gives it") {
  // Planted defect: moments left 0 where none was given: the body's own inertia turned negative,
  // and the link was refused.
  const Mechanism arm = two_links();
  const Mechanism loaded = with_identified(
      arm, learnt(entry("payload", "link tip", {{"mass", 0.5}, {"first_moment_x", 0.15}})));
  const Body& tip = loaded.bodies[1];
  CHECK(tip.mass == Approx(0.8));
  CHECK(tip.centre_of_mass.x() == Approx((0.03 + 0.15) / 0.8));
  const double apart = 0.2;  // of both centres
  CHECK(tip.inertia(2, 2) == Approx(1e-3 + 0.3 * 0.5 / 0.8 * apart * apart));
  CHECK(tip.inertia(0, 0) == Approx(1e-4));
  CHECK(is_physical(body_pseudo_inertia(tip)));
}

TEST_CASE("a link of another mass and centre keeps its shape") {
  const Mechanism arm = two_links();
  const Mechanism light =
      with_identified(arm, learnt(entry("inertial_parameters", "link tip",
                                        {{"mass", -0.15}, {"first_moment_x", -0.01}})));
  CHECK(light.bodies[1].mass == Approx(0.15));
  CHECK(light.bodies[1].centre_of_mass.x() == Approx(0.02 / 0.15));
  CHECK(light.bodies[1].inertia(2, 2) == Approx(0.5e-3));
}

TEST_CASE("a link that is no body is refused") {
  // Planted defect: without is_physical() in change_body(): read, and M(0, 0) = -0.74 kg m^2.
  using Catch::Contains;
  const Mechanism arm = two_links();
  CHECK_THAT(refusal(arm, entry("payload", "link tip", {{"mass", 0.1}, {"moment_xx", -1.0}})),
             Contains("link 'tip'") && Contains("not positive definite"));
  CHECK_THAT(refusal(arm, entry("inertial_parameters", "link root", {{"mass", -0.4}})),
             Contains("without mass"));
  CHECK_THAT(refusal(arm, entry("payload", "link none", {{"mass", 0.4}})),
             Contains("there is no link none"));
  // Moments that each are positive, and together belong to no body.
  CHECK_THAT(
      refusal(arm,
              entry("payload", "link tip",
                    {{"mass", 0.1}, {"moment_xx", 1.0}, {"moment_yy", 1e-3}, {"moment_zz", 1e-3}})),
      Contains("not positive definite"));
  // A described inertia that breaks the triangle rule may be loaded by what is a body.
  Mechanism odd = arm;
  odd.bodies[1].inertia = Eigen::Vector3d(1e-3, 1e-4, 1e-4).asDiagonal();
  CHECK(refusal(odd, entry("payload", "link tip", {{"mass", 0.1}})) == "");
}

TEST_CASE("what a drive learns leaves the mass matrix positive at every corner") {
  // The more the elbow is stretched, the less inertia has a shoulder whose elbow gives way: the
  // mass matrix is indefinite in a part of the range only. Planted defect: the centre of the
  // ranges alone: it is read, nothing is said.
  const Mechanism arm = two_links();
  const auto change = [](double inertia) {
    return entry("inertia", "q1", {{"inertia_change", inertia}});
  };
  const Eigen::MatrixXd straight = mass_matrix_at(arm, Eigen::Vector2d(0.3, 0.3)),
                        bent = mass_matrix_at(arm, Eigen::Vector2d(0.3, 0.9));
  const auto schur = [](const Eigen::MatrixXd& M) {
    return M(0, 0) + 1e-4 - M(0, 1) * M(0, 1) / (M(1, 1) + 1e-4);
  };
  const double least = schur(straight), in_the_middle = schur(bent);
  REQUIRE(least < 0.9 * in_the_middle);
  CHECK(refusal(arm, change(-0.9 * least)) == "");
  const std::string why = refusal(arm, change(-0.5 * (least + in_the_middle)));
  INFO(why);
  CHECK(why.find("would not be positive definite at q1 = ") != std::string::npos);
  CHECK(why.find("'inertia' at 'q1'") != std::string::npos);
}

TEST_CASE("a finger that a torque would accelerate the wrong way in a quarter of its range") {
  // Bent fingers have little inertia about the joint that spreads them. What takes away more than
  // they have then, and less than a straight one has, leaves the centre of the ranges as it should
  // be. Planted defects: without is_physical() in change_body() the mass matrix alone is to blame
  // for load and link; without a look at the mass matrix, too, nothing is said of any of the three.
  using Catch::Contains;
  const Mechanism finger = read_mechanism(SINEW_SOURCE_DIR "/models/index");
  constexpr double change = -6.4e-6;  // kg*m^2
  std::vector<Range> ranges;
  for (const Joint& joint : finger.joints) ranges.push_back({joint.low, joint.high});
  const std::vector<Eigen::VectorXd> samples = workspace_samples(ranges);
  const auto acceleration = [&](const Eigen::VectorXd& q) {  // of q20, by a torque of 1 N*m there
    Eigen::MatrixXd M = mass_matrix_at(finger, q);
    M(0, 0) += change;
    return Eigen::MatrixXd(M.inverse())(0, 0);
  };
  std::size_t wrong = 0;
  for (const Eigen::VectorXd& q : samples) wrong += acceleration(q) < 0.0;
  CHECK(wrong > samples.size() / 4);
  CHECK(acceleration(samples.front()) > 0.0);
  CHECK_THAT(refusal(finger, entry("inertia", "q20", {{"inertia_change", change}})),
             Contains("not be positive definite at q20 = "));
  // The same by a load or a link whose moments are no body's: in 30 % of the range.
  for (const char* effect : {"payload", "inertial_parameters"})
    CHECK_THAT(
        refusal(finger, entry(effect, "link distal", {{"mass", 1e-6}, {"moment_zz", -2.6e-7}})),
        Contains("link 'distal'"));
}

TEST_CASE("a motor keeps an inertia") {
  MotorParameters motor;
  motor.gear_ratio = 0.01;
  motor.rotor_inertia = 1e-7;
  motor.gearbox_inertia = 1e-4;
  motor.torque_constant = 0.02;
  motor.gamma1 = 100.0;
  const DrivenModel driven = driven_model(motor, "m");
  const auto with = [&](double change) {
    return why_not_definite(driven,
                            learnt(entry("inertia", "motor", {{"inertia_change", change}})));
  };
  CHECK_FALSE(with(-0.9 * 1.1e-3));
  CHECK(with(-1.1 * 1.1e-3));
}

TEST_CASE("the states that are looked at: the centre, the corners, and between them") {
  const std::vector<Range> three(3, Range{-1.0, 2.0}), many(12, Range{-1.0, 2.0});
  const auto few = workspace_samples(three), more = workspace_samples(many);
  CHECK(few.size() == 1 + 8 + 64);
  CHECK(more.size() == 1 + 256 + 64);
  for (const auto* all : {&few, &more})
    for (const Eigen::VectorXd& q : *all) {
      CHECK(q.minCoeff() >= -1.0);
      CHECK(q.maxCoeff() <= 2.0);
    }
  // Every corner's side is taken by every coordinate about as often.
  for (Eigen::Index k = 0; k < 12; ++k) {
    int high = 0;
    for (std::size_t i = 1; i <= 256; ++i) high += more[i](k) > 1.9;
    CHECK(std::abs(high - 128) < 20);
  }
}

TEST_CASE("a finger with a four-bar and coupled joints is looked at as it moves") {
  for (const char* name : {"index", "ring", "thumb"}) {
    const Mechanism finger = read_mechanism(fmt::format("{}/models/{}", SINEW_SOURCE_DIR, name));
    const std::string link = "link " + finger.bodies.back().name;
    INFO(name);
    CHECK(refusal(finger, entry("payload", link, {{"mass", 0.02}, {"first_moment_x", 1e-4}})) ==
          "");
  }
}

TEST_CASE("a joint whose sensor reads too much stands where it is") {
  // Planted defects, each seen to fail: the offset with the other sign; a slide along the parent's
  // axis.
  for (const JointType type : {JointType::revolute, JointType::prismatic}) {
    Mechanism arm = two_links();
    arm.joints[1].type = type;
    arm.joints[1].axis = Eigen::Vector3d(0.6, 0.0, 0.8);
    arm.joints[1].origin.rotation =
        Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()).toRotationMatrix();
    const double offset = 0.07;
    const Mechanism learnt_arm =
        with_identified(arm, learnt(entry("sensor_offset", "q2", {{"zero_offset", offset}})));
    const reference::NewtonEuler<double> as_drawn(arm), as_learnt(learnt_arm);
    const Eigen::Vector2d q(0.5, 0.9), qd(0.3, -0.7), qdd(1.1, 0.4);
    const Eigen::Vector2d read = q + Eigen::Vector2d(0.0, offset);
    const Eigen::VectorXd expected = as_drawn.inverse_dynamics(q, qd, qdd);
    CHECK((as_learnt.inverse_dynamics(read, qd, qdd) - expected).norm() < 1e-12 * expected.norm());
  }
}

TEST_CASE("the zero of a joint that moves another one is not adopted") {
  // Planted defect, seen to fail: the joint that moves the other one is not asked about.
  Mechanism arm = two_links();
  arm.couplings.push_back({"q2", "q1", 0.8, 0.0, {}});
  for (const char* joint : {"q1", "q2"})
    CHECK(refusal(arm, entry("sensor_offset", joint, {{"zero_offset", 0.05}}))
              .find("is coupled with another one") != std::string::npos);
  CHECK(refusal(two_links(), entry("sensor_offset", "q9", {{"zero_offset", 0.05}}))
            .find("there is no joint 'q9'") != std::string::npos);
}
