// SPDX-License-Identifier: GPL-3.0-or-later
// Mistakes in couplings, four-bars and reference poses of a mechanism, each reported where it
// stands.
#include <catch2/catch.hpp>

#include "symbolic/files/description_error.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/write_mechanism.h"
#include "tests/symbolic/model/malformed_case.h"

using namespace malformed;

namespace {

constexpr std::string_view sound = R"([mechanism]
name = "linkage"
gravity = { value = [0, 0, -9.81], unit = "m/s^2", from = "assumed" }

[values]
r1 = { value = 6, unit = "mm", from = "assumed" }
r2 = { value = 4, unit = "mm", from = "assumed" }

[[body]]
name = "crank"
massless = true
[[body]]
name = "bar"
massless = true
[[body]]
name = "swing"
massless = true
[[body]]
name = "follower"

[[joint]]
name = "q1"
type = "revolute"
parent = "base"
child = "crank"
axis = [0, 0, 1]
range = { value = [-20, 40], unit = "deg", from = "assumed" }
reference = { value = 10, unit = "deg", from = "assumed" }
[[joint]]
name = "q2"
type = "revolute"
parent = "crank"
child = "bar"
origin.xyz = { value = [10, 0, 2], unit = "mm", from = "assumed" }
axis = [0, 0, 1]
range = { value = [-2, 2], unit = "rad", from = "assumed" }
[[joint]]
name = "q3"
type = "revolute"
parent = "base"
child = "swing"
origin.xyz = { value = [0, 12, 0], unit = "mm", from = "assumed" }
axis = [0, 0, 1]
range = { value = [-2, 2], unit = "rad", from = "assumed" }
[[joint]]
name = "q4"
type = "revolute"
parent = "bar"
child = "follower"
axis = [0, 1, 0]
range = { value = [-1, 1], unit = "rad", from = "assumed" }

[[four_bar]]
dependent = "q2"
independent = "q1"
ground = { value = 12, unit = "mm", from = "assumed" }
crank = { value = 10, unit = "mm", from = "assumed" }
coupler = { value = 12.5, unit = "mm", from = "assumed" }
rocker = { value = 11, unit = "mm", from = "assumed" }
branch = "open"
follows = "coupler"
crank_angle = { value = 80, unit = "deg", from = "assumed" }
[[four_bar]]
dependent = "q3"
independent = "q1"
ground = { value = 12, unit = "mm", from = "assumed" }
crank = { value = 10, unit = "mm", from = "assumed" }
coupler = { value = 12.5, unit = "mm", from = "assumed" }
rocker = { value = 11, unit = "mm", from = "assumed" }
branch = "open"
crank_angle = { value = 80, unit = "deg", from = "assumed" }

[[coupling]]
dependent = "q4"
independent = "q1"
independent_radius = "r1"
dependent_radius = "r2"
)";

constexpr std::string_view masses =
    "link,mass [g],com_x [mm],com_y [mm],com_z [mm],ixx [g*mm^2],iyy [g*mm^2],izz [g*mm^2],"
    "ixy [g*mm^2],ixz [g*mm^2],iyz [g*mm^2]\nfollower,9,20,3,0,162,1303,1303,0,0,0\n";

std::vector<std::string> mistakes_in(std::string_view text) {
  try {
    sinew::parse_mechanism({text, masses, "file", "csv"});
    return {};
  } catch (const sinew::DescriptionError& error) {
    return error.messages();
  }
}

}  // namespace

TEST_CASE("mistakes in couplings and four-bars", "[malformed]") {
  REQUIRE(mistakes_in(sound).empty());
  const std::vector<Case> cases{
      {"value = 10, unit = \"deg\"", "value = 41, unit = \"deg\"", "41",
       "outside the joint's range"},
      {"value = 10, unit = \"deg\"", "value = 10, unit = \"mm\"",
       "\"mm\", from = \"assumed\" }\n[[joint]]", "expected a unit of angle"},
      {"independent_radius = \"r1\"", "independent_radius = \"r3\"", "\"r3\"",
       "unknown value 'r3'"},
      {"independent_radius = \"r1\"", "", "[[coupling]]", "has no 'independent_radius'"},
      {"independent_radius = \"r1\"",
       "ratio = { value = 2, from = \"assumed\" }\nindependent_radius = \"r1\"", "{ value = 2,",
       "has both radii and a ratio"},
      {"r1 = { value = 6", "r1 = { value = 0", "\"r1\"", "independent_radius is zero"},
      {"dependent = \"q4\"", "dependent = \"q9\"", "\"q9\"", "q9"},
      {"ground = { value = 12", "ground = { value = -12", "-12", "ground is not positive"},
      {"ground = { value = 12", "ground = { value = 40", "[[four_bar]]", "locks or does not close"},
      {"crank = { value = 10", "crank = { value = 10.5", "[[four_bar]]", "pivots 0.01 m apart"},
      {"crank = {", "krank = {", "krank", "unknown key 'krank'"},
      {"crank = {", "krank = {", "[[four_bar]]", "has no 'crank'"},
      {"value = 12.5", "value = 0", "0, unit = \"mm\", from = \"assumed\" }\nrocker",
       "coupler is not positive"},
      {"branch = \"open\"", "", "[[four_bar]]", "has no 'branch'"},
      {"branch = \"open\"", "branch = \"closed\"", "\"closed\"", "expected one of: open, crossed"},
      {"\"coupler\"", "\"crank\"", "\"crank\"\ncrank_angle", "expected one of: rocker, coupler"},
      {"follows = \"coupler\"", "follows = \"rocker\"", "[[four_bar]]", "hinges on another body"},
      {"crank_angle = {", "crank_angel = {", "crank_angel", "(did you mean 'crank_angle'?)"},
      {"independent = \"q1\"", "independent = \"q2\"", "\"q2\"\nground", "coupled to itself"},
      {"independent = \"q1\"", "independent = \"q3\"", "[[four_bar]]", "cannot follow 'q3'"},
      {"independent = \"q1\"", "independent = \"q7\"", "\"q7\"", "q7"},
      {"dependent = \"q3\"", "dependent = \"q2\"",
       "[[four_bar]]\ndependent = \"q2\"\nindependent = \"q1\"\nground = { value = 12, unit = "
       "\"mm\", from = \"assumed\" }\ncrank = { value = 10, unit = \"mm\", from = \"assumed\" "
       "}\ncoupler = { value = 12.5, unit = \"mm\", from = \"assumed\" }\nrocker = { value = 11, "
       "unit = \"mm\", from = \"assumed\" }\nbranch = \"open\"\ncrank_angle",
       "q2"},
      {"axis = [0, 1, 0]", "axis = [0, 1, 0]\nreferense = 3", "referense",
       "(did you mean 'reference'?)"},
      {"[0, 0, 1]\nrange = { value = [-2", "[0, 1, 1]\nrange = { value = [-2", "[[four_bar]]",
       "turns about another direction"},
  };
  for (const Case& each : cases) {
    const std::string text = spoilt(sound, each);
    check_messages(each, text, mistakes_in(text));
  }
  // One joint in a loop and in a linkage.
  std::string twice(sound);
  twice.replace(twice.rfind("\"q4\""), 4, "\"q3\"");
  bool is_told = false;
  for (const std::string& message : mistakes_in(twice))
    is_told = is_told || message.find("a joint depends on two others") != std::string::npos;
  CHECK(is_told);
}

TEST_CASE("couplings, four-bars and reference poses written read back", "[write]") {
  const sinew::Mechanism mechanism = sinew::parse_mechanism({sound, masses, "file", "csv"});
  const std::string text = sinew::describe_mechanism(mechanism, "written").toml;
  const sinew::Mechanism back = sinew::parse_mechanism({text, masses, "file", "csv"});
  REQUIRE(back.four_bars.size() == 2);
  CHECK(back.four_bars[0].crank_angle == mechanism.four_bars[0].crank_angle);
  CHECK(back.four_bars[0].coupler == mechanism.four_bars[0].coupler);
  CHECK(back.four_bars[0].follows == sinew::FourBarCoupling::Follows::coupler);
  CHECK(back.four_bars[1].follows == sinew::FourBarCoupling::Follows::rocker);
  CHECK(back.couplings[0].ratio == mechanism.couplings[0].ratio);
  CHECK(back.couplings[0].ratio == 1.5);
  CHECK(back.joints[0].reference == mechanism.joints[0].reference);
  CHECK_FALSE(back.joints[1].reference);
}
