// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/ended_early.h"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "identification/adoption/held_out_judgement.h"
#include "identification/report/findings_json.h"

using namespace sinew::diagnosis;

TEST_CASE("a search that ends with an error is told, and nothing is adopted") {
  CHECK(why_ended([] {}).empty());
  const std::string why = why_ended([] { throw std::runtime_error("no bodies are left"); });
  CHECK(why == "no bodies are left");
  Findings findings;
  findings.extension.adopted = true;
  tell_ended_search(why, findings);
  CHECK_FALSE(findings.extension.adopted);
  CHECK_FALSE(findings.verdict.nothing_beyond_noise());
  CHECK_THAT(findings.headline, Catch::Contains("no bodies are left"));
  CHECK_THAT(findings_json(findings), Catch::Contains("\"adopted\": false"));
}

TEST_CASE("an adoption that is taken back says why and emits nothing") {
  Extension extension;
  decide_adoption(true, true, {0.5, 0.4, 0.6}, {"effort"}, extension);
  REQUIRE(extension.adopted);
  withhold("a joint would be worse", extension);
  CHECK_FALSE(extension.adopted);
  CHECK(extension.functions.empty());
  CHECK(extension.reason == "a joint would be worse");
  extension.reason = "no cause with a term of its own was named";
  withhold("a joint would be worse", extension);
  CHECK(extension.reason == "no cause with a term of its own was named");
}
