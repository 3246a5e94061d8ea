// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/import.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/models/plausibility.h"
#include "cli/terminal/terminal.h"
#include "generator/outputs/outputs.h"
#include "generator/outputs/unfinished_run.h"
#include "symbolic/files/readable.h"
#include "symbolic/model/read_urdf.h"
#include "symbolic/model/write_mechanism.h"

namespace sinew {
namespace {

struct ImportOptions {
  std::string urdf;
  std::string out;
  std::vector<double> gravity{0.0, 0.0, -9.81};
  bool force = false;
  bool strict = false;
  bool json = false;
};

/// What is told besides mistakes.
struct Told {
  std::vector<std::string> notes, warnings;
};

/// Joints that move by themselves, and those that follow them.
struct Movers {
  std::vector<std::string> coordinates, followers;
};

Movers movers_of(const Mechanism& mechanism) {
  Movers movers;
  for (const Joint& joint : mechanism.joints) {
    if (joint.type == JointType::fixed) continue;
    const bool follows = std::any_of(
        mechanism.couplings.begin(), mechanism.couplings.end(),
        [&](const JointCoupling& coupling) { return coupling.dependent == joint.name; });
    (follows ? movers.followers : movers.coordinates).push_back(joint.name);
  }
  return movers;
}

void report_as_text(const Mechanism& mechanism, const ImportOptions& options, const Told& told) {
  for (const std::string& note : told.notes) warn("note: {}\n", note);
  for (const std::string& warning : told.warnings) warn("warning: {}\n", warning);
  tell("{}: robot '{}' with {} bodies, {} moving joints:", options.out, mechanism.name,
       mechanism.bodies.size(), coordinate_count(mechanism));
  const Movers movers = movers_of(mechanism);
  for (const std::string& name : movers.coordinates) tell(" {}", name);
  if (!movers.followers.empty()) tell("; and following them: {}", listed(movers.followers));
  tell("\nnext: sinew generate {}\n", options.out);
}

void report_as_json(const Mechanism& mechanism, const ImportOptions& options, const Told& told) {
  nlohmann::ordered_json report{{"model", options.out}, {"name", mechanism.name}};
  report["bodies"] = nlohmann::json::array();
  for (const Body& body : mechanism.bodies) report["bodies"].push_back(body.name);
  const Movers movers = movers_of(mechanism);
  report["coordinates"] = movers.coordinates;
  report["followers"] = movers.followers;
  report["notes"] = told.notes;
  report["warnings"] = told.warnings;
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

/// Names of a robot that was here before must not stay.
std::map<std::string, std::string> files_of(const Mechanism& mechanism,
                                            const std::filesystem::path& folder) {
  const std::string comment = "Imported from URDF with sinew import.";
  std::map<std::string, std::string> files = mechanism_files(mechanism, comment);
  if (std::filesystem::exists(folder / "names.toml"))
    files.emplace("names.toml", "# " + comment + " Every name is the source's own.\n");
  return files;
}

int import_robot(const ImportOptions& options) {
  const Eigen::Vector3d gravity(options.gravity.data());
  if (!gravity.allFinite()) {
    warn("sinew import: --gravity is not finite; expected 3 finite numbers\n");
    return 2;
  }
  Told told;
  const std::filesystem::path source(options.urdf);
  Outputs outputs = outputs_for(options);
  const Mechanism mechanism = read_urdf(source, gravity, &told.notes, &told.warnings);
  for (std::string& each : plausibility_warnings(mechanism))
    told.warnings.push_back(std::move(each));
  refuse_if_strict(told.warnings, options.strict);
  outputs.into_folder(options.out, files_of(mechanism, options.out));
  outputs.commit();
  options.json ? report_as_json(mechanism, options, told)
               : report_as_text(mechanism, options, told);
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
  command->add_flag("--strict", options->strict,
                    "What is possible but not plausible (units, signs) is a mistake");
  command->add_flag("--json", options->json, "Report as JSON");
  command->callback([options, &exit_status] { exit_status = import_robot(*options); });
}

}  // namespace sinew
