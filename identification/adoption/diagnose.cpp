// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/diagnose.h"
#include "identification/adoption/lines_over_angle.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>

#include "identification/adoption/adopted_fit.h"
#include "identification/adoption/cause_terms.h"
#include "identification/adoption/discrepancy.h"
#include "identification/adoption/ended_early.h"
#include "identification/adoption/extend.h"
#include "identification/adoption/held_out_judgement.h"
#include "identification/adoption/measure.h"
#include "identification/adoption/motion_file.h"
#include "identification/adoption/possible_terms.h"
#include "identification/adoption/prediction.h"
#include "identification/adoption/read_subject.h"
#include "identification/adoption/unquiet_channels.h"
#include "identification/contacts/undisturbed.h"
#include "identification/diagnosis/explanation.h"
#include "identification/diagnosis/sensor_play.h"
#include "identification/diagnosis/separation.h"
#include "identification/likelihood/explain.h"
#include "identification/report/log_record.h"
#include "identification/report/verdict_text.h"
#include "identification/report/wording.h"

namespace sinew::diagnosis {
namespace {

using Clock = std::chrono::steady_clock;

class Run {
 public:
  explicit Run(const DiagnoseRequest& request)
      : request_(request), subject_(empty_subject(request)) {}

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
    for (int c = 0; c < subject_.problem().channels; ++c)
      subject_.set_quantum(c, quantum_of(columns_, c));
    tell("searching for causes", 0.3);
    Explanation explanation;
    const std::string ended = why_ended([&] { explanation = search(); });
    if (!ended.empty()) explanation = {};
    f.verdict = explanation.verdict;
    tell("extending and measuring", 0.9);
    extend_or_measure(explanation);
    describe_terms(subject_, f);
    f.headline = headline(f);
    report_discrepancies(discrepant_, f);
    tell_unquiet_channels(f);
    if (!ended.empty()) tell_ended_search(ended, f);
    if (request_.settings.first_look) tell_first_look(f);
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
    SubjectOfLogs read = read_subject(request_);
    refuse_held_out_twins(read.logs);
    subject_ = std::move(read.subject);
    columns_ = std::move(read.columns);
    torque_constants_ = std::move(read.torque_constants);
    result_.findings.logs = std::move(read.logs);
  }

  Explanation search() {
    Explanation explanation = explain(subject_.problem(), request_.settings);
    std::optional<NamedCause> force;
    if (!request_.settings.first_look) {
      const auto by = [&](const auto& explained) {
        return [&](const DrivenSubject& rest, const std::vector<SlotForm>& beginning) {
          return explained(rest.problem(), request_.settings, beginning);
        };
      };
      force = find_undisturbed({by(explain_roughly), by(explain)}, request_.settings, subject_,
                               explanation);
      look_at_standstills(explanation);
    }
    merge_members(explanation.verdict);
    if (!request_.holdout.empty()) confirm_on_held_out(explanation.verdict);
    propose_experiments(
        subject_.problem(), request_.settings,
        request_.settings.first_look
            ? ExperimentPlanner()
            : [this](int channel) { return subject_.experiments(channel); },
        explanation);
    write_motions(explanation.verdict);
    for (NamedCause& line : lines_beside(subject_, explanation.verdict, request_.settings))
      explanation.verdict.causes.push_back(std::move(line));
    if (force) explanation.verdict.causes.push_back(std::move(*force));
    return explanation;
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
    Explanation other = explain(subject.problem(), request_.settings);
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

  /// What was read is reported whatever becomes of the extension.
  void extend_or_measure(const Explanation& explanation) {
    Findings& f = result_.findings;
    const std::string failed = why_ended([&] { extend(explanation); });
    if (failed.empty()) return;
    f.channels.clear();
    f.extension = {};
    f.extension.reason = "the extended model could not be made and measured: " + failed;
    result_.extended = request_.identified;
    const Design design(subject_.problem(), request_.settings);
    tell_errors(explanation, design, measure(subject_, design, {}, subject_.effort()), false);
  }

  /// What the model is extended by, and how well it does.
  struct Extended {
    ExtensionTerms fitted;
    PossibleTerms possible;
    bool any = false;  ///< some cause has a term
    EffortModel effort;
    std::vector<MeasuredChannel> measured;
  };

  Extended extended_by(const Explanation& explanation, const Design& design,
                       const Selection& fit) const {
    ExtensionTerms fitted;
    if (!fit.model.terms.empty()) fitted = extension_terms(subject_, design, explanation, fit);
    PossibleTerms possible = possible_terms(subject_, fitted.terms);
    const bool any = std::any_of(possible.terms.begin(), possible.terms.end(),
                                 [](const ExtensionTerm& t) { return t.cause >= 0; });
    if (!any) possible.terms.clear();
    EffortModel effort = any ? extended_effort(subject_, possible.terms) : subject_.effort();
    auto measured = measure(subject_, design, possible.terms, effort);
    return {std::move(fitted), std::move(possible), any, std::move(effort), std::move(measured)};
  }

  std::optional<int> harmed(const std::vector<MeasuredChannel>& measured) const {
    return harmed_channel(measured, subject_.problem().channels, request_.settings);
  }

  /// Adopted where the measured gain on held-out logs is positive with its interval, and no joint
  /// is worse for it.
  void extend(const Explanation& explanation) {
    Findings& f = result_.findings;
    const Design design(subject_.problem(), request_.settings);
    AdoptedFit fit;  // of what is told
    if (!f.verdict.immaterial) fit = possible_fit(design, explanation);
    Extended e = extended_by(explanation, design, fit.selection);
    std::optional<int> worse = harmed(e.measured);
    while (worse && leave_out_harmful(design, request_.settings, *worse,
                                      channel_name(subject_, *worse), fit)) {
      e = extended_by(explanation, design, fit.selection);
      worse = harmed(e.measured);
    }
    tell_errors(explanation, design, e.measured, e.any);
    if (!request_.settings.first_look) add_predictions(subject_, e.effort, f.channels);
    result_.extended = extended(request_.identified, e.possible.terms);
    for (const LogRecord& log : f.logs)
      if (!log.held_out) result_.extended.logs.push_back({log.file, log.sha256});
    // Another log fits others, beside which what this one teaches is wrong.
    for (const auto& [joint, constant] : torque_constants_)
      result_.extended.torque_constants[joint] = constant;
    decide_adoption(e.any, !request_.holdout.empty(), f.verdict.held_out, emitted_functions(),
                    f.extension);
    if (worse)
      withhold(fmt::format("the held-out error of '{}' would grow", channel_name(subject_, *worse)),
               f.extension);
    if (!discrepant_.empty())
      withhold(fmt::format("more than half of '{}' is left over, which no part of this model "
                           "explains: its unit, its sign and its column come first",
                           discrepant_.front().channel),
               f.extension);
    std::vector<std::string> refused = std::move(fit.refused);
    refused.insert(refused.end(), e.possible.refused.begin(), e.possible.refused.end());
    add_remarks(e.fitted.changed, refused, e.any, f.extension);
    f.extension.operations_before = subject_.effort().operations();
    f.extension.operations_after = subject_.effort_with(result_.extended).operations();
  }

  /// Errors of every channel, by the emitted C.
  void tell_errors(const Explanation& explanation, const Design& design,
                   const std::vector<MeasuredChannel>& measured, bool any) {
    Findings& f = result_.findings;
    for (int c = 0; c < subject_.problem().channels; ++c)
      f.channels.push_back(channel_finding(subject_, measured, c,
                                           noise_floor(explanation.selection, design, c),
                                           quantum_of(columns_, c), request_.settings));
    tell_measured(measured, subject_.problem().unlike_channels, any, request_.settings.seed,
                  f.verdict);
    discrepant_ = discrepant_channels(subject_.problem(), measured, columns_, false);
    unquiet_ = unquiet_channels(design, explanation.selection);
  }

  /// No known cause was found where noise is not all that is left.
  void tell_unquiet_channels(Findings& f) const {
    std::vector<std::string> names;
    for (const UnquietChannel& u : unquiet_)
      names.push_back(fmt::format("{:.0f} times the sensor's noise at '{}'", u.times_noise,
                                  f.channels[static_cast<std::size_t>(u.channel)].name));
    if (names.empty()) return;
    const std::string what = joined(names, "and") + ", in bursts that no known cause explains";
    if (f.verdict.nothing_beyond_noise()) {
      f.verdict.unexplained.none_of_the_known = true;
      f.headline = "The model leaves " + what + ".";
    } else {
      f.headline += " It leaves " + what + ".";
    }
  }

  std::vector<std::string> emitted_functions() const {
    std::vector<std::string> names{"effort"};
    if (!compensation_function(subject_.model(), result_.extended).outputs.empty())
      names.push_back("compensation");
    return names;
  }

  const DiagnoseRequest& request_;
  DrivenSubject subject_;
  std::map<std::string, std::vector<LoggedColumn>> columns_;  ///< by file
  std::map<std::string, double> torque_constants_;            ///< by joint
  std::vector<DataFault> discrepant_;
  std::vector<UnquietChannel> unquiet_;
  Diagnosis result_;
};

}  // namespace

Diagnosis diagnose(const DiagnoseRequest& request) {
  return Run(request)();
}

}  // namespace sinew::diagnosis
