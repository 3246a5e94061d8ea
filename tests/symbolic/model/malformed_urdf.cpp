// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/symbolic/model/malformed_case.h"

namespace malformed {

const std::string_view sound_urdf = R"(<?xml version="1.0"?>
<robot name="arm">
  <!-- base -->
  <link name="world"/>
  <link name="upper">
    <inertial>
      <origin xyz="0.1 0 0" rpy="0 0 0.5"/>
      <mass value="2"/>
      <inertia ixx="0.01" iyy="0.02" izz="0.025" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <visual><geometry><mesh filename="upper.stl"/></geometry></visual>
  </link>
  <link name="lower">
    <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
  </link>
  <link name="tool"/>
  <joint name="shoulder" type="revolute">
    <parent link="world"/>
    <child link="upper"/>
    <origin xyz="0 0 0.3" rpy="1.5707963267948966 0 0"/>
    <axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="10" velocity="3"/>
    <dynamics damping="0.1" friction="0"/>
  </joint>
  <joint name="elbow" type="prismatic">
    <parent link="upper"/>
    <child link="lower"/>
    <axis xyz="1 0 0"/>
    <limit lower="0" upper="0.2" effort="10" velocity="1"/>
    <mimic joint="shoulder" multiplier="0.1"/>
  </joint>
  <joint name="flange" type="fixed">
    <parent link="lower"/>
    <child link="tool"/>
  </joint>
</robot>
)";

const std::vector<Case>& urdf_cases() {
  static const std::vector<Case> cases{
      // XML
      {sound_urdf, "", "^", "not well-formed XML"},
      {sound_urdf, "   \n", "", "not well-formed XML"},
      {sound_urdf, "not xml", "", "not well-formed XML"},
      {sound_urdf, "{\"robot\": 1}", "", "not well-formed XML"},
      {sound_urdf, "<!-- only a comment -->", "^", "the file has no element"},
      {sound_urdf, "<robot name=\"a\">", "", "not well-formed XML"},
      {"</robot>", "", "", "not well-formed XML"},
      {"</robot>", "</robo>", "", "not well-formed XML"},
      {"<link name=\"world\"/>", "<link name=\"world\">", "", "not well-formed XML"},
      {"<link name=\"world\"/>", "<link name=\"world/>", "", "not well-formed XML"},
      {"<link name=\"world\"/>", "<link name=\"world\" name=\"x\"/>", "", "not well-formed XML"},
      {"<link name=\"world\"/>", "<link name/>", "", "not well-formed XML"},
      {"<!-- base -->", "<!-- base", "", "not well-formed XML"},
      {"<!-- base -->", "base", "base", "text inside <robot>"},
      {"</robot>\n", "</robot>\n<robot name=\"b\"/>", "<robot name=\"b\"",
       "the document goes on after </robot>"},
      {"</robot>\n", "</robot>\nrest", "rest", "text outside the root element"},
      {"<robot name=\"arm\">", "<robot>", "<robot>", "<robot> has no name"},
      {"<robot name=\"arm\">", "<robot name=\"\">", "<robot", "<robot> has no name"},
      {sound_urdf, "<sdf version=\"1.6\"/>", "^", "the root element is <sdf>; expected <robot"},
      {sound_urdf, "<robot name=\"a\"/>", "^", "the robot has no link"},
      {sound_urdf, "<robot name=\"a\"><link name=\"b\"/></robot>", "^",
       "the robot has no moving joint"},
      // links
      {"<link name=\"world\"/>", "<link/>", "<link/>", "<link> has no name"},
      {"<link name=\"world\"/>", "<link nmae=\"world\"/>", "<link nmae", "<link> has no name"},
      {"<link name=\"world\"/>", "<Link name=\"world\"/>", "<Link",
       "unknown element <Link> in <robot>; expected <link>"},
      {"<link name=\"world\"/>", "<xacro:macro name=\"world\"/>", "<xacro", "run xacro first"},
      {"lower=\"-2\"", "lower=\"${-limit}\"", "lower=\"${", "a xacro file, which is not expanded"},
      {"xyz=\"0.1 0 0\"", "xyz=\"$(arg x) 0 0\"", "xyz=\"$(arg",
       "xacro robot.urdf.xacro > robot.urdf"},
      {"<link name=\"world\"/>", "<link name=\"world\"/><link name=\"floor\"/>",
       "<link name=\"floor\"", "two root links: world, floor"},
      {"<link name=\"world\"/>",
       "<link name=\"world\"/><link name=\"floor\"/><link name=\"wall\"/>", "<link name=\"floor\"",
       "several root links: world, floor, wall"},
      {"<link name=\"tool\"/>", "<link name=\"upper\"/>", "<link name=\"upper\"/>",
       "link 'upper' is defined a second time"},
      {"<link name=\"tool\"/>", "", "<child link=\"tool\"", "unknown child 'tool'"},
      {"<link name=\"tool\"/>", "<link name=\"tools\"/>", "<child link=\"tool\"",
       "did you mean 'tools'?"},
      {"<link name=\"tool\"/>", "<link name=\"tool\">steel</link>", "steel", "text inside <link>"},
      {"<link name=\"tool\"/>", "<link name=\"tool\"><inertail/></link>", "<inertail",
       "expected <inertial>"},
      {"<link name=\"tool\"/>", "<link name=\"tool\"><inertial/></link>", "<inertial/>",
       "<inertial> has no <mass>"},
      {"<link name=\"tool\"/>", "<link name=\"tool\"><inertial/></link>", "<inertial/>",
       "<inertial> has no <inertia>"},
      {"<link name=\"tool\"/>", "<link name=\"tool\"><inertial/><inertial /></link>",
       "<inertial />", "<link> has a second <inertial>"},
      // inertials
      {"<mass value=\"2\"/>", "", "<inertial>\n", "<inertial> has no <mass>"},
      {"<mass value=\"2\"/>", "<mass/>", "<mass/>", "<mass> has no value"},
      {"<mass value=\"2\"/>", "<mass vlaue=\"2\"/>", "vlaue",
       "unknown attribute 'vlaue' of <mass>; expected 'value'"},
      {"<mass value=\"2\"/>", "<mass value=\"\"/>", "value=\"\"", "value of <mass> is ''"},
      {"<mass value=\"2\"/>", "<mass value=\"two\"/>", "value=\"two\"",
       "value of <mass> is 'two'; expected a finite number"},
      {"<mass value=\"2\"/>", "<mass value=\"2,0\"/>", "value=\"2,0\"", "value of <mass> is '2,0'"},
      {"<mass value=\"2\"/>", "<mass value=\"2 kg\"/>", "value=\"2 kg\"", "value of <mass>"},
      {"<mass value=\"2\"/>", "<mass value=\"2 3\"/>", "value=\"2 3\"", "value of <mass> is '2 3'"},
      {"<mass value=\"2\"/>", "<mass value=\"nan\"/>", "value=\"nan\"", "expected a finite number"},
      {"<mass value=\"2\"/>", "<mass value=\"inf\"/>", "value=\"inf\"", "expected a finite number"},
      {"<mass value=\"2\"/>", "<mass value=\"1e400\"/>", "value=\"1e400\"",
       "expected a finite number"},
      {"<mass value=\"2\"/>", "<mass value=\"-2\"/>", "<mass value=\"-2\"",
       "the mass of link 'upper' is -2 kg"},
      {"<mass value=\"2\"/>", "<mass value=\"0\"/>", "<mass value=\"0\"",
       "link 'upper' has inertia but no mass"},
      {"<mass value=\"2\"/>", "<mass value=\"2\"/><mass value=\"3\"/>", "<mass value=\"3\"",
       "<inertial> has a second <mass>"},
      {"<mass value=\"2\"/>", "<mass value=\"2\"/>kg", "kg\n", "text inside <inertial>"},
      {"izz=\"0.025\" ", "", "<inertia ixx=\"0.01\" iyy=\"0.02\"", "<inertia> has no izz"},
      {"izz=\"0.025\" ", "izz=\"x\" ", "izz=\"x\"", "izz of <inertia> is 'x'"},
      {"izz=\"0.025\" ", "izz=\"-0.025\" ", "<inertia ixx=\"0.01\" iyy=\"0.02\"",
       "link 'upper': the inertia is not positive definite"},
      {"ixy=\"0\" ixz=\"0\" iyz=\"0\"", "ixy=\"0.05\" ixz=\"0\" iyz=\"0\"",
       "<inertia ixx=\"0.01\" iyy=\"0.02\"", "not positive definite"},
      {"<origin xyz=\"0.1 0 0\"", "<origin xyz=\"0.1 0\"", "xyz=\"0.1 0\"",
       "xyz of <origin> is '0.1 0'; expected 3 finite numbers"},
      {"<origin xyz=\"0.1 0 0\"", "<origin xyz=\"0.1 0 0 0\"", "xyz=\"0.1 0 0 0\"",
       "expected 3 finite numbers"},
      {"<origin xyz=\"0.1 0 0\"", "<origin xyz=\"0.1 0 O\"", "xyz=\"0.1 0 O\"",
       "expected 3 finite numbers"},
      {"<origin xyz=\"0.1 0 0\"", "<origin xzy=\"0.1 0 0\"",
       "xzy=", "unknown attribute 'xzy' of <origin>; expected 'xyz'"},
      {"rpy=\"0 0 0.5\"", "rpy=\"0 0 inf\"", "rpy=\"0 0 inf\"", "rpy of <origin>"},
      {"rpy=\"0 0 0.5\"", "ryp=\"0 0 0.5\"", "ryp=", "expected 'rpy'"},
      // joints
      {"<joint name=\"shoulder\" ", "<joint ", "<joint type=\"revolute\"", "<joint> has no name"},
      {"<joint name=\"elbow\" ", "<joint name=\"shoulder\" ",
       "<joint name=\"shoulder\" type=\"prismatic\"", "joint 'shoulder' is defined a second time"},
      {"type=\"revolute\"", "", "<joint name=\"shoulder\"", "the joint has no type"},
      {"type=\"revolute\"", "type=\"revolut\"", "<joint name=\"shoulder\"",
       "unknown joint type 'revolut' (did you mean 'revolute'?)"},
      {"type=\"revolute\"", "type=\"hinge\"", "<joint name=\"shoulder\"",
       "expected one of: revolute, continuous"},
      {"<parent link=\"world\"/>", "", "<joint name=\"shoulder\"", "<joint> has no <parent>"},
      {"<parent link=\"world\"/>", "<parent/>", "<parent/>", "<parent> has no link"},
      {"<parent link=\"world\"/>", "<parent link=\"wrold\"/>", "<parent link=\"wrold\"",
       "unknown parent 'wrold' (did you mean 'world'?)"},
      {"<parent link=\"world\"/>", "<parent link=\"lower\"/>", "<joint name=\"shoulder\"",
       "cycle: upper <- lower <- upper"},
      {"<parent link=\"world\"/>", "<parent link=\"upper\"/>", "<joint name=\"shoulder\"", "cycle"},
      {"<parent link=\"world\"/>", "<parent link=\"world\"/><parent link=\"tool\"/>",
       "<parent link=\"tool\"", "<joint> has a second <parent>"},
      {"<child link=\"upper\"/>", "", "<joint name=\"shoulder\"", "<joint> has no <child>"},
      {"<child link=\"upper\"/>", "<child link=\"\"/>", "<child link=\"\"", "unknown child ''"},
      {"<child link=\"upper\"/>", "<child link=\"lower\"/>", "<child link=\"lower\"/>\n    <axis",
       "is carried by joint"},
      {"<child link=\"upper\"/>", "<child link=\"world\"/>", "<joint name=\"shoulder\"",
       "cycle: world <- world"},
      {"<child link=\"upper\"/>", "<chlid link=\"upper\"/>", "<chlid", "expected <child>"},
      {"<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 0\"/>", "<axis xyz=\"0 0 0\"",
       "the axis of joint 'shoulder' is zero"},
      {"<axis xyz=\"0 0 1\"/>", "<axis/>", "<axis/>", "<axis> has no xyz"},
      {"<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 1\"/>", "xyz=\"0 1\"", "xyz of <axis> is '0 1'"},
      {"<axis xyz=\"0 0 1\"/>", "<axis xyz=\"z\"/>", "xyz=\"z\"", "xyz of <axis> is 'z'"},
      {"<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 1\"/><axis xyz=\"1 0 0\" />",
       "<axis xyz=\"1 0 0\" />", "<joint> has a second <axis>"},
      {"<axis xyz=\"0 0 1\"/>", "<axs xyz=\"0 0 1\"/>", "<axs",
       "unknown element <axs> in <joint>; expected <axis>"},
      {"lower=\"-2\"", "lower=\"-inf\"", "lower=\"-inf\"", "expected a finite number"},
      {"lower=\"-2\"", "lowr=\"-2\"", "lowr",
       "unknown attribute 'lowr' of <limit>; expected 'lower'"},
      {"velocity=\"3\"", "velocity=\"fast\"", "velocity=\"fast\"", "velocity of <limit> is 'fast'"},
      {"effort=\"10\" velocity=\"3\"", "effort=\"-\" velocity=\"3\"", "effort=\"-\"",
       "effort of <limit>"},
      {"damping=\"0.1\"", "damping=\"-0.1\"", "<dynamics", "the damping is negative"},
      {"damping=\"0.1\"", "damping=\"a\"", "damping=\"a\"", "damping of <dynamics>"},
      {"damping=\"0.1\"", "dampin=\"0.1\"", "dampin=", "expected 'damping'"},
      {"<mimic joint=\"shoulder\"", "<mimic", "<mimic", "<mimic> has no joint"},
      {"<mimic joint=\"shoulder\"", "<mimic joint=\"shoulders\"", "<mimic",
       "joint 'elbow' mimics the unknown joint 'shoulders'"},
      {"<mimic joint=\"shoulder\"", "<mimic joint=\"elbow\"", "<mimic", "mimics itself"},
      {"<limit lower=\"-2\" upper=\"2\" effort=\"10\" velocity=\"3\"/>", "<mimic joint=\"elbow\"/>",
       "<mimic joint=\"shoulder\"", "mimics itself, by way of other joints"},
      {"multiplier=\"0.1\"", "multiplier=\"\"", "multiplier=\"\"", "multiplier of <mimic>"},
      {"multiplier=\"0.1\"", "offset=\"a\"", "offset=\"a\"", "offset of <mimic>"},
      // everything fixed
      {sound_urdf,
       "<robot name=\"a\"><link name=\"b\"/><link name=\"c\"/><joint name=\"j\" type=\"fixed\">"
       "<parent link=\"b\"/><child link=\"c\"/></joint></robot>",
       "^", "the robot has no moving joint"},
      {sound_urdf,
       "<robot name=\"a\"><link name=\"b\"/><link name=\"c\"/>"
       "<joint name=\"i\" type=\"fixed\"><parent link=\"b\"/><child link=\"c\"/></joint>"
       "<joint name=\"j\" type=\"fixed\"><parent link=\"c\"/><child link=\"b\"/></joint></robot>",
       "<link name=\"b\"", "no root link"},
  };
  return cases;
}

}  // namespace malformed
