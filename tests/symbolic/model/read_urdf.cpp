// SPDX-License-Identifier: GPL-3.0-or-later
// Robots in URDF: trees, joints of every kind, turned inertias, odd axes, order and names.
#include "symbolic/model/read_urdf.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <filesystem>

#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/singular_mass_matrix.h"
#include "symbolic/model/write_mechanism.h"
#include "tests/symbolic/model/malformed_case.h"
#include "tests/symbolic/model/same_mechanism.h"

using namespace sinew;

namespace {

const Eigen::Vector3d down(0, 0, -9.81);

/// A link with mass 1 and the inertia of a ball, or with the inertial given.
std::string link_xml(
    const std::string& name,
    const std::string& inertial =
        "<mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>") {
  return fmt::format("<link name='{}'>{}</link>\n", name,
                     inertial.empty() ? "" : "<inertial>" + inertial + "</inertial>");
}

std::string joint_xml(
    const std::string& name, const std::string& parent, const std::string& child,
    const std::string& type = "revolute",
    const std::string& rest = "<limit lower='-1' upper='1' effort='0' velocity='0'/>") {
  return fmt::format("<joint name='{}' type='{}'><parent link='{}'/><child link='{}'/>{}</joint>\n",
                     name, type, parent, child, rest);
}

std::string robot(const std::string& content, const std::string& name = "robot") {
  return fmt::format("<?xml version='1.0'?>\n<robot name='{}'>\n{}</robot>\n", name, content);
}

Mechanism read(const std::string& text, std::vector<std::string>* notes = nullptr) {
  return parse_urdf(text, "test.urdf", down, notes);
}

std::vector<std::string> joint_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const Joint& each : mechanism.joints) names.push_back(each.name);
  return names;
}

bool has_note(const std::vector<std::string>& notes, const std::string& phrase) {
  for (const std::string& note : notes)
    if (note.find(phrase) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("a branched tree is ordered depth-first, siblings as in the file", "[urdf]") {
  // Names and places are against the alphabet: sorted by name, every order below would differ.
  const Mechanism tree =
      read(robot(link_xml("tip_z") + joint_xml("wrist", "forearm", "tip_z") + link_xml("trunk") +
                 joint_xml("z_shoulder", "trunk", "upper") + link_xml("upper") +
                 joint_xml("m_shoulder", "trunk", "other") + link_xml("other") +
                 joint_xml("a_shoulder", "trunk", "last") + link_xml("last") +
                 joint_xml("elbow_b", "upper", "forearm") + link_xml("forearm") +
                 joint_xml("elbow_a", "upper", "finger") + link_xml("finger")));
  REQUIRE(joint_names(tree) == std::vector<std::string>{"z_shoulder", "elbow_b", "wrist", "elbow_a",
                                                        "m_shoulder", "a_shoulder"});
  std::vector<int> parents;
  for (const Joint& each : tree.joints) parents.push_back(each.parent);
  REQUIRE(parents == std::vector<int>{-1, 0, 1, 0, -1, -1});
  REQUIRE(tree.bodies[2].name == "tip_z");
  std::vector<std::string> frames;
  for (const Frame& frame : tree.frames) frames.push_back(frame.name);
  REQUIRE(frames == std::vector<std::string>{"tip_z", "finger", "other", "last"});
}

TEST_CASE("joint kinds, ranges and dynamics", "[urdf]") {
  std::vector<std::string> notes;
  const std::string damped =
      "<limit lower='-0.5' upper='1.5' effort='1' velocity='4'/><dynamics damping='0.25' "
      "friction='0.5'/>";
  const Mechanism arm =
      read(robot(link_xml("base", "") +
                 joint_xml("a", "base", "b", "continuous", "<axis xyz='0 0 -3'/>") + link_xml("b") +
                 joint_xml("c", "b", "d", "prismatic", damped + "<axis xyz='1 1 0'/>") +
                 link_xml("d") + joint_xml("e", "d", "f", "fixed", "<axis xyz='0 0 0'/>") +
                 link_xml("f") + joint_xml("g", "f", "h", "revolute", "") + link_xml("h") +
                 joint_xml("i", "h", "j", "prismatic", "") + link_xml("j")),
           &notes);
  REQUIRE(arm.joints[0].type == JointType::revolute);
  REQUIRE(arm.joints[0].axis == Eigen::Vector3d(0, 0, -1));
  REQUIRE(arm.joints[0].low == -3.141592653589793);
  REQUIRE(arm.joints[0].high == 3.141592653589793);
  REQUIRE(arm.joints[1].type == JointType::prismatic);
  REQUIRE(arm.joints[1].axis.isApprox(Eigen::Vector3d(std::sqrt(0.5), std::sqrt(0.5), 0), 1e-15));
  REQUIRE(arm.joints[1].low == -0.5);
  REQUIRE(arm.joints[1].high == 1.5);
  REQUIRE(arm.joints[1].max_velocity == 4);
  REQUIRE(arm.joints[1].damping == 0.25);
  REQUIRE(arm.joints[2].type == JointType::fixed);
  REQUIRE(arm.joints[3].axis == Eigen::Vector3d::UnitX());  // URDF's own default
  REQUIRE(arm.joints[3].high == 3.141592653589793);
  REQUIRE(arm.joints[4].high == 1.0);
  REQUIRE(arm.provenance.at("joint.g.range") == "assumed");
  REQUIRE(arm.provenance.at("joint.c.range") == "urdf");
  REQUIRE(has_note(notes, "joint 'g' has no range: -pi to pi is assumed"));
  REQUIRE(has_note(notes, "joint 'i' has no range: -1 to 1 m is assumed"));
  REQUIRE(arm.joints[1].friction == 0.5);
  REQUIRE_FALSE(has_note(notes, "joint 'a'"));
}

TEST_CASE("inertias are turned into link axes", "[urdf]") {
  const std::string inertial =
      "<origin xyz='0.1 0.2 0.3' rpy='{} {} {}'/><mass value='2'/>"
      "<inertia ixx='1' ixy='0.1' ixz='-0.2' iyy='2' iyz='0.3' izz='2.5'/>";
  const auto inertia = [&](double roll, double pitch, double yaw) {
    const Mechanism arm =
        read(robot(link_xml("base", "") + joint_xml("j", "base", "b") +
                   link_xml("b", fmt::format(fmt::runtime(inertial), roll, pitch, yaw))));
    REQUIRE(arm.bodies[0].centre_of_mass == Eigen::Vector3d(0.1, 0.2, 0.3));
    return arm.bodies[0].inertia;
  };
  Eigen::Matrix3d given;
  given << 1, 0.1, -0.2, 0.1, 2, 0.3, -0.2, 0.3, 2.5;
  REQUIRE(inertia(0, 0, 0) == given);
  Eigen::Matrix3d quarter;  // a quarter turn about z: x becomes y, y becomes -x
  quarter << 2, -0.1, -0.3, -0.1, 1, -0.2, -0.3, -0.2, 2.5;
  REQUIRE(inertia(0, 0, 1.5707963267948966) == quarter);
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  const Eigen::Matrix3d turned = inertia(0.3, -0.4, 0.7);
  REQUIRE(turned == turned.transpose());
  REQUIRE(turned.isApprox(turn * given * turn.transpose(), 1e-15));
}

TEST_CASE("origins: translation in the parent, roll pitch yaw, exact quarter turns", "[urdf]") {
  const Mechanism arm = read(
      robot(link_xml("base", "") +
            joint_xml("j", "base", "b", "continuous",
                      "<origin xyz='1e-3\t2\n3' rpy='1.5707963267948966 0 -3.141592653589793'/>") +
            link_xml("b")));
  Eigen::Matrix3d expected;
  expected << -1, 0, 0, 0, 0, 1, 0, 1, 0;
  REQUIRE(arm.joints[0].origin.rotation == expected);
  REQUIRE(arm.joints[0].origin.translation == Eigen::Vector3d(1e-3, 2, 3));
}

TEST_CASE("massless links: frames may be, moving ends may not", "[urdf]") {
  const std::string start = link_xml("base", "") + joint_xml("a", "base", "b") + link_xml("b");
  const Mechanism arm =
      read(robot(start + joint_xml("f", "b", "flange", "fixed", "") + link_xml("flange", "")));
  REQUIRE(arm.bodies[1].mass == 0.0);
  REQUIRE(arm.frames.at(0).name == "tip");
  REQUIRE(arm.frames.at(0).body == "flange");
  // A moving link without mass is fine where a body with mass follows.
  REQUIRE_NOTHROW(
      read(robot(link_xml("base", "") + joint_xml("a", "base", "b") + link_xml("b", "") +
                 joint_xml("c", "b", "d", "revolute", "<axis xyz='0 1 0'/>") + link_xml("d"))));
  // One that moves nothing is taken; its inverse dynamics can be derived.
  std::vector<std::string> notes;
  read(robot(start + joint_xml("f", "b", "flange") + link_xml("flange", "")), &notes);
  REQUIRE(notes.size() == 1);
  REQUIRE_THAT(notes.front(),
               Catch::Contains("test.urdf:6:1: the mass matrix is singular: joint 'f' can move"));
  const std::string zero =
      "<mass value='0'/><inertia ixx='0' ixy='0' ixz='0' iyy='0' iyz='0' izz='0'/>";
  REQUIRE_NOTHROW(
      read(robot(start + joint_xml("f", "b", "flange", "fixed", "") + link_xml("flange", zero))));
}

TEST_CASE("unusual inertias are taken with a note", "[urdf]") {
  std::vector<std::string> notes;
  const auto inertial = [](const std::string& xx) {
    return "<origin xyz='0.1 0.1 0'/><mass value='1'/><inertia ixx='" + xx +
           "' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>";
  };
  const auto arm = [&](const std::string& xx) {
    return read(
        robot(link_xml("base", "") + joint_xml("a", "base", "b") + link_xml("b", inertial(xx))),
        &notes);
  };
  REQUIRE(arm("3").bodies[0].inertia(0, 0) == 3);  // identified values may break the triangle rule
  REQUIRE(has_note(notes, "violates the triangle inequality"));
  notes.clear();
  arm("0");  // a thin rod
  REQUIRE(has_note(notes, "link 'b': the inertia is not positive definite"));
  notes.clear();
  arm("1");
  REQUIRE(notes.empty());
}

TEST_CASE("names become identifiers, and that is said", "[urdf]") {
  std::vector<std::string> notes;
  const Mechanism arm =
      read(robot(link_xml("world") + joint_xml("joint-1", "world", "base") + link_xml("base") +
                     joint_xml("joint 1", "base", "link 1") + link_xml("link 1") +
                     joint_xml("double", "link 1", "link_1") + link_xml("link_1"),
                 "my-robot 2"),
           &notes);
  REQUIRE(arm.name == "my_robot_2");
  REQUIRE(has_note(notes, "test.urdf:2:1: robot 'my-robot 2' is called my_robot_2"));
  REQUIRE(joint_names(arm) == std::vector<std::string>{"joint_1", "joint_1_1", "double_1"});
  REQUIRE(arm.joints[0].source_name == "joint-1");
  REQUIRE(arm.bodies[0].name == "base_1");
  REQUIRE(arm.bodies[1].name == "link_1_1");
  REQUIRE(arm.bodies[2].name == "link_1");  // an identifier stays what it is
  REQUIRE(arm.bodies[2].source_name == "");
  REQUIRE(has_note(notes, "the mass of the root link 'world' is ignored"));
}

TEST_CASE("mimic joints become couplings", "[urdf]") {
  const Mechanism arm = parse_urdf(malformed::sound_urdf, "test.urdf", down);
  REQUIRE(arm.couplings.size() == 1);
  REQUIRE(arm.couplings[0].dependent == "elbow");
  REQUIRE(arm.couplings[0].independent == "shoulder");
  REQUIRE(arm.couplings[0].ratio == 0.1);
}

TEST_CASE("chains of mimics become one step, with their offsets", "[urdf]") {
  const auto mimic = [](const std::string& joint, double multiplier, double offset) {
    return fmt::format(
        "<limit lower='-1' upper='1' effort='0' velocity='0'/><mimic joint='{}' multiplier='{}' "
        "offset='{}'/>",
        joint, multiplier, offset);
  };
  const std::string chain =
      link_xml("base", "") + joint_xml("a", "base", "b") + link_xml("b") +
      joint_xml("c", "b", "d", "revolute", mimic("a", 2, 0.5)) + link_xml("d") +
      joint_xml("e", "d", "f", "revolute", mimic("c", -3, 0.25)) + link_xml("f");
  const Mechanism arm = read(robot(chain));
  REQUIRE(arm.couplings.size() == 2);
  REQUIRE(arm.couplings[0].ratio == 2);
  REQUIRE(arm.couplings[0].offset == 0.5);
  REQUIRE(arm.couplings[1].independent == "a");
  REQUIRE(arm.couplings[1].ratio == -6);
  REQUIRE(arm.couplings[1].offset == -1.25);  // -3 * 0.5 + 0.25
  // What follows something that stands still stands still, and so on.
  const auto fixed = [&](const std::string& from, const std::string& to) {
    std::string changed = chain;
    changed.replace(changed.find(from), from.size(), to);
    return read(robot(changed + joint_xml("g", "f", "h") + link_xml("h")));
  };
  const Mechanism zero = fixed("multiplier='2'", "multiplier='0'");
  REQUIRE(zero.couplings.empty());
  REQUIRE(zero.joints[1].type == JointType::fixed);
  const Eigen::AngleAxisd half(0.5, Eigen::Vector3d::UnitX());
  REQUIRE(zero.joints[1].origin.rotation.isApprox(half.toRotationMatrix(), 1e-15));
  const Eigen::AngleAxisd followed(-3 * 0.5 + 0.25, Eigen::Vector3d::UnitX());
  REQUIRE(zero.joints[2].origin.rotation.isApprox(followed.toRotationMatrix(), 1e-15));
  const Mechanism still = fixed("lower='-1' upper='1'", "lower='0.3' upper='0.3'");
  REQUIRE(coordinate_count(still) == 1);
}

TEST_CASE("ranges of one value, none, swapped and without end", "[urdf]") {
  std::vector<std::string> notes;
  const auto limited = [&](const std::string& limits) {
    notes.clear();
    return read(robot(link_xml("base", "") +
                      joint_xml("a", "base", "b", "prismatic",
                                "<limit " + limits + " effort='0' velocity='0'/>") +
                      link_xml("b") + joint_xml("c", "b", "d") + link_xml("d")),
                &notes);
  };
  const Mechanism none = limited("lower='0' upper='0'");  // what exporters write
  CHECK(none.joints[0].low == -1.0);
  CHECK(has_note(notes, "joint 'a' has no range"));
  const Mechanism one = limited("lower='0.25' upper='0.25'");
  CHECK(one.joints[0].type == JointType::fixed);
  CHECK(one.joints[0].origin.translation == Eigen::Vector3d(0.25, 0, 0));
  CHECK(has_note(notes, "the joint stands at 0.25 m"));
  const Mechanism swapped = limited("lower='0.5' upper='-0.25'");
  CHECK(swapped.joints[0].low == -0.25);
  CHECK(swapped.joints[0].high == 0.5);
  CHECK(has_note(notes, "swapped"));
  const Mechanism endless = limited("lower='-1e16' upper='1e16'");
  CHECK(endless.joints[0].high == 1.0);
}

TEST_CASE("floating and planar joints are held, which is a warning", "[urdf]") {
  for (const std::string type : {"floating", "planar"}) {
    std::vector<std::string> notes, warnings;
    const Mechanism arm =
        parse_urdf(robot(link_xml("world", "") + joint_xml("free", "world", "base", type, "") +
                         link_xml("base") + joint_xml("a", "base", "b") + link_xml("b")),
                   "test.urdf", down, &notes, &warnings);
    CHECK(coordinate_count(arm) == 1);
    CHECK(arm.joints[0].type == JointType::fixed);
    CHECK(has_note(warnings, "the " + type + " joint 'free' is held"));
  }
}

TEST_CASE("moments negative by rounding are zero, others are mistakes", "[urdf]") {
  const auto moments = [](const std::string& xx, const std::string& others) {
    return "<mass value='0.01'/><inertia ixx='" + xx + "' ixy='0' ixz='0' iyy='" + others +
           "' iyz='0' izz='" + others + "'/>";
  };
  std::vector<std::string> notes;
  const auto body = [&](const std::string& inertial) {
    return read(robot(link_xml("base", "") + joint_xml("a", "base", "b") +
                      link_xml("b", inertial + "<origin xyz='0.01 0.01 0'/>")),
                &notes)
        .bodies[0];
  };
  CHECK(body(moments("-2.4e-35", "0")).inertia.isZero(0.0));
  CHECK(has_note(notes, "negative by rounding"));
  CHECK(body(moments("-1e-21", "1e-6")).inertia(0, 0) == 0.0);
  // Planted: a moment of -1e-9 kg m^2 of 10 g is no rounding (a radius of gyration of 0.3 mm).
  CHECK_THROWS_WITH(body(moments("-1e-9", "1e-6")), Catch::Contains("not positive definite"));
}

TEST_CASE("a robot without masses is one of kinematics alone", "[urdf]") {
  std::vector<std::string> notes;
  const Mechanism arm =
      read(robot(link_xml("base", "") + joint_xml("a", "base", "b") + link_xml("b", "") +
                 joint_xml("c", "b", "d") + link_xml("d", "")),
           &notes);
  REQUIRE(is_massless(arm));
  REQUIRE(notes.size() == 1);
  REQUIRE(has_note(notes, "a description of kinematics alone"));
  notes.clear();
  read(robot(link_xml("base", "") + joint_xml("a", "base", "b") + link_xml("b") +
             joint_xml("f", "b", "c", "fixed", "") + "<link name='c'><visual/></link>\n"),
       &notes);
  CHECK(has_note(notes, "link 'c' has a shape and no <inertial>"));
}

TEST_CASE("names.toml holds the source's names and reads back", "[urdf]") {
  const Mechanism hand =
      read(robot(link_xml("palm", "") + joint_xml("0", "palm", "a-b") + link_xml("a-b") +
                 joint_xml("j/1", "a-b", "\u6307") + link_xml("\u6307") +
                 joint_xml("\u95a2\u7bc0", "\u6307", "q") + link_xml("q")));
  CHECK(joint_names(hand) == std::vector<std::string>{"n0", "j_1", "joint"});
  CHECK(hand.joints[2].source_name == "\u95a2\u7bc0");
  const auto files = mechanism_files(hand, "");
  const std::string& names = files.at("names.toml");
  CHECK(names.find("n0 = \"0\"") != std::string::npos);
  const auto again = [&](const std::string& text) {
    return parse_mechanism({files.at("mechanism.toml"), files.at("mass_properties.csv"),
                            "mechanism.toml", "mass_properties.csv", text, "names.toml"});
  };
  CHECK(first_difference(hand, again(names)) == "");
  // Planted: a joint that the model does not have, a name given twice, one that is no text.
  CHECK_THROWS_WITH(
      again("[joint]\nn1 = \"0\"\n"),
      Catch::Contains("names.toml:2:6: the model has no joint 'n1' (did you mean 'n0'?)"));
  CHECK_THROWS_WITH(again("[joint]\nn0 = \"x\"\nj_1 = \"x\"\n"),
                    Catch::Contains("two joints are called 'x'"));
  CHECK_THROWS_WITH(again("[joint]\nn0 = 3\n"), Catch::Contains("joint.n0 is no text"));
  CHECK_THROWS_WITH(again("[joints]\n"), Catch::Contains("'joints' is unknown"));
}

TEST_CASE("what does not concern the mechanism is left out", "[urdf]") {
  std::vector<std::string> notes;
  const std::string plain = link_xml("base", "") + joint_xml("a", "base", "b") + link_xml("b");
  const Mechanism expected = read(robot(plain));
  const std::string extras =
      "<!-- a remark --><material name='blue'/><gazebo><plugin filename='x'>text</plugin></gazebo>"
      "<transmission name='t'><joint name='zz'/></transmission><loop name='x'/>";
  const Mechanism arm = read(robot(extras + plain), &notes);
  REQUIRE(first_difference(expected, arm) == "");
  REQUIRE(notes.size() == 1);
  REQUIRE(has_note(notes, "<loop> in <robot> is ignored"));
}

TEST_CASE("files that cannot be read", "[urdf]") {
  REQUIRE_THROWS_WITH(read_urdf("no/such.urdf", down),
                      Catch::Contains("no/such.urdf: cannot be read"));
  REQUIRE_THROWS_WITH(read_urdf(".", down), Catch::Contains("cannot be read"));
  REQUIRE_THROWS_WITH(read_mechanism("no/such"), Catch::Contains("mechanism.toml: cannot be read"));
  REQUIRE_THROWS_WITH(read(std::string("<robot\0name='a'/>", 17)), Catch::Contains("zero byte"));
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  REQUIRE_THROWS_WITH(read(deep), Catch::Contains("nested more than 200 deep"));
}

TEST_CASE("the robots of the benchmarks", "[urdf]") {
  const std::filesystem::path folder = std::string(SINEW_SOURCE_DIR) + "/benchmarks/robots";
  const Mechanism panda = read_urdf(folder / "panda.urdf", down);
  REQUIRE(coordinate_count(panda) == 7);
  REQUIRE(panda.bodies[6].mass == 0.735522);
  REQUIRE(panda.joints[3].origin.rotation.cwiseAbs().sum() == 3.0);
  const Mechanism finger = read_urdf(folder / "finger.urdf", {1.7, -3.1, -9.1});
  REQUIRE(coordinate_count(finger) == 4);
  REQUIRE(finger.gravity == Eigen::Vector3d(1.7, -3.1, -9.1));
}
