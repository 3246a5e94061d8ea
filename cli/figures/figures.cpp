// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figures/figures.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/figures/guiding.h"
#include "cli/figures/lever.h"
#include "cli/figures/motor.h"
#include "cli/figures/source_figures.h"
#include "cli/terminal/terminal.h"
#include "generator/outputs/unfinished_run.h"
#include "symbolic/parts/part.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

struct FiguresOptions {
  std::string out = "figures", models = "models", generated = "generated", runtime = "runtime";
  std::vector<int> chapters;  ///< none: all
};

template <typename Parameters>
Parameters parameters_of(const FiguresOptions& o, const char* model) {
  const fs::path folder = fs::path(o.models) / model;
  const Part part = read_part(folder);
  if (const auto* found = std::get_if<Parameters>(&part.parameters)) return *found;
  throw std::runtime_error((folder / "part.toml").string() + ": describes no " + model);
}

std::vector<Figure> figures_guiding(const FiguresOptions& o) {
  std::vector<FittedSeries> all;
  for (GuidingSeries& s :
       read_guiding_table(fs::path(o.models) / "guiding" / "assumed_measurements.csv")) {
    GuidingFit fit = fit_guiding(s);
    all.push_back({std::move(s), std::move(fit)});
  }
  const std::string origin =
      "Assumed measurements (models/guiding/assumed_measurements.csv): the source prints curves "
      "but no numbers. Measure, and run sinew identify --experiment guiding on your own table.";
  std::vector<Figure> figures{figure_guiding_friction(all, usual_tension(all), origin),
                              figure_pulley_or_sliding(all, origin)};
  for (Figure& figure : figures) figure.title += " (assumed measurements)";
  return figures;
}

std::vector<Figure> figures_of(const FiguresOptions& o, int chapter) {
  const auto compiled = [&](const char* model) {
    return CompiledModel(fs::path(o.generated) / model, o.runtime);
  };
  std::vector<Figure> figures;
  const auto add = [&](const std::vector<Figure>& more) {
    figures.insert(figures.end(), more.begin(), more.end());
  };
  if (chapter == 3) add(figures_motor(fs::path(o.models) / "motor", compiled("motor"), o.runtime));
  if (chapter == 4) {
    const CompiledModel lever = compiled("lever");
    add({figure_lever(lever, parameters_of<LeverParameters>(o, "lever")),
         figure_lever_calibration(lever, parameters_of<TendonWithLever>(o, "tendon"))});
    add(figures_guiding(o));
  }
  if (chapter == 5) {
    add({figure_coriolis(compiled("index"))});
    add(figures_link_position(compiled("thumb")));
  }
  if (chapter == 6)
    add(figures_wrist(compiled("wrist"), parameters_of<WristParameters>(o, "wrist")));
  return figures;
}

/// What is read, after recovery of what an interrupted run left there.
Inputs inputs_of(const FiguresOptions& o) {
  Inputs inputs;
  for (const std::string& folder : {o.models, o.generated, o.runtime}) {
    recover_interrupted(folder);
    std::error_code ignored;
    for (const fs::directory_entry& model : fs::directory_iterator(folder, ignored)) {
      inputs.add(model.path());
      if (!model.is_directory(ignored)) continue;
      recover_interrupted(model.path());
      for (const fs::directory_entry& file :
           fs::recursive_directory_iterator(model.path(), ignored))
        inputs.add(file.path());
    }
  }
  return inputs;
}

void run_figures(const FiguresOptions& o) {
  (void)output_folder(o.out);
  const Inputs inputs = inputs_of(o);
  std::vector<Figure> figures;
  for (const int chapter : {3, 4, 5, 6})
    if (o.chapters.empty() ||
        std::find(o.chapters.begin(), o.chapters.end(), chapter) != o.chapters.end())
      for (Figure& figure : figures_of(o, chapter)) figures.push_back(std::move(figure));
  FileSet files{{"index.html", gallery_page(figures)}};
  for (const Figure& figure : figures) files.merge(figure_files(figure));
  Outputs outputs;
  outputs.protect(inputs);
  outputs.into_folder(o.out, files);
  outputs.commit();
  tell("{0} figures written to {1}; all on one page: {1}/index.html\n", figures.size(), o.out);
}

}  // namespace

void add_figures_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("figures", "Reproduce the source's figures");
  auto options = std::make_shared<FiguresOptions>();
  command->add_option("--out", options->out, "Folder of the figures (default: figures)");
  command->add_option("--chapter", options->chapters, "3, 4, 5, 6: of these chapters only")
      ->check(CLI::Range(3, 6));
  command->add_option("--models", options->models, "Folder of the model folders");
  command->add_option("--generated", options->generated, "Folder of the emitted C");
  command->add_option("--runtime", options->runtime, "Folder of the runtime's headers");
  command->callback([options] { run_figures(*options); });
}

}  // namespace sinew
