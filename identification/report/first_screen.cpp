// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/report/numbers.h"
#include "identification/report/page.h"
#include "identification/report/sections.h"
#include "identification/report/verdict_text.h"
#include "identification/report/wording.h"

namespace sinew::diagnosis {
namespace {

std::string kicker(const Findings& findings) {
  std::string text = "Diagnosis of <b>" + escaped_name(findings.model) + "</b>";
  if (!findings.description.empty()) text += " (" + escaped(findings.description) + ")";
  if (!findings.kind.empty()) text += " · " + escaped(findings.kind);
  text += " · " + counted(findings.logs.size(), "log", "logs");
  if (has_held_out(findings)) text += ", judged on " + escaped(judged_logs(findings));
  return "<p class=\"kicker\">" + text + "</p>\n";
}

/// Long headlines in smaller letters.
std::string h1_of(const std::string& headline) {
  return (headline.size() > 150 ? "<h1 class=\"long\">" : "<h1>") + escaped(headline);
}

/// The gain of all causes; a lone one's stands with it alone.
std::string gain_sentence(const Findings& findings) {
  const Verdict& v = findings.verdict;
  if (v.causes.empty()) return "";
  if (!has_held_out(findings))
    return "<p>No log was held out: these are errors on the logs that were learnt from.</p>";
  const bool extended = std::any_of(v.causes.begin(), v.causes.end(), [&](const NamedCause& c) {
    return gain_name(findings, c) != "held-out gain if corrected";
  });
  if (!extended) return "<p>The model has no term for this cause: its error stays.</p>";
  if (v.causes.size() == 1 || !std::isfinite(v.held_out.share)) return "";
  return fmt::format(
      "<p>Held-out gain of all causes together: the squared error <b>{} by {}</b> "
      "<span class=\"soft\">(95&nbsp;% interval {})</span>.</p>",
      v.held_out.share < 0.0 ? "rises" : "falls", shown_share(std::abs(v.held_out.share)),
      shown_interval(v.held_out));
}

/// Every channel's own error, where there are several.
std::string channel_table(const Findings& findings) {
  const std::vector<ChannelErrors> all = channel_errors(findings);
  if (all.empty()) return "";
  const bool changed = !all.front().after.empty();
  std::vector<std::string> headings{"Channel", changed ? "#Before" : "#Relative error"};
  if (changed) headings.push_back("#After");
  Table table(headings, "", true);
  for (const ChannelErrors& c : all) {
    std::vector<std::string> cells{escaped_name(c.channel),
                                   "<span class=\"before\">" + c.before + "</span>"};
    if (changed) cells.push_back("<span class=\"after\">" + c.after + "</span>");
    table.row(cells);
  }
  return table.html();
}

std::string error_card(const Findings& findings) {
  const Verdict& v = findings.verdict;
  if (!std::isfinite(v.relative_error_before) || findings.logs.empty()) return "";
  if (nothing_to_explain(findings))
    return "<div class=\"card\"><span class=\"label\">Error on " + judged_logs(findings) +
           "</span>\n<p>Nothing to explain: no channel's error is worth a cause.</p></div>\n";
  const bool named = !v.causes.empty() && std::isfinite(v.relative_error_after);
  const double most = named ? std::max(v.relative_error_before, v.relative_error_after)
                            : std::max(v.relative_error_before, 1e-12);
  std::string text =
      "<div class=\"card\"><span class=\"label\">Error on " + judged_logs(findings) +
      ", rms, relative to the standard deviation of what was measured</span>\n<p class=\"change\">";
  text += fmt::format("<span class=\"before\">{}</span>", shown_percent(v.relative_error_before));
  if (named)
    text += fmt::format(
        "<span class=\"arrow\" aria-label=\"to\"> → </span><span class=\"after\">{}"
        "</span>",
        shown_percent(v.relative_error_after));
  text += "</p>\n" + bar(v.relative_error_before / (named ? most : 1.0), "before");
  if (named) text += bar(v.relative_error_after / most, "after");
  if (named)
    text +=
        "<p class=\"small soft\"><span class=\"before\">Orange</span>: the model as it was. "
        "<span class=\"after\">Blue</span>: extended by the causes below.</p>\n";
  return text + gain_sentence(findings) + channel_table(findings) + "</div>\n";
}

std::string next_card(const Findings& findings) {
  const Extension& e = findings.extension;
  if (findings.next_step.empty() && e.reason.empty()) return "";
  const std::string todo =
      findings.next_step.empty() ? extension_state(e) + ": " + e.reason : findings.next_step;
  return "<div class=\"card next\"><h2 class=\"label\" style=\"border:0;padding:0\">What to do "
         "next</h2><p>" +
         escaped(sentence(todo)) + "</p></div>\n";
}

std::string fault_note(const Findings& findings) {
  const std::vector<std::string> faults = faults_of(findings);
  if (faults.empty()) return "";
  return fmt::format(
      "<p class=\"note\" role=\"note\"><b>{} in the logs.</b> {} "
      "<a href=\"#logs\">{}</a></p>\n",
      counted(faults.size(), "fault", "faults"), escaped(faults.front()),
      faults.size() > 1 ? "All faults" : "The logs");
}

std::string largest_parameters(const NamedCause& cause) {
  std::string text;
  int shown = 0;
  for (const ParameterEstimate& p : cause.parameters) {
    if (!p.log.empty() || !p.is_felt() || ++shown > 3) continue;
    text += (text.empty() ? "" : "; ") + escaped(parameter_label(cause, p)) + " <b>" +
            escaped(shown_parameter(p)) + "</b>";
  }
  return text.empty() ? "" : "<p class=\"small\">" + text + "</p>\n";
}

std::string facts(const Findings& findings, const NamedCause& cause) {
  const Gain& gain = gain_of(findings, cause);
  return fmt::format(
      "<dl class=\"facts\"><div><dt>{0}</dt><dd><b>{1}</b>{2}</dd></div>\n"
      "<div><dt>{6}</dt><dd><b>{3}</b> "
      "<span class=\"soft\">({4})</span>{5}</dd></div></dl>\n",
      cause.members.size() > 1 ? "Confidence that it is one of these" : "Confidence",
      escaped(shown_confidence(cause.confidence)), bar(cause.confidence, "ink"),
      shown_share(gain.share), shown_interval(gain), interval_bar(gain),
      capitalised(gain_name(findings, cause)));
}

std::string cause_card(const Findings& findings, std::size_t index) {
  const auto& causes = findings.verdict.causes;
  const NamedCause& cause = causes[index];
  const std::string place = place_of(cause);
  const bool set = cause.members.size() > 1;
  std::string text =
      fmt::format("<article class=\"card cause{}\">", causes.size() == 1 ? " alone" : "");
  std::string label = set ? "Missing is one of these" : "Missing";
  if (causes.size() > 1)
    label += " · " + std::to_string(index + 1) + " of " + std::to_string(causes.size());
  text += "<span class=\"label\">" + label + "</span>\n";
  text += "<h3>" + escaped(capitalised(title_of(cause)));
  if (!place.empty()) text += " <span class=\"place\">" + escaped("· " + place) + "</span>";
  text += "</h3>\n" + facts(findings, cause);
  if (set)
    text += "<p class=\"settle\">" + escaped(separation_of(cause)) + "</p>\n";
  else
    text += largest_parameters(cause);
  return text + "</article>\n";
}

std::string leftover_card(const Verdict& verdict) {
  const Unexplained& rest = verdict.unexplained;
  std::string text =
      "<article class=\"card cause alone\"><span class=\"label\">Structured, but none "
      "of the known causes</span>\n<h3>Something real is missing that has no name "
      "here</h3>\n<p>" +
      escaped(leftover_of(verdict)) + "</p>\n";
  if (!rest.depends_on.empty())
    text += fmt::format(
        "<dl class=\"facts\"><div><dt>Log odds of a free curve over it, against "
        "nothing</dt><dd><b>{}</b></dd></div></dl>\n",
        shown_number(rest.depends_on.front().log_odds));
  return text +
         "<p class=\"small\"><a href=\"#unexplained\">What it depends on</a></p></article>\n";
}

std::string noise_card() {
  return "<article class=\"card cause alone\"><span class=\"label\">Verdict</span>\n<h3>Nothing "
         "beyond noise</h3>\n<p>What the model gets wrong looks like measurement noise: no known "
         "cause and no curve over position, velocity, load or time predicts it. A cause that these "
         "logs do not excite cannot be seen in them.</p></article>\n";
}

std::string disagreement_card(const Findings& findings) {
  return "<article class=\"card cause alone\"><span class=\"label\">Not the same in all "
         "logs</span>\n<h3>Training and held-out logs disagree</h3>\n<p>" +
         escaped(disagreement_text(findings)) + "</p></article>\n";
}

std::string cards(const Findings& findings) {
  const Verdict& v = findings.verdict;
  std::string text;
  for (std::size_t i = 0; i < v.causes.size(); ++i) text += cause_card(findings, i);
  if (v.unexplained.none_of_the_known) text += leftover_card(v);
  if (!v.disagreements.empty()) text += disagreement_card(findings);
  if (v.nothing_beyond_noise() && !findings.logs.empty()) text += noise_card();
  return "<div class=\"cards\">\n" + text + "</div>\n";
}

}  // namespace

std::string first_screen(const Findings& findings) {
  std::string text = "<header>\n" + kicker(findings) + h1_of(headline_of(findings)) +
                     "</h1>\n</header>\n<div class=\"pair\">\n";
  text += error_card(findings) + next_card(findings) + "</div>\n";
  return text + cards(findings) + fault_note(findings);
}

}  // namespace sinew::diagnosis
