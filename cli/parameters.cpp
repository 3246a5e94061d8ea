// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parameters.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/hand/hand_table.h"
#include "cli/models/model_folder.h"
#include "cli/terminal/report_stream.h"
#include "cli/terminal/terminal.h"
#include "simulation/plant/learnt_model.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

struct ParametersOptions {
  std::string model, out;
  bool json = false;
};

TendonWithLever tendon_beside(const fs::path& model) {
  const fs::path folder = folder_of_motor(model).parent_path() / "tendon";
  if (is_part_folder(folder)) {
    const Part part = read_part(folder);
    if (const auto* tendon = std::get_if<TendonWithLever>(&part.parameters)) return *tendon;
  }
  throw std::runtime_error(fmt::format("{}: not found; expected the tendon of {} there",
                                       folder.string(), model.string()));
}

void run_parameters(const ParametersOptions& o) {
  refuse_two_reports(o.out, o.json);
  const ModelFolder folder = open_model_folder(o.model);
  const Hand* hand = std::get_if<Hand>(&folder.model);
  if (!hand) throw std::runtime_error(o.model + ": is no hand; expected a folder with a hand.toml");
  const auto motor = motor_beside(o.model);
  if (!motor)
    throw std::runtime_error(fmt::format("{}: not found; expected the motor of {} there",
                                         folder_of_motor(o.model).string(), o.model));
  const TendonWithLever tendon = tendon_beside(o.model);
  const StepSettings settings = read_step_settings(o.model);
  const HandTable table = hand_table({*hand, tendon, *motor, settings});
  Inputs inputs;
  add_model(inputs, o.model);
  for (const fs::path& file : {fs::path(o.model) / "real_time.toml",
                               folder_of_motor(o.model).parent_path() / "tendon" / "part.toml"})
    inputs.add(file);
  Outputs outputs;
  outputs.protect(inputs);
  outputs.file(o.out, hand_table_text(table.parameters,
                                      fmt::format(" * Made by: sinew parameters models/{}\n"
                                                  " * Model:   sha256 {}\n",
                                                  hand->name, folder.identity.hash)));
  outputs.commit();
  if (o.json)
    return tell_json({{"model", o.model},
                      {"out", o.out},
                      {"checksum", table.parameters.checksum},
                      {"bytes", sizeof(hand_parameters)},
                      {"largest_force_error_N", table.force_error},
                      {"largest_elongation_error_m", table.elongation_error},
                      {"largest_stiffness_error_N_per_m", table.stiffness_error}});
  print_to(
      stream_of_report(o.out),
      "{}: table of {} bytes written to {}, checksum {:08x}\n  the lever's polynomials are off "
      "by at most {:.2g} N, {:.2g} m, {:.2g} N/m\n",
      o.model, sizeof(hand_parameters), o.out, table.parameters.checksum, table.force_error,
      table.elongation_error, table.stiffness_error);
}

}  // namespace

void add_parameters_command(CLI::App& app, int&) {
  CLI::App* command =
      app.add_subcommand("parameters", "The constants of a hand's real-time step, as C");
  auto options = std::make_shared<ParametersOptions>();
  command->add_option("model", options->model, "Folder of a hand, with its real_time.toml")
      ->required();
  command->add_option("--out", options->out, "C file of the table; - is standard output")
      ->required();
  command->add_flag("--json", options->json, "Report for machines");
  command->callback([options] { run_parameters(*options); });
}

}  // namespace sinew
