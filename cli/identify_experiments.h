// SPDX-License-Identifier: GPL-3.0-or-later
// One experiment each: logs in, numbers with their errors out.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/outputs/outputs.h"
#include "identification/experiments/bump_projection.h"
#include "identification/logs/log.h"
#include "symbolic/parts/lever.h"
#include "symbolic/parts/motor.h"

namespace sinew {

/// What `sinew identify` reports. `missing`: what the logs cannot say, and the experiment that
/// would; may be there although the rest is identified.
struct IdentifyReport {
  bool identified = false;
  nlohmann::ordered_json results;
  std::vector<std::string> missing;
  FileSet emitted, tables;  ///< of the folders that --emit and --tables name
};

/// {"value", "standard_error", "interval_95": [low, high]}.
nlohmann::ordered_json json_of(const Estimate& estimate);

IdentifyReport report_friction(const std::vector<Log>& logs, const MotorParameters& motor);
IdentifyReport report_inertia(const std::vector<Log>& logs, const MotorParameters& motor);
/// The first log is the one without compensation where the effect of one is asked for.
IdentifyReport report_ripple(const std::vector<Log>& logs, const MotorParameters& motor);
/// `emit`: with the C of the calibration, where it is identified.
IdentifyReport report_lever(const std::vector<Log>& logs, const LeverParameters& lever, bool emit);
/// Tables of guiding friction (docs/identify.md); `with_tables`: and the designers' tables
/// and plots.
IdentifyReport report_guiding(const std::vector<std::string>& files, bool with_tables);

}  // namespace sinew
