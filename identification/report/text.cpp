// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/text.h"

#include <algorithm>

#include "identification/report/numbers.h"
#include "identification/report/wording.h"

namespace sinew::diagnosis {
namespace {

constexpr std::size_t kWidth = 100, kLabel = 11;

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(std::string text, std::size_t width) {
  while (width_of(text) < width) text += ' ';
  return text;
}

/// A word alone on its line that is still too long.
std::string shortened(std::string word, std::size_t width) {
  if (width_of(word) <= width) return word;
  while (width_of(word) > width - 1) {
    while ((word.back() & 0xC0) == 0x80) word.pop_back();
    word.pop_back();
  }
  return word + "…";
}

/// `label` in a column of its own, the text wrapped beside it in at most `most` lines.
class Page {
 public:
  void add(const std::string& label, const std::string& text, std::size_t most,
           std::size_t indent = kLabel) {
    std::string line = padded(label, indent);
    std::size_t lines = 1, begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
      const std::string word = shortened(text.substr(begin, end - begin), kWidth - indent);
      begin = end + 1;
      if (word.empty()) continue;
      const bool first = width_of(line) <= indent;
      if (first || width_of(line) + 1 + width_of(word) <= kWidth - (lines == most ? 2 : 0)) {
        line += (first ? "" : " ") + word;
        continue;
      }
      if (lines == most) {
        line += " …";
        break;
      }
      put(line);
      line = std::string(indent, ' ') + word;
      ++lines;
    }
    put(line);
  }
  void gap() { text_ += "\n"; }
  const std::string& text() const { return text_; }

 private:
  void put(const std::string& line) {
    text_ += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  std::string text_;
};

std::string logs_of(const Findings& findings) {
  const auto held =
      static_cast<std::size_t>(std::count_if(findings.logs.begin(), findings.logs.end(),
                                             [](const LogRecord& log) { return log.held_out; }));
  std::string text = counted(findings.logs.size(), "log", "logs");
  if (held) text += ", " + std::to_string(held) + " held out";
  return text;
}

std::string error_of(const Findings& findings) {
  const Verdict& v = findings.verdict;
  if (nothing_to_explain(findings)) return "nothing to explain, on " + judged_logs(findings);
  std::string text = shown_percent(v.relative_error_before);
  if (!v.causes.empty()) text += " → " + shown_percent(v.relative_error_after);
  text += " of the standard deviation, on " + judged_logs(findings);
  if (v.causes.size() < 2 || !has_held_out(findings)) return text;
  return text + "; held-out gain of all causes " + shown_share(v.held_out.share) + " (" +
         shown_interval(v.held_out) + ")";
}

/// Each channel's, where there are several: a robot is as good as its worst joint.
std::string errors_of_channels(const Findings& findings) {
  std::string text;
  for (const ChannelErrors& c : channel_errors(findings)) {
    const std::string effort = "effort of ";
    const bool joint = c.channel.starts_with(effort);
    text += (text.empty() ? "" : ", ") + (joint ? c.channel.substr(effort.size()) : c.channel) +
            " " + c.before + (c.after.empty() ? "" : " → " + c.after);
  }
  return text;
}

std::string parameters_of(const NamedCause& cause) {
  std::string text;
  for (const ParameterEstimate& p : cause.parameters) {
    if (!p.log.empty() || !p.is_felt()) continue;
    text += (text.empty() ? "" : ", ") + parameter_label(cause, p) + " " + shown_parameter(p);
  }
  return text;
}

void add_cause(Page& page, const Findings& findings, const NamedCause& cause, std::size_t index) {
  const std::string label = index == 0 ? "Missing" : "";
  page.add(label,
           std::to_string(index + 1) + ". " + cause_text(cause) + ": confidence " +
               shown_confidence(cause.confidence) + ", " + gain_name(findings, cause) + " " +
               shown_share(gain_of(findings, cause).share) + " (" +
               shown_interval(gain_of(findings, cause)) + ")",
           2);
  const std::string second = cause.members.size() > 1 ? separation_of(cause) : parameters_of(cause);
  if (!second.empty()) page.add("", second, cause.members.size() > 1 ? 2 : 1, kLabel + 3);
}

void add_causes(Page& page, const Findings& findings, std::size_t most) {
  const auto& causes = findings.verdict.causes;
  for (std::size_t i = 0; i < std::min(most, causes.size()); ++i)
    add_cause(page, findings, causes[i], i);
  if (causes.size() > most)
    page.add("", "and " + std::to_string(causes.size() - most) + " more in the report", 1);
}

std::string ruled_out_of(const Verdict& verdict) {
  std::string text;
  constexpr std::size_t kMost = 2;
  const auto& all = verdict.ruled_out;
  for (std::size_t i = 0; i < std::min(kMost, all.size()); ++i)
    text += (i ? "; " : "") + all[i].name + " (" + all[i].reason + ")";
  if (all.size() > kMost) text += "; " + std::to_string(all.size() - kMost) + " more in the report";
  return text;
}

/// With at most so many causes.
std::string page_of(const Findings& findings, std::size_t most) {
  const Verdict& verdict = findings.verdict;
  const std::vector<std::string> faults = faults_of(findings);
  Page page;
  page.add("", headline_of(findings), 3, 0);
  page.gap();
  page.add("Model",
           findings.model + (findings.kind.empty() ? "" : ", " + findings.kind) + " · " +
               logs_of(findings),
           1);
  page.add("Error", error_of(findings), 2);
  if (const std::string each = errors_of_channels(findings); !each.empty())
    page.add("Each", each, 4);
  add_causes(page, findings, most);
  if (!verdict.ruled_out.empty()) page.add("Ruled out", ruled_out_of(verdict), 2);
  page.add("Residual", leftover_of(verdict), 2);
  if (!faults.empty())
    page.add("Log faults", std::to_string(faults.size()) + ", the first: " + faults.front(), 2);
  const Extension& extension = findings.extension;
  if (!extension.reason.empty() && findings.next_step.find(extension.reason) == std::string::npos)
    page.add("Extension", extension_state(extension) + ": " + extension.reason, 2);
  if (!findings.next_step.empty()) page.add("Next", findings.next_step, 2);
  return page.text();
}

}  // namespace

std::string report_text(const Findings& findings) {
  constexpr std::ptrdiff_t kLines = 25;
  std::string text;
  for (std::size_t most = 4; most > 0; --most) {
    text = page_of(findings, most);
    if (std::count(text.begin(), text.end(), '\n') <= kLines) break;
  }
  return text;
}

}  // namespace sinew::diagnosis
