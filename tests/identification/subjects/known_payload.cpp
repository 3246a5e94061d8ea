// SPDX-License-Identifier: GPL-3.0-or-later
// Logs that say which load they were recorded with.
#include <catch2/catch.hpp>
#include <stdexcept>

#include "identification/logs/carried_payload.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/identification/subjects/diagnosed_robot.h"
#include "tests/identification/subjects/loaded_arm.h"

namespace {

using namespace sinew;
using namespace sinew::test;
using diagnosis::Findings;

/// The same log with a column more.
std::string with_column(const std::string& text, const std::string& name,
                        const std::string& value) {
  std::string out;
  bool header = true;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    out += text.substr(at, end - at) + "," + (header ? name : value) + "\n";
    header = false;
    at = end + 1;
  }
  return out;
}

bool names_payload(const Findings& found) {
  for (const auto& cause : found.verdict.causes)
    for (const auto& member : cause.members)
      if (member.name == "payload") return true;
  return false;
}

std::string said_of(const Findings& found, std::size_t log) {
  std::string all;
  for (const std::string& fault : found.logs[log].faults) all += fault + "\n";
  return all;
}

std::string said(const Findings& found) {
  std::string all;
  for (std::size_t i = 0; i < found.logs.size(); ++i) all += said_of(found, i);
  return all;
}

}  // namespace

TEST_CASE("a load of known mass is no deviation, and friction beside it is found",
          "[slow][thorough]") {
  // Planted defect, seen to fail: no payload_effort in the recordings (DrivenSubject::take).
  const Mechanism arm = arm_of_five();
  const ArmFriction friction{0.6, 0.4};
  const std::vector<LogText> logs{
      {"bare.csv", csv(draw_log(arm, 1, friction)), false},
      {"loaded.csv", csv(draw_log(loaded(arm), 2, friction)), false},
      {"heavy.csv", csv(draw_log(loaded(arm, 2.0 * kLoad), 4, friction)), false},
      {"test.csv", csv(draw_log(loaded(arm), 3, friction)), true}};
  const std::vector<std::string> conditions{"loaded.csv:payload=600 g", "test.csv: payload=0.6kg",
                                            "heavy.csv:payload@l5=1.2kg at 50, -20, 30 mm"};
  const Findings found = diagnosis_of(arm, logs, conditions).findings;
  INFO(found.headline << "\n" << said(found));
  CHECK_FALSE(names_payload(found));
  CHECK(found.verdict.causes.size() == 2 * kArmJoints);
  CHECK(found.extension.adopted);
  // Beside the log that carries it, and known to a millimetre.
  CHECK(said_of(found, 0).find("payload") == std::string::npos);
  CHECK(said_of(found, 1).find("its centre is at 0.05") != std::string::npos);
  CHECK(
      said_of(found, 2).find("its centre is at 0.05, -0.02, 0.03 m in the link's frame, as told") !=
      std::string::npos);
  // What is left is what an arm without a load leaves: noise, a share of the rms, and how friction
  // turns.
  const Findings bare =
      diagnosed(arm, csv(draw_log(arm, 1, friction)), csv(draw_log(arm, 3, friction)));
  for (std::size_t j = 0; j < found.channels.size(); ++j) {
    const auto relative = [&](const Findings& f) {
      return f.channels[j].domains.front().after / f.channels[j].measured_rms;
    };
    INFO(j << ": " << relative(found) << ", without load " << relative(bare));
    CHECK(relative(found) < 1.2 * relative(bare));
  }
}

TEST_CASE("a column may say which load a log carried", "[slow][thorough]") {
  const Mechanism arm = arm_of_five();
  const auto log = [&](std::uint64_t seed) {
    return with_column(csv(draw_log(loaded(arm), seed, {})), "payload [g]", "600");
  };
  // Planted: a fitted centre that is known from then on as if without an error. Both logs were told
  // an offset of joint 4, which feels the load's weight.
  for (const std::uint64_t seed : {1U, 17U}) {
    const std::vector<LogText> logs{{"train.csv", log(seed), false},
                                    {"test.csv", log(seed + 1), true}};
    const Findings found = diagnosis_of(arm, logs).findings;
    INFO(found.headline << "\n" << said(found));
    CHECK(found.verdict.nothing_beyond_noise());
  }
  // Nothing told: the load is found.
  const std::vector<LogText> bare{{"train.csv", csv(draw_log(loaded(arm), 1, {})), false},
                                  {"test.csv", csv(draw_log(loaded(arm), 2, {})), true}};
  CHECK(names_payload(diagnosis_of(arm, bare).findings));
}

TEST_CASE("a payload is read as people write it, and refused with what is expected") {
  const CarriedPayload all = carried_payload("payload=2.805kg");
  CHECK(all.log.empty());
  CHECK(all.mass == Approx(2.805));
  CHECK_FALSE(all.centre);
  const CarriedPayload one =
      carried_payload("logs/a b.csv: payload@tool0 = 500 g at 0, -10, 50 mm");
  CHECK(one.log == "logs/a b.csv");
  CHECK(one.link == "tool0");
  CHECK(one.mass == Approx(0.5));
  REQUIRE(one.centre);
  CHECK(one.centre->isApprox(Eigen::Vector3d(0.0, -0.01, 0.05)));
  for (const char* text : {"payload", "load=1kg", "payload=kg", "payload=1", "payload=1m",
                           "payload=-1kg", "payload=1,2kg", "payload@=1kg", "payload=1kg at 0, 0 m",
                           "payload=1kg at 0, 0, 1", "xpayload=1kg"})
    CHECK_THROWS_AS(carried_payload(text), std::invalid_argument);
  const std::vector<CarriedPayload> twice{all, one};
  CHECK(payload_of(twice, "b.csv") == &twice[0]);
  CHECK_THROWS_AS(payload_of(twice, "logs/a b.csv"), std::invalid_argument);
  CHECK_THROWS_AS(check_payloads({one}, {"b.csv"}), std::invalid_argument);
}
