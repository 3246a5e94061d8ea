// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/report_wording.h"

#include <fmt/format.h>

#include <algorithm>

#include "identification/report/report_numbers.h"
#include "identification/report/verdict_text.h"

namespace sinew::diagnosis {
namespace {

std::string joined(const std::vector<std::string>& items, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " " + last + " " : ", ") + items[i];
  return text;
}

std::vector<std::string> labels_of(const NamedCause& cause) {
  const bool one_name =
      std::all_of(cause.members.begin(), cause.members.end(),
                  [&](const RankedCause& m) { return m.name == cause.members.front().name; });
  const bool one_place = !place_of(cause).empty();
  std::vector<std::string> labels;
  for (const RankedCause& member : cause.members) {
    const std::string place = one_place || member.place.empty() ? "" : member.place;
    labels.push_back(one_name && cause.members.size() > 1 && !place.empty() ? place
                     : place.empty()                                        ? member.name
                                     : member.name + " (" + place + ")");
  }
  return labels;
}

}  // namespace

std::string place_of(const NamedCause& cause) {
  if (cause.members.empty()) return "";
  const std::string& place = cause.members.front().place;
  const bool same = std::all_of(cause.members.begin(), cause.members.end(),
                                [&](const RankedCause& m) { return m.place == place; });
  return same ? place : "";
}

std::string title_of(const NamedCause& cause) {
  if (cause.members.empty()) return "a cause without a name";
  const std::vector<std::string> labels = labels_of(cause);
  const std::string& name = cause.members.front().name;
  const bool places_only =
      cause.members.size() > 1 && labels.front() == cause.members.front().place;
  return places_only ? name + " (" + joined(labels, "or") + ")" : joined(labels, "or");
}

bool has_held_out(const Findings& findings) {
  return std::any_of(findings.logs.begin(), findings.logs.end(),
                     [](const LogRecord& log) { return log.held_out; });
}

const Gain& gain_of(const Findings& findings, const NamedCause& cause) {
  return has_held_out(findings) ? cause.held_out : cause.cross_validated;
}

std::string measured_on(const Findings& findings) {
  const auto count = std::count_if(findings.logs.begin(), findings.logs.end(),
                                   [](const LogRecord& log) { return log.held_out; });
  return count == 0 ? "left-out blocks" : count == 1 ? "the held-out log" : "the held-out logs";
}

std::string separation_of(const NamedCause& cause) {
  if (cause.members.size() < 2) return "";
  const std::vector<std::string> labels = labels_of(cause);
  const std::string set =
      "These logs cannot tell " +
      (labels.size() == 2 ? joined(labels, "from") + "." : joined(labels, "and") + " apart.");
  return cause.separation.experiment.empty()
             ? set
             : set + " To settle it: " + sentence(experiment_text(cause.separation));
}

std::vector<std::string> faults_of(const Findings& findings) {
  std::vector<std::string> faults;
  for (const LogRecord& log : findings.logs)
    faults.insert(faults.end(), log.faults.begin(), log.faults.end());
  return faults;
}

std::string headline_of(const Findings& findings) {
  if (!findings.headline.empty()) return findings.headline;
  const Verdict& verdict = findings.verdict;
  if (findings.logs.empty() && verdict.nothing_beyond_noise())
    return "There was no log to look at.";
  if (verdict.nothing_beyond_noise())
    return "The model explains these logs down to the noise; nothing is missing that they can "
           "show.";
  if (verdict.causes.empty() && !verdict.unexplained.none_of_the_known)
    return disagreement_text(findings);
  if (verdict.causes.empty())
    return "The model misses something, and it is none of the known causes.";
  std::vector<std::string> names;
  for (const NamedCause& cause : verdict.causes) names.push_back(title_of(cause));
  return "The model misses " + joined(names, "and") + ".";
}

std::string leftover_of(const Verdict& verdict) {
  const Unexplained& rest = verdict.unexplained;
  std::vector<std::string> on;
  for (const Dependence& dependence : rest.depends_on) {
    std::string text = shown_dependence(dependence.on);
    if (!dependence.place.empty()) text += " (" + dependence.place + ")";
    on.push_back(text);
  }
  if (on.empty() && rest.none_of_the_known)
    return "Structure that none of the known causes explains.";
  if (on.empty())
    return verdict.compared_below_hz > 0.0
               ? fmt::format(
                     "Nothing beyond noise below {:.2g} Hz; above, noise or too few samples of the "
                     "logged position would hide it.",
                     verdict.compared_below_hz)
               : "Nothing beyond noise.";
  const std::string what = joined(on, "and");
  return rest.none_of_the_known
             ? "Structure that none of the known causes explains. It depends on " + what + "."
             : "A smaller dependence on " + what + " that no known cause accounts for.";
}

std::string shown_dependence(std::string on) {
  const std::string sign = " x ";
  for (std::size_t at = on.find(sign); at != std::string::npos; at = on.find(sign, at))
    on.replace(at, sign.size(), " × ");
  return on;
}

std::string sentence(std::string text) {
  if (!text.empty() && std::string(".!?").find(text.back()) == std::string::npos) text += '.';
  return text;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + "\u00a0" + (count == 1 ? one : many);
}

}  // namespace sinew::diagnosis
