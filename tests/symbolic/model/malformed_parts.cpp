// SPDX-License-Identifier: GPL-3.0-or-later
// Mistakes in part.toml and hand.toml, each reported where it stands.
#include <catch2/catch.hpp>

#include "symbolic/files/description_error.h"
#include "symbolic/parts/part.h"
#include "symbolic/hand/read_hand.h"
#include "tests/reference/temporary_folder.h"
#include "tests/symbolic/model/malformed_case.h"

using namespace malformed;
using sinew::reference::TemporaryFolder;
using sinew::reference::write_text;
namespace fs = std::filesystem;

namespace {

constexpr std::string_view sound_wrist = R"([part]
name = "wrist"
description = "Two channels"

[wrist]
length = { value = 50, unit = "mm", from = "text", ref = "Table 6.1" }
width = { value = 42, unit = "mm", from = "assumed" }
thickness = { value = 36, unit = "mm", from = "assumed" }
motor_radius = { value = 5, unit = "mm", from = "assumed" }
flexion = { value = [-30, 30], unit = "deg", from = "assumed" }
abduction = { value = [-20, 20], unit = "deg", from = "assumed" }

[[channel]]
forearm = { value = [4, 7, 8], unit = "mm", from = "assumed" }
palm = { value = [-4, -11, 10], unit = "mm", from = "assumed" }
[[channel]]
forearm = { value = [4, 8, 9], unit = "mm", from = "assumed" }
palm = { value = [-4, -10, 11], unit = "mm", from = "assumed" }
)";

constexpr std::string_view sound_four_bar = R"([part]
name = "hmc"

[four_bar]
ground = { value = 12, unit = "mm", from = "assumed" }
crank = { value = 10, unit = "mm", from = "assumed" }
coupler = { value = 12.5, unit = "mm", from = "assumed" }
rocker = { value = 11, unit = "mm", from = "assumed" }
branch = "open"
pulley_radius = { value = 5, unit = "mm", from = "assumed" }
reference_theta2 = { value = 90, unit = "deg", from = "assumed" }
theta2 = { value = [60, 120], unit = "deg", from = "assumed" }
)";

constexpr std::string_view sound_tendon = R"([part]
name = "tendon"

[tendon]
axial_stiffness = { value = 10000, unit = "N", from = "assumed" }
free_length = { value = 0.5, unit = "m", from = "assumed" }

[lever]
motor_centre = { value = [0, 0], unit = "mm", from = "assumed" }
motor_radius = { value = 5, unit = "mm", from = "assumed" }
motor_sense = "counter_clockwise"
fixed_centre = { value = [34, 0], unit = "mm", from = "assumed" }
fixed_radius = { value = 4, unit = "mm", from = "assumed" }
fixed_sense = "counter_clockwise"
pivot = { value = [5, -5], unit = "mm", from = "assumed" }
lever_length = { value = 14, unit = "mm", from = "assumed" }
pulley_radius = { value = 4.5, unit = "mm", from = "assumed" }
pulley_sense = "clockwise"
spring_arm = { value = 15, unit = "mm", from = "assumed" }
spring_angle = { value = -130, unit = "deg", from = "assumed" }
anchor = { value = [25, -17], unit = "mm", from = "assumed" }
spring_stiffness = { value = 6400, unit = "N/m", from = "assumed" }
free_angle = { value = 48, unit = "deg", from = "assumed" }
travel = { value = 10, unit = "mm", from = "assumed" }
)";

constexpr std::string_view sound_motor = R"([part]
name = "motor"

[motor]
gear_ratio = { value = 0.01, unit = "1", from = "assumed" }
rotor_inertia = { value = 2e-07, unit = "kg*m^2", from = "assumed" }
gearbox_inertia = { value = 5e-05, unit = "kg*m^2", from = "assumed" }
torque_constant = { value = 0.0085, unit = "N*m/A", from = "assumed" }
pulley_radius = { value = 0.005, unit = "m", from = "assumed" }
gamma1 = { value = 10, unit = "s/rad", from = "assumed" }
gamma2 = { value = 0.55, unit = "N*m", from = "assumed" }
gamma3 = { value = 0.03, unit = "N*m*s/rad", from = "assumed" }
friction_compensation = { value = 0.9, unit = "1", from = "assumed" }
ripple_compensation = { value = 0.8, unit = "1", from = "assumed" }

[[ripple]]
side = "output"
order = { value = 1, unit = "1", from = "assumed" }
amplitude = { value = 0.02, unit = "N*m", from = "assumed" }
phase = { value = 0.3, unit = "rad", from = "assumed" }
)";

constexpr std::string_view sound_guiding = R"([part]
name = "guiding"

[guiding_friction]
C0 = { value = 6, unit = "N", from = "assumed" }
C1 = { value = 0.35, unit = "1/rad", from = "assumed" }
reversal_velocity = { value = 0.0001, unit = "m/s", from = "assumed" }
)";

constexpr std::string_view sound_capstan = R"([part]
name = "capstan"

[capstan]
friction_coefficient = { value = 0.1, unit = "1", from = "assumed" }
reversal_velocity = { value = 0.0001, unit = "m/s", from = "assumed" }
)";

/// Messages with the file called "file".
std::vector<std::string> named_file(const std::vector<std::string>& messages,
                                    const fs::path& file) {
  std::vector<std::string> result;
  for (const std::string& message : messages)
    result.push_back(message.starts_with(file.string())
                         ? "file" + message.substr(file.string().size())
                         : message);
  return result;
}

template <class Read>
std::vector<std::string> messages_of(const fs::path& file, const Read& read) {
  try {
    read();
    return {};
  } catch (const sinew::DescriptionError& error) {
    return named_file(error.messages(), file);
  }
}

void check_part(std::string_view sound, const std::vector<Case>& cases) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "part.toml";
  const auto mistakes = [&](std::string_view text) {
    write_text(file, std::string(text));
    return messages_of(file, [&] { sinew::read_part(folder.path()); });
  };
  REQUIRE(mistakes(sound).empty());
  for (const Case& each : cases) {
    const std::string text = spoilt(sound, each);
    check_messages(each, text, mistakes(text));
  }
}

}  // namespace

TEST_CASE("mistakes in the part.toml of any part", "[malformed]") {
  check_part(
      sound_capstan,
      {
          {"[part]", "[part", "", "expected TOML 1.0"},
          {"[part]", "[parts]", "parts]", "unknown key 'parts' (did you mean 'part'?)"},
          {"[part]", "[prt]", "^", "has no 'part'; expected a table [part]"},
          {"[part]\nname = \"capstan\"", "part = 3", "3", "part is an integer; expected a table"},
          {"name = \"capstan\"", "", "[part]", "part has no 'name'"},
          {"name = \"capstan\"", "name = 7", "7", "part.name is an integer; expected a string"},
          {"name = \"capstan\"", "name = \"two words\"", "\"two words\"", "part.name 'two words'"},
          {"name = \"capstan\"", "name = \"while\"", "\"while\"", "part.name 'while'"},
          {"name = \"capstan\"", "name = \"3d\"", "\"3d\"", "part.name '3d'"},
          {"name = \"capstan\"", "name = \"capstan\"\ncolour = 1", "colour",
           "unknown key 'colour' in part"},
          {"[capstan]", "[capstn]", "capstn]", "unknown key 'capstn' (did you mean 'capstan'?)"},
          {"[capstan]", "[capstn]", "^", "describes no part, or more than one"},
          {"[part]", "[effects]\n[part]", "^", "describes no part, or more than one"},
          {"[part]", "[wheel]\n[part]", "wheel]", "unknown key 'wheel'"},
          {"friction_coefficient = { value = 0.1, unit = \"1\", from = \"assumed\" }", "",
           "[capstan]", "capstan has no 'friction_coefficient'"},
          {"value = 0.1,", "value = -0.1,", "{ value = -0.1",
           "capstan.friction_coefficient is negative"},
          {"value = 0.1,", "value = nan,", "nan", "is not finite"},
          {"value = 0.1,", "value = \"0.1\",", "\"0.1\"", "is a string; expected a number"},
          {"value = 0.1,", "value = [0.1, 0.2],", "[0.1", "is an array; expected a number"},
          {"value = 0.1, ", "", "{ unit", "has no 'value'"},
          {"value = 0.0001, unit = \"m/s\"", "value = 0.0001", "{ value = 0.0001", "has no unit"},
          {"unit = \"m/s\"", "unit = \"m\"", "\"m\"", "has the unit 'm' of length"},
          {"unit = \"m/s\"", "unit = \"furlong\"", "\"furlong\"", "unknown unit 'furlong'"},
          {"value = 0.0001", "value = 0", "{ value = 0,", "is not positive"},
          {"from = \"assumed\"", "from = \"guessed\"", "\"guessed\"", "expected one of"},
          {"from = \"assumed\"", "from = \"text\"", "\"text\"", "does not say where"},
          {", from = \"assumed\"", "", "{ value = 0.1", "has no 'from'"},
      });
}

TEST_CASE("mistakes in the part.toml of a wrist", "[malformed]") {
  check_part(sound_wrist,
             {
                 {"width = { value = 42", "width = { value = -42", "{ value = -42",
                  "wrist.width is not positive; expected a number > 0"},
                 {"width = {", "breadth = {", "breadth", "unknown key 'breadth' in wrist"},
                 {"width = {", "breadth = {", "[wrist]", "wrist has no 'width'"},
                 {"width = { value = 42, unit = \"mm\"", "width = { value = 42, unit = \"deg\"",
                  "\"deg\"", "expected a unit of length"},
                 {"width = { value = 42, unit = \"mm\", from = \"assumed\" }", "width = 0.042",
                  "0.042", "wrist.width is a number; expected { value = ..."},
                 {"[-30, 30]", "[30, -30]", "{ value = [30, -30]",
                  "wrist.flexion is empty; expected low < high"},
                 {"[-30, 30]", "[-30, 0, 30]", "[-30, 0, 30]", "has 3 entries"},
                 {"[-30, 30]", "[-120, 120]", "{ value = [-120, 120]", "out of the wrist's reach"},
                 {"[-20, 20]", "[-85, 85]", "{ value = [-85, 85]", "out of the wrist's reach"},
                 {"[4, 7, 8]", "[4, 7]", "[4, 7]", "expected an array of 3 numbers"},
                 {"palm = { value = [-4, -11, 10], unit = \"mm\", from = \"assumed\" }", "",
                  "[[channel]]\nforearm = { value = [4, 7", "has no 'palm'"},
                 {"palm = { value = [-4, -11", "plam = { value = [-4, -11", "plam",
                  "unknown key 'plam' in channel[0] (did you mean 'palm'?)"},
                 {"[[channel]]\nforearm = { value = [4, 7", "[channel]\nforearm = { value = [4, 7",
                  "", "expected TOML 1.0"},
             });
  const std::string none(sound_wrist.substr(0, sound_wrist.find("[[channel]]")));
  const TemporaryFolder folder;
  write_text(folder.path() / "part.toml", none);
  const auto messages =
      messages_of(folder.path() / "part.toml", [&] { sinew::read_part(folder.path()); });
  check_messages({"", "", "[wrist]", "the wrist has no channel"}, none, messages);
}

TEST_CASE("mistakes in the part.toml of a four-bar", "[malformed]") {
  check_part(sound_four_bar,
             {
                 {"ground = { value = 12,", "ground = { value = 0,", "{ value = 0,",
                  "four_bar.ground is not positive"},
                 {"ground = { value = 12,", "ground = { value = 120,", "{ value = [60, 120]",
                  "locks or does not close at"},
                 {"coupler = { value = 12.5", "coupler = { value = 7", "{ value = [60, 120]",
                  "locks or does not close at 2.0944 rad"},
                 {"[60, 120]", "[120, 60]", "{ value = [120, 60]", "four_bar.theta2 is empty"},
                 {"value = 90", "value = 150", "{ value = 150", "is outside theta2"},
                 {"\"open\"", "\"opne\"", "\"opne\"", "(did you mean 'open'?)"},
                 {"branch = \"open\"", "", "[four_bar]", "has no 'branch'"},
                 {"branch = \"open\"", "branch = 1", "1\npulley", "four_bar.branch is an integer"},
                 {"crank = ", "cranck = ", "cranck", "unknown key 'cranck' in four_bar"},
                 {"pulley_radius = { value = 5", "pulley_radius = { value = -5", "{ value = -5",
                  "four_bar.pulley_radius is not positive"},
             });
}

TEST_CASE("mistakes in the part.toml of a tendon with its lever", "[malformed]") {
  check_part(sound_tendon,
             {
                 {"value = 10000", "value = -10000", "{ value = -10000",
                  "tendon.axial_stiffness is not positive"},
                 {"unit = \"N\"", "unit = \"N/m\"", "\"N/m\"", "expected a unit of force"},
                 {"free_length", "free_lenght", "free_lenght", "(did you mean 'free_length'?)"},
                 {"[lever]", "[levers]", "levers]", "unknown key 'levers'"},
                 {"[lever]", "[levers]", "^", "has no 'lever'; expected a table [lever]"},
                 {"motor_sense = \"counter_clockwise\"", "motor_sense = \"left\"", "\"left\"",
                  "expected one of: counter_clockwise, clockwise"},
                 {"motor_centre = { value = [0, 0]", "motor_centre = { value = [0, 0, 0]",
                  "[0, 0, 0]", "expected an array of 2 numbers"},
                 {"lever_length = { value = 14", "lever_length = { value = 0", "{ value = 0,",
                  "lever.lever_length is not positive"},
                 {"pivot = {", "pivots = {", "pivots", "unknown key 'pivots' in lever"},
                 {"travel = { value = 10", "travel = { value = 1000", "{ value = 1000,",
                  "lever.travel is out of the lever's reach"},
             });
}

TEST_CASE("mistakes in the part.toml of motors and guides", "[malformed]") {
  check_part(sound_motor,
             {
                 {"value = 0.9", "value = 1.1", "{ value = 1.1", "more energy than friction takes"},
                 {"value = 0.9", "value = -0.1", "{ value = -0.1", "expected a share in 0..1"},
                 {"gear_ratio = { value = 0.01", "gear_ratio = { value = 0", "{ value = 0,",
                  "motor.gear_ratio is not positive"},
                 {"gamma2 = { value = 0.55", "gamma2 = { value = -0.55", "{ value = -0.55",
                  "motor.gamma2 is negative"},
                 {"unit = \"N*m/A\"", "unit = \"N*m\"", "\"N*m\"", "has the unit 'N*m'"},
                 {"side = \"output\"", "side = \"both\"", "\"both\"", "expected one of"},
                 {"order = { value = 1", "order = { value = -1", "{ value = -1", "is not positive"},
                 {"amplitude", "amplitud", "amplitud ", "unknown key 'amplitud' in ripple[0]"},
             });
  check_part(sound_guiding,
             {
                 {"C0 = {", "c0 = {", "c0", "unknown key 'c0' in guiding_friction"},
                 {"value = 6", "value = -6", "{ value = -6", "guiding_friction.C0 is negative"},
                 {"\"1/rad\"", "\"rad\"", "\"rad\"", "has the unit 'rad'"},
             });
}

namespace {

constexpr std::string_view sound_hand = R"([hand]
name = "claw"
wrist = "../wrist"

[[finger]]
model = "../arm"
base.xyz = { value = [10, 0, 0], unit = "mm", from = "assumed" }
base.rpy = { value = [0, 0, 90], unit = "deg", from = "assumed" }
channels = "1-2"

[[finger]]
model = "../arm"
base.xyz = { value = [20, 0, 0], unit = "mm", from = "assumed" }
carried_by = "four_bar"
channels = "5, 6"

[four_bar]
model = "../hmc"
base.xyz = { value = [15, 0, 0], unit = "mm", from = "assumed" }
channels = "3-4"
)";

/// A hand with everything it is made of.
class HandPlace {
 public:
  HandPlace() {
    std::string wrist(sound_wrist);
    const std::string channel(sound_wrist.substr(sound_wrist.find("[[channel]]")));
    write("wrist/part.toml", wrist + channel + channel);
    write("hmc/part.toml", std::string(sound_four_bar));
    write("arm/mechanism.toml", std::string(sound_toml));
    write("arm/mass_properties.csv", std::string(sound_csv));
  }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((folder_.path() / file).parent_path());
    write_text(folder_.path() / file, text);
  }
  std::vector<std::string> mistakes(const std::string& text) const {
    write("hand/hand.toml", text);
    return messages_of(folder_.path() / "hand/hand.toml",
                       [&] { sinew::read_hand(folder_.path() / "hand"); });
  }
  fs::path path(const std::string& file) const { return folder_.path() / file; }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("mistakes in hand.toml", "[malformed]") {
  const HandPlace place;
  REQUIRE(place.mistakes(std::string(sound_hand)).empty());
  const std::vector<Case> cases{
      {"[hand]", "[hand", "", "expected TOML 1.0"},
      {"[hand]", "[hnad]", "^", "has no 'hand'"},
      {"name = \"claw\"", "name = \"cl-aw\"", "\"cl-aw\"", "hand.name 'cl-aw'"},
      {"name = \"claw\"", "name = true", "true", "is a truth value; expected a string"},
      {"name = \"claw\"", "", "[hand]", "hand has no 'name'"},
      {"name = \"claw\"", "name = \"claw\"\nfingers = 5", "fingers",
       "unknown key 'fingers' in hand"},
      {"\"../wrist\"", "\"../wrst\"", "\"../wrst\"", "there is no model folder"},
      {"\"../wrist\"", "\"../hmc\"", "\"../hmc\"", "hmc is another kind of part"},
      {"\"../wrist\"", "\"../arm\"", "\"../arm\"", "is no part"},
      {"model = \"../arm\"", "model = \"../wrist\"", "\"../wrist\"\nbase.xyz = { value = [10",
       "is no mechanism"},
      {"model = \"../arm\"", "model = \"../leg\"", "\"../leg\"", "there is no model folder"},
      {"model = \"../arm\"", "", "[[finger]]", "has no 'model'"},
      {"model = \"../hmc\"", "model = \"../wrist\"", "\"../wrist\"\nbase.xyz = { value = [15",
       "wrist is another kind of part"},
      {"base.xyz = { value = [10, 0, 0], unit = \"mm\", from = \"assumed\" }", "", "base.rpy",
       "has no 'xyz'"},
      {"[10, 0, 0]", "[10, 0]", "[10, 0]", "expected an array of 3 numbers"},
      {"unit = \"deg\"", "unit = \"mm\"", "\"mm\", from = \"assumed\" }\nchannels = \"1-2\"",
       "expected a unit of angle"},
      {"base.rpy", "base.rpi", "rpi", "unknown key 'rpi'"},
      {"channels = \"1-2\"", "channels = \"1-3\"", "\"1-3\"",
       "3 channels; expected one a tendon: 2"},
      {"channels = \"1-2\"", "channels = \"1\"", "\"1\"", "1 channels; expected one a tendon: 2"},
      {"channels = \"1-2\"", "channels = \"1, 1\"", "\"1, 1\"", "channel 1 is taken by finger.arm"},
      {"channels = \"1-2\"", "channels = \"1, 7\"", "\"1, 7\"", "the wrist has no channel 7"},
      {"channels = \"1-2\"", "channels = \"0-1\"", "\"0-1\"", "is no list of channels"},
      {"channels = \"1-2\"", "channels = \"2-1\"", "\"2-1\"", "is no list of channels"},
      {"channels = \"1-2\"", "channels = \"one\"", "\"one\"", "is no list of channels"},
      {"channels = \"1-2\"", "channels = [1, 2]", "[1, 2]", "is an array; expected a string"},
      {"channels = \"3-4\"", "channels = \"2-3\"", "\"2-3\"", "channel 2 is taken by finger.arm"},
      {"\"four_bar\"", "\"coupler\"", "\"coupler\"", "expected one of: palm, four_bar"},
      {"channels = \"5, 6\"", "", "[[finger]]\nmodel = \"../arm\"\nbase.xyz = { value = [20",
       "has no 'channels'"},
      {"[four_bar]", "[fourbar]", "fourbar]", "unknown key 'fourbar'"},
      {"[[finger]]", "[[fingr]]", "fingr]", "unknown key 'fingr'"},
      {"[four_bar]\nmodel", "[fourbar]\nmodel", "\"four_bar\"", "a four-bar that the hand has not"},
  };
  for (const Case& each : cases) {
    const std::string text = spoilt(sound_hand, each);
    check_messages(each, text, place.mistakes(text));
  }
  // A finger less: its channels have no tendon.
  const std::size_t second = sound_hand.rfind("[[finger]]"),
                    linkage = sound_hand.find("[four_bar]");
  std::string fewer(sound_hand);
  fewer.erase(second, linkage - second);
  check_messages({"", "", "^", "4 of the wrist's channels have a tendon; expected all 6"}, fewer,
                 place.mistakes(fewer));
}

TEST_CASE("a mistake in a model of the hand is reported in that model's file", "[malformed]") {
  const HandPlace place;
  std::string wrist = sinew::reference::read_text(place.path("wrist/part.toml"));
  wrist.replace(wrist.find("value = 42"), 10, "value = -1");
  place.write("wrist/part.toml", wrist);
  const auto messages = place.mistakes(std::string(sound_hand));
  REQUIRE(messages.size() == 1);
  CHECK(messages[0].find("part.toml:7:") != std::string::npos);
  CHECK(messages[0].find("wrist.width is not positive; expected a number > 0") !=
        std::string::npos);
}
