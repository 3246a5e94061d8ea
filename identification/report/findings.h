// SPDX-License-Identifier: GPL-3.0-or-later
// Everything a diagnosis found, as plain data: the report and findings.json are made from this
// alone.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "identification/diagnosis/materiality.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// A log that took part.
struct LogRecord {
  std::string file, sha256;
  bool held_out = false;
  long rows = 0;
  double seconds = 0.0;
  double period = 0.0;              ///< s, of the samples that were used
  std::vector<std::string> faults;  ///< "file:row:column: what; what was done"
  std::vector<std::string> notes;   ///< the same, of what is no fault: a column no channel needs
};

/// One curve or cloud of points.
struct Series {
  std::string label;  ///< "measured", "model before", "model after", "noise floor", ...
  std::vector<double> x, y;
  bool points = false;
};

/// A plot of one channel. kind: "time", "velocity", "position", "load", "spectrum", "loop".
struct Plot {
  std::string kind, title, x_label, y_label;  ///< labels with units
  std::string caption;                        ///< one sentence: what to see here
  bool logarithmic = false;                   ///< both axes
  std::vector<Series> series;
};

/// The error in one domain, model before and after, on the held-out logs where there are any (the
/// training logs otherwise), standstill aside. domain: "force" (inverse dynamics), "sensor",
/// "window" (short-window prediction of the motion), "open loop".
struct DomainError {
  std::string domain, unit;
  double before = 0.0, after = 0.0;  ///< rms
  Gain gain;                         ///< of the mean square, 95 % by blocks
};

/// What the model gets wrong on one measured channel, on the logs that DomainError says. The first
/// domain is that of the measured quantity itself.
struct ChannelFinding {
  std::string name, unit;  ///< as in the log, "tau_m", "N*m"
  double measured_rms = 0.0;
  double standard_deviation = 0.0;  ///< of what was measured
  double compared_below_hz = 0.0;
  double compared_share = 0.0;  ///< of its samples: those at which errors count
  double quantum = 0.0;         ///< step of the logged values; 0: none is seen
  double noise_floor = 0.0;     ///< rms that no model can explain
  /// Fraction of the channel's variance that the model does not explain: mean square error /
  /// variance, 1 at most; 0 where there is nothing to explain.
  double unexplained_before = 0.0;
  double unexplained_after = 0.0;
  std::vector<DomainError> domains;

  /// An rms error of the channel in units of its standard deviation; not a number where it has
  /// none.
  double relative(double error) const {
    return standard_deviation > 0.0 ? error / standard_deviation
                                    : std::numeric_limits<double>::quiet_NaN();
  }
  double material_share = Settings{}.material_share;  ///< of the rms: less is not worth telling
  /// The rms error that is worth explaining (diagnosis/materiality.h).
  double material_error() const { return immaterial_error(measured_rms, quantum, material_share); }
  bool nothing_to_explain() const {
    return !domains.empty() && domains.front().before <= material_error();
  }
  std::vector<Plot> plots;  ///< the ones that carry the verdict first
};

/// The symbolic term of a cause.
struct CauseTerm {
  int cause = 0;             ///< index into verdict.causes
  std::string mathml;        ///< <math> element: effort = ...
  std::string text;          ///< the same on one line, plain text
  std::string signature;     ///< what it looks like in the residual
  std::string excitation;    ///< what has to happen for it to be seen
  std::string effect;        ///< identifier in symbolic/effects, as identified.toml has it
  bool compensable = false;  ///< whether the firmware's compensation takes it up
};

/// What became of the model.
struct Extension {
  bool adopted = false;
  bool dry_run = false;
  std::string reason;        ///< why adopted or not, in one sentence without numbers
  std::string model_folder;  ///< where the extended model was written, empty where it was not
  std::vector<std::string> functions;               ///< emitted functions that are new or changed
  int operations_before = 0, operations_after = 0;  ///< of the force model
};

struct Findings {
  std::string model, description, model_hash;
  std::string kind;  ///< "rotary drive", "robot", "finger", "lever", "wrist"
  std::vector<LogRecord> logs;
  std::vector<ChannelFinding> channels;
  Verdict verdict;
  std::vector<CauseTerm> terms;
  Extension extension;
  std::string headline;   ///< one sentence a person understands
  std::string next_step;  ///< what to do now
  double seconds = 0.0;   ///< time the diagnosis took
};

}  // namespace sinew::diagnosis
