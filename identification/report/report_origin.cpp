// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "identification/report/report_numbers.h"
#include "identification/report/report_page.h"
#include "identification/report/report_sections.h"
#include "identification/report/report_wording.h"
#include "symbolic/notation/print_mathml.h"

namespace sinew::diagnosis {
namespace {

std::string operations_of(const Extension& e) {
  if (e.operations_after <= 0) return "";
  const int more = e.operations_after - e.operations_before;
  return fmt::format("<p>The force model costs {} operations now, {} before ({}{}).</p>\n",
                     e.operations_after, e.operations_before, more < 0 ? "−" : "+",
                     more < 0 ? -more : more);
}

std::string functions_of(const Extension& e) {
  if (e.functions.empty()) return "";
  std::string items;
  for (const std::string& name : e.functions)
    items += "<li><code>" + escaped(name) + "</code></li>";
  return "<p>Emitted functions that are new or changed:</p><ul>" + items + "</ul>\n";
}

std::string log_name(const LogRecord& log) {
  return "<span class=\"mono\">" + escaped_name(log.file) + "</span>";
}

std::string fault_list(const Findings& findings) {
  std::string items;
  for (const std::string& fault : faults_of(findings)) items += "<li>" + escaped(fault) + "</li>";
  return items.empty() ? "<p>No faults were found in them.</p>\n"
                       : "<h3>Faults, and what was done</h3>\n<ul>" + items + "</ul>\n";
}

std::string hashes(const Findings& findings) {
  std::string text;
  for (const LogRecord& log : findings.logs)
    text += "<li>" + log_name(log) + "<br><code>" + escaped(log.sha256) + "</code></li>";
  if (!findings.model_hash.empty())
    text += "<li>model " + escaped(findings.model) + "<br><code>" + escaped(findings.model_hash) +
            "</code></li>";
  return folded("SHA-256 of the logs and of the model", "<ul>" + text + "</ul>");
}

std::string baseline(const Verdict& verdict) {
  if (verdict.baseline.empty()) return "";
  Table table({"Parameter", "#Value ± standard error"}, "", true);
  for (const ParameterEstimate& p : verdict.baseline)
    table.row({"<math>" + mathml_name(p.name) + "</math>",
               escaped(shown_estimate(p.value, p.standard_error, p.unit))});
  return folded("Parameters of the model itself, fitted together with the causes", table.html());
}

constexpr const char* kMethod = R"(
<p><b>Error before and after.</b> What the model predicts, minus what was measured, inside the band that
was looked at. Before: the model with its own parameters fitted to the same logs, so that a gain is the new
term's and not a better calibration's. After: the same with the causes.</p>
<p><b>Gain.</b> The share of the squared error that goes away. Its 95&nbsp;% interval comes from drawing
whole blocks of the log again and again, because neighbouring samples are not independent. A single
cause is measured against the same model without it, so the shares of several causes do not add up.</p>
<p><b>Chance of a false name.</b> What a model leaves over is coloured noise, and a test that takes it for
white always finds something. So the same search runs on surrogates: noise with the same spectrum and
nothing hidden. The number is how often the best of the whole library does as well there.</p>
<p><b>Confidence.</b> The probability that the truth is this cause, or one of the set; from trials in
which the truth was known and one of the library. It is never above 84 %: so often the surest sets held
the truth there.</p>
<p><b>Standard errors</b> are those for coloured noise with all parameters free.</p>
<p><b>Ruled out.</b> Each cause of the library is asked for on top of the final model. It is refused where
chance does as well, where left-out blocks do not improve, or where its sign or size is not physical.</p>
)";

}  // namespace

std::string extension_section(const Findings& findings) {
  const Extension& e = findings.extension;
  if (!e.adopted && !e.dry_run && e.reason.empty()) return "";
  std::string text = "<p><b>" +
                     std::string(e.adopted   ? "The model was extended."
                                 : e.dry_run ? "Nothing was changed: this was a dry run."
                                             : "The model was left as it is.") +
                     "</b> " + escaped(sentence(capitalised(e.reason))) + "</p>\n";
  if (!e.model_folder.empty())
    text += "<p>The extended model is in <code>" + escaped_name(e.model_folder) + "</code>.</p>\n";
  return section("extension", "What became of the model",
                 text + functions_of(e) + operations_of(e));
}

std::string log_section(const Findings& findings) {
  if (findings.logs.empty()) return "";
  Table table({"Log", "Used for", "#Samples", "#Duration", "#Sampling rate", "#Faults"});
  for (const LogRecord& log : findings.logs)
    table.row({log_name(log), log.held_out ? "testing (held out)" : "training",
               std::to_string(log.rows), shown_duration(log.seconds),
               log.period > 0.0 ? escaped(shown_quantity(1.0 / log.period, "Hz", 4)) : "–",
               std::to_string(log.faults.size())});
  return section("logs", "The logs", table.html() + fault_list(findings) + hashes(findings));
}

std::string method_section(const Findings& findings) {
  std::string text = std::string(kMethod) + baseline(findings.verdict);
  if (findings.seconds > 0.0)
    text += "<p class=\"soft\">The diagnosis took " + shown_duration(findings.seconds) + ".</p>\n";
  return section("method", "How the numbers were made", text);
}

}  // namespace sinew::diagnosis
