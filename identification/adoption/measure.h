// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a model on logs, through its emitted C: before and after an extension.
#pragma once

#include <optional>
#include <vector>

#include "identification/adoption/extend.h"
#include "identification/regression/cross_validation.h"
#include "identification/report/findings.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// One channel of one recording at the band-limited instants.
struct MeasuredChannel {
  int recording = 0;  ///< training logs first, then held-out ones
  int channel = 0;
  bool held_out = false;
  Eigen::VectorXd time, position, velocity, load;  ///< load empty where there is none
  Eigen::VectorXd measured, before, after;         ///< effort, all behind the same filter
  double step = 0.0;                               ///< s
  double band_hz = 0.0;                            ///< what is below is compared
  Eigen::VectorXd counts;  ///< 1, and 0 at standstill (Design::window); empty: all count
};

/// The emitted effort with the terms that hold for every log.
EffortModel extended_effort(const DrivenSubject& subject, std::vector<ExtensionTerm> terms);

/// Runs the emitted effort of the model as it was and of the extended one, `after`, over every log.
/// Coefficients that differ from log to log are fitted on the other half of the log they are judged
/// on.
std::vector<MeasuredChannel> measure(const DrivenSubject& subject, const Design& design,
                                     const std::vector<ExtensionTerm>& terms,
                                     const EffortModel& after);

/// The logs that errors and gains are told of: held-out ones where there are any.
bool judged_on_held_out(const std::vector<MeasuredChannel>& measured);

/// Whether what the extended model leaves of a channel is more than that share of what is measured.
bool leaves_more_than(double share, const std::vector<MeasuredChannel>& measured, int channel);

/// For how long [s] a channel's errors count in the logs that they are told of.
double judged_seconds(const std::vector<MeasuredChannel>& measured, int channel);

/// Gain of the mean square, standstill aside, on the logs judged on, with its interval from twelve
/// blocks of each. channel = -1: of all, each in units of what is left of it at best.
Gain measured_gain(const std::vector<MeasuredChannel>& measured, int channel, unsigned seed);

/// A channel of the held-out logs of which the extended model leaves surely more over, the first
/// of `channels`; none without held-out logs.
std::optional<int> harmed_channel(const std::vector<MeasuredChannel>& measured, int channels,
                                  const Settings& settings);

/// Puts errors and gain of all channels together, as measured, into a verdict: whatever is told of
/// them is told from there. A lone cause that the extension holds gains what all gain. `unlike`:
/// channels of different quantities, each in units of its own variance.
void tell_measured(const std::vector<MeasuredChannel>& measured, bool unlike, bool extended,
                   unsigned seed, Verdict& verdict);

/// rms of the noise that is left in the band, from the noise model of the final selection.
double noise_floor(const Selection& selection, const Design& design, int channel);

/// Adds the first domain's error of one channel and what is unexplained of it. The finding knows
/// its unit and its quantum.
void add_error(const std::string& domain, const std::vector<MeasuredChannel>& measured, int channel,
               unsigned seed, ChannelFinding& finding);

/// "tau_m" of a lone drive, else "effort of <joint>".
std::string channel_name(const DrivenSubject& subject, int channel);

/// The error in the force domain and the plots of one channel, which the logs write in steps of
/// `quantum`.
ChannelFinding channel_finding(const DrivenSubject& subject,
                               const std::vector<MeasuredChannel>& measured, int channel,
                               double noise_floor, double quantum, const Settings& settings);

}  // namespace sinew::diagnosis
