// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/findings_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "identification/report/thinning.h"

namespace sinew::diagnosis {
namespace {

using Json = nlohmann::ordered_json;

template <class T, class Convert>
Json list(const std::vector<T>& items, Convert convert) {
  Json result = Json::array();
  for (const T& item : items) result.push_back(convert(item));
  return result;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// Seven digits are more than a picture shows.
Json coordinate(double value) {
  if (!std::isfinite(value)) return nullptr;
  char buffer[32];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 7);
  double rounded = value;
  std::from_chars(buffer, end.ptr, rounded);
  return rounded;
}

/// Curves on one line each: a line for every coordinate would be most of the file.
std::string with_short_curves(const std::string& text) {
  std::string result;
  bool curve = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 6, "\"x\": [") == 0 || text.compare(i, 6, "\"y\": [") == 0) curve = true;
    if (curve && text[i] == ']') curve = false;
    if (!curve || (text[i] != '\n' && text[i] != ' ') || (i > 0 && text[i - 1] == ':'))
      result += text[i];
  }
  return result;
}

Json json(const Gain& gain) {
  return {{"share", number(gain.share)}, {"low", number(gain.low)}, {"high", number(gain.high)}};
}

Json json(const LogRecord& log) {
  return {{"file", log.file},
          {"sha256", log.sha256},
          {"held_out", log.held_out},
          {"rows", log.rows},
          {"seconds", number(log.seconds)},
          {"period_s", number(log.period)},
          {"faults", log.faults},
          {"notes", log.notes}};
}

Json json(const Series& series, bool logarithmic) {
  const Series thin = thinned(series, logarithmic);
  return {{"label", thin.label},
          {"points", thin.points},
          {"x", list(thin.x, coordinate)},
          {"y", list(thin.y, coordinate)}};
}

Json json(const Plot& plot) {
  const auto series = [&](const Series& s) { return json(s, plot.logarithmic); };
  return {{"kind", plot.kind},
          {"title", plot.title},
          {"x_label", plot.x_label},
          {"y_label", plot.y_label},
          {"caption", plot.caption},
          {"logarithmic", plot.logarithmic},
          {"series", list(plot.series, series)}};
}

Json json(const DomainError& error) {
  return {{"domain", error.domain},
          {"unit", error.unit},
          {"before", number(error.before)},
          {"after", number(error.after)},
          {"gain", json(error.gain)}};
}

/// The error of the first domain in standard deviations.
Json relative(const ChannelFinding& channel, double DomainError::*error) {
  if (channel.domains.empty()) return nullptr;
  return number(channel.relative(channel.domains.front().*error));
}

Json json(const ChannelFinding& channel) {
  return {{"name", channel.name},
          {"unit", channel.unit},
          {"measured_rms", number(channel.measured_rms)},
          {"standard_deviation", number(channel.standard_deviation)},
          {"compared_below_hz", number(channel.compared_below_hz)},
          {"compared_share", number(channel.compared_share)},
          {"quantum", number(channel.quantum)},
          {"noise_floor", number(channel.noise_floor)},
          {"material_error", number(channel.material_error())},
          {"nothing_to_explain", channel.nothing_to_explain()},
          {"relative_error_before", relative(channel, &DomainError::before)},
          {"relative_error_after", relative(channel, &DomainError::after)},
          {"unexplained_before", number(channel.unexplained_before)},
          {"unexplained_after", number(channel.unexplained_after)},
          {"domains", list(channel.domains, [](const auto& x) { return json(x); })},
          {"plots", list(channel.plots, [](const auto& x) { return json(x); })}};
}

Json json(const ParameterEstimate& parameter) {
  return {{"name", parameter.name},
          {"unit", parameter.unit},
          {"value", number(parameter.value)},
          {"standard_error", number(parameter.standard_error)},
          {"log", parameter.log}};
}

Json json(const RankedCause& cause) {
  return {{"name", cause.name},
          {"place", cause.place},
          {"candidate", cause.candidate},
          {"behind", number(cause.behind)},
          {"weight", number(cause.weight)}};
}

Json json(const NamedCause& cause) {
  return {{"members", list(cause.members, [](const auto& x) { return json(x); })},
          {"confidence", number(cause.confidence)},
          {"log_odds", number(cause.log_odds)},
          {"cross_validated", json(cause.cross_validated)},
          {"held_out", json(cause.held_out)},
          {"parameters", list(cause.parameters, [](const auto& x) { return json(x); })},
          {"separating_experiment", cause.separation.experiment},
          {"separating_motion", cause.separation.file},
          {"would_rule_out", cause.separation.rules_out},
          {"expected_separation", number(cause.separation.expected)}};
}

Json json(const RuledOut& cause) {
  return {{"name", cause.name},
          {"place", cause.place},
          {"reason", cause.reason},
          {"log_odds", number(cause.log_odds)}};
}

Json json(const Dependence& dependence) {
  return {{"on", dependence.on},
          {"place", dependence.place},
          {"log_odds", number(dependence.log_odds)}};
}

Json json(const Unexplained& unexplained) {
  return {{"none_of_the_known", unexplained.none_of_the_known},
          {"depends_on", list(unexplained.depends_on, [](const auto& x) { return json(x); })},
          {"named_share", number(unexplained.named_share)},
          {"remaining", number(unexplained.remaining)}};
}

Json json(const Disagreement& disagreement) {
  return {{"name", disagreement.name},
          {"place", disagreement.place},
          {"in_training", json(disagreement.in_training)},
          {"channel", disagreement.channel},
          {"ratio", number(disagreement.ratio)}};
}

Json json(const Verdict& verdict) {
  return {{"outcome", outcome(verdict)},
          {"causes", list(verdict.causes, [](const auto& x) { return json(x); })},
          {"disagreements", list(verdict.disagreements, [](const auto& x) { return json(x); })},
          {"ruled_out", list(verdict.ruled_out, [](const auto& x) { return json(x); })},
          {"unexplained", json(verdict.unexplained)},
          {"baseline", list(verdict.baseline, [](const auto& x) { return json(x); })},
          {"relative_error_before", number(verdict.relative_error_before)},
          {"relative_error_after", number(verdict.relative_error_after)},
          {"held_out", json(verdict.held_out)},
          {"compared_below_hz",
           verdict.compared_below_hz > 0.0 ? number(verdict.compared_below_hz) : Json(nullptr)}};
}

Json json(const CauseTerm& term) {
  return {{"cause", term.cause},
          {"effect", term.effect},
          {"text", term.text},
          {"mathml", term.mathml},
          {"signature", term.signature},
          {"excitation", term.excitation},
          {"compensable", term.compensable}};
}

Json json(const Extension& extension) {
  return {{"adopted", extension.adopted},
          {"dry_run", extension.dry_run},
          {"reason", extension.reason},
          {"model_folder", extension.model_folder},
          {"functions", extension.functions},
          {"operations_before", extension.operations_before},
          {"operations_after", extension.operations_after}};
}

Json model_of(const Findings& findings) {
  return {{"name", findings.model},
          {"kind", findings.kind},
          {"description", findings.description},
          {"sha256", findings.model_hash}};
}

}  // namespace

std::string outcome(const Verdict& verdict) {
  if (verdict.nothing_beyond_noise()) return "nothing beyond noise";
  if (verdict.causes.empty() && !verdict.unexplained.none_of_the_known) return "the logs disagree";
  if (verdict.causes.empty()) return "none of the known causes";
  const bool set = std::any_of(verdict.causes.begin(), verdict.causes.end(),
                               [](const NamedCause& c) { return c.members.size() > 1; });
  return set ? "cannot tell" : "causes named";
}

std::string findings_json(const Findings& findings) {
  const Json all = {{"schema", "sinew findings"},
                    {"schema_version", kFindingsSchemaVersion},
                    {"headline", findings.headline},
                    {"next_step", findings.next_step},
                    {"model", model_of(findings)},
                    {"verdict", json(findings.verdict)},
                    {"terms", list(findings.terms, [](const auto& x) { return json(x); })},
                    {"channels", list(findings.channels, [](const auto& x) { return json(x); })},
                    {"extension", json(findings.extension)},
                    {"logs", list(findings.logs, [](const auto& x) { return json(x); })},
                    {"seconds", number(findings.seconds)}};
  return with_short_curves(all.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace sinew::diagnosis
