// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/import.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/terminal/terminal.h"
#include "generator/outputs/outputs.h"
#include "generator/outputs/unfinished_run.h"
#include "symbolic/model/read_urdf.h"
#include "symbolic/model/write_mechanism.h"

namespace sinew {
namespace {

struct ImportOptions {
  std::string urdf;
  std::string out;
  std::vector<double> gravity{0.0, 0.0, -9.81};
  bool force = false;
  bool json = false;
};

void report_as_text(const Mechanism& mechanism, const ImportOptions& options,
                    const std::vector<std::string>& notes) {
  for (const std::string& note : notes) warn("note: {}\n", note);
  tell("{}: robot '{}' with {} bodies, {} moving joints:", options.out, mechanism.name,
       mechanism.bodies.size(), coordinate_count(mechanism));
  for (const Joint& joint : mechanism.joints)
    if (joint.type != JointType::fixed) tell(" {}", joint.name);
  tell("\nnext: sinew generate {}\n", options.out);
}

void report_as_json(const Mechanism& mechanism, const ImportOptions& options,
                    const std::vector<std::string>& notes) {
  nlohmann::ordered_json report{{"model", options.out}, {"name", mechanism.name}};
  report["bodies"] = nlohmann::json::array();
  report["coordinates"] = nlohmann::json::array();
  for (const Body& body : mechanism.bodies) report["bodies"].push_back(body.name);
  for (const Joint& joint : mechanism.joints)
    if (joint.type != JointType::fixed) report["coordinates"].push_back(joint.name);
  report["notes"] = notes;
  tell_json(report);
}

/// Ready to take the model's folder. Throws std::runtime_error where that is in use.
Outputs outputs_for(const ImportOptions& options) {
  const std::filesystem::path folder = output_folder(options.out);
  recover_interrupted(folder);
  std::error_code ignored;
  if (!options.force && std::filesystem::exists(folder) &&
      !std::filesystem::is_empty(folder, ignored))
    throw std::runtime_error(options.out +
                             ": is not empty; expected an empty or new folder, or --force");
  Inputs inputs;
  inputs.add(options.urdf);
  Outputs outputs;
  outputs.protect(std::move(inputs));
  return outputs;
}

int import_robot(const ImportOptions& options) {
  const Eigen::Vector3d gravity(options.gravity.data());
  if (!gravity.allFinite()) {
    warn("sinew import: --gravity is not finite; expected 3 finite numbers\n");
    return 2;
  }
  std::vector<std::string> notes;
  const std::filesystem::path source(options.urdf);
  Outputs outputs = outputs_for(options);
  const Mechanism mechanism = read_urdf(source, gravity, &notes);
  outputs.into_folder(options.out,
                      mechanism_files(mechanism, "Imported from URDF with sinew import."));
  outputs.commit();
  options.json ? report_as_json(mechanism, options, notes)
               : report_as_text(mechanism, options, notes);
  return 0;
}

}  // namespace

void add_import_command(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command = app.add_subcommand("import", "Make a model folder from a URDF file");
  command->add_option("urdf", options->urdf, "The robot's URDF file")->required();
  command->add_option("--out", options->out, "The model folder to write, models/<name>")
      ->required();
  command
      ->add_option("--gravity", options->gravity,
                   "Gravity in the root link's frame, m/s^2 (0 0 -9.81)")
      ->expected(3);
  command->add_flag("--force", options->force,
                    "Replace the description in a folder that holds something");
  command->add_flag("--json", options->json, "Report as JSON");
  command->callback([options, &exit_status] { exit_status = import_robot(*options); });
}

}  // namespace sinew
