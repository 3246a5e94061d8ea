// SPDX-License-Identifier: GPL-3.0-or-later
// Effects hidden in simulated drives. A few in every run; the study ([.study]) prints rates.
#include <fmt/core.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <map>
#include <set>

#include "identification/explain.h"
#include "tests/identification/drive_candidates.h"
#include "tests/identification/synthetic_drive.h"

namespace {

using namespace sinew::diagnosis;
using namespace sinew::test;

Explanation diagnose(const SyntheticDrive& drive, unsigned seed) {
  Problem problem;
  problem.training = {drive.log};
  DriveScales scales = drive_scales(problem.training);
  scales.period_in = drive.period_in;
  scales.period_out = drive.period_out;
  Settings settings;
  settings.edge_s = 0.2;
  settings.seed = seed;
  problem.baseline = drive_baseline(scales);
  scales.presliding = fitted_presliding(problem.training, scales, settings);
  problem.library = drive_library(scales);
  return explain(problem, settings);
}

bool is_member(const Verdict& verdict, const std::string& name) {
  return std::any_of(verdict.causes.begin(), verdict.causes.end(), [&](const NamedCause& cause) {
    return std::any_of(cause.members.begin(), cause.members.end(),
                       [&](const RankedCause& member) { return member.name == name; });
  });
}

std::set<std::string> first_names(const Verdict& verdict) {
  std::set<std::string> names;
  for (const NamedCause& cause : verdict.causes) names.insert(cause.members.front().name);
  return names;
}

int environment(const char* name, int otherwise) {
  const char* value = std::getenv(name);
  return value ? std::atoi(value) : otherwise;
}

}  // namespace

TEST_CASE("an effect as large as the noise is named, and nothing else") {
  for (const std::string name : {"viscous asymmetry", "ripple, input order 2", "spring"}) {
    INFO(name);
    const Verdict verdict = diagnose(simulate_drive({name}, {1.0}, 30.0, 41), 1).verdict;
    CHECK(first_names(verdict) == std::set<std::string>{name});
    CHECK_FALSE(verdict.unexplained.none_of_the_known);
    CHECK(verdict.causes.front().confidence > 0.7);
    CHECK(verdict.relative_error_after < verdict.relative_error_before);
  }
}

TEST_CASE("where nothing is hidden nothing is named") {
  for (const unsigned seed : {301u, 302u, 303u, 304u}) {
    const Verdict verdict = diagnose(simulate_drive({}, {}, 30.0, seed), seed).verdict;
    CHECK(verdict.nothing_beyond_noise());
    CHECK(verdict.ruled_out.size() > 20);
  }
}

TEST_CASE("an effect outside the library gets no name, but what it depends on") {
  const Verdict verdict =
      diagnose(simulate_drive({"bump in position"}, {1.0}, 30.0, 77), 2).verdict;
  CHECK(verdict.unexplained.none_of_the_known);
  REQUIRE_FALSE(verdict.unexplained.depends_on.empty());
  CHECK(verdict.unexplained.depends_on.front().on.find("position") != std::string::npos);
}

// SINEW_TRIALS, SINEW_SIZE (percent of the noise) and SINEW_SEED choose the run.
TEST_CASE("study: detection and right names", "[.study]") {
  const int trials = environment("SINEW_TRIALS", 19);
  const double size = environment("SINEW_SIZE", 100) / 100.0;
  const unsigned first = static_cast<unsigned>(environment("SINEW_SEED", 1000));
  int detected = 0, inside = 0, exact = 0, members = 0, causes = 0;
  std::map<std::string, int> wrong;
  for (int i = 0; i < trials; ++i) {
    const std::string& name =
        hidden_effects()[static_cast<std::size_t>(i) % hidden_effects().size()];
    const unsigned seed = first + static_cast<unsigned>(i);
    const Verdict verdict = size > 0.0
                                ? diagnose(simulate_drive({name}, {size}, 30.0, seed), seed).verdict
                                : diagnose(simulate_drive({}, {}, 30.0, seed), seed).verdict;
    detected += verdict.causes.empty() ? 0 : 1;
    inside += is_member(verdict, name) ? 1 : 0;
    exact += first_names(verdict) == std::set<std::string>{name} ? 1 : 0;
    for (const NamedCause& cause : verdict.causes)
      members += static_cast<int>(cause.members.size());
    causes += static_cast<int>(verdict.causes.size());
    for (const std::string& other : first_names(verdict))
      if (other != name) ++wrong[name + " -> " + other];
  }
  fmt::print("size {} trials {}: detected {} truth inside {} exact {} mean set {:.2f}\n", size,
             trials, detected, inside, exact, causes ? static_cast<double>(members) / causes : 0.0);
  for (const auto& [what, count] : wrong) fmt::print("  {} x{}\n", what, count);
}
