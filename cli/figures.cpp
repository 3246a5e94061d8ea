// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figures.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/source_figures.h"
#include "symbolic/part.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string out = "figures", models = "models", generated = "generated", runtime = "runtime";
};

WristParameters wrist_parameters(const fs::path& folder) {
  const Part part = read_part(folder);
  if (const auto* wrist = std::get_if<WristParameters>(&part.parameters)) return *wrist;
  throw std::runtime_error((folder / "part.toml").string() + ": describes no wrist");
}

void run_figures(const Options& o) {
  const auto compiled = [&](const char* model) {
    return CompiledModel(fs::path(o.generated) / model, o.runtime);
  };
  std::vector<Figure> figures{figure_coriolis(compiled("index"))};
  for (const Figure& figure : figures_link_position(compiled("thumb"))) figures.push_back(figure);
  for (const Figure& figure :
       figures_wrist(compiled("wrist"), wrist_parameters(fs::path(o.models) / "wrist")))
    figures.push_back(figure);
  fs::create_directories(o.out);
  for (const Figure& figure : figures) write_figure(o.out, figure);
  write_index(o.out, figures);
  fmt::print("{} figures written to {}\n", figures.size(), o.out);
}

}  // namespace

void add_figures_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("figures", "Reproduce the source's figures");
  auto options = std::make_shared<Options>();
  command->add_option("--out", options->out, "Folder of the figures (default: figures)");
  command->add_option("--models", options->models, "Folder of the model folders");
  command->add_option("--generated", options->generated, "Folder of the emitted C");
  command->add_option("--runtime", options->runtime, "Folder of the runtime's headers");
  command->callback([options] { run_figures(*options); });
}

}  // namespace sinew
