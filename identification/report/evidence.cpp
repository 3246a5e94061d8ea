// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "identification/report/numbers.h"
#include "identification/report/page.h"
#include "identification/report/sections.h"
#include "identification/report/wording.h"
#include "symbolic/notation/print_mathml.h"

namespace sinew::diagnosis {
namespace {

std::string parameter_table(const NamedCause& cause) {
  bool per_log = false;
  for (const ParameterEstimate& p : cause.parameters) per_log = per_log || !p.log.empty();
  std::vector<std::string> headings = {"Parameter", "#Value ± standard error"};
  if (per_log) headings.push_back("Holds for");
  Table table(headings, "", true);
  for (const ParameterEstimate& p : cause.parameters)
    table.row(
        {"<math>" + mathml_name(p.name) + "</math>",
         p.is_felt() ? escaped(shown_parameter(p)) : "not excited in these logs",
         p.log.empty() ? "every log" : "<span class=\"mono\">" + escaped_name(p.log) + "</span>"});
  return table.empty() ? "" : table.html();
}

std::string term(const Findings& findings, const CauseTerm& term) {
  const auto index = static_cast<std::size_t>(term.cause);
  if (term.cause < 0 || index >= findings.verdict.causes.size()) return "";
  const NamedCause& cause = findings.verdict.causes[index];
  const std::string place = place_of(cause);
  const std::string name = cause.members.empty() ? title_of(cause) : cause.members.front().name;
  std::string text = "<div class=\"term card\"><h3>" + escaped(capitalised(name)) +
                     (place.empty() ? "" : " <span class=\"soft\">" + escaped(place) + "</span>") +
                     "</h3>\n";
  if (cause.members.size() > 1)
    text +=
        "<p class=\"small soft\">The likeliest of the credible set; the others have terms of their "
        "own.</p>\n";
  text += term.mathml.empty() ? "<p class=\"mono\">" + escaped(term.text) + "</p>\n"
                              : "<div class=\"math\" tabindex=\"0\" role=\"group\" aria-label=\"" +
                                    escaped(term.text) + "\">" + term.mathml + "</div>\n";
  text += "<div class=\"sides\"><div>" + parameter_table(cause) + "</div>\n<div>";
  if (!term.signature.empty())
    text += "<p><b>Looks like:</b> " + escaped(term.signature) + ".</p>\n";
  if (!term.excitation.empty())
    text += "<p><b>Shows in:</b> " + escaped(term.excitation) + ".</p>\n";
  text += "<p class=\"small soft\">";
  if (!term.effect.empty()) text += "Entry <code>" + escaped(term.effect) + "</code>. ";
  text += term.compensable ? "The firmware's compensation can take it up."
                           : "The firmware cannot compensate it from what it measures; the "
                             "simulation has it.";
  return text + "</p></div></div></div>\n";
}

Table member_table(const NamedCause& cause) {
  Table table({"Member", "Place", "#Probability", "#Log odds below the best"});
  for (const RankedCause& m : cause.members)
    table.row({escaped(m.name), escaped(m.place), shown_share(m.weight), shown_number(m.behind)});
  return table;
}

std::string found(const Findings& findings) {
  Table table({"Cause", "Place", "#Log odds", "#Cross-validated gain"},
              "Log odds: natural logarithm of how much more probable the cause is than nothing in "
              "its place, prior included. Both are of the cause beside the others, in the training "
              "logs.");
  for (const NamedCause& c : findings.verdict.causes)
    table.row({escaped(title_of(c)), escaped(place_of(c)), shown_number(c.log_odds),
               shown_share(c.cross_validated.share) + " <span class=\"soft\">(" +
                   shown_interval(c.cross_validated) + ")</span>"});
  return table.empty() ? "" : "<h3>Found</h3>\n" + table.html();
}

std::string sets(const Findings& findings) {
  std::string text;
  for (const NamedCause& c : findings.verdict.causes)
    if (c.members.size() > 1)
      text += "<h3>Credible set: " + escaped(title_of(c)) + "</h3>\n<p class=\"settle\">" +
              escaped(separation_of(c)) + "</p>\n" + member_table(c).html();
  return text;
}

std::string ruled_out(const Verdict& verdict) {
  if (verdict.ruled_out.empty()) return "";
  Table table({"Cause", "Place", "Why not", "#Log odds"});
  for (const RuledOut& r : verdict.ruled_out)
    table.row({escaped(r.name), escaped(r.place), escaped(r.reason), shown_number(r.log_odds)});
  return "<h3>Ruled out</h3>\n<p>Every cause below was tested as well, beside the named "
         "ones.</p>\n" +
         (verdict.ruled_out.size() > 12 ? folded("All " + std::to_string(verdict.ruled_out.size()) +
                                                     " causes that were ruled out",
                                                 table.html())
                                        : table.html());
}

}  // namespace

std::string term_section(const Findings& findings) {
  std::string text;
  for (const CauseTerm& each : findings.terms) text += term(findings, each);
  return section("terms", "What was missing, as an equation", text);
}

std::string ranking_section(const Findings& findings) {
  return section("ranking", "Why these causes and no others",
                 found(findings) + sets(findings) + ruled_out(findings.verdict));
}

std::string unexplained_section(const Findings& findings) {
  const Unexplained& rest = findings.verdict.unexplained;
  std::string text = "<p>" + escaped(leftover_of(findings.verdict)) + "</p>\n";
  Table table({"Depends on", "Place", "#Log odds of a free curve"});
  for (const Dependence& d : rest.depends_on)
    table.row(
        {escaped(dependence_text({d.on, "", 0.0})), escaped(d.place), shown_number(d.log_odds)});
  if (!table.empty()) text += table.html();
  if (!findings.verdict.causes.empty() || rest.none_of_the_known)
    text += fmt::format(
        "<p class=\"soft\">Named causes account for {} of the log odds of all that was found in "
        "the training logs. The cross-validated loss with them is {} of that of the model as it "
        "was, "
        "noise included.</p>\n",
        shown_share(rest.named_share), shown_share(rest.remaining));
  return section("unexplained", "What is still unexplained", text);
}

}  // namespace sinew::diagnosis
