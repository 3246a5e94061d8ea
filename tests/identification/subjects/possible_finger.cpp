// SPDX-License-Identifier: GPL-3.0-or-later
// What logs of a finger on tendons teach leaves every joint and every motor its inertia.
#include <catch2/catch.hpp>

#include "identification/adoption/possible_terms.h"
#include "tests/identification/subjects/finger_with_motors.h"

using namespace sinew;
using namespace sinew::diagnosis;

namespace {

ExtensionTerm term(const char* effect, const char* place,
                   const std::vector<IdentifiedValue>& coefficients) {
  ExtensionTerm one;
  one.entry.effect = effect;
  one.entry.place = place;
  one.entry.coefficients = coefficients;
  return one;
}

}  // namespace

TEST_CASE("nothing is adopted with which a torque would move a finger the wrong way") {
  // A load and a link with moments that no body has, a drive that takes away more inertia than the
  // bent finger has, a motor without any: the first three make the mass matrix indefinite in about
  // 30 % of the joints' range. Planted defects: no look at bodies in change_body(): the mass matrix
  // alone is to blame; nor at the mass matrix: all are adopted.
  const std::filesystem::path runtime = SINEW_SOURCE_DIR "/runtime";
  const Mechanism finger = read_mechanism(SINEW_SOURCE_DIR "/models/index");
  const DrivenSubject subject(test::finger_with_motors(), {}, runtime,
                              std::make_shared<const RigidColumns>(finger, runtime));
  const std::vector<IdentifiedValue> no_body{{"mass", 1e-6, 1e-7, "kg"},
                                             {"moment_zz", -2.6e-7, 1e-8, "kg*m^2"}};
  const auto inertia = [](double change) {
    return std::vector<IdentifiedValue>{{"inertia_change", change, 1e-8, "kg*m^2"}};
  };
  const std::pair<ExtensionTerm, const char*> impossible[] = {
      {term("payload", "link distal", no_body), "payload (link distal) cannot be adopted: no body"},
      {term("inertial_parameters", "link distal", no_body), "cannot be adopted: no body has"},
      {term("inertia", "q20", inertia(-6.4e-6)), "not be positive definite at q20 = "},
      {term("inertia", "motor 3", inertia(-1.0)), "the inertia of 'motor 3' would be -"}};
  for (const auto& [one, why] : impossible) {
    const PossibleTerms possible = possible_terms(subject, {one});
    INFO(one.entry.effect << " at " << one.entry.place);
    CHECK(possible.terms.empty());
    REQUIRE(possible.refused.size() == 1);
    CHECK_THAT(possible.refused.front(), Catch::Contains(why));
  }
  CHECK(possible_terms(subject, {term("inertia", "q20", inertia(-6.4e-7))}).refused.empty());
}
