// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/diagnose_observed.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "identification/adoption/discrepancy.h"
#include "identification/adoption/ended_early.h"
#include "identification/adoption/held_out_judgement.h"
#include "identification/adoption/measure_plots.h"
#include "identification/adoption/observed_extension.h"
#include "identification/adoption/possible_terms.h"
#include "identification/diagnosis/separation.h"
#include "identification/likelihood/explain.h"
#include "identification/logs/read_csv.h"
#include "identification/report/log_record.h"
#include "identification/report/verdict_text.h"
#include "identification/subjects/rig_readings.h"
#include "symbolic/notation/print_mathml.h"

namespace sinew::diagnosis {
namespace {

using Clock = std::chrono::steady_clock;
using Eigen::Index;

class ObservedRun {
 public:
  explicit ObservedRun(const ObservedRequest& request)
      : request_(request),
        subject_(request.rig.observation, request.rig.channels, request.identified,
                 request.runtime) {}

  Diagnosis operator()() {
    const auto start = Clock::now();
    Findings& f = result_.findings;
    f.model = request_.name;
    f.description = request_.description;
    f.model_hash = request_.hash;
    f.kind = request_.kind;
    read();
    tell("comparing with the model", 0.2);
    prepare();
    for (int c = 0; c < subject_.problem().channels; ++c)
      subject_.problem().quantum.push_back(quantum_of(columns_, c) / subject_.units()(c));
    tell("searching for causes", 0.3);
    Explanation explanation;
    const std::string ended = why_ended([&] {
      explanation = explain(subject_.problem(), request_.settings);
      merge_members(explanation.verdict);
      propose_experiments(subject_.problem(), request_.settings, {}, explanation);
      if (!request_.holdout.empty()) confirm_on_held_out(explanation.verdict);
    });
    if (!ended.empty()) explanation = {};
    f.verdict = explanation.verdict;
    tell("extending and measuring", 0.9);
    extend(explanation);
    describe_terms();
    f.headline = headline(f);
    report_discrepancies(discrepant_, f);
    if (!ended.empty()) tell_ended_search(ended, f);
    if (request_.settings.first_look) tell_first_look(f);
    f.next_step = next_step(f);
    f.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return std::move(result_);
  }

  ObservedReplay replay() {
    read();
    prepare();
    const Design design(subject_.problem(), request_.settings);
    const std::vector<MeasuredChannel> measured =
        measure_observation(subject_, design, request_.identified, request_.rig.free_zero);
    ObservedReplay replay{{"time [s]"}, {}, {}};
    for (std::size_t c = 0; c < request_.rig.channels.size(); ++c) {
      const ObservedChannel& named = request_.rig.channels[c];
      replay.columns.push_back(fmt::format("{} [{}]", named.name, named.unit));
      ChannelFinding finding;
      add_error("sensor", measured, static_cast<int>(c), false, finding);
      replay.errors.push_back({named.name, named.unit, finding.domains.front().before});
    }
    std::map<double, std::vector<double>> rows;  // by time: stretches one after the other
    for (const MeasuredChannel& m : measured)
      for (Index k = 0; k < m.time.size(); ++k) {
        std::vector<double>& row = rows[m.time(k)];
        row.resize(replay.columns.size(), std::nan(""));
        row[0] = m.time(k);
        row[static_cast<std::size_t>(m.channel) + 1] = m.before(k);
      }
    for (auto& [time, row] : rows) replay.rows.push_back(std::move(row));
    return replay;
  }

 private:
  void tell(const std::string& step, double share) const {
    if (request_.progress) request_.progress(step, share);
  }

  void read() {
    tell("reading the logs", 0.0);
    ReadOptions options;
    options.map = request_.map;
    const bool first_look = request_.settings.first_look;
    options.max_rate = first_look ? kFirstLookRate : kDiagnosisRate;
    options.max_values =
        diagnosis_values(request_.logs.size() + request_.holdout.size(), first_look);
    std::vector<LogFile> files;
    for (const std::vector<std::string>& group : {request_.logs, request_.holdout})
      for (const std::string& file : group) files.push_back({file, request_.rig.specs});
    const std::vector<Log> logs = read_csv(files, options);
    for (std::size_t i = 0; i < logs.size(); ++i) take(logs[i], i >= request_.logs.size());
    refuse_held_out_twins(result_.findings.logs);
  }

  void take(const Log& log, bool held_out) {
    FaultList faults(log.file);
    judge_rig_columns(log, request_.rig, subject_, faults);
    if (faults.stops()) throw LogError(faults.all());
    int part = 0;
    for (const sinew::Segment& segment : log.segments) {
      if (segment.samples.rows() < shortest_segment(log.period)) continue;
      Recording r = request_.rig.recording(log, segment, subject_.open());
      r.name = log.segments.size() > 1 ? fmt::format("{} part {}", log.file, ++part) : log.file;
      r.log = log.file;
      subject_.add(std::move(r), held_out);
    }
    for (const ObservedChannel& channel : request_.rig.channels) {
      const int index = log.channel(channel.name);
      const Channel* own = index < 0 ? nullptr : &log.channels[static_cast<std::size_t>(index)];
      columns_[log.file].push_back({channel.name, own ? own->column : 0, own ? own->quantum : 0.0});
    }
    result_.findings.logs.push_back(log_record(log, held_out));
  }

  void prepare() {
    subject_.prepare();
    if (request_.rig.free_zero)
      for (int c = 0; c < subject_.problem().channels; ++c) subject_.add_offset(c);
    if (request_.rig.complete) request_.rig.complete(subject_);
  }

  /// Adopted where the measured gain on held-out logs is positive with its interval.
  void extend(const Explanation& explanation) {
    Findings& f = result_.findings;
    const Design design(subject_.problem(), request_.settings);
    bool any = std::any_of(f.verdict.causes.begin(), f.verdict.causes.end(),
                           [&](const NamedCause& c) { return effect_of(c) >= 0; });
    result_.extended =
        any ? extended_observation(subject_, design, explanation) : request_.identified;
    std::vector<std::string> refused;
    if (const auto why = why_impossible(subject_.observation(), result_.extended)) {
      refused.push_back("what was fitted cannot be adopted: " + *why);
      result_.extended = request_.identified;
      any = false;
    }
    const std::vector<MeasuredChannel> measured =
        measure_observation(subject_, design, result_.extended, request_.rig.free_zero);
    discrepant_ =
        discrepant_channels(subject_.problem(), measured, columns_, request_.rig.free_zero);
    for (int c = 0; c < subject_.problem().channels; ++c)
      f.channels.push_back(channel(
          measured, c, subject_.units()(c) * noise_floor(explanation.selection, design, c)));
    tell_measured(measured, subject_.problem().unlike_channels, any, request_.settings.seed,
                  f.verdict);
    for (const LogRecord& log : f.logs)
      if (!log.held_out && any) result_.extended.logs.push_back({log.file, log.sha256});
    decide_adoption(any, !request_.holdout.empty(), f.verdict.held_out, {"observation"},
                    f.extension);
    if (const auto worse = harmed_channel(measured, subject_.problem().channels, request_.settings))
      withhold(fmt::format("the held-out error of '{}' would grow",
                           request_.rig.channels[static_cast<std::size_t>(*worse)].name),
               f.extension);
    if (!discrepant_.empty())
      withhold(fmt::format("more than half of '{}' is left over: its unit, its sign and its column "
                           "come first",
                           discrepant_.front().channel),
               f.extension);
    add_remarks({}, refused, any, f.extension);
    f.extension.operations_before = observation_operations(subject_, request_.identified);
    f.extension.operations_after = observation_operations(subject_, result_.extended);
  }

  ChannelFinding channel(const std::vector<MeasuredChannel>& measured, int index, double noise) {
    const ObservedChannel& named = request_.rig.channels[static_cast<std::size_t>(index)];
    ChannelFinding finding;
    finding.name = named.name;
    finding.unit = named.unit;
    finding.noise_floor = noise;
    finding.quantum = quantum_of(columns_, index);
    finding.material_share = request_.settings.material_share;
    const bool held_out = judged_on_held_out(measured);
    add_error("sensor", measured, index, request_.settings.seed, finding);
    finding.plots = channel_plots(
        measured, index, held_out,
        {named.name, named.unit, request_.rig.position, request_.rig.position_unit, "N"});
    return finding;
  }

  int effect_of(const NamedCause& cause) const {
    const int candidate = cause.candidate;
    return candidate < 0 ? -1 : subject_.origins()[static_cast<std::size_t>(candidate)].effect;
  }

  void describe_terms() {
    const auto& causes = result_.findings.verdict.causes;
    for (std::size_t c = 0; c < causes.size(); ++c) {
      CauseTerm term;
      term.cause = static_cast<int>(c);
      const int index = effect_of(causes[c]);
      if (index >= 0) {
        const ObservationEffect& effect =
            subject_.observation().effects[static_cast<std::size_t>(index)];
        term.effect = effect.id;
        term.mathml = mathml_equation(effect.left, effect.term);
        term.text = plain_equation(effect.left, effect.term);
        term.signature = effect.signature;
        term.excitation = effect.excitation;
      }
      result_.findings.terms.push_back(std::move(term));
    }
  }

  const ObservedRequest& request_;
  ObservedSubject subject_;
  std::map<std::string, std::vector<LoggedColumn>> columns_;  ///< by file
  std::vector<DataFault> discrepant_;
  Diagnosis result_;
};

}  // namespace

Diagnosis diagnose_observed(const ObservedRequest& request) {
  return ObservedRun(request)();
}

ObservedReplay replay_observed(const ObservedRequest& request) {
  return ObservedRun(request).replay();
}

}  // namespace sinew::diagnosis
