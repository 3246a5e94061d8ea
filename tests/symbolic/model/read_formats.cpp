// SPDX-License-Identifier: GPL-3.0-or-later
// The ways one mechanism may be written down, and the conversions to SI.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <clocale>

#include "symbolic/files/identifier.h"
#include "symbolic/files/units.h"
#include "symbolic/model/check_mechanism.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/rotation.h"
#include "symbolic/model/singular_mass_matrix.h"
#include "tests/skip.h"
#include "tests/symbolic/model/malformed_case.h"
#include "tests/symbolic/model/same_mechanism.h"

using namespace sinew;
using malformed::sound_csv;
using malformed::sound_toml;

namespace {

Mechanism arm() {
  return parse_mechanism({sound_toml, sound_csv, "toml", "csv"});
}

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string out(text);
  std::size_t at = out.find(from);
  REQUIRE(at != std::string::npos);
  for (; at != std::string::npos; at = out.find(from, at + to.size()))
    out.replace(at, from.size(), to);
  return out;
}

}  // namespace

TEST_CASE("bodies are sorted depth-first, siblings in the order of their joints", "[formats]") {
  const Mechanism mechanism = arm();
  std::vector<std::string> bodies, joints;
  std::vector<int> parents;
  for (const Body& body : mechanism.bodies) bodies.push_back(body.name);
  for (const Joint& joint : mechanism.joints) {
    joints.push_back(joint.name);
    parents.push_back(joint.parent);
  }
  REQUIRE(bodies == std::vector<std::string>{"upper", "lower", "plate", "slide"});
  REQUIRE(joints == std::vector<std::string>{"q1", "q2", "mount", "q3"});
  REQUIRE(parents == std::vector<int>{-1, 0, 1, 0});
  REQUIRE(coordinate_of_joint(mechanism) == std::vector<int>{0, 1, -1, 2});
}

TEST_CASE("values are converted to SI, and quarter turns are exact", "[formats]") {
  const Mechanism mechanism = arm();
  REQUIRE(mechanism.joints[0].axis == Eigen::Vector3d::UnitZ());
  REQUIRE(mechanism.joints[0].origin.rotation.cwiseAbs().sum() == 3.0);
  REQUIRE(mechanism.joints[0].origin.rotation(2, 1) == 1.0);
  REQUIRE(mechanism.joints[0].high == 1.5707963267948966);
  REQUIRE(mechanism.joints[1].origin.translation == Eigen::Vector3d(0.1, 0, 0));
  REQUIRE(mechanism.joints[3].type == JointType::prismatic);
  REQUIRE(mechanism.joints[3].high == 0.02);
  REQUIRE(mechanism.tendons[0].h0 == 0.002);
  REQUIRE(mechanism.tendons[0].pulleys[1].radius == -0.005);
  REQUIRE(mechanism.tendons[1].straights[0].to == Eigen::Vector3d(0.1, 0, 0));
  REQUIRE(mechanism.tendon_stiffness_high == 4e4);
  REQUIRE(mechanism.couplings[0].ratio == 0.02);
  REQUIRE(mechanism.bodies[2].mass == 0.0);
  REQUIRE(mechanism.provenance.at("tendon.t1.pulleys[1].radius") == "assumed");
  REQUIRE(mechanism.provenance.at("joint.q2.origin.xyz") == "text: Table 1");
  REQUIRE(mechanism.provenance.at("body.slide.mass_properties") == "text: Table 2");
}

TEST_CASE("the table's columns, units and line ends may vary", "[formats]") {
  const Mechanism expected = arm();
  const auto read = [](const std::string& csv) {
    return parse_mechanism({sound_toml, csv, "toml", "csv"});
  };
  REQUIRE(first_difference(expected, read("\xEF\xBB\xBF" + replaced(sound_csv, "\n", "\r\n"))) ==
          "");
  REQUIRE(first_difference(expected,
                           read(replaced(sound_csv, "\n", "\n\n# remark, with commas\n"))) == "");
  REQUIRE(first_difference(expected, read(replaced(sound_csv, ",", "  ,\t"))) == "");
  REQUIRE(first_difference(expected, read(replaced(sound_csv, "0.05,", "\"+0.05\","))) == "");
  REQUIRE(first_difference(expected, read(replaced(sound_csv, "kg*m^2", "kg·m²"))) == "");
  REQUIRE(first_difference(expected, read(replaced(sound_csv, "kg*m^2", "kg m^2"))) == "");
  const std::string grams =
      "izz [g*mm^2],iyy [g mm²],ixx [g*mm^2],ixy [g mm^2],ixz [g*mm^2],iyz [g*mm^2],com_x "
      "[mm],com_y "
      "[mm],com_z [mm],mass [g],link\n"
      "500000,400000,150000,10000,20000,30000,50,0,1,500,upper\n"
      "220000,210000,60000,0,0,0,40,0,0,250,lower\n13000,12000,11000,0,0,0,10,0,0,100,slide";
  Mechanism converted = read(grams);
  converted.provenance = expected.provenance;
  REQUIRE(first_difference(expected, converted) == "");
}

TEST_CASE("numbers do not depend on the locale", "[formats]") {
  const Mechanism expected = arm();
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
    return sinew::test::skip("the locale de_DE.UTF-8 is not installed");
  const Mechanism here = arm();
  std::setlocale(LC_ALL, "C");
  REQUIRE(first_difference(expected, here) == "");
}

TEST_CASE("units convert by one rounding", "[formats]") {
  REQUIRE(to_si(6, *find_unit("mm")) == 0.006);
  REQUIRE(to_si(40.38, *find_unit("mm")) == 0.04038);
  REQUIRE(to_si(180, *find_unit("deg")) == 3.141592653589793);
  REQUIRE(to_si(3, *find_unit("g*mm^2")) == 3e-9);
  REQUIRE(find_unit(" kg * m^2 ")->dimension == Dimension::inertia);
  REQUIRE(find_unit("kg.m²")->dimension == Dimension::inertia);
  REQUIRE_FALSE(find_unit("furlong"));
  REQUIRE(units_of(Dimension::mass) == "kg, g");
}

TEST_CASE("identifiers are checked and made", "[formats]") {
  for (const char* fine : {"a", "q20", "my_arm", "Panda"}) REQUIRE_FALSE(why_not_identifier(fine));
  for (const char* wrong :
       {"", "1a", "_a", "a__b", "a-b", "int", "co_await", "restrict", "é", "main"})
    REQUIRE(why_not_identifier(wrong));
  REQUIRE(make_identifier("my-robot 2") == "my_robot_2");
  for (const char* text :
       {"", "int", "1a", "__x__", "é", "a--b", "\xff", "NULL",
        "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"})
    REQUIRE_FALSE(why_not_identifier(make_identifier(text)));
  REQUIRE(nearest("axes", {"range", "axis"}) == "axis");
  REQUIRE(nearest("q9", {"reach"}) == "");
}

TEST_CASE("rotations: convention, exact quarter turns, exact way back", "[formats]") {
  const double quarter = 1.5707963267948966;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  REQUIRE(rotation_from_rpy({quarter, 0, 0}) * y == z);
  REQUIRE(rotation_from_rpy({0, quarter, 0}) * z == x);
  REQUIRE(rotation_from_rpy({0, 0, quarter}) * x == y);
  REQUIRE(rotation_from_rpy({quarter, 0, quarter}) * y == z);  // roll first, about the fixed x
  int exact = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d rpy(std::sin(i), 1.5 * std::sin(7.0 * i + 1.0),
                              3.0 * std::sin(3.0 * i + 2.0));
    const Eigen::Matrix3d rotation = rotation_from_rpy(rpy);
    REQUIRE(is_rotation(rotation));
    const auto back = exact_rpy(rotation);
    if (back) REQUIRE(rotation_from_rpy(*back) == rotation);
    exact += back.has_value();
  }
  REQUIRE(exact > 400);  // the others are written as matrices
  REQUIRE_FALSE(is_rotation(Eigen::Vector3d(1, 1, -1).asDiagonal().toDenseMatrix()));
  REQUIRE_FALSE(is_rotation(1.001 * Eigen::Matrix3d::Identity()));
}

TEST_CASE("inertias: how strict a check they pass", "[formats]") {
  const auto diagonal = [](double a, double b, double c) {
    return Eigen::Matrix3d(Eigen::Vector3d(a, b, c).asDiagonal());
  };
  REQUIRE(strictest_check(diagonal(1, 2, 3)) == InertiaCheck::physical);  // a plate
  REQUIRE(strictest_check(diagonal(1, 2, 3.002)) ==
          InertiaCheck::physical);  // printed with 4 digits
  REQUIRE(strictest_check(diagonal(1, 2, 3.01)) == InertiaCheck::as_given);
  REQUIRE(strictest_check(diagonal(0, 2, 2)) == InertiaCheck::idealised);
  REQUIRE(strictest_check(diagonal(0, 0, 0)) == InertiaCheck::idealised);
  REQUIRE(strictest_check(diagonal(1, 2, -1e-6)) == std::nullopt);
  Eigen::Matrix3d skew = diagonal(1, 1, 1);
  skew(0, 1) = 0.1;
  REQUIRE(strictest_check(skew) == std::nullopt);
}

TEST_CASE("a mechanism made by hand is checked too", "[formats]") {
  const auto wrong = [](auto change) {
    Mechanism mechanism = arm();
    change(mechanism);
    try {
      require_sound(mechanism);
    } catch (const DescriptionError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using Catch::Contains;
  CHECK(wrong([](Mechanism&) {}) == "");
  CHECK_THAT(wrong([](Mechanism& m) { m.name = "a b"; }), Contains("has a character other"));
  CHECK_THAT(wrong([](Mechanism& m) { m.gravity[0] = std::nan(""); }),
             Contains("gravity is not finite"));
  CHECK_THAT(wrong([](Mechanism& m) { m.bodies.pop_back(); }),
             Contains("bodies and joints differ"));
  CHECK_THAT(wrong([](Mechanism& m) { m.joints[1].parent = 2; }),
             Contains("does not come after its parent"));
  CHECK_THAT(wrong([](Mechanism& m) { m.joints[1].parent = -2; }),
             Contains("does not come after its parent"));
  CHECK_THAT(wrong([](Mechanism& m) { m.joints[0].axis *= 2; }), Contains("not a unit vector"));
  CHECK_THAT(wrong([](Mechanism& m) { m.joints[0].low = 9; }), Contains("expected low < high"));
  CHECK_THAT(wrong([](Mechanism& m) { m.joints[0].origin.rotation *= 2; }),
             Contains("no rigid transform"));
  CHECK_THAT(wrong([](Mechanism& m) { m.joints[0].damping = -1; }), Contains("negative damping"));
  CHECK_THAT(wrong([](Mechanism& m) { m.bodies[0].mass = -1; }),
             Contains("mass of body 'upper' is -1"));
  CHECK_THAT(wrong([](Mechanism& m) { m.bodies[0].mass = 0; }),
             Contains("has inertia but no mass"));
  CHECK_THAT(wrong([](Mechanism& m) { m.bodies[0].centre_of_mass[1] = HUGE_VAL; }),
             Contains("not finite"));
  CHECK_THAT(wrong([](Mechanism& m) { m.bodies[0].inertia(0, 1) += 1e-6; }),
             Contains("not symmetric"));
  CHECK_THAT(wrong([](Mechanism& m) { m.bodies[1].name = "upper"; }), Contains("appears twice"));
  CHECK_THAT(wrong([](Mechanism& m) { m.tendons[0].pulleys[0].joint = "mount"; }),
             Contains("expected a moving joint"));
  CHECK_THAT(wrong([](Mechanism& m) { m.tendons[0].pulleys[0].radius = 0; }),
             Contains("without radius"));
  CHECK_THAT(wrong([](Mechanism& m) { m.tendons[0].pulleys.clear(); }),
             Contains("no pulley and no straight"));
  CHECK_THAT(wrong([](Mechanism& m) { m.tendons[1].straights[0].to_body = "x"; }),
             Contains("unknown body"));
  CHECK_THAT(wrong([](Mechanism& m) { m.couplings[0].ratio = 0; }), Contains("is not possible"));
  CHECK_THAT(wrong([](Mechanism& m) { m.couplings.push_back(m.couplings[0]); }),
             Contains("depends on two"));
  CHECK_THAT(wrong([](Mechanism& m) { m.frames[0].body = "x"; }), Contains("unknown body"));
  CHECK_THAT(wrong([](Mechanism& m) { m.frames[0].pose.rotation.setZero(); }),
             Contains("no rigid transform"));
  CHECK_THAT(wrong([](Mechanism& m) {
               for (Joint& joint : m.joints) joint.type = JointType::fixed;
             }),
             Contains("no moving joint"));
}

TEST_CASE("the mass matrix of the check: two point masses on a rod", "[formats]") {
  Mechanism arm;
  for (int i = 0; i < 2; ++i) {
    arm.bodies.push_back(
        {"b" + std::to_string(i), "", 1.0, {1, 0, 0}, Eigen::Matrix3d::Zero(), {}});
    Joint joint;
    joint.name = "q" + std::to_string(i);
    joint.parent = i - 1;
    joint.origin.translation[0] = i;
    arm.joints.push_back(joint);
  }
  const Eigen::MatrixXd mass = mass_matrix_at(arm, Eigen::Vector2d(0.3, 0.5));
  const double c = std::cos(0.5);
  REQUIRE(mass(0, 0) == Approx(3 + 2 * c));
  REQUIRE(mass(0, 1) == Approx(1 + c));
  REQUIRE(mass(1, 1) == Approx(1));
  REQUIRE_FALSE(joint_without_inertia(arm));
  arm.bodies[1].centre_of_mass.setZero();  // the second point lies on its own axis
  REQUIRE(joint_without_inertia(arm) == 1u);
  CHECK_THAT(*note_of_singular_mass_matrix(arm), Catch::Contains("inertia about its axis"));
}

TEST_CASE("an inertia that is a rounding error is none, whatever way its joint stands") {
  Mechanism arm;
  for (int i = 0; i < 2; ++i) {
    arm.bodies.push_back(
        {"b" + std::to_string(i), "", 1.0, {0.1, 0, 0}, Eigen::Matrix3d::Zero(), {}});
    Joint joint;
    joint.name = "q" + std::to_string(i);
    joint.parent = i - 1;
    joint.origin.rotation = (Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()) *
                             Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()))
                                .toRotationMatrix();
    arm.joints.push_back(joint);
  }
  // A rod along an axis that no coordinate direction is.
  const Eigen::Vector3d along = Eigen::Vector3d(3, -1, 2).normalized();
  arm.joints[1].axis = along;
  arm.bodies[1].centre_of_mass = 0.3 * along;
  arm.bodies[1].inertia = 0.02 * (Eigen::Matrix3d::Identity() - along * along.transpose());
  arm.bodies[1].inertia = (arm.bodies[1].inertia + arm.bodies[1].inertia.transpose()).eval() / 2;
  CHECK(joint_without_inertia(arm) == 1u);
  arm.bodies[1].inertia += 1e-9 * along * along.transpose();
  CHECK_FALSE(joint_without_inertia(arm));
}
