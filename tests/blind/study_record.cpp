// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/study_record.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/reference/record_line.h"

namespace sinew::blind {
namespace {

using Json = nlohmann::ordered_json;

bool is_hidden(const Outcome& outcome, const std::string& name) {
  return std::any_of(outcome.seal.hidden.begin(), outcome.seal.hidden.end(),
                     [&](const truth::HiddenCause& cause) { return cause.name == name; });
}

Json sets_of(const Outcome& outcome) {
  Json sets = Json::array();
  for (const diagnosis::NamedCause& cause : outcome.findings.verdict.causes) {
    Json members = Json::array();
    bool holds_truth = false;
    for (const auto& member : cause.members) {
      const std::string name = outcome.words(member.name, member.place);
      members.push_back(name);
      holds_truth = holds_truth || is_hidden(outcome, name);
    }
    sets.push_back(
        {{"members", members}, {"confidence", cause.confidence}, {"holds_truth", holds_truth}});
  }
  return sets;
}

}  // namespace

void record(const truth::TrialRequest& trial, const Outcome& outcome, const Outcome* played) {
  Json line{{"plant", trial.plant},
            {"family", truth::family_name(trial.family)},
            {"size", trial.size},
            {"seed", trial.seed},
            {"hidden", Json::array()},
            {"told", sets_of(outcome)},
            {"detected", outcome.detected},
            {"inside", outcome.all_inside},
            {"right", outcome.all_right},
            {"false_names", outcome.false_names},
            {"none_of_the_known", outcome.findings.verdict.unexplained.none_of_the_known},
            {"seconds", outcome.findings.seconds}};
  for (const truth::HiddenCause& cause : outcome.seal.hidden) line["hidden"].push_back(cause.name);
  if (played) {
    line["settled"] = played->is_settled();
    line["alone"] = played->is_settled() && played->members == 1;
  }
  reference::record_line(line.dump());
}

}  // namespace sinew::blind
