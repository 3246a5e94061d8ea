// SPDX-License-Identifier: GPL-3.0-or-later
// What is too small to be worth telling is not told, however plain it is.
#include "identification/diagnosis/materiality.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>

#include "tests/identification/subjects/diagnosed_robot.h"

namespace {

using namespace sinew;

constexpr double kMass = 20.0, kViscous = 60.0, kCoulomb = 30.0;

/// 20 s of a slide that lacks only `lacking` [N/m^3] of force by its position's cube, without
/// noise.
std::string log_of(double lacking, double phase) {
  std::string text = "time [s],q_x [m],tau_x [N]\n";
  for (int k = 0; k < 10000; ++k) {
    const double t = 2e-3 * k, w1 = 2.1, w2 = 5.3;
    const double x = 0.3 * std::sin(w1 * t + phase) + 0.1 * std::sin(w2 * t);
    const double v = 0.3 * w1 * std::cos(w1 * t + phase) + 0.1 * w2 * std::cos(w2 * t);
    const double a = -0.3 * w1 * w1 * std::sin(w1 * t + phase) - 0.1 * w2 * w2 * std::sin(w2 * t);
    const double friction = std::abs(v) < 1e-9 ? 0.0 : std::copysign(kCoulomb, v);
    fmt::format_to(std::back_inserter(text), "{:.3f},{:.12g},{:.12g}\n", t, x,
                   kMass * a + kViscous * v + friction + lacking * x * x * x);
  }
  return text;
}

diagnosis::Findings found_with(double lacking) {
  return test::diagnosed(test::slide(kMass, kViscous, kCoulomb), log_of(lacking, 0.4),
                         log_of(lacking, 1.3));
}

}  // namespace

TEST_CASE("a log of the model itself without noise leaves nothing over that is worth naming") {
  // Planted defects, seen to fail: with immaterial_error() 0 all that is left is noise, and nobody
  // says that it is too little to matter; where friction may not turn a step of the log late
  // (within_step in force_fit.cpp) one reversal is a push.
  for (const double lacking : {0.0, 0.5}) {
    const diagnosis::Findings found = found_with(lacking);
    INFO(lacking << ": " << found.headline);
    CHECK(found.verdict.nothing_beyond_noise());
    CHECK(found.verdict.immaterial);
    CHECK(found.headline.starts_with("The model leaves nothing over that is worth naming"));
    CHECK_FALSE(found.extension.adopted);
  }
  // The same, large enough.
  const diagnosis::Findings large = found_with(200.0);
  INFO(large.headline);
  CHECK_FALSE(large.verdict.immaterial);
  CHECK_FALSE(large.verdict.nothing_beyond_noise());
}

TEST_CASE("what is immaterial is a share of what is measured, or what rounding makes") {
  CHECK(diagnosis::immaterial_error(2.0, 0.0, 0.001) == Approx(0.002));
  CHECK(diagnosis::immaterial_error(2.0, 0.1, 0.001) == Approx(0.1 / std::sqrt(12.0)));
  CHECK(diagnosis::immaterial_error(2.0, 0.0, 0.0) == 0.0);
}

TEST_CASE("causes at immaterial channels alone are taken back, and no others") {
  diagnosis::Problem problem;
  problem.channels = 2;
  problem.library.resize(2);
  problem.library[0].channels = {0};
  problem.library[1].channels = {1};
  const auto two_causes = [] {
    diagnosis::Verdict verdict;
    for (int i = 0; i < 2; ++i) {
      diagnosis::NamedCause cause;
      cause.candidate = i;
      cause.members.resize(1);
      cause.members[0].name = i == 0 ? "first" : "second";
      verdict.causes.push_back(cause);
    }
    verdict.unexplained.none_of_the_known = true;
    verdict.most_excess.channel = 0;
    return verdict;
  };
  diagnosis::Verdict one = two_causes();
  diagnosis::remove_immaterial(problem, {true, false}, one);
  REQUIRE(one.causes.size() == 1);
  CHECK(one.causes[0].members[0].name == "second");
  REQUIRE(one.ruled_out.size() == 1);
  CHECK(one.ruled_out[0].name == "first");
  CHECK(one.most_excess.channel == -1);
  CHECK(one.unexplained.none_of_the_known);
  CHECK_FALSE(one.immaterial);
  diagnosis::Verdict both = two_causes();
  diagnosis::remove_immaterial(problem, {true, true}, both);
  CHECK(both.nothing_beyond_noise());
  CHECK(both.immaterial);
}
