// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/simulate_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/model_report_of.h"

namespace sinew {
namespace {

ModelReport drawn_model(const std::filesystem::path& path) {
  const ModelFolder folder = open_model_folder(path);
  EmittedModel unnamed;
  unnamed.name = folder.identity.name;
  unnamed.description = folder.identity.description;
  unnamed.hash = folder.identity.hash;
  return model_report_of(folder, unnamed);
}

constexpr const char* slack_prefix = "slack_";

}  // namespace

RunRecorder::RunRecorder(const std::filesystem::path& model, const std::string& what,
                         const Plant& plant)
    : report_{drawn_model(model),
              what,
              plant.scenario().duration,
              RecordedRun(output_columns(plant), plant.scenario().duration),
              RecordedBooks(plant.scenario().duration),
              {},
              {},
              false,
              {}} {
  for (int i = 0; i < power_count; ++i) report_.powers.emplace_back(name_of_power(i));
  for (const std::string& name : plant.event_names())
    report_.knows_slack = report_.knows_slack || name.rfind(slack_prefix, 0) == 0;
}

void RunRecorder::take_slack(const SimulationResult& result) {
  std::map<std::string, double> open;
  for (const Event& event : result.events) {
    if (event.name.rfind(slack_prefix, 0) != 0) continue;
    const std::string tendon = "tendon " + event.name.substr(std::string(slack_prefix).size());
    if (event.begins) {
      open[tendon] = event.time;
      continue;
    }
    // One that is slack from the start on has no beginning.
    const auto began = open.find(tendon);
    report_.slack.push_back({tendon, began == open.end() ? 0.0 : began->second, event.time});
    if (began != open.end()) open.erase(began);
  }
  for (const auto& [tendon, from] : open) report_.slack.push_back({tendon, from, report_.duration});
}

std::string RunRecorder::html(const SimulationResult& result) {
  take_slack(result);
  report_.facts = {{"Steps of the integrator", std::to_string(result.count.steps)},
                   {"Rows of the log", std::to_string(result.rows)}};
  std::map<std::string, long> kinds;
  for (const auto& [name, count] : result.event_counts)
    kinds[name.substr(0, name.rfind('_'))] += count;
  for (const auto& [kind, title] : {std::pair("slack", "A tendon went slack"),
                                    std::pair("tendon_sticks", "A tendon stuck in its guide"),
                                    std::pair("motor_sticks", "A motor stood still")})
    if (kinds.count(kind))
      report_.facts.emplace_back(title, fmt::format("{} times in all", kinds[kind]));
  return run_page(report_);
}

}  // namespace sinew
