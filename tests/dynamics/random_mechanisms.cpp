// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanisms nobody looked at: generated on the spot, compiled and compared.
#include <catch2/catch.hpp>

#include "symbolic/read_mechanism.h"
#include "symbolic/write_mechanism.h"
#include "tests/dynamics/deviation.h"
#include "tests/dynamics/generated_model.h"
#include "tests/dynamics/mechanics_checks.h"
#include "tests/reference/random_mechanism.h"

namespace sinew::reference {
namespace {

/// A mechanism in a model folder, as the folder says it.
struct ModelFolder {
  TemporaryFolder place;
  std::string name;
  Mechanism mechanism;

  explicit ModelFolder(const Mechanism& original) : name(original.name) {
    write_mechanism(original, path(), "a random mechanism");
    mechanism = read_mechanism(path());
  }
  std::filesystem::path path() const { return place.path() / name; }
};

ModelFolder folder_of(std::uint64_t seed, const RandomMechanismOptions& options) {
  return ModelFolder(random_mechanism(seed, options));
}

void check_agreement(const ModelFolder& folder, const ComparisonSize& size) {
  const EmittedModel model = GeneratedModel(folder.path()).load();
  const auto deviations = compare(model, folder.mechanism, size);
  INFO(folder.mechanism.name << "\n" << describe(deviations));
  for (const Deviation& each : deviations) {
    CAPTURE(each.function);
    CHECK(each.relative <= 1e-12);
    CHECK(each.units <= unit_limit(folder.mechanism));
  }
}

void check_mechanics(const ModelFolder& folder) {
  const EmittedModel model = GeneratedModel(folder.path()).load();
  const auto states = sample_states(folder.mechanism, 100, 5);
  auto laws = rigid_body_laws(model, states);
  for (const LawCheck& law : tendon_laws(model, states)) laws.push_back(law);
  laws.push_back(energy_law(model, folder.mechanism, states.back(), 0.1));
  INFO(folder.mechanism.name << "\n" << describe(laws));
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
  const ModelFolder folder = folder_of(3, chain_of(3));
  check_agreement(folder, {10000, 1000, 1});
  check_mechanics(folder);
}

TEST_CASE("a random chain of 6 joints") {
  const ModelFolder folder = folder_of(6, chain_of(6));
  check_agreement(folder, {10000, 500, 1});
  check_mechanics(folder);
}

TEST_CASE("a random chain of 8 joints") {
  const ModelFolder folder = folder_of(8, chain_of(8));
  check_agreement(folder, {10000, 300, 1});
  check_mechanics(folder);
}

TEST_CASE("random chains of 2 to 12 joints") {
  for (int joints = 2; joints <= 12; ++joints) {
    RandomMechanismOptions options;
    options.joints = joints;
    options.arm = joints % 2 == 0;
    check_agreement(folder_of(100 + static_cast<std::uint64_t>(joints), options), {1000, 50, 2});
  }
}

TEST_CASE("random trees") {
  for (int joints = 3; joints <= 10; ++joints) {
    RandomMechanismOptions options;
    options.joints = joints;
    options.branched = true;
    options.arm = joints % 2 == 1;
    check_agreement(folder_of(200 + static_cast<std::uint64_t>(joints), options), {1000, 50, 3});
  }
}

TEST_CASE("a mass off by 1e-9 in a random chain is seen") {
  ModelFolder folder = folder_of(6, chain_of(6));
  const EmittedModel model = GeneratedModel(folder.path()).load();
  folder.mechanism.bodies.back().mass *= 1.0 + 1e-9;
  bool all = true;
  for (const Deviation& each : compare(model, folder.mechanism, {200, 50, 1}))
    all = all && each.relative <= 1e-12;
  CHECK_FALSE(all);
}

}  // namespace
}  // namespace sinew::reference
