// SPDX-License-Identifier: GPL-3.0-or-later
// The rates the engine is judged by, over many simulated drives. Not part of a usual run:
//   SINEW_TRIALS=200 SINEW_SIZE=50 SINEW_SEED=1000 identification_diagnosis_tests "[.study]" -c one
#include <fmt/core.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <map>
#include <random>

#include "tests/identification/diagnosis/drive_diagnosis.h"

namespace {

using namespace sinew::test;

int environment(const char* name, int otherwise) {
  const char* value = std::getenv(name);
  return value ? std::atoi(value) : otherwise;
}

/// Counts over trials; the truth may be empty (nothing hidden, or nothing of the library).
struct Rates {
  int trials = 0, detected = 0, inside = 0, exact = 0, false_names = 0, none_known = 0;
  int causes = 0, members = 0, false_causes = 0;
  std::map<std::string, int> wrong;
  std::array<int, 10> stated{}, right{};

  void count(const std::set<std::string>& truth, const Verdict& verdict) {
    ++trials;
    const std::set<std::string> names = first_names(verdict);
    detected += verdict.causes.empty() ? 0 : 1;
    none_known += verdict.unexplained.none_of_the_known ? 1 : 0;
    exact += names == truth ? 1 : 0;
    bool all = true, any_false = false;
    for (const std::string& name : truth) {
      const bool found = is_member(verdict, name);
      all = all && found;
      if (!found) ++wrong["missed: " + name];
    }
    for (const NamedCause& cause : verdict.causes) {
      ++causes;
      members += static_cast<int>(cause.members.size());
      bool holds = false;
      for (const std::string& name : truth) holds = holds || is_member(cause, name);
      if (!holds) {
        ++false_causes;
        any_false = true;
        ++wrong[(truth.empty() ? std::string("nothing") : *truth.begin()) + " -> " +
                cause.members.front().name];
      }
      const auto bin = static_cast<std::size_t>(std::min(9.0, 10.0 * cause.confidence));
      ++stated[bin];
      right[bin] += holds ? 1 : 0;
    }
    inside += all ? 1 : 0;
    false_names += any_false ? 1 : 0;
  }

  void print(const std::string& title) const {
    fmt::print(
        "{}: trials {} named {} truth inside {} exact first names {} with a false name {} none of "
        "the known {} mean set {:.2f}\n",
        title, trials, detected, inside, exact, false_names, none_known,
        causes ? static_cast<double>(members) / causes : 0.0);
    for (std::size_t b = 0; b < stated.size(); ++b)
      if (stated[b] > 0)
        fmt::print("  confidence {:.2f}: right {}/{}\n", 0.1 * static_cast<double>(b) + 0.05,
                   right[b], stated[b]);
    for (const auto& [what, count] : wrong) fmt::print("  {} x{}\n", what, count);
  }
};

/// `together` effects of the list in every trial.
void study(const std::string& title, const std::vector<std::string>& effects, int together,
           double size, bool nameable) {
  const int trials = environment("SINEW_TRIALS", 19);
  const auto first = static_cast<unsigned>(environment("SINEW_SEED", 1000));
  Rates rates;
  for (int i = 0; i < trials; ++i) {
    const unsigned seed = first + static_cast<unsigned>(i);
    std::mt19937 random(seed);
    std::set<std::string> truth;
    if (together == 1 && !effects.empty())
      truth.insert(effects[static_cast<std::size_t>(i) % effects.size()]);
    while (static_cast<int>(truth.size()) < together)
      truth.insert(effects[random() % effects.size()]);
    const SyntheticDrive drive = simulate_drive(
        {truth.begin(), truth.end()}, std::vector<double>(truth.size(), size), 30.0, seed);
    const Verdict verdict = diagnose_drive(drive, seed).verdict;
    rates.count(nameable ? truth : std::set<std::string>{}, verdict);
    if (environment("SINEW_VERBOSE", 0) && first_names(verdict) != truth)
      fmt::print(
          "  seed {}: {}\n", seed,
          fmt::format("{}", *(truth.empty() ? std::set<std::string>{"nothing"} : truth).begin()));
  }
  rates.print(title);
}

double size_of_effects() {
  return environment("SINEW_SIZE", 100) / 100.0;
}

}  // namespace

// SINEW_TRIALS, SINEW_SIZE (percent of the noise) and SINEW_SEED choose the run.
TEST_CASE("study: rates", "[.study]") {
  const double size = size_of_effects();
  SECTION("null") {
    study("nothing hidden", {}, 0, 0.0, true);
  }
  SECTION("one") {
    study(fmt::format("one at {}", size), hidden_effects(), 1, size, true);
  }
  SECTION("two") {
    study(fmt::format("two at {}", size), hidden_effects(), 2, size, true);
  }
  SECTION("three") {
    study(fmt::format("three at {}", size), hidden_effects(), 3, size, true);
  }
  SECTION("foreign") {
    study(fmt::format("outside the library at {}", size), foreign_effects(), 1, size, false);
  }
}
