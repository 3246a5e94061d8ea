// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/held_out_judgement.h"

#include <catch2/catch.hpp>
#include <optional>

using namespace sinew::diagnosis;

TEST_CASE("a name stands where its gain on held-out logs is surely one") {
  // Planted defect: with any share above zero "chance" is named, too.
  const auto cause = [](const char* name, const Gain& gain) {
    NamedCause c;
    c.members.emplace_back();
    c.members.front().name = name;
    c.confirmed = gain;
    return c;
  };
  Verdict verdict;
  verdict.causes = {cause("chance", {0.011, -0.003, 0.019}), cause("sure", {0.05, 0.02, 0.08}),
                    cause("sure to one side", {0.05, -0.005, 0.1}),
                    cause("loss", {-0.2, -0.3, -0.1})};
  confirm_on_held_out(verdict);
  REQUIRE(verdict.causes.size() == 2);
  CHECK(verdict.causes[0].members.front().name == "sure");
  CHECK(verdict.causes[1].members.front().name == "sure to one side");
  REQUIRE(verdict.ruled_out.size() == 2);
  CHECK(verdict.ruled_out.front().reason == "no sure gain on the held-out logs");
}

// Seen red where only a gain in left-out blocks of the training logs counted: "the model leaves
// nothing over but noise", of an rms residual 3.4 times the noise.
TEST_CASE("a name that held-out logs refute is no noise where the training logs leave much") {
  const auto refuted = [](double left_without) {
    NamedCause c;
    c.members.emplace_back();
    c.members.front().name = "cable";
    c.log_odds = 740.0;
    c.cross_validated = {0.1, -0.4, 0.5};
    c.confirmed = {-0.2, -0.3, -0.1};
    c.left_without = left_without;
    Verdict verdict;
    verdict.causes = {c};
    confirm_on_held_out(verdict);
    return verdict;
  };
  CHECK(refuted(1.5).nothing_beyond_noise());
  const Verdict told = refuted(3.4);
  REQUIRE(told.disagreements.size() == 1);
  CHECK(told.disagreements.front().name == "cable");
  CHECK(told.disagreements.front().ratio == 3.4);
}

// Seen red with structure that is told whatever the held-out logs say, and with such of one log's
// time taken back.
TEST_CASE(
    "structure without a name stands unless held-out logs could have confirmed it and did not") {
  const auto on = [](const char* what, std::optional<Gain> confirmed) {
    Dependence d;
    d.on = what;
    d.confirmed = confirmed;
    return d;
  };
  Verdict verdict;
  verdict.unexplained.none_of_the_known = true;
  verdict.unexplained.named_share = 0.3;
  verdict.unexplained.depends_on = {on("position", Gain{0.01, -0.02, 0.04}),
                                    on("velocity", Gain{0.2, 0.1, 0.3}), on("time", std::nullopt)};
  confirm_on_held_out(verdict);
  REQUIRE(verdict.unexplained.depends_on.size() == 2);
  CHECK(verdict.unexplained.depends_on[0].on == "velocity");
  CHECK(verdict.unexplained.depends_on[1].on == "time");
  CHECK(verdict.unexplained.none_of_the_known);
  verdict.unexplained.depends_on = {on("position", Gain{0.01, -0.02, 0.04})};
  confirm_on_held_out(verdict);
  CHECK(verdict.unexplained.depends_on.empty());
  CHECK_FALSE(verdict.unexplained.none_of_the_known);
  CHECK(verdict.unexplained.named_share == 1.0);
}
