// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/logs/diagnose_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "identification/logs/channel_map.h"
#include "identification/logs/csv_rows.h"
#include "identification/subjects/lever_subject.h"
#include "identification/subjects/wrist_subject.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

constexpr std::size_t kMostMotors = 99;

using Headers = std::vector<std::vector<std::string>>;

/// Whether every log names the channel.
bool everywhere(const std::string& channel, const Headers& headers,
                const std::vector<std::string>& map) {
  return std::all_of(headers.begin(), headers.end(),
                     [&](const auto& header) { return names_channel(header, map, channel); });
}

/// The tendons whose motors every log has, from 1.
std::vector<int> logged_tendons(std::size_t count, const Headers& headers,
                                const std::vector<std::string>& map) {
  std::vector<int> tendons;
  for (std::size_t i = 1; i <= count; ++i) {
    if (everywhere("theta_" + std::to_string(i), headers, map))
      tendons.push_back(static_cast<int>(i));
  }
  return tendons;
}

/// Throws std::invalid_argument naming a log without any motor's angle, or all of them where they
/// have none in common.
void require_motors(const std::vector<int>& tendons, const std::vector<std::string>& files,
                    const Headers& headers, const std::vector<std::string>& map) {
  if (!tendons.empty()) return;
  constexpr const char* wanted = "the angle of at least one motor, theta_1 [rad] ...";
  for (std::size_t f = 0; f < files.size(); ++f)
    if (logged_tendons(kMostMotors, {headers[f]}, map).empty())
      throw std::invalid_argument(fmt::format(
          "{}:1: a wrist's log needs {}; the header has: {}. --map theta_1=name says which it is",
          files[f], wanted, listed(headers[f])));
  throw std::invalid_argument(fmt::format("the logs have no motor in common: all need {}", wanted));
}

}  // namespace

std::optional<diagnosis::ObservedRequest> rig_request(const ModelFolder& folder,
                                                      const std::vector<std::string>& logs,
                                                      const std::vector<std::string>& holdout,
                                                      const std::vector<std::string>& map) {
  const Part* part = std::get_if<Part>(&folder.model);
  if (!part) return std::nullopt;
  std::vector<std::string> files = logs;
  files.insert(files.end(), holdout.begin(), holdout.end());
  Headers headers;
  for (const std::string& file : files) headers.push_back(CsvReader(file).dialect().header);
  diagnosis::ObservedRequest request;
  const bool elongation = everywhere("elongation", headers, map);
  if (const auto* lever = std::get_if<LeverParameters>(&part->parameters)) {
    request.kind = "lever";
    request.rig = diagnosis::lever_rig({*lever, 0.0}, part->name, elongation);
  } else if (const auto* tendon = std::get_if<TendonWithLever>(&part->parameters)) {
    request.kind = "tendon";
    request.rig = diagnosis::lever_rig(
        {tendon->lever, tendon->tendon.free_length / tendon->tendon.axial_stiffness}, part->name,
        elongation);
  } else if (const auto* wrist = std::get_if<WristParameters>(&part->parameters)) {
    request.kind = "wrist";
    const std::vector<int> tendons = logged_tendons(wrist->palm_points.size(), headers, map);
    require_motors(tendons, files, headers, map);
    request.rig = diagnosis::wrist_rig(*wrist, part->name, tendons);
  } else {
    return std::nullopt;
  }
  return request;
}

}  // namespace sinew
