// SPDX-License-Identifier: GPL-3.0-or-later
// What a report says in percent: every number is one quantity's, and every quantity has one number,
// on the page, in the terminal and in findings.json.
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "identification/diagnosis/confidence.h"
#include "identification/report/findings_json.h"
#include "identification/report/html.h"
#include "identification/report/numbers.h"
#include "identification/report/text.h"
#include "identification/report/wording.h"
#include "tests/identification/report/example.h"
#include "tests/reference/temporary_folder.h"

using namespace sinew::diagnosis;

namespace {

void erase_elements(std::string& html, const std::string& name) {
  const std::string begin = "<" + name, end = "</" + name + ">";
  for (std::size_t at = html.find(begin); at != std::string::npos; at = html.find(begin, at))
    html.erase(at, html.find(end, at) + end.size() - at);
}

/// What is read of a page: no tags, no style, no labels of plots; ordinary blanks.
std::string read_text_of(std::string html) {
  for (const char* element : {"style", "title", "svg"}) erase_elements(html, element);
  std::string text;
  bool tag = false;
  for (const char c : html) {
    if (c == '<' || c == '>') text += ' ';
    tag = c == '<' || (tag && c != '>');
    if (!tag && c != '>') text += c;
  }
  text = std::regex_replace(text, std::regex("&nbsp;|\u00a0"), " ");
  return std::regex_replace(text, std::regex("[ \n]+"), " ");
}

std::string plain(const std::string& shown) {
  return read_text_of(shown);
}

/// "78 %", "71 to 83 %", "−35.26 ± 0.41 %", and how often.
std::map<std::string, int> percents_in(const std::string& text) {
  static const std::regex number("(?:(?:−)?[0-9.]+ (?:to|±) )?(?:−)?[0-9.]+ %");
  std::map<std::string, int> found;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
    ++found[it->str()];
  return found;
}

/// Shown number by quantity. Two quantities of one number would hide a contradiction: the examples
/// have none.
class Quantities {
 public:
  explicit Quantities(const Findings& f) {
    const Verdict& v = f.verdict;
    add("relative error before", shown_percent(v.relative_error_before));
    add("relative error after", shown_percent(v.relative_error_after));
    for (const NamedCause& c : v.causes) {
      add("confidence of " + title_of(c), shown_confidence(c.confidence));
      add_gain("cross-validated gain of " + title_of(c), c.cross_validated);
      if (v.causes.size() > 1) add_gain("held-out gain of " + title_of(c), c.held_out);
      for (const ParameterEstimate& p : c.parameters)
        if (p.unit == "1") add(parameter_label(c, p), shown_parameter(p));
    }
    add_gain("held-out gain", v.held_out);
    add("share of structure named", shown_share(v.unexplained.named_share));
    add("loss remaining", shown_share(v.unexplained.remaining));
    for (const Dependence& d : v.unexplained.depends_on)
      add("log odds over " + d.on, shown_number(d.log_odds));
    for (const ChannelErrors& c : channel_errors(f)) {
      add("relative error before of " + c.channel, c.before);
      if (!c.after.empty()) add("relative error after of " + c.channel, c.after);
    }
    for (const ChannelFinding& c : f.channels) {
      add("unexplained before", shown_share(c.unexplained_before));
      add("unexplained after", shown_share(c.unexplained_after));
      for (const DomainError& d : c.domains)
        add_gain(&d == &c.domains.front() ? "held-out gain" : "gain, " + d.domain, d.gain);
    }
    add("level of intervals", "95 %");
    add("most that is unexplained", "100 %");
    add("material share", shown_share(Settings{}.material_share));
    add("highest confidence", shown_confidence(kHighestConfidence));
  }

  /// Empty where it is no quantity's.
  std::string owner(const std::string& number) const {
    const auto at = owners_.find(number);
    return at == owners_.end() ? "" : at->second;
  }

 private:
  void add(const std::string& quantity, const std::string& shown) {
    const std::string number = plain(shown);
    const auto [at, is_new] = owners_.try_emplace(number, quantity);
    INFO(number << ": " << quantity << ", " << at->second);
    CHECK((is_new || at->second == quantity));
  }
  void add_gain(const std::string& quantity, const Gain& gain) {
    add(quantity, shown_share(gain.share));
    add("interval of " + quantity, shown_interval(gain));
  }
  std::map<std::string, std::string> owners_;
};

void check_owners(const Findings& findings, const std::string& text) {
  const Quantities quantities(findings);
  const auto percents = percents_in(text);
  CHECK(percents.size() > 3);
  for (const auto& [number, count] : percents) {
    INFO(number);
    CHECK(quantities.owner(number) != "");
  }
}

}  // namespace

TEST_CASE("every number in percent is one quantity's, every quantity has one number") {
  // Planted defects, each of which was told as a number without a quantity: decide_adoption() with
  // "falls by 78.0 %" for a reason; the relative error as shown_share() ("4.1 %" beside "4.08 %");
  // "84 %" in confidence_meaning().
  for (const Findings& f : {example::rich_drive(), example::lone_cause()}) {
    check_owners(f, read_text_of(report_html(f)));
    check_owners(f, read_text_of(report_text(f)));
  }
}

TEST_CASE("a lone cause gains what the extension gains, everywhere") {
  const Findings f = example::lone_cause();
  const auto j = nlohmann::json::parse(findings_json(f));
  CHECK(j["verdict"]["held_out"] == j["verdict"]["causes"][0]["held_out"]);
  CHECK(j["verdict"]["held_out"] == j["channels"][0]["domains"][0]["gain"]);
  const double before = j["channels"][0]["domains"][0]["before"],
               after = j["channels"][0]["domains"][0]["after"];
  CHECK(j["verdict"]["held_out"]["share"].get<double>() ==
        Approx(1.0 - after * after / (before * before)));
  const std::string gain = plain(shown_share(f.verdict.held_out.share));
  CHECK(read_text_of(report_text(f)).find("held-out gain " + gain) != std::string::npos);
  CHECK(read_text_of(report_html(f)).find("Held-out gain " + gain) != std::string::npos);
}

TEST_CASE("the page, the manual and the schema name one highest confidence") {
  // Planted defect: with "0.84 at most" in docs/diagnose.md the second check fails.
  const auto page = [](const char* name) {
    return sinew::reference::read_text(std::string(SINEW_SOURCE_DIR "/docs/") + name);
  };
  const std::string shown = plain(shown_confidence(kHighestConfidence));
  const std::string number = nlohmann::json(kHighestConfidence).dump();
  CHECK(read_text_of(report_html(example::rich_drive())).find("It is " + shown + " at most") !=
        std::string::npos);
  CHECK(page("diagnose.md").find("The confidence is " + number + " at most") != std::string::npos);
  CHECK(page("findings.md").find("at most " + number) != std::string::npos);
  const auto schema = nlohmann::json::parse(page("findings.schema.json"));
  CHECK(schema["$defs"]["cause"]["properties"]["confidence"]["maximum"] == kHighestConfidence);
  CHECK(confidence_of(1e9, 0.0) == Approx(kHighestConfidence));
}
