// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diagnose_rig.h"

#include <algorithm>
#include <fstream>

#include "identification/lever_subject.h"
#include "identification/wrist_subject.h"

namespace sinew {
namespace {

/// The header and the texts of --map, where channels are named.
std::string named_channels(const std::string& file, const std::vector<std::string>& map) {
  std::ifstream in(file, std::ios::binary);
  std::string names, line;
  while (std::getline(in, line) && (line.empty() || line.front() == '#')) {
  }
  names = line;
  for (const std::string& text : map) names += "," + text;
  return names;
}

bool everywhere(const std::string& channel, const std::vector<std::string>& headers) {
  return std::all_of(headers.begin(), headers.end(), [&](const std::string& names) {
    return names.find(channel) != std::string::npos;
  });
}

/// The tendons whose motors every log has, from 1.
std::vector<int> logged_tendons(std::size_t count, const std::vector<std::string>& headers) {
  std::vector<int> tendons;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::string name = "theta_" + std::to_string(i);
    if (everywhere(name + " ", headers) || everywhere(name + "[", headers) ||
        everywhere(name + "=", headers))
      tendons.push_back(static_cast<int>(i));
  }
  return tendons;
}

}  // namespace

std::optional<diagnosis::ObservedRequest> rig_request(const ModelFolder& folder,
                                                      const std::vector<std::string>& logs,
                                                      const std::vector<std::string>& holdout,
                                                      const std::vector<std::string>& map) {
  const Part* part = std::get_if<Part>(&folder.model);
  if (!part) return std::nullopt;
  std::vector<std::string> headers;
  for (const auto* files : {&logs, &holdout})
    for (const std::string& file : *files) headers.push_back(named_channels(file, map));
  diagnosis::ObservedRequest request;
  const bool elongation = everywhere("elongation", headers);
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
    request.rig = diagnosis::wrist_rig(*wrist, part->name,
                                       logged_tendons(wrist->palm_points.size(), headers));
  } else {
    return std::nullopt;
  }
  return request;
}

}  // namespace sinew
