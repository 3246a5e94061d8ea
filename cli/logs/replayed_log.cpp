// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/logs/replayed_log.h"

#include "cli/logs/diagnose_rig.h"
#include "cli/logs/driven_request.h"
#include "identification/logs/model_channels.h"
#include "identification/logs/read_csv.h"

namespace sinew {

ReplayedLog replayed_log(const std::filesystem::path& model, const std::string& log,
                         const std::vector<std::string>& map) {
  ReadOptions options;
  options.map = mapped_channels(model, map);
  options.max_values = diagnosis_values(1);
  diagnosis::DiagnoseRequest request;
  request.logs = {log};
  request.map = options.map;
  const ModelFolder folder = open_model_folder(model);
  request.identified = folder.identified;
  request.torque_constants = torque_constants(model, {});
  std::vector<HeldJoint> held = set_driven_model(folder, request);
  ReplayedLog result{request.channels(log), {}, request.notes};
  diagnosis::set_torque_constants(request.torque_constants, result.channels);
  // What no constant is known of cannot drive the model.
  for (ChannelSpec& spec : result.channels.specs) spec.keep_ampere = false;
  options.max_rate = result.channels.forces.empty() ? kDiagnosisRate : kTendonRate;
  result.replay = diagnosis::replay_of(read_csv(log, result.channels.specs, options),
                                       result.channels, request.model);
  result.replay.scenario.held = std::move(held);
  return result;
}

std::optional<diagnosis::ObservedReplay> replayed_rig(const std::filesystem::path& model,
                                                      const std::string& log,
                                                      const std::vector<std::string>& map,
                                                      const std::filesystem::path& runtime) {
  const ModelFolder folder = open_model_folder(model);
  const std::vector<std::string> mapped = mapped_channels(model, map);
  auto request = rig_request(folder, {log}, {}, mapped);
  if (!request) return std::nullopt;
  request->name = folder.identity.name;
  request->identified = folder.identified;
  request->runtime = runtime;
  request->logs = {log};
  request->map = mapped;
  request->settings.edge_s = diagnosis::driven_edge;
  request->settings.band_hz = diagnosis::driven_band;
  return diagnosis::replay_observed(*request);
}

}  // namespace sinew
