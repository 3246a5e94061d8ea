// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of the truth simulators read as a user's would be: clean ones without suspicion, spoilt ones
// with the fault named.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "identification/logs/read_csv.h"
#include "tests/blind/truth/sealed_trial.h"
#include "tests/reference/temporary_folder.h"

using namespace sinew;
using namespace sinew::truth;

namespace {

double number_in(const std::string& json, const std::string& key) {
  const size_t at = json.find('"' + key + "\":");
  return at == std::string::npos ? 0.0 : std::strtod(json.c_str() + at + key.size() + 3, nullptr);
}

// What a model file would say about the drive.
std::vector<ChannelSpec> specs_of(const Trial& trial) {
  DriveLimits limits;
  const double reach = 2.5 * number_in(trial.nominal, "amplitude");
  limits.low = -reach;
  limits.high = reach;
  limits.max_velocity = 5.0 * number_in(trial.nominal, "top_speed");
  limits.inertia = number_in(trial.nominal, "inertia");
  limits.friction = 1.5 * number_in(trial.nominal, "friction_level");
  limits.max_effort = 60.0 * limits.friction;
  return trial.plant == "linear_drive" ? linear_drive_channels(limits)
                                       : rotary_drive_channels(limits);
}

std::vector<DataFault> findings(const Trial& trial) {
  const reference::TemporaryFolder folder;
  const auto path = folder.path() / "trial.csv";
  reference::write_text(path, trial.train);
  try {
    return read_csv(path.string(), specs_of(trial)).faults;
  } catch (const LogError& error) {
    return error.faults;
  }
}

std::string serious(const std::vector<DataFault>& found) {
  std::string text;
  for (const DataFault& f : found)
    if (f.severity != Severity::note) text += "\n  " + message(f);
  return text;
}

bool is_named(const std::vector<DataFault>& found, const Seal& seal) {
  for (const DataFault& f : found) {
    if (fault_name(f.kind) != seal.fault) continue;
    const bool either = seal.fault == "unit slip" || seal.fault == "swapped columns";
    if (!either && f.channel != seal.channel) continue;
    if (seal.row > 0 && (seal.row < f.row || seal.row > f.last_row)) continue;
    return true;
  }
  return false;
}

int trials() {
  const char* asked = std::getenv("SINEW_FAULT_TRIALS");
  return asked != nullptr ? 20 * std::atoi(asked) : 40;
}

}  // namespace

TEST_CASE("drives with and without hidden causes are read without suspicion") {
  int suspected = 0;
  for (int seed = 1; seed <= trials(); ++seed) {
    TrialRequest request;
    request.seed = static_cast<std::uint64_t>(seed);
    request.family = seed % 2 == 0 ? Family::nothing : Family::one;
    const SealedTrial trial(request);
    const std::string found = serious(findings(trial.open()));
    if (found.empty()) continue;
    // A coarse sensor is a cause of its own, and looks like one.
    const auto& hidden = trial.seal().hidden;
    ++suspected;
    UNSCOPED_INFO(
        fmt::format("seed {}: {}{}", seed, hidden.empty() ? "nothing" : hidden[0].name, found));
  }
  WARN(suspected << " of " << trials() << " suspected");
  CHECK(suspected <= std::max(1.0, 0.01 * trials()));
}

TEST_CASE("spoilt logs of drives are seen through") {
  int named = 0;
  for (int seed = 1; seed <= trials(); ++seed) {
    TrialRequest request;
    request.seed = static_cast<std::uint64_t>(5000 + seed);
    request.family = Family::data_fault;
    const SealedTrial trial(request);
    const auto found = findings(trial.open());
    if (is_named(found, trial.seal()))
      ++named;
    else
      UNSCOPED_INFO(fmt::format("seed {}: {} in {} at row {}{}", seed, trial.seal().fault,
                                trial.seal().channel, trial.seal().row, serious(found)));
  }
  WARN(named << " of " << trials() << " named");
  CHECK(named >= 0.95 * trials());
}
