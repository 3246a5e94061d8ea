// SPDX-License-Identifier: GPL-3.0-or-later
// What a log was recorded with, as --condition tells it: a load whose mass is known.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace sinew {

/// A load at a link of a robot during a log.
struct CarriedPayload {
  std::string log;    ///< file, as given or without its folder; empty: every log
  std::string link;   ///< empty: the last one
  double mass = 0.0;  ///< kg
  std::optional<Eigen::Vector3d> centre;  ///< of mass, in the link's frame [m]; nothing: not known
};

/// "payload=2.805kg", "loaded.csv:payload=2.805 kg", "loaded.csv:payload@tool0=2805 g at 0, 0, 50
/// mm". Throws std::invalid_argument with what is expected.
CarriedPayload carried_payload(const std::string& text);

/// The load of a log file among those told; nullptr: none. Throws std::invalid_argument where two
/// are told of one log.
const CarriedPayload* payload_of(const std::vector<CarriedPayload>& told, const std::string& file);

/// Throws std::invalid_argument where a load is told of a log that is not among `files`.
void check_payloads(const std::vector<CarriedPayload>& told, const std::vector<std::string>& files);

}  // namespace sinew
