// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/import.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

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
  for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);
  fmt::print("{}: robot '{}' with {} bodies, {} moving joints:", options.out, mechanism.name,
             mechanism.bodies.size(), coordinate_count(mechanism));
  for (const Joint& joint : mechanism.joints)
    if (joint.type != JointType::fixed) fmt::print(" {}", joint.name);
  fmt::print("\nnext: sinew generate {}\n", options.out);
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
  const auto replace = nlohmann::json::error_handler_t::replace;  // names may be any bytes
  fmt::print("{}\n", report.dump(2, ' ', false, replace));
}

int import_robot(const ImportOptions& options) {
  const Eigen::Vector3d gravity(options.gravity.data());
  if (!gravity.allFinite()) {
    fmt::print(stderr, "sinew import: --gravity is not finite; expected 3 finite numbers\n");
    return 2;
  }
  std::vector<std::string> notes;
  const std::filesystem::path source(options.urdf);
  const Mechanism mechanism = read_urdf(source, gravity, &notes);
  write_mechanism(mechanism, options.out, "Imported from URDF with sinew import.",
                  options.force ? Existing::replace : Existing::refuse);
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
