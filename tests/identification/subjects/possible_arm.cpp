// SPDX-License-Identifier: GPL-3.0-or-later
// What logs of an arm teach about its links leaves it an arm that there can be.
#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include "identification/adoption/possible_terms.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/extension/learnt_mass_matrix.h"
#include "symbolic/files/description_error.h"
#include "symbolic/model/pseudo_inertia.h"
#include "symbolic/model/singular_mass_matrix.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/identification/subjects/diagnosed_robot.h"

using namespace sinew;
using namespace sinew::test;

namespace {

std::vector<Range> ranges_of(const Mechanism& arm) {
  std::vector<Range> ranges;
  for (const Joint& joint : arm.joints) ranges.push_back({joint.low, joint.high});
  return ranges;
}

}  // namespace

TEST_CASE("a small load in noisy logs is adopted as a body", "[slow]") {
  // A weight in the hand's centre of mass, a point: its mass shows, its moments of inertia are lost
  // in the noise, and what is fitted is no body. The hand's own moments hide that: hand and weight
  // together are one with either, so that the weight is looked at by itself, too. Planted defect:
  // no make_links_physical() (extend.cpp): its own pseudo-inertia is not positive definite.
  const Mechanism arm = arm_of_five();
  Mechanism built = arm;
  built.bodies.back().mass += 0.05;
  const diagnosis::Diagnosis found =
      whole_diagnosis(arm, csv(draw_log(built, 1, {})), csv(draw_log(built, 2, {})));
  INFO(found.findings.headline << "\n" << found.findings.extension.reason);
  REQUIRE(found.findings.extension.adopted);
  REQUIRE(found.findings.terms.front().effect == "payload");
  const Identified read = parse_identified(identified_text(found.extended), "identified.toml",
                                           learnt_places(arm, false));
  CHECK_THAT(found.findings.extension.reason, Catch::Contains("none that a body has"));
  REQUIRE(read.effects.front().effect == "payload");
  CHECK(Eigen::LLT<Eigen::Matrix4d>(pseudo_inertia_of(read.effects.front())).info() ==
        Eigen::Success);
  const Mechanism learnt = with_identified(arm, read);
  CHECK(learnt.bodies.back().mass == Approx(0.13).epsilon(0.1));
  for (const Body& body : learnt.bodies)
    CHECK(Eigen::LLT<Eigen::Matrix4d>(body_pseudo_inertia(body)).info() == Eigen::Success);
  for (const Eigen::VectorXd& q : workspace_samples(ranges_of(learnt)))
    CHECK(Eigen::LLT<Eigen::MatrixXd>(mass_matrix_at(learnt, q)).info() == Eigen::Success);
}

TEST_CASE("a term that would make the model impossible is left out with the reason") {
  // Planted defect: possible_terms() taking every term: three stay.
  using namespace sinew::diagnosis;
  const Mechanism arm = upper_and_lower_arm();
  const std::filesystem::path runtime = SINEW_SOURCE_DIR "/runtime";
  const DrivenSubject subject(driven_model(arm), {}, runtime,
                              std::make_shared<const RigidColumns>(arm, runtime));
  const auto term = [](const char* effect, const char* place, const char* name, double value,
                       const char* unit) {
    ExtensionTerm one;
    one.entry.effect = effect;
    one.entry.place = place;
    one.entry.coefficients = {{name, value, 0.01, unit}};
    return one;
  };
  // Less than the lower arm has about the elbow; a spring that pushes; a payload that is one.
  const PossibleTerms possible =
      possible_terms(subject, {term("inertia", "j2", "inertia_change", -0.2, "kg*m^2"),
                               term("torsion_spring", "j1", "stiffness", -0.3, "N*m/rad"),
                               term("payload", "link l2", "mass", 0.1, "kg")});
  REQUIRE(possible.terms.size() == 1);
  CHECK(possible.terms.front().entry.effect == "payload");
  REQUIRE(possible.refused.size() == 2);
  CHECK_THAT(possible.refused[0], Catch::Contains("inertia (j2) cannot be adopted") &&
                                      Catch::Contains("not be positive definite at j1 = "));
  // Seen red with the key of the file before it, "effect[1].coefficient[0]".
  CHECK_THAT(possible.refused[1], Catch::Contains("cannot be adopted: 'stiffness' is") &&
                                      Catch::Contains("it would push away"));
  // What a longer hand makes possible: links are looked at first. Less than the arm has about the
  // elbow now (1.6 kg at 0.13 m, and its own), and not less than with 2 kg m more beyond it.
  ExtensionTerm hand = term("inertial_parameters", "link l2", "mass", 8.0, "kg");
  hand.entry.coefficients.push_back({"first_moment_z", 2.0, 0.01, "kg*m"});
  for (const char* moment : {"moment_xx", "moment_yy"})
    hand.entry.coefficients.push_back({moment, 0.6, 0.01, "kg*m^2"});
  const ExtensionTerm lighter = term("inertia", "j2", "inertia_change", -0.06, "kg*m^2");
  CHECK(possible_terms(subject, {lighter}).refused.size() == 1);
  CHECK(possible_terms(subject, {lighter, hand}).refused == std::vector<std::string>{});
}
