// SPDX-License-Identifier: GPL-3.0-or-later
// identified.toml is read like every other file of a model: what its effects do not declare is
// refused with its place, what they do is converted to SI.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "symbolic/effects/effects.h"
#include "symbolic/effects/model_effects.h"
#include "symbolic/extension/identified.h"
#include "symbolic/extension/learnt_entry.h"
#include "symbolic/files/description_error.h"

using namespace sinew;

namespace {

const LearntPlaces places{{"q1", PlaceKind::joint, true},
                          {"x", PlaceKind::joint, false},
                          {"tendon f", PlaceKind::tendon, false},
                          {"link tip", PlaceKind::link, false},
                          {"base", PlaceKind::base, false}};

std::string value(const std::string& key, const std::string& name, const std::string& value,
                  const std::string& unit) {
  return fmt::format(
      "[[effect.{}]]\nname = \"{}\"\nvalue = {}\nstandard_error = 0.25\nunit = \"{}\"\n", key, name,
      value, unit);
}

std::string entry(const std::string& effect, const std::string& place, const std::string& values) {
  return fmt::format("[[effect]]\neffect = \"{}\"\nplace = \"{}\"\n{}", effect, place, values);
}

std::string viscous(const std::string& number, const std::string& unit) {
  return entry("viscous_level", "q1", value("coefficient", "viscous_change", number, unit));
}

std::string stribeck(const std::string& speed) {
  return entry("stribeck", "q1",
               value("shape", "stribeck_velocity", speed, "rad/s") +
                   value("coefficient", "extra_at_rest", "0.1", "N*m"));
}

Identified read(const std::string& text) {
  return parse_identified(text, "identified.toml", places);
}

/// All messages; empty where the text was read.
std::string mistakes(const std::string& text) {
  try {
    read(text);
  } catch (const DescriptionError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("values are converted to SI, in whatever order they stand") {
  // Planted defect: converted() giving the number back whatever its unit: 3 N m.
  const IdentifiedEffect read_one =
      read(entry("coulomb_level", "q1", value("coefficient", "level_change", "3", "N*mm")))
          .effects.front();
  CHECK(read_one.coefficients.front().value == Approx(3e-3));
  CHECK(read_one.coefficients.front().standard_error == Approx(0.25e-3));
  CHECK(read_one.coefficients.front().unit == "N*m");
  CHECK(read(entry("stribeck", "q1",
                   value("coefficient", "extra_at_rest", "0.1", "N m") +
                       value("shape", "stribeck_velocity", "180", "deg/s")))
            .effects.front()
            .shape.front()
            .value == Approx(3.14159265));
  const auto payload = read(entry("payload", "link tip",
                                  value("coefficient", "first_moment_x", "0.02", "kg*m") +
                                      value("coefficient", "mass", "100", "g")))
                           .effects.front();
  REQUIRE(payload.coefficients.size() == 2);
  CHECK(payload.coefficients[0].name == "mass");
  CHECK(payload.coefficients[0].value == Approx(0.1));
  // Units follow the joint.
  CHECK(mistakes(entry("viscous_level", "x",
                       value("coefficient", "viscous_change", "3", "N*s/m"))) == "");
}

TEST_CASE("an entry without a shape that its effect had not then means what it meant") {
  // Planted defect, seen to fail: shapes without `before`, so that "has no shape 'turning_share'".
  const IdentifiedEffect law = read(stribeck("0.01")).effects.front();
  REQUIRE(law.shape.size() == 2);
  CHECK(law.shape[1].name == "turning_share");
  CHECK(law.shape[1].value == 1.0);
  CHECK_THAT(mistakes(entry("stribeck", "q1", value("coefficient", "extra_at_rest", "1", "N*m"))),
             Catch::Contains("has no shape 'stribeck_velocity'"));
}

TEST_CASE("torque constants are read as they were written, and one joint has one") {
  // Planted defects, seen to fail: constants that identified_text() leaves out, and a second one
  // that goes before the first.
  Identified known;
  known.torque_constants = {{"q1", 11.13}, {"a \"joint\"", 2.0 / 3.0}};
  const std::string text = identified_text(known);
  CHECK(read(text).torque_constants == known.torque_constants);
  CHECK_THAT(mistakes(text + "\n[[torque_constant]]\njoint = \"q1\"\nvalue = 3\n"),
             Catch::Contains("gives 'q1' a second time"));
  CHECK_THAT(mistakes("[[torque_constant]]\njoint = \"q1\"\nvalue = -3\n"),
             Catch::Contains("above 0"));
}

TEST_CASE("what no effect declares is refused with its place") {
  using Catch::Contains;
  // Planted defects, each seen to fail: no check of the limits (Stribeck at 0 was read), of units
  // (newtons were read as newton metres), of second entries, of second values.
  CHECK(mistakes(viscous("0.1", "N*m*s/rad")) == "");
  CHECK_THAT(mistakes(viscous("0.1", "N*s/m")), Contains("identified.toml:8:8:") &&
                                                    Contains("the unit 'N*s/m'") &&
                                                    Contains("expected N*m*s/rad"));
  CHECK_THAT(mistakes(viscous("0.1", "parsecs")), Contains("identified.toml:8:8:"));
  CHECK_THAT(mistakes(viscous("nan", "N*m*s/rad")), Contains("not finite"));
  CHECK_THAT(mistakes(viscous("inf", "N*m*s/rad")), Contains("identified.toml:6:9:"));
  CHECK_THAT(mistakes(viscous("\"a\"", "N*m*s/rad")), Contains("identified.toml:6:9:"));
  CHECK_THAT(mistakes(stribeck("0")),
             Contains("'stribeck_velocity' is 0 rad/s") && Contains("expected above 0"));
  CHECK_THAT(mistakes(stribeck("-1")), Contains("expected above 0"));
  CHECK(mistakes(stribeck("0.01")) == "");
  CHECK_THAT(mistakes(entry("viscous_levle", "q1", "")),
             Contains("identified.toml:2:10:") && Contains("did you mean 'viscous_level'?"));
  CHECK_THAT(mistakes(entry("viscous_level", "q2",
                            value("coefficient", "viscous_change", "1", "N*m*s/rad"))),
             Contains("identified.toml:3:9:") && Contains("cannot be at 'q2'") &&
                 Contains("expected one of: q1, x"));
  CHECK_THAT(mistakes(entry("viscous_level", "tendon f",
                            value("coefficient", "viscous_change", "1", "N*s/m"))),
             Contains("cannot be at 'tendon f'"));
  CHECK_THAT(mistakes(entry("viscous_level", "q1", value("coefficient", "level", "1", "N*m"))),
             Contains("the unknown 'level'") && Contains("has no coefficient 'viscous_change'"));
  CHECK_THAT(mistakes(viscous("1", "N*m*s/rad") +
                      value("coefficient", "viscous_change", "1", "N*m*s/rad")),
             Contains("a second time"));
  CHECK_THAT(mistakes(viscous("1", "N*m*s/rad") + viscous("2", "N*m*s/rad")),
             Contains("identified.toml:10:10:") && Contains("first in line 2"));
  CHECK_THAT(mistakes(viscous("1", "N*m*s/rad") + "colour = 1\n"), Contains("unknown key"));
  CHECK_THAT(mistakes("colour = 1\n"), Contains("unknown key"));
  CHECK_THAT(mistakes("[[log]]\nfile = \"a.csv\"\nsha256 = \"abc\"\n"), Contains("64 hexadecimal"));
  CHECK_THAT(
      mistakes(entry("torsion_spring", "q1", value("coefficient", "stiffness", "-0.3", "N*m/rad"))),
      Contains("it would push away from the position"));
  CHECK_THAT(mistakes(entry("guiding_friction", "tendon f",
                            value("shape", "bending_elsewhere", "1", "rad") +
                                value("coefficient", "friction_coefficient", "1.5", "1"))),
             Contains("expected at least 0 and at most 1"));
  CHECK_THAT(mistakes(entry("delay", "q1", value("coefficient", "delay", "3", "s"))),
             Contains("longer than any bus"));
  CHECK_THAT(
      mistakes(entry("torque_constant", "q1", value("coefficient", "gain_change", "-1", "1"))),
      Contains("expected at least -0.6"));
  CHECK_THAT(mistakes(entry("payload", "link tip", value("coefficient", "mass", "-1", "kg"))),
             Contains("no body near the robot"));
  CHECK_THAT(mistakes(entry("payload", "link top", value("coefficient", "mass", "1", "kg"))),
             Contains("did you mean 'link tip'?"));
}

TEST_CASE("the same effect at the same place in another shape is another entry") {
  CHECK(mistakes(stribeck("0.01") + stribeck("0.02")) == "");
  CHECK_THAT(mistakes(stribeck("0.01") + stribeck("0.01")), Catch::Contains("a second time"));
}

TEST_CASE("every effect reads back as it is written, in its own units, for turning and sliding") {
  // A new effect needs nothing but its declaration. Planted defect: a coefficient's unit left "1"
  // as the writer once had it for what was not estimated: "'inertia_change' has the unit '1';
  // expected kg*m^2".
  for (const std::string& id : declared_effects())
    for (const LearntPlace& place : places) {
      const DeclaredEntry declared = *declared_entry(id, place.revolute);
      if (declared.place != place.kind) continue;
      IdentifiedEffect effect;
      effect.effect = id;
      effect.place = place.name;
      const auto fill = [](const std::vector<DeclaredValue>& from,
                           std::vector<IdentifiedValue>& to) {
        for (const DeclaredValue& v : from) {
          const double inside = v.limits.hold(0.5) ? 0.5 : v.limits.hold(-0.5) ? -0.5 : 0.01;
          to.push_back({v.name, inside, 0.125, v.unit});
        }
      };
      fill(declared.shapes, effect.shape);
      fill(declared.coefficients, effect.coefficients);
      const std::string text = identified_text({{effect}, {}});
      INFO(text);
      REQUIRE(mistakes(text) == "");
      CHECK(identified_text(read(text)) == text);
    }
}

TEST_CASE("a log's name may hold any character") {
  Identified learnt;
  learnt.logs.push_back({"a \"b\"\\c\nd.csv", std::string(64, 'a')});
  // Planted defect: the name between quotes as it is: "expected a comment or whitespace, saw 'b'".
  CHECK(read(identified_text(learnt)).logs.front().file == learnt.logs.front().file);
}
