// SPDX-License-Identifier: GPL-3.0-or-later
// A scenario given as text, run on a model of the source tree.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "simulation/plant/simulate.h"
#include "tests/reference/temporary_folder.h"

namespace sinew_tests {

inline const std::string source = SINEW_SOURCE_DIR;

/// `[scenario]` with duration and rate, then `rest`.
inline std::string scenario_text(double duration, double rate, const std::string& rest) {
  return "[scenario]\nduration = { value = " + std::to_string(duration) +
         ", unit = \"s\" }\noutput_rate = { value = " + std::to_string(rate) +
         ", unit = \"Hz\" }\n" + rest;
}

struct Run {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  sinew::SimulationResult result;

  std::size_t column(const std::string& name) const {
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].substr(0, columns[i].find(" [")) == name) return i;
    throw std::runtime_error("no column " + name);
  }
  double at(std::size_t row, const std::string& name) const { return rows[row][column(name)]; }
};

inline sinew::Plant plant_of(const std::string& model, const std::string& scenario) {
  const sinew::reference::TemporaryFolder folder;
  const auto file = folder.path() / "scenario.toml";
  sinew::reference::write_text(file, scenario);
  return sinew::build_plant(source + "/models/" + model, file, source + "/runtime");
}

inline Run run(sinew::Plant& plant) {
  Run run;
  run.columns = sinew::output_columns(plant);
  run.result =
      sinew::simulate(plant, [&](const std::vector<double>& row) { run.rows.push_back(row); });
  return run;
}

inline Run run(const std::string& model, const std::string& scenario) {
  sinew::Plant plant = plant_of(model, scenario);
  return run(plant);
}

}  // namespace sinew_tests
