// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diagnose_fleet.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/terminal/terminal.h"
#include "identification/adoption/fleet.h"

namespace sinew {

int run_summarise(const diagnosis::DiagnoseRequest& request, const std::string& out,
                  const Inputs& inputs, bool json) {
  check_output_file(out, inputs);
  const diagnosis::SumsFile file = diagnosis::summarise(request, SINEW_VERSION);
  std::string bytes = diagnosis::sums_bytes(file);
  const std::size_t size = bytes.size();
  const Eigen::Index columns = file.sums.columns.target.size();
  Outputs outputs;
  outputs.protect(inputs);
  outputs.file(out, std::move(bytes));
  outputs.commit();
  if (is_standard_output(out)) return 0;
  if (json) {
    const nlohmann::ordered_json said{
        {"sums", out},        {"log", file.origin.log}, {"log_sha256", file.origin.log_hash},
        {"columns", columns}, {"bytes", size},          {"faults", file.origin.faults}};
    tell("{}\n", said.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return 0;
  }
  tell("{}: sums of {} columns over {:.3g} s, {:.2f} MB\n", out, columns, file.origin.log_seconds,
       1e-6 * static_cast<double>(size));
  for (const std::string& fault : file.origin.faults) tell("  {}\n", fault);
  return 0;
}

int run_sums(const diagnosis::DiagnoseRequest& request, const std::vector<std::string>& training,
             const std::vector<std::string>& held_out, bool json) {
  const diagnosis::FleetFindings findings =
      diagnosis::diagnose_sums(request, SINEW_VERSION, {training, held_out});
  tell("{}", json ? fleet_json(findings) : fleet_text(findings));
  return findings.verdict.nothing_beyond_noise() ? 0 : 1;
}

}  // namespace sinew
