// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanisms nobody looked at: generated on the spot, compiled and compared.
#include <catch2/catch.hpp>

#include "generator/outputs/outputs.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/write_mechanism.h"
#include "tests/reference/random_mechanism.h"
#include "tests/symbolic/dynamics/deviation.h"
#include "tests/symbolic/dynamics/generated_model.h"
#include "tests/symbolic/dynamics/mechanics_checks.h"

namespace sinew::reference {
namespace {

/// A mechanism as its model folder says it, and the C that the program made of the folder.
struct Subject {
  Mechanism mechanism;
  EmittedModel model;
};

Subject generate(std::uint64_t seed, const RandomMechanismOptions& options) {
  const Mechanism original = random_mechanism(seed, options);
  const TemporaryFolder place;
  const std::filesystem::path folder = place.path() / original.name;
  Outputs outputs;
  outputs.into_folder(folder, mechanism_files(original, "a random mechanism"));
  outputs.commit();
  return {read_mechanism(folder), GeneratedModel(folder).load()};
}

void check_agreement(const Subject& subject, const ComparisonSize& size) {
  const auto deviations = compare(subject.model, subject.mechanism, size);
  INFO(subject.mechanism.name << "\n" << describe(deviations));
  for (const Deviation& each : deviations) {
    CAPTURE(each.function);
    CHECK(each.relative <= 1e-12);
    CHECK(each.units <= unit_limit(subject.mechanism));
  }
}

void check_mechanics(const Subject& subject) {
  const auto states = sample_states(subject.mechanism, 100, 5);
  auto laws = rigid_body_laws(subject.model, states);
  if (!subject.mechanism.tendons.empty())
    for (const LawCheck& law : tendon_laws(subject.model, states)) laws.push_back(law);
  laws.push_back(energy_law(subject.model, subject.mechanism, states.back(), 0.1));
  INFO(subject.mechanism.name << "\n" << describe(laws));
  for (const LawCheck& law : laws) CHECK(law.holds());
}

RandomMechanismOptions chain_of(int joints) {
  RandomMechanismOptions options;
  options.joints = joints;
  options.arm = joints == 6;
  options.tendons = 2 * joints;
  return options;
}

TEST_CASE("a random chain of 3 joints") {
  const Subject subject = generate(3, chain_of(3));
  check_agreement(subject, {10000, 1000, 1});
  check_mechanics(subject);
}

TEST_CASE("a random chain of 6 joints") {
  const Subject subject = generate(6, chain_of(6));
  check_agreement(subject, {10000, 250, 1});
  check_mechanics(subject);
}

TEST_CASE("a random chain of 8 joints") {
  const Subject subject = generate(8, chain_of(8));
  check_agreement(subject, {10000, 150, 1});
  check_mechanics(subject);
}

TEST_CASE("random chains of 2 to 12 joints", "[slow][thorough]") {
  for (int joints = 2; joints <= 12; ++joints) {
    RandomMechanismOptions options;
    options.joints = joints;
    options.arm = joints % 2 == 0;
    check_agreement(generate(100 + static_cast<std::uint64_t>(joints), options), {1000, 50, 2});
  }
}

TEST_CASE("random trees", "[slow][thorough]") {
  for (int joints = 3; joints <= 10; ++joints) {
    RandomMechanismOptions options;
    options.joints = joints;
    options.branched = true;
    options.arm = joints % 2 == 1;
    const Subject subject = generate(200 + static_cast<std::uint64_t>(joints), options);
    check_agreement(subject, {1000, 50, 3});
    check_mechanics(subject);
  }
}

TEST_CASE("a mass off by 1e-9 in a random chain is seen") {
  Subject subject = generate(6, chain_of(6));
  subject.mechanism.bodies.back().mass *= 1.0 + 1e-9;
  bool all = true;
  for (const Deviation& each : compare(subject.model, subject.mechanism, {200, 50, 1}))
    all = all && each.relative <= 1e-12;
  CHECK_FALSE(all);
}

}  // namespace
}  // namespace sinew::reference
