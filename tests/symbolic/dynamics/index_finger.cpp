// SPDX-License-Identifier: GPL-3.0-or-later
// The committed C of the index finger against independent numerics and against mechanics.
#include <catch2/catch.hpp>

#include "symbolic/model/read_mechanism.h"
#include "tests/symbolic/dynamics/deviation.h"
#include "tests/symbolic/dynamics/generated_model.h"
#include "tests/symbolic/dynamics/mechanics_checks.h"

namespace sinew::reference {
namespace {

const std::filesystem::path kSource = SINEW_SOURCE_DIR;

Mechanism index_mechanism() {
  return read_mechanism(kSource / "models/index");
}

EmittedModel index_model() {
  return EmittedModel(kSource / "generated/index");
}

/// The committed C with the first `from` inside one function's definition replaced by `to`.
EmittedModel index_with(const std::string& function, const std::string& from,
                        const std::string& to) {
  const TemporaryFolder copy;
  std::filesystem::copy(kSource / "generated/index", copy.path());
  const std::filesystem::path file = copy.path() / "index.c";
  std::string text = read_text(file);
  const std::size_t definition = text.find("void " + function + "(");
  REQUIRE(definition != std::string::npos);
  const std::size_t place = text.find(from, text.find('{', definition));
  REQUIRE(place != std::string::npos);
  std::filesystem::permissions(file, std::filesystem::perms::owner_write,
                               std::filesystem::perm_options::add);
  write_text(file, text.replace(place, from.size(), to));
  return EmittedModel(copy.path());
}

void check_all(const std::vector<LawCheck>& laws) {
  INFO(describe(laws));
  for (const LawCheck& law : laws) CHECK(law.holds());
}

const Deviation& of(const std::vector<Deviation>& deviations, const std::string& function) {
  for (const Deviation& each : deviations)
    if (each.function == function) return each;
  throw std::out_of_range(function);
}

TEST_CASE("index: emitted C is Newton-Euler's over 10,000 states") {
  const auto deviations = compare(index_model(), index_mechanism(), {10000, 500, 11});
  INFO(describe(deviations));
  REQUIRE(deviations.size() == 13);
  for (const Deviation& each : deviations) {
    CAPTURE(each.function);
    CHECK(each.relative <= 1e-12);
    CHECK(each.units <= 16.0);
  }
}

TEST_CASE("index: emitted C obeys mechanics") {
  const EmittedModel model = index_model();
  const auto states = sample_states(index_mechanism(), 300, 21);
  check_all(rigid_body_laws(model, states));
  check_all(tendon_laws(model, states));
}

TEST_CASE("index: free motion keeps its energy") {
  const EmittedModel model = index_model();
  for (const State& start : sample_states(index_mechanism(), 5, 31))
    check_all({energy_law(model, index_mechanism(), start, 0.2)});
}

TEST_CASE("index: an inertia off by 1e-9 and a radius off by 1e-9 are seen") {
  Mechanism changed = index_mechanism();
  changed.bodies.back().inertia(2, 2) *= 1.0 + 1e-9;
  changed.tendons.front().pulleys.front().radius *= 1.0 + 1e-9;
  const auto deviations = compare(index_model(), changed, {500, 100, 11});
  CHECK(of(deviations, "mass_matrix").relative > 1e-12);
  CHECK(of(deviations, "mass_matrix").units > 16.0);
  CHECK(of(deviations, "inverse_dynamics").units > 16.0);
  CHECK(of(deviations, "coupling_matrix").units > 16.0);
  CHECK(of(deviations, "gravity").units <= 16.0);
}

TEST_CASE("index: one sign flipped in the emitted Coriolis matrix is seen") {
  const EmittedModel wrong = index_with("index_coriolis_matrix", " - ", " + ");
  const auto deviations = compare(wrong, index_mechanism(), {500, 100, 11});
  CHECK(of(deviations, "coriolis_matrix").relative > 1e-12);
  bool all = true;
  for (const LawCheck& law : rigid_body_laws(wrong, sample_states(index_mechanism(), 20, 21)))
    all = all && law.holds();
  CHECK_FALSE(all);
}

TEST_CASE("index: float emitted from the same model keeps float's precision") {
  const GeneratedModel generated(kSource / "models/index", {"--scalar", "float"});
  const EmittedModel model = generated.load();
  REQUIRE(model.catalogue().scalar_bytes == 4);
  const auto deviations = compare(model, index_mechanism(), {1000, 1000, 11});
  INFO(describe(deviations));
  for (const Deviation& each : deviations) {
    CAPTURE(each.function);
    CHECK(each.units <= 16.0);
  }
}

}  // namespace
}  // namespace sinew::reference
