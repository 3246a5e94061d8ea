// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/replayed_log.h"

#include "cli/driven_request.h"
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
  std::vector<HeldJoint> held = set_driven_model(folder, request);
  ReplayedLog result{request.channels(log), {}, request.notes};
  options.max_rate = result.channels.forces.empty() ? kDiagnosisRate : kTendonRate;
  result.replay = diagnosis::replay_of(read_csv(log, result.channels.specs, options),
                                       result.channels, request.model);
  result.replay.scenario.held = std::move(held);
  return result;
}

}  // namespace sinew
