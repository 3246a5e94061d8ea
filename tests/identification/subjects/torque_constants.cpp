// SPDX-License-Identifier: GPL-3.0-or-later
// An arm whose logs have currents.
#include <catch2/catch.hpp>
#include <string>

#include "identification/adoption/diagnose.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/identification/subjects/diagnosed_robot.h"

namespace {

using namespace sinew;
using namespace sinew::test;

/// The same log with each joint's effort as a current.
std::string in_amperes(ArmLog log, const std::vector<double>& constants) {
  for (Eigen::Index j = 0; j < log.tau.cols(); ++j)
    log.tau.col(j) /= constants[static_cast<std::size_t>(j)];
  std::string text = csv(log);
  for (std::size_t at = 0; (at = text.find("tau_", at)) != std::string::npos;)
    text.replace(at, 4, "i_");
  for (std::size_t at = 0; (at = text.find("[N*m]", at)) != std::string::npos;)
    text.replace(at, 5, "[A]");
  return text;
}

}  // namespace

TEST_CASE("torque constants that nobody gave are fitted to what the links ask for, and said") {
  // Planted defect, seen to fail: where the logs are not read again with the fitted constants
  // (read() in diagnose.cpp) 9 and 2 standard deviations are left over.
  const Mechanism arm = upper_and_lower_arm();
  const std::vector<double> constants{8.0, 3.0};
  const auto log = [&](std::uint64_t seed) {
    return in_amperes(draw_log(arm, seed, {.coulomb = 0.05, .viscous = 0.02}), constants);
  };
  const diagnosis::Findings found = diagnosed(arm, log(1), log(2));
  int said = 0;
  for (const std::string& fault : found.logs.front().faults)
    for (const char* each : {"'tau_j1' is a current: the torque constant 8.0",
                             "'tau_j1' is a current: the torque constant 7.9",
                             "'tau_j2' is a current: the torque constant 3.0",
                             "'tau_j2' is a current: the torque constant 2.9"})
      said += fault.find(each) != std::string::npos ? 1 : 0;
  CHECK(said == 2);
  for (const diagnosis::ChannelFinding& channel : found.channels)
    CHECK(channel.relative(channel.domains.front().after) < 0.05);
}
