// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/fleet_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "identification/report/findings_json.h"
#include "identification/report/numbers.h"
#include "identification/report/wording.h"

namespace sinew::diagnosis {
namespace {

using FleetJson = nlohmann::ordered_json;

constexpr int kFleetSchema = 1;

std::size_t held_out_logs(const FleetFindings& f) {
  return static_cast<std::size_t>(std::count_if(f.logs.begin(), f.logs.end(),
                                                [](const LogRecord& log) { return log.held_out; }));
}

/// Of one held-out log there is no interval: it is over logs.
std::string gain_text(const FleetFindings& f, const Gain& gain) {
  const std::size_t held = held_out_logs(f);
  if (held == 0) return "";
  const std::string share = ", held-out gain " + shown_share(gain.share);
  return held == 1 ? share + " (one log: no interval)" : share + " (" + shown_interval(gain) + ")";
}

std::string cause_lines(const FleetFindings& f, const NamedCause& cause, std::size_t number) {
  std::string text =
      fmt::format("  {}. {}: confidence {}\n     takes away {} of the whitened error{}\n", number,
                  cause_text(cause), shown_confidence(cause.confidence),
                  shown_share(cause.cross_validated.share), gain_text(f, cause.held_out));
  for (const ParameterEstimate& p : cause.parameters)
    if (p.is_felt())
      text += fmt::format("     {} {}\n", parameter_label(cause, p), shown_parameter(p));
  return text;
}

FleetJson gain_json(const FleetFindings& f, const Gain& gain) {
  const std::size_t held = held_out_logs(f);
  if (held == 0) return nullptr;
  FleetJson j{{"share", gain.share}, {"low", nullptr}, {"high", nullptr}};
  if (held > 1) {
    j["low"] = gain.low;
    j["high"] = gain.high;
  }
  return j;
}

FleetJson cause_json(const FleetFindings& f, const NamedCause& cause) {
  FleetJson members = FleetJson::array(), parameters = FleetJson::array();
  for (const RankedCause& m : cause.members)
    members.push_back({{"name", m.name}, {"place", m.place}, {"weight", m.weight}});
  for (const ParameterEstimate& p : cause.parameters)
    parameters.push_back({{"name", p.name},
                          {"unit", p.unit},
                          {"value", p.value},
                          {"standard_error", p.standard_error}});
  return {{"members", std::move(members)},
          {"confidence", cause.confidence},
          {"whitened_share", cause.cross_validated.share},
          {"held_out", gain_json(f, cause.held_out)},
          {"parameters", std::move(parameters)}};
}

FleetJson logs_json(const FleetFindings& f) {
  FleetJson logs = FleetJson::array();
  for (const LogRecord& log : f.logs)
    logs.push_back({{"file", log.file},
                    {"sha256", log.sha256},
                    {"held_out", log.held_out},
                    {"rows", log.rows},
                    {"seconds", log.seconds},
                    {"faults", log.faults}});
  return logs;
}

}  // namespace

std::string fleet_text(const FleetFindings& f) {
  const std::size_t held = held_out_logs(f);
  double seconds = 0.0;
  std::size_t faults = 0;
  for (const LogRecord& log : f.logs) {
    seconds += log.seconds;
    faults += log.faults.size();
  }
  std::string text = f.headline + "\n\n";
  text += fmt::format("Model      {}, {} · sums of {}, {} held out, {:.3g} s in all\n", f.model,
                      f.kind, counted(f.logs.size(), "log", "logs"), held, seconds);
  text += fmt::format("Error      {} of what was measured (rms), before any cause\n",
                      shown_percent(f.verdict.relative_error_before));
  if (!f.verdict.causes.empty()) text += "Missing\n";
  for (std::size_t i = 0; i < f.verdict.causes.size(); ++i)
    text += cause_lines(f, f.verdict.causes[i], i + 1);
  text += fmt::format("Residual   {} of the whitened squared error is left\n",
                      shown_percent(f.whitened_error_left));
  if (faults > 0) text += fmt::format("Log faults {}: --json lists them\n", faults);
  text += "Next       nothing is adopted from sums: sinew diagnose with a few of these logs does\n";
  return text;
}

std::string fleet_json(const FleetFindings& f) {
  FleetJson causes = FleetJson::array(), ruled_out = FleetJson::array(),
            depends_on = FleetJson::array();
  for (const NamedCause& cause : f.verdict.causes) causes.push_back(cause_json(f, cause));
  for (const RuledOut& r : f.verdict.ruled_out)
    ruled_out.push_back({{"name", r.name}, {"place", r.place}, {"reason", r.reason}});
  for (const Dependence& d : f.verdict.unexplained.depends_on)
    depends_on.push_back({{"on", d.on}, {"place", d.place}});
  const FleetJson j{{"fleet_schema", kFleetSchema},
                    {"model", f.model},
                    {"model_sha256", f.model_hash},
                    {"kind", f.kind},
                    {"headline", f.headline},
                    {"outcome", outcome(f.verdict)},
                    {"causes", std::move(causes)},
                    {"none_of_the_known", f.verdict.unexplained.none_of_the_known},
                    {"depends_on", std::move(depends_on)},
                    {"ruled_out", std::move(ruled_out)},
                    {"relative_error_before", f.verdict.relative_error_before},
                    {"whitened_error_left", f.whitened_error_left},
                    {"held_out", gain_json(f, f.verdict.held_out)},
                    {"seconds", f.seconds},
                    {"logs", logs_json(f)}};
  return j.dump(2, ' ', false, FleetJson::error_handler_t::replace) + "\n";
}

}  // namespace sinew::diagnosis
