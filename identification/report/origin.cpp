// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "identification/report/numbers.h"
#include "identification/report/page.h"
#include "identification/report/sections.h"
#include "identification/report/wording.h"
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

std::string list_of(const std::vector<std::string>& texts) {
  std::string items;
  for (const std::string& text : texts) items += "<li>" + escaped(text) + "</li>";
  return "<ul>" + items + "</ul>\n";
}

std::string fault_list(const Findings& findings) {
  const std::vector<std::string> faults = faults_of(findings), notes = notes_of(findings);
  return (faults.empty() ? "<p>No faults were found in them.</p>\n"
                         : "<h3>Faults, and what was done</h3>\n" + list_of(faults)) +
         (notes.empty() ? "" : "<h3>Notes</h3>\n" + list_of(notes));
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
    table.row({"<math>" + mathml_name(p.name) + "</math>", escaped(shown_parameter(p))});
  return folded("Parameters of the model itself, fitted together with the causes", table.html());
}

constexpr const char* kMethod = R"(
<p><b>Error before and after.</b> What the model's emitted C says, minus what was measured, inside the band
that was compared, standstill aside; on the held-out logs where there are any. Before: the model as it was.
After: with the terms that its extension holds.</p>
<p><b>Held-out gain.</b> The share of the squared error that goes away on logs that the fit had not seen:
1&nbsp;− (error after / error before)². Of several channels together, each counts in units of what is left of
it at best. The 95&nbsp;% interval is a block bootstrap's, because neighbouring samples are not
independent.</p>
<p><b>Held-out gain beside the other causes.</b> The same for a single cause, against the search's model with
all other causes fitted again. What several causes share is credited to none, so these gains do not add
up.</p>
<p><b>Cross-validated gain.</b> The same on blocks of the training logs, each predicted by a fit to the
others.</p>
<p><b>Log odds.</b> The residual of a model is coloured noise, so what it leaves over is weighted by the
noise's own spectrum, small errors of every form included. The number is the natural logarithm of how much more
probable the logs are with the cause than with nothing in its place, over all sizes and shapes that it may have, and of
its prior odds: 4.6 are a hundred to one. Below zero, nothing is more probable.</p>
<p><b>Standard errors</b> are those for coloured noise with all parameters free.</p>
<p><b>Ruled out.</b> Each cause of the library is tested beside the named ones. It is refused where the
odds are against it, where it gains nothing sure on held-out logs, or where its sign or size is not physical.</p>
)";

}  // namespace

std::string extension_section(const Findings& findings) {
  const Extension& e = findings.extension;
  if (!e.adopted && !e.dry_run && e.reason.empty()) return "";
  std::string text = "<p><b>" + extension_state(e) + ".</b> " +
                     escaped(sentence(capitalised(e.reason))) + "</p>\n";
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
  std::string text = std::string(kMethod) + "<p><b>Confidence.</b> " +
                     escaped(confidence_meaning()) + "</p>\n" + baseline(findings.verdict);
  if (findings.seconds > 0.0)
    text += "<p class=\"soft\">The diagnosis took " + shown_duration(findings.seconds) + ".</p>\n";
  return section("method", "How the numbers were made", text);
}

}  // namespace sinew::diagnosis
