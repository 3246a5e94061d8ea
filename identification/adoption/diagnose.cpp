// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "identification/adoption/discrepancy.h"
#include "identification/adoption/extend.h"
#include "identification/adoption/held_out_judgement.h"
#include "identification/adoption/measure.h"
#include "identification/adoption/motion_file.h"
#include "identification/adoption/possible_terms.h"
#include "identification/adoption/prediction.h"
#include "identification/diagnosis/explain.h"
#include "identification/diagnosis/sensor_play.h"
#include "identification/logs/read_csv.h"
#include "identification/report/log_record.h"
#include "identification/report/verdict_text.h"
#include "identification/subjects/effort_consistency.h"
#include "identification/subjects/lone_consistency.h"
#include "identification/subjects/tendon_consistency.h"
#include "symbolic/effects/effects.h"
#include "symbolic/notation/print_mathml.h"

namespace sinew::diagnosis {
namespace {

using Clock = std::chrono::steady_clock;

class Run {
 public:
  explicit Run(const DiagnoseRequest& request)
      : request_(request),
        subject_(request.model, request.identified, request.runtime,
                 request.mechanism
                     ? std::make_shared<const RigidColumns>(*request.mechanism, request.runtime)
                     : nullptr) {}

  Diagnosis operator()() {
    const auto start = Clock::now();
    Findings& f = result_.findings;
    f.model = request_.name;
    f.description = request_.description;
    f.model_hash = request_.hash;
    f.kind = request_.kind;
    read();
    tell("comparing with the model", 0.2);
    subject_.prepare(request_.settings);
    tell("searching for causes", 0.3);
    Explanation explanation = explain_subject(subject_);
    look_at_standstills(explanation);
    merge_members(explanation.verdict);
    remove_nuisances(explanation.verdict);
    if (!request_.holdout.empty()) confirm_on_held_out(explanation.verdict);
    write_motions(explanation.verdict);
    f.verdict = explanation.verdict;
    tell("extending and measuring", 0.9);
    extend(explanation);
    describe_terms(explanation.verdict);
    f.headline = headline(f);
    report_discrepancies(discrepant_, f);
    f.next_step = next_step(f);
    f.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return std::move(result_);
  }

 private:
  void tell(const std::string& step, double share) const {
    if (request_.progress) request_.progress(step, share);
  }

  void read() {
    tell("reading the logs", 0.0);
    std::vector<LogFile> files;
    std::vector<DrivenChannels> channels;
    ReadOptions options;
    options.map = request_.map;
    options.max_values = diagnosis_values(request_.logs.size() + request_.holdout.size());
    for (const std::vector<std::string>& group : {request_.logs, request_.holdout})
      for (const std::string& file : group) {
        channels.push_back(request_.channels(file));
        files.push_back({file, channels.back().specs});
        options.max_rate = channels.back().forces.empty() ? kDiagnosisRate : kTendonRate;
      }
    const std::vector<Log> logs = read_csv(files, options);
    for (std::size_t i = 0; i < logs.size(); ++i)
      take(logs[i], channels[i], i >= request_.logs.size());
    refuse_held_out_twins(result_.findings.logs);
    LogRecord& first = result_.findings.logs.front();
    for (const std::string& note : request_.notes) first.faults.push_back(first.file + ": " + note);
  }

  void take(const Log& log, const DrivenChannels& channels, bool held_out) {
    const auto found = [&](const std::vector<std::string>& names) {
      std::vector<int> columns;
      for (const std::string& name : names) columns.push_back(log.channel(name));
      return columns;
    };
    const DrivenColumns columns{found(channels.positions), found(channels.efforts),
                                found(channels.forces),
                                channels.load.empty() ? -1 : log.channel(channels.load)};
    subject_.add_log(log, columns, held_out);
    columns_[log.file] = judged_columns(log, columns);
    result_.findings.logs.push_back(log_record(log, held_out));
    for (const DataFault& doubt : check_columns(log, columns, held_out))
      result_.findings.logs.back().faults.push_back(message(doubt));
  }

  /// What each channel of the problem is measured by: forces of tendons stand for their joints.
  static std::vector<LoggedColumn> judged_columns(const Log& log, const DrivenColumns& columns) {
    std::vector<LoggedColumn> judged;
    const auto add = [&](int index, const std::string& whole) {
      const Channel& channel = log.channels[static_cast<std::size_t>(index)];
      judged.push_back({whole.empty() ? channel.name : whole, channel.column});
    };
    const std::size_t joints = columns.positions.size() - columns.efforts.size();
    for (std::size_t j = 0; j < joints; ++j)
      add(columns.forces.front(),
          "the forces' torque at " +
              log.channels[static_cast<std::size_t>(columns.positions[j])].name);
    for (const int effort : columns.efforts) add(effort, {});
    return judged;
  }

  /// The model tells exchanged columns and wrong signs of coupled joints from what they lack.
  /// Throws LogError where going on is not safe, and gives what is doubtful.
  std::vector<DataFault> check_columns(const Log& log, const DrivenColumns& columns,
                                       bool held_out) const {
    const Recording* longest = nullptr;
    for (const Recording& r : held_out ? subject_.problem().holdout : subject_.problem().training)
      if (r.name.starts_with(log.file) && (!longest || r.time.size() > longest->time.size()))
        longest = &r;
    if (!longest) return {};
    FaultList faults(log.file);
    const DrivenModel& model = request_.model;
    if (!model.tendons.names.empty()) {
      judge_tendons(log, columns, *longest, model, subject_.effort(), request_.runtime, faults);
    } else {
      judge_efforts(log, columns, *longest, subject_.effort(), faults);
      judge_lone_effort(log, columns, *longest, subject_.effort(), model.joints.front(), faults);
    }
    if (faults.stops()) throw LogError(faults.all());
    return faults.all();
  }

  Explanation explain_subject(const DrivenSubject& subject) const {
    std::map<int, std::vector<PlannedExperiment>> planned;
    return explain(subject.problem(), request_.settings,
                   [&](int channel) -> const std::vector<PlannedExperiment>& {
                     const auto [at, is_new] = planned.try_emplace(channel);
                     if (is_new) at->second = subject.experiments(channel);
                     return at->second;
                   });
  }

  /// Motions that would settle what is told as a set, as files.
  void write_motions(Verdict& verdict) {
    const DrivenChannels channels = request_.channels(request_.logs.front());
    for (NamedCause& cause : verdict.causes) {
      if (cause.members.size() < 2 || !cause.separation.motion) continue;
      cause.separation.file = fmt::format("experiment_{}.csv", result_.experiments.size() + 1);
      result_.experiments[cause.separation.file] = motion_text(*cause.separation.motion, channels);
    }
  }

  /// A sensor with play stands still behind every reversal. So does a joint that sticks, but it
  /// hides less than a few steps of its sensor, and a play explains little of it.
  void look_at_standstills(Explanation& explanation) {
    constexpr double kSteps = 3.0, kShare = 0.5;
    std::vector<int> named;
    for (const NamedCause& cause : explanation.verdict.causes) named.push_back(cause.candidate);
    DrivenSubject subject = subject_;
    subject.look_at_standstills(named);
    std::vector<int> plays;
    const std::vector<CandidateOrigin>& origins = subject.library_origins();
    for (std::size_t i = 0; i < origins.size(); ++i)
      if (origins[i].effect == "sensor_hysteresis") plays.push_back(static_cast<int>(i));
    if (!may_have_play(Design(subject.problem(), request_.settings), explanation.selection.model,
                       plays))
      return;
    Explanation other = explain_subject(subject);
    const auto is_play = [&](const NamedCause& cause) {
      if (cause.candidate < 0) return false;
      const CandidateOrigin& origin =
          subject.library_origins()[static_cast<std::size_t>(cause.candidate)];
      return origin.effect == "sensor_hysteresis" && cause.cross_validated.share > kShare &&
             cause.parameters.front().value > kSteps * subject.position_step(origin.joint);
    };
    const auto& causes = other.verdict.causes;
    if (std::none_of(causes.begin(), causes.end(), is_play)) return;
    // The other explanation points into that subject's library, which moves along.
    subject_ = std::move(subject);
    explanation = std::move(other);
  }

  /// Adopted where the measured gain on held-out logs is positive with its interval.
  void extend(const Explanation& explanation) {
    Findings& f = result_.findings;
    const Design design(subject_.problem(), request_.settings);
    const ExtensionTerms fitted = extension_terms(subject_, design, explanation);
    const PossibleTerms possible = possible_terms(subject_, fitted.terms);
    const std::vector<ExtensionTerm>& terms = possible.terms;
    const bool any = std::any_of(terms.begin(), terms.end(),
                                 [](const ExtensionTerm& t) { return t.cause >= 0; });
    const std::vector<ExtensionTerm> adding = any ? terms : std::vector<ExtensionTerm>{};
    const EffortModel after = extended_effort(subject_, adding);
    const std::vector<MeasuredChannel> measured = measure(subject_, design, adding, after);
    for (int c = 0; c < subject_.problem().channels; ++c)
      f.channels.push_back(
          channel_finding(subject_, measured, c, noise_floor(explanation.selection, design, c)));
    discrepant_ = discrepant_channels(subject_.problem(), measured, columns_, false);
    add_predictions(subject_, after, f.channels);
    result_.extended = extended(request_.identified, terms);
    for (const LogRecord& log : f.logs)
      if (!log.held_out) result_.extended.logs.push_back({log.file, log.sha256});
    decide_adoption(any, !request_.holdout.empty(),
                    measured_gain(measured, -1, true, 12, request_.settings.seed),
                    emitted_functions(), f.extension);
    add_remarks(fitted.changed, possible.refused, any, f.extension);
    f.extension.operations_before = subject_.effort().operations();
    f.extension.operations_after = subject_.effort_with(result_.extended).operations();
  }

  std::vector<std::string> emitted_functions() const {
    std::vector<std::string> names{"effort"};
    if (!compensation_function(subject_.model(), result_.extended).outputs.empty())
      names.push_back("compensation");
    return names;
  }

  /// Every encoder has steps and every sensor noise, which the acceleration makes large. Steps are
  /// a cause where they are no finer than a good encoder's and make a good part of what all other
  /// causes leave over; noise is none. What
  /// it leaves of itself passes for effects of fast motion at its place: they have to be larger.
  void remove_nuisances(Verdict& verdict) const {
    constexpr double good_part = 0.2, fast_part = 0.08;
    const auto is_noise = [&](const NamedCause& cause) {
      const std::string origin = origin_of(cause.candidate);
      return origin == "sensor_noise" || origin == "sensor_quantisation";
    };
    const auto is_always_there = [&](const NamedCause& cause) {
      return cause.candidate >= 0 &&
             subject_.problem().library[static_cast<std::size_t>(cause.candidate)].nuisance;
    };
    const auto is_fast = [&](const NamedCause& cause) {
      const std::string& name = cause.members.front().name;
      return name == find_effect("gear_elasticity").name ||
             name == find_effect("inertial_backlash").name;
    };
    std::set<std::string> noisy;
    for (const NamedCause& cause : verdict.causes)
      if (is_noise(cause)) noisy.insert(cause.members.front().place);
    const auto nuisance = [&](const NamedCause& cause) {
      const double share = cause.cross_validated.share;
      if (is_noise(cause)) return share < good_part || is_always_there(cause);
      return is_fast(cause) && share < fast_part && noisy.count(cause.members.front().place) == 1;
    };
    for (const NamedCause& cause : verdict.causes)
      if (nuisance(cause))
        verdict.ruled_out.push_back({cause.members.front().name, cause.members.front().place,
                                     "no more than the position's noise, as in every measurement",
                                     cause.statistic, cause.p_family});
    std::erase_if(verdict.causes, nuisance);
  }

  void describe_terms(const Verdict& verdict) {
    for (std::size_t c = 0; c < verdict.causes.size(); ++c) {
      const int candidate = verdict.causes[c].candidate;
      const std::string id = origin_of(candidate);
      CauseTerm term;
      term.cause = static_cast<int>(c);
      term.effect = id;
      fill_term(id, term);
      result_.findings.terms.push_back(std::move(term));
    }
  }

  std::string origin_of(int candidate) const {
    if (candidate >= 0)
      return subject_.library_origins()[static_cast<std::size_t>(candidate)].effect;
    return subject_.deviation_origin(-1 - candidate).effect;
  }

  static void fill_term(const std::string& id, CauseTerm& term) {
    for (const Effect& effect : effects()) {
      if (effect.id != id) continue;
      term.mathml = mathml_equation("effort", effort(effect));
      term.text = plain_equation("effort", effort(effect));
      term.signature = effect.signature;
      term.excitation = effect.excitation;
      term.compensable = effect.compensable;
      return;
    }
    describe_model_term(id, term);
  }

  const DiagnoseRequest& request_;
  DrivenSubject subject_;
  std::map<std::string, std::vector<LoggedColumn>> columns_;  ///< by file
  std::vector<DataFault> discrepant_;
  Diagnosis result_;
};

}  // namespace

Diagnosis diagnose(const DiagnoseRequest& request) {
  return Run(request)();
}

}  // namespace sinew::diagnosis
