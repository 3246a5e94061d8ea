// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/symbolic/model/malformed_case.h"

namespace malformed {

const std::string_view sound_toml = R"(# an arm with a slide
[mechanism]
name = "arm"
description = "Test arm"
gravity = { value = [0, 0, -9.81], unit = "m/s^2", from = "assumed" }

[values]
reach = { value = [100, 0, 0], unit = "mm", from = "text", ref = "Table 1" }
r1 = { value = 5, unit = "mm", from = "assumed" }

[[body]]
name = "slide"
[[body]]
name = "upper"
[[body]]
name = "lower"
inertia_check = "idealised"
[[body]]
name = "plate"
massless = true

[[joint]]
name = "q1"
type = "revolute"
parent = "base"
child = "upper"
origin.rpy = { value = [90, 0, 0], unit = "deg", from = "assumed" }
axis = [0, 0, 2]
range = { value = [-90, 90], unit = "deg", from = "assumed" }
max_velocity = { value = 8, unit = "rad/s", from = "assumed" }
max_acceleration = { value = 80, unit = "rad/s^2", from = "assumed" }
damping = { value = 1e-4, unit = "N*m*s/rad", from = "measured", ref = "bench" }

[[joint]]
name = "q2"
type = "revolute"
parent = "upper"
child = "lower"
origin = { xyz = "reach" }
axis = { value = [0, 1, 0], from = "text", ref = "Fig. 2" }
range = { value = [-1, 1], unit = "rad", from = "assumed" }

[[joint]]
name = "q3"
type = "prismatic"
parent = "upper"
child = "slide"
origin.rotation = { value = [[0, -1, 0], [1, 0, 0], [0, 0, 1]], from = "assumed" }
axis = [1, 0, 0]
range = { value = [0, 20], unit = "mm", from = "assumed" }

[[joint]]
name = "mount"
type = "fixed"
parent = "lower"
child = "plate"

[[frame]]
name = "tip"
body = "plate"
pose.xyz = { value = [0.01, 0, 0], unit = "m", from = "cad" }

[[tendon]]
name = "t1"
h0 = { value = 2, unit = "mm", from = "assumed" }
pulleys = [{ joint = "q1", radius = "r1" }, { joint = "q2", radius = "-r1" }]
[[tendon]]
name = "t2"
straights = [
  { from_body = "base", from_point = { value = [0, 1, 0], unit = "m", from = "cad" }, to_body = "lower", to_point = "reach" },
]

[[coupling]]
dependent = "q3"
independent = "q2"
ratio = { value = 0.02, from = "assumed" }

[tendon_defaults]
stiffness = { value = [1, 40], unit = "N/mm", from = "assumed" }
max_force = { value = 90, unit = "N", from = "assumed" }
)";

const std::vector<Case>& toml_cases() {
  static const std::vector<Case> cases{
      // syntax
      {"[mechanism]", "[mechanism", "", "expected TOML 1.0"},
      {"name = \"arm\"", "name = \"arm", "", "expected TOML 1.0"},
      {"name = \"arm\"", "name : \"arm\"", "", "expected TOML 1.0"},
      {"name = \"arm\"", "name = arm", "arm\n", "expected TOML 1.0"},
      {"name = \"arm\"", "name = \"arm\"\nname = \"leg\"", "\"leg\"", "cannot redefine"},
      {"name = \"arm\"", "name = \"\\q\"", "", "expected TOML 1.0"},
      {"name = \"arm\"", "= \"arm\"", "", "expected TOML 1.0"},
      {"value = [0, 0, -9.81]", "value = [0, 0, -9.81", "", "expected TOML 1.0"},
      {"value = [0, 0, -9.81]", "value = [0, 0, -9,81 x]", "", "expected TOML 1.0"},
      {"value = [0, 0, -9.81]", "value = [0, 0, -.]", "", "expected TOML 1.0"},
      {"# an arm", "\xff an arm", "", "expected TOML 1.0"},
      {"# an arm", "# \xc3( arm", "", "expected TOML 1.0"},
      // whole file
      {sound_toml, "", "^", "has no 'mechanism'; expected a table [mechanism]"},
      {sound_toml, "[mechanism]\nname = \"a\"\n", "^", "has no 'gravity'"},
      {sound_toml, "[mechanism]\nname = \"a\"\n", "^", "the mechanism has no body or no joint"},
      {sound_toml, "mechanism = 1\n", "1\n", "mechanism is an integer; expected a table"},
      // unknown keys
      {"description = ", "descripton = ", "descripton",
       "unknown key 'descripton' in mechanism (did you mean 'description'?)"},
      {"[values]", "[value]", "value]", "unknown key 'value' (did you mean 'values'?)"},
      {"[values]\n", "[values]\nspare = 1\n", "1\nreach", "values.spare is not a quantity"},
      {"[values]\n", "[values]\nspare = { value = 1, unit = \"m\", from = \"cad\" }\n", "spare",
       "values.spare is never used"},
      {"[tendon_defaults]", "[tendon_default]", "tendon_default]",
       "unknown key 'tendon_default' (did you mean 'tendon_defaults'?)"},
      {"[[coupling]]", "[[couplings]]", "", "unknown key 'couplings' (did you mean 'coupling'?)"},
      {"[[frame]]", "[[farme]]", "", "unknown key 'farme' (did you mean 'frame'?)"},
      {"massless = true", "masless = true", "masless", "in body.plate (did you mean 'massless'?)"},
      {"axis = [0, 0, 2]", "axes = [0, 0, 2]", "axes", "in joint.q1 (did you mean 'axis'?)"},
      {"max_velocity = ", "max_speed = ", "max_speed", "unknown key 'max_speed' in joint.q1"},
      {"origin = { xyz", "origin = { xzy", "xzy", "in joint.q2.origin (did you mean 'xyz'?)"},
      {"pose.xyz", "pose.position", "position", "unknown key 'position' in frame.tip.pose"},
      {"pose.xyz", "pos.xyz", "pos.", "unknown key 'pos' in frame.tip"},
      {"{ joint = \"q1\", radius = \"r1\" }", "{ joint = \"q1\", radius = \"r1\", side = 1 }",
       "side", "unknown key 'side' in tendon.t1.pulleys[0]"},
      {"unit = \"mm\", from = \"text\"", "unit = \"mm\", form = \"text\"", "form",
       "unknown key 'form' in values.reach (did you mean 'from'?)"},
      {"parent = \"lower\"", "parent = \"lower\"\naxis = [0, 0, 1]", "axis = [0, 0, 1]",
       "unknown key 'axis' in joint.mount"},
      {"parent = \"lower\"", "parent = \"lower\"\nlimits = 1", "limits",
       "expected one of: child, name, origin, parent, type"},
      {"max_force = ", "max_forces = ", "max_forces", "(did you mean 'max_force'?)"},
      {"ratio = ", "ratios = ", "ratios", "(did you mean 'ratio'?)"},
      // missing keys
      {"name = \"arm\"\n", "", "[mechanism]", "mechanism has no 'name'"},
      {"gravity = {", "# {", "[mechanism]", "mechanism has no 'gravity'"},
      {"name = \"slide\"\n", "", "[[body]]", "body[0] has no 'name'"},
      {"name = \"q1\"\n", "", "[[joint]]", "joint[0] has no 'name'"},
      {"type = \"revolute\"\n", "", "[[joint]]",
       "joint.q1 has no 'type'; expected one of: revolute, prismatic, fixed"},
      {"parent = \"base\"\n", "", "[[joint]]", "joint.q1 has no 'parent'"},
      {"child = \"upper\"\n", "", "[[joint]]", "joint.q1 has no 'child'"},
      {"axis = [0, 0, 2]\n", "", "[[joint]]", "joint.q1 has no 'axis'"},
      {"range = { value = [-90, 90], unit = \"deg\", from = \"assumed\" }\n", "", "[[joint]]",
       "joint.q1 has no 'range'; expected an angle"},
      {"value = [-90, 90], ", "", "{ unit = \"deg\", from", "joint.q1.range has no 'value'"},
      {"body = \"plate\"\n", "", "[[frame]]", "frame.tip has no 'body'"},
      {"name = \"tip\"\n", "", "[[frame]]", "frame[0] has no 'name'"},
      {"name = \"t1\"\n", "", "[[tendon]]", "tendon[0] has no 'name'"},
      {"pulleys = [{", "# [{", "\"t1\"", "tendon.t1 has no path; expected pulleys or straights"},
      {"{ joint = \"q1\", radius = \"r1\" }", "{ radius = \"r1\" }", "{ radius = \"r1\" }",
       "tendon.t1.pulleys[0] has no 'joint'"},
      {"{ joint = \"q1\", radius = \"r1\" }", "{ joint = \"q1\" }", "{ joint = \"q1\" }",
       "has no 'radius'; expected a length in m, cm, mm"},
      {"from_body = \"base\", ", "", "{ from_point", "tendon.t2.straights[0] has no 'from_body'"},
      {"to_body = \"lower\", ", "", "{ from_body", "has no 'to_body'"},
      {", to_point = \"reach\"", "", "{ from_body", "has no 'to_point'"},
      {"dependent = \"q3\"\n", "", "[[coupling]]", "has no 'dependent'"},
      {"independent = \"q2\"\n", "", "[[coupling]]", "has no 'independent'"},
      {"ratio = { value = 0.02, from = \"assumed\" }\n", "", "[[coupling]]",
       "coupling.q3 has no 'ratio'"},
      {"unit = \"m/s^2\", ", "", "{ value = [0, 0, -9.81]",
       "mechanism.gravity has no unit; expected a unit of acceleration: m/s^2"},
      {", from = \"assumed\" }\n\n[values]", " }\n\n[values]", "{ value = [0, 0, -9.81]",
       "mechanism.gravity has no 'from'"},
      {", ref = \"Table 1\"", "", "\"text\"",
       "values.reach is from the text but does not say where"},
      // wrong types
      {"name = \"arm\"", "name = 3", "3\n", "mechanism.name is an integer; expected a string"},
      {"name = \"arm\"", "name = [\"arm\"]", "[\"arm\"]", "mechanism.name is an array"},
      {"\"Test arm\"", "1979-05-27", "1979", "is a date or time; expected a string"},
      {"gravity = { value = [0, 0, -9.81], unit = \"m/s^2\", from = \"assumed\" }",
       "gravity = -9.81", "-9.81", "mechanism.gravity is a number; expected { value = [...]"},
      {"value = [0, 0, -9.81]", "value = -9.81", "-9.81",
       "mechanism.gravity.value is a number; expected an array of 3 numbers"},
      {"value = [0, 0, -9.81]", "value = [0, -9.81]", "[0, -9.81]",
       "has 2 entries; expected an array of 3 numbers"},
      {"value = [0, 0, -9.81]", "value = [0, 0, \"-9.81\"]", "\"-9.81\"",
       "is a string; expected an array of 3 numbers"},
      {"value = [0, 0, -9.81]", "value = []", "[], unit", "has 0 entries"},
      {"massless = true", "massless = 1", "1\n\n[[joint]]",
       "body.plate.massless is an integer; expected true or false"},
      {"massless = true", "massless = \"yes\"", "\"yes\"", "expected true or false"},
      {"axis = [0, 0, 2]", "axis = \"z\"", "\"z\"", "joint.q1.axis names the unknown value 'z'"},
      {"axis = [0, 0, 2]", "axis = [0, 0]", "[0, 0]\n", "joint.q1.axis has 2 entries"},
      {"axis = [0, 0, 2]", "axis = 2", "2\nrange", "joint.q1.axis is an integer"},
      {"origin = { xyz = \"reach\" }", "origin = [0.1, 0, 0]", "[0.1, 0, 0]",
       "joint.q2.origin is an array; expected a table"},
      {"origin = { xyz = \"reach\" }", "origin = { xyz = [0.1, 0, 0] }", "[0.1, 0, 0]",
       "joint.q2.origin.xyz is an array; expected { value"},
      {"value = [-1, 1]", "value = 1", "1, unit = \"rad\"",
       "joint.q2.range.value is an integer; expected an array of 2 numbers"},
      {"value = [-1, 1]", "value = [-1, 0, 1]", "[-1, 0, 1]", "joint.q2.range.value has 3 entries"},
      {"value = 8,", "value = [8],", "[8]",
       "joint.q1.max_velocity.value is an array; expected a number"},
      {"[[0, -1, 0], [1, 0, 0], [0, 0, 1]]", "[0, -1, 0]", "0, -1, 0]",
       "is an integer; expected 3 rows of 3 numbers"},
      {"[[0, -1, 0], [1, 0, 0], [0, 0, 1]]", "[[0, -1, 0], [1, 0, 0]]", "[[0, -1, 0]",
       "has 2 rows"},
      {"[[0, -1, 0], [1, 0, 0], [0, 0, 1]]", "[[0, -1], [1, 0, 0], [0, 0, 1]]", "[0, -1]",
       "has 2 entries"},
      {"pulleys = [{ joint = \"q1\", radius = \"r1\" }, ", "pulleys = [5, ", "5, { joint",
       "an entry of tendon.t1.pulleys is an integer; expected an array of tables"},
      {"pulleys = [{ joint = \"q1\", radius = \"r1\" }, { joint = \"q2\", radius = \"-r1\" }]",
       "pulleys = \"q1\"", "\"q1\"\n[[tendon]]", "tendon.t1.pulleys is a string"},
      {"pulleys = [{ joint = \"q1\", radius = \"r1\" }, { joint = \"q2\", radius = \"-r1\" }]",
       "pulleys = []", "[]\n", "tendon.t1 has an empty path"},
      {"radius = \"r1\" }", "radius = 0.005 }", "0.005",
       "tendon.t1.pulleys[0].radius is a number; expected { value"},
      {"radius = \"r1\" }", "radius = true }", "true }", "is a truth value"},
      {"[tendon_defaults]", "[[tendon_defaults]]", "",
       "tendon_defaults is an array; expected a table"},
      {"[[frame]]", "[frame]", "[frame]",
       "frame is a table; expected an array of tables: [[frame]]"},
      // units and origins
      {"unit = \"m/s^2\"", "unit = \"m/s\"", "\"m/s\"",
       "has the unit 'm/s' of velocity; expected a unit of acceleration"},
      {"unit = \"m/s^2\"", "unit = \"g\"", "\"g\"", "has the unit 'g' of mass"},
      {"unit = \"m/s^2\"", "unit = 1", "1, from", "mechanism.gravity.unit is an integer"},
      {"[100, 0, 0], unit = \"mm\"", "[100, 0, 0], unit = \"inch\"", "\"inch\"",
       "values.reach has the unknown unit 'inch'; expected a unit of length: m, cm, mm"},
      {"[100, 0, 0], unit = \"mm\"", "[100, 0, 0], unit = \"MM\"", "\"MM\"", "unknown unit 'MM'"},
      {"[100, 0, 0], unit = \"mm\"", "[100, 0, 0], unit = \"deg\"", "\"deg\", from = \"text\"",
       "of angle"},
      {"[90, 0, 0], unit = \"deg\"", "[90, 0, 0], unit = \"degree\"", "\"degree\"",
       "unknown unit 'degree'; expected a unit of angle: rad, deg"},
      {"[90, 0, 0], unit = \"deg\"", "[90, 0, 0], unit = \"m\"", "\"m\", from",
       "joint.q1.origin.rpy has the unit 'm' of length"},
      {"[-1, 1], unit = \"rad\"", "[-1, 1], unit = \"mm\"",
       "\"mm\", from = \"assumed\" }\n\n[[joint]]\nname = \"q3\"",
       "joint.q2.range has the unit 'mm' of length"},
      {"[0, 20], unit = \"mm\"", "[0, 20], unit = \"deg\"",
       "\"deg\", from = \"assumed\" }\n\n[[joint]]\nname = \"mount\"",
       "joint.q3.range has the unit 'deg' of angle"},
      {"unit = \"N*m*s/rad\"", "unit = \"N*s/m\"", "\"N*s/m\"",
       "joint.q1.damping has the unit 'N*s/m' of damping; expected a unit of angular damping"},
      {"unit = \"N/mm\"", "unit = \"N\"", "\"N\", from = \"assumed\" }\nmax_force",
       "of force; expected a unit of stiffness"},
      {"ratio = { value = 0.02,", "ratio = { value = 0.02, unit = \"m\",",
       "\"m\", from = \"assumed\" }\n\n[tendon_defaults]", "expected a unit of pure number: 1"},
      {"from = \"measured\"", "from = \"meassured\"", "\"meassured\"",
       "is 'meassured' (did you mean 'measured'?)"},
      {"from = \"measured\"", "from = \"a friend\"", "\"a friend\"",
       "expected one of: text, assumed"},
      {"from = \"measured\"", "from = 1", "1, ref", "joint.q1.damping.from is an integer"},
      {"ref = \"bench\"", "ref = 7", "7 }", "joint.q1.damping.ref is an integer"},
      // named values
      {"xyz = \"reach\"", "xyz = \"raech\"", "\"raech\"",
       "names the unknown value 'raech' (did you mean 'reach'?)"},
      {"xyz = \"reach\"", "xyz = \"r1\"", "5, unit",
       "values.r1.value is an integer; expected an array of 3 numbers"},
      {"radius = \"-r1\"", "radius = \"--r1\"", "\"--r1\"", "names the unknown value '-r1'"},
      {"radius = \"-r1\"", "radius = \"\"", "\"\" }", "names the unknown value ''"},
      {"radius = \"-r1\"", "radius = \"reach\"", "[100, 0, 0]",
       "values.reach.value is an array; expected a number"},
      {"r1 = { value = 5, unit = \"mm\"", "r1 = { value = 5, unit = \"N\"",
       "\"N\", from = \"assumed\" }\n\n[[body]]",
       "values.r1 has the unit 'N' of force; expected a unit of length"},
      {"r1 = { value = 5, unit = \"mm\", from = \"assumed\" }", "r1 = \"reach\"", "\"reach\"\n\n",
       "values.r1 is not a quantity"},
      // numbers
      {"value = [0, 0, -9.81]", "value = [0, 0, nan]", "nan", "is not finite"},
      {"value = [0, 0, -9.81]", "value = [0, 0, -inf]", "-inf",
       "is not finite; expected a finite number"},
      {"value = 1e-4", "value = inf", "inf", "joint.q1.damping.value is not finite"},
      {"value = 1e-4", "value = -1e-4", "-1e-4", "joint.q1.damping is negative"},
      {"value = [1, 40]", "value = [1, 1e306]", "[1, 1e306]", "is not finite in SI units"},
      {"value = [-90, 90]", "value = [90, -90]", "[90, -90]",
       "joint.q1.range is empty; expected low < high"},
      {"value = [-90, 90]", "value = [90, 90]", "[90, 90]", "joint.q1.range is empty"},
      {"value = 8,", "value = 0,", "0, unit = \"rad/s\"", "joint.q1.max_velocity is not positive"},
      {"damping = {",
       "motor_poles = { value = 14.5, unit = \"1\", from = \"assumed\" }\ndamping = {", "14.5",
       "joint.q1.motor_poles is no count; expected a whole number"},
      {"damping = {", "gear_teeth = { value = 0, unit = \"1\", from = \"assumed\" }\ndamping = {",
       "0, unit = \"1\"", "joint.q1.gear_teeth is no count"},
      {"value = 80,", "value = -80,", "-80", "joint.q1.max_acceleration is not positive"},
      {"axis = [0, 0, 2]", "axis = [0, 0, 0]", "[0, 0, 0]",
       "joint.q1.axis is zero; expected a direction"},
      {"r1 = { value = 5,", "r1 = { value = 0,", "\"r1\" }", "tendon.t1.pulleys[0].radius is zero"},
      {"value = 0.02,", "value = 0,", "0, from = \"assumed\" }\n\n[tendon_defaults]",
       "coupling.q3.ratio is zero"},
      {"value = [1, 40]", "value = [40, 1]", "[40, 1]", "expected 0 < low < high"},
      {"value = [1, 40]", "value = [0, 40]", "[0, 40]", "expected 0 < low < high"},
      {"value = 90, unit = \"N\"", "value = 0, unit = \"N\"", "0, unit = \"N\"",
       "tendon_defaults.max_force is not positive"},
      {"[[0, -1, 0], [1, 0, 0], [0, 0, 1]]", "[[0, 1, 0], [1, 0, 0], [0, 0, 1]]", "[[0, 1, 0]",
       "joint.q3.origin.rotation is not a rotation matrix"},
      {"[[0, -1, 0], [1, 0, 0], [0, 0, 1]]", "[[0, -2, 0], [1, 0, 0], [0, 0, 1]]", "[[0, -2, 0]",
       "is not a rotation matrix"},
      {"origin.rotation = ",
       "origin.rpy = { value = [0, 0, 0], unit = \"rad\", from = \"cad\" }\norigin.rotation = ",
       "[[0, -1, 0]", "joint.q3.origin has both rpy and rotation"},
      // names
      {"name = \"arm\"", "name = \"my-arm\"", "\"my-arm\"",
       "has a character other than a letter, a digit or an underscore"},
      {"name = \"arm\"", "name = \"1arm\"", "\"1arm\"", "starts with a digit"},
      {"name = \"arm\"", "name = \"\"", "\"\"", "is empty"},
      {"name = \"arm\"", "name = \"_arm\"", "\"_arm\"", "starts with an underscore"},
      {"name = \"arm\"", "name = \"my__arm\"", "\"my__arm\"", "has two underscores"},
      {"name = \"arm\"", "name = \"double\"", "\"double\"", "is a word of C or C++"},
      {"name = \"arm\"", "name = \"Ärm\"", "\"Ärm\"", "has a character other than"},
      {"name = \"arm\"",
       "name = \"a234567890123456789012345678901234567890123456789012345678901234\"", "\"a2345",
       "has 64 characters, more than 63"},
      {"name = \"upper\"", "name = \"class\"", "\"class\"",
       "body[1].name 'class' is a word of C or C++"},
      {"name = \"upper\"", "name = \"base\"", "\"base\"", "a body is called 'base'"},
      {"name = \"upper\"", "name = \"slide\"",
       "[[body]]\nname = \"slide\"\n[[body]]\nname = \"lower\"",
       "body 'slide' is defined a second time, first in line 11"},
      {"name = \"q2\"", "name = \"q1\"",
       "[[joint]]\nname = \"q1\"\ntype = \"revolute\"\nparent = \"upper\"",
       "joint 'q1' is defined a second time"},
      {"name = \"q2\"", "name = \"register\"", "\"register\"", "is a word of C or C++"},
      {"name = \"t2\"", "name = \"t1\"", "[[tendon]]\nname = \"t1\"\nstraights",
       "tendon 't1' is defined a second time"},
      {"name = \"t2\"", "name = \"t 2\"", "\"t 2\"", "has a character other than"},
      {"name = \"tip\"", "name = \"for\"", "\"for\"", "is a word of C or C++"},
      // words
      {"type = \"prismatic\"", "type = \"prizmatic\"", "\"prizmatic\"",
       "(did you mean 'prismatic'?)"},
      {"type = \"prismatic\"", "type = \"ball\"", "\"ball\"",
       "expected one of: revolute, prismatic, fixed"},
      {"type = \"prismatic\"", "type = 2", "2\nparent", "joint.q3.type is an integer"},
      {"inertia_check = \"idealised\"", "inertia_check = \"none\"", "\"none\"",
       "expected one of: physical, idealised, as_given"},
      // the tree
      {"parent = \"base\"", "parent = \"bas\"", "\"bas\"",
       "unknown parent 'bas' (did you mean 'base'?)"},
      {"parent = \"base\"", "parent = \"upper\"", "[[joint]]", "cycle"},
      {"parent = \"base\"", "parent = \"lower\"", "[[joint]]", "is on a cycle"},
      {"child = \"upper\"", "child = \"uper\"", "\"uper\"",
       "unknown child 'uper' (did you mean 'upper'?)"},
      {"child = \"upper\"", "child = \"base\"", "\"base\"\norigin", "carries the base"},
      {"child = \"slide\"", "child = \"lower\"", "\"lower\"\norigin.rotation",
       "body 'lower' is carried by joint 'q2' and by joint 'q3'"},
      {"child = \"slide\"", "child = \"lower\"", "[[body]]",
       "body 'slide' is not connected; expected a joint with it as child"},
      {"[[body]]\nname = \"slide\"\n", "[[body]]\nname = \"spare\"\n[[body]]\nname = \"slide\"\n",
       "[[body]]", "body 'spare' is not connected"},
      {"[[body]]\nname = \"slide\"\n", "[[body]]\nname = \"spare\"\n[[body]]\nname = \"slide\"\n",
       "[[body]]", "body 'spare' has no row in csv"},
      {"[[body]]\nname = \"slide\"\n", "", "\"slide\"", "unknown child 'slide'"},
      {"massless = true", "", "[[body]]\nname = \"plate\"", "body 'plate' has no row in csv"},
      // references
      {"body = \"plate\"", "body = \"plat\"", "\"plat\"",
       "frame.tip.body names the unknown body 'plat' (did you mean 'plate'?)"},
      {"body = \"plate\"", "body = \"base\"", "\"base\"\npose", "unknown body 'base'"},
      {"{ joint = \"q1\"", "{ joint = \"q9\"", "\"q9\"", "names the unknown joint 'q9'"},
      {"{ joint = \"q1\"", "{ joint = \"mount\"", "\"mount\", radius",
       "'mount' is a fixed joint; expected a moving joint"},
      {"{ joint = \"q1\"", "{ joint = \"q2\"", "\"q2\", radius = \"-r1\"",
       "is a second pulley at joint 'q2'"},
      {"from_body = \"base\"", "from_body = \"bse\"", "\"bse\"",
       "tendon.t2.straights[0].from_body names the unknown body 'bse'"},
      {"from_body = \"base\"", "from_body = \"lower\"", "\"lower\", to_point",
       "tendon.t2.straights[0] stays on 'lower'"},
      {"to_body = \"lower\"", "to_body = \"Lower\"", "\"Lower\"", "(did you mean 'lower'?)"},
      {"dependent = \"q3\"", "dependent = \"q4\"", "\"q4\"",
       "coupling.q4.dependent names the unknown joint 'q4'"},
      {"dependent = \"q3\"", "dependent = \"mount\"", "\"mount\"\nindependent", "is a fixed joint"},
      {"independent = \"q2\"", "independent = \"q3\"", "\"q3\"\nratio",
       "joint 'q3' is coupled to itself"},
      {"independent = \"q2\"", "independent = \"mount\"", "\"mount\"\nratio",
       "coupling.q3.independent 'mount' is a fixed joint"},
      {"[tendon_defaults]",
       "[[coupling]]\ndependent = \"q3\"\nindependent = \"q1\"\nratio = { value = 1, from = "
       "\"cad\" }\n[tendon_defaults]",
       "[[coupling]]\ndependent = \"q3\"\nindependent = \"q1\"",
       "the coupling of 'q3' is defined a second time"},
      {"[tendon_defaults]",
       "[[coupling]]\ndependent = \"q2\"\nindependent = \"q1\"\nratio = { value = 1, from = "
       "\"cad\" }\n[tendon_defaults]",
       "[[coupling]]", "joint 'q3' depends on 'q2', which depends on 'q1'"},
  };
  return cases;
}

}  // namespace malformed
