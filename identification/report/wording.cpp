// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/wording.h"

#include <fmt/format.h>

#include <algorithm>

#include "identification/diagnosis/confidence.h"
#include "identification/report/numbers.h"
#include "identification/report/verdict_text.h"

namespace sinew::diagnosis {
namespace {

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

/// Of a number without a unit: whether it is a part of something, as a change of a gain is of the
/// gain. Others are an exponent, a damping ratio.
bool is_share(const ParameterEstimate& parameter) {
  if (parameter.unit != "1") return false;
  const std::string& name = parameter.name;
  return name.starts_with("share") || name.ends_with("_change") || name.ends_with("_error") ||
         name.ends_with("_excess");
}

}  // namespace

std::string joined(const std::vector<std::string>& items, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " " + last + " " : ", ") + items[i];
  return text;
}

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

std::string cause_text(const NamedCause& cause) {
  const std::string place = place_of(cause);
  return place.empty() ? title_of(cause) : title_of(cause) + " (" + place + ")";
}

bool nothing_to_explain(const Findings& findings) {
  return !findings.channels.empty() &&
         std::all_of(findings.channels.begin(), findings.channels.end(),
                     [](const ChannelFinding& c) { return c.nothing_to_explain(); });
}

std::vector<ChannelErrors> channel_errors(const Findings& findings) {
  std::vector<ChannelErrors> list;
  if (findings.channels.size() < 2) return list;
  for (const ChannelFinding& c : findings.channels) {
    if (c.domains.empty()) continue;
    const DomainError& first = c.domains.front();
    list.push_back({c.name, shown_percent(c.relative(first.before)),
                    findings.verdict.causes.empty() ? "" : shown_percent(c.relative(first.after))});
  }
  return list;
}

bool has_held_out(const Findings& findings) {
  return std::any_of(findings.logs.begin(), findings.logs.end(),
                     [](const LogRecord& log) { return log.held_out; });
}

const Gain& gain_of(const Findings& findings, const NamedCause& cause) {
  return has_held_out(findings) ? cause.held_out : cause.cross_validated;
}

std::string gain_name(const Findings& findings, const NamedCause& cause) {
  if (!has_held_out(findings)) return "cross-validated gain";
  if (findings.verdict.causes.size() > 1) return "held-out gain beside the other causes";
  return cause.held_out.share == findings.verdict.held_out.share ? extension_gain_name(findings)
                                                                 : "held-out gain if corrected";
}

std::string extension_gain_name(const Findings& findings) {
  return has_held_out(findings) ? "held-out gain" : "gain on the training logs";
}

std::string judged_logs(const Findings& findings) {
  const auto count = std::count_if(findings.logs.begin(), findings.logs.end(),
                                   [](const LogRecord& log) { return log.held_out; });
  return count == 0 ? "the training logs" : count == 1 ? "the held-out log" : "the held-out logs";
}

std::string parameter_label(const NamedCause& cause, const ParameterEstimate& parameter) {
  if (parameter.name == "gain_change" && !cause.members.empty()) return cause.members.front().name;
  std::string label = parameter.name;
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

std::string shown_parameter(const ParameterEstimate& parameter) {
  return is_share(parameter)
             ? shown_estimate(100.0 * parameter.value, 100.0 * parameter.standard_error, "%")
             : shown_estimate(parameter.value, parameter.standard_error, parameter.unit);
}

std::string confidence_meaning() {
  return "The probability that the truth is this cause or, of a credible set, one of its members; "
         "from trials in which the truth was known and one of the library. It is " +
         shown_confidence(kHighestConfidence) +
         " at most: that is how often the surest sets of those trials held the truth.";
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

std::string extension_state(const Extension& extension) {
  if (!extension.adopted) return "The model was left as it is";
  return extension.dry_run ? "The model would be extended, but this was a dry run"
                           : "The model was extended";
}

std::vector<std::string> faults_of(const Findings& findings) {
  std::vector<std::string> faults;
  for (const LogRecord& log : findings.logs)
    faults.insert(faults.end(), log.faults.begin(), log.faults.end());
  return faults;
}

std::vector<std::string> notes_of(const Findings& findings) {
  std::vector<std::string> notes;
  for (const LogRecord& log : findings.logs)
    notes.insert(notes.end(), log.notes.begin(), log.notes.end());
  return notes;
}

std::string headline_of(const Findings& findings) {
  if (!findings.headline.empty()) return findings.headline;
  return findings.logs.empty() && findings.verdict.nothing_beyond_noise()
             ? "There was no log to look at."
             : headline(findings);
}

std::string leftover_of(const Verdict& verdict) {
  const Unexplained& rest = verdict.unexplained;
  std::vector<std::string> on;
  for (const Dependence& dependence : rest.depends_on) on.push_back(dependence_text(dependence));
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

std::string dependence_text(const Dependence& dependence) {
  std::string on = dependence.on;
  const std::string sign = " x ";
  for (std::size_t at = on.find(sign); at != std::string::npos; at = on.find(sign, at))
    on.replace(at, sign.size(), " × ");
  return dependence.place.empty() ? on : on + " (" + dependence.place + ")";
}

std::string sentence(std::string text) {
  if (!text.empty() && std::string(".!?").find(text.back()) == std::string::npos) text += '.';
  return text;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + "\u00a0" + (count == 1 ? one : many);
}

}  // namespace sinew::diagnosis
