// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences and names that the page, the terminal and the headline share: each stands here once.
// Plain text, UTF-8.
#pragma once

#include <string>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// "a, b and c" for the last word "and".
std::string joined(const std::vector<std::string>& items, const std::string& last);

/// Names of all members: "payload or torque gain". Members that differ by place alone:
/// "friction (tendon 1 or tendon 2)".
std::string title_of(const NamedCause& cause);

/// The place of all members where it is one and the same, otherwise empty.
std::string place_of(const NamedCause& cause);

/// Title and place: "friction concave in speed (motor)".
std::string cause_text(const NamedCause& cause);

/// The gain told of a cause: on held-out logs where there are any, cross-validated otherwise.
const Gain& gain_of(const Findings& findings, const NamedCause& cause);

/// What that gain is called: "held-out gain" where it is that of the whole extension, "held-out
/// gain beside the other causes" where there are others, "held-out gain if corrected" where the
/// extension does not hold the cause, "cross-validated gain" without held-out logs.
std::string gain_name(const Findings& findings, const NamedCause& cause);

/// What the gain of the extended model is called: "held-out gain", or "gain on the training logs".
std::string extension_gain_name(const Findings& findings);

/// Whether no channel's error is worth explaining.
bool nothing_to_explain(const Findings& findings);

/// Channel by channel its relative error before and, where a cause was named, after; empty of a
/// lone channel.
struct ChannelErrors {
  std::string channel;
  std::string before, after;  ///< "12.3 %"; after: empty without a cause
};
std::vector<ChannelErrors> channel_errors(const Findings& findings);

/// Whether a log was held out.
bool has_held_out(const Findings& findings);

/// The logs that errors are told of: "the held-out log", "the held-out logs" or "the training
/// logs".
std::string judged_logs(const Findings& findings);

/// What a parameter is called beside its cause: "bend", or the cause's own name for the change of
/// the gain that it stands for ("pulley radius").
std::string parameter_label(const NamedCause& cause, const ParameterEstimate& parameter);

/// Value ± standard error with unit; changes and shares without a unit in percent.
std::string shown_parameter(const ParameterEstimate& parameter);

/// What a confidence is, and how high it may be.
std::string confidence_meaning();

/// "These logs cannot tell payload from torque gain." with the experiment, empty for a single
/// member.
std::string separation_of(const NamedCause& cause);

/// What became of the model, without a full stop.
std::string extension_state(const Extension& extension);

/// All faults, or all notes, of all logs.
std::vector<std::string> faults_of(const Findings& findings);
std::vector<std::string> notes_of(const Findings& findings);

/// The headline, or the one that the verdict gives where there is none.
std::string headline_of(const Findings& findings);

/// One sentence about the residual of the named causes.
std::string leftover_of(const Verdict& verdict);

/// "position x direction" with a multiplication sign, and its place.
std::string dependence_text(const Dependence& dependence);

/// With a full stop at the end.
std::string sentence(std::string text);

/// "1 log", "3 logs".
std::string counted(std::size_t count, const std::string& one, const std::string& many);

}  // namespace sinew::diagnosis
