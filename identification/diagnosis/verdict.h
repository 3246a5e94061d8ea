// SPDX-License-Identifier: GPL-3.0-or-later
// What a diagnosis says, and what every statement rests on.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "identification/diagnosis/planned_motion.h"
#include "identification/regression/cross_validation.h"

namespace sinew::diagnosis {

struct ParameterEstimate {
  std::string name, unit;
  double value = 0.0;
  double standard_error = 0.0;  ///< for coloured noise, all parameters free
  std::string log;              ///< a nuisance's log; empty for shared parameters

  /// false: moves nothing in these logs, as a payload's mass at the axis.
  bool is_felt() const { return value != 0.0 || standard_error > 0.0; }
};

/// A candidate that may be the cause.
struct RankedCause {
  int candidate = 0;  ///< index into the library; deviation i of the problem is -1 - i
  std::string name, place;
  double behind = 0.0;  ///< log odds below those of the best: 0 for the best
  double weight = 1.0;  ///< probability among all rivals, sums to at most 1
};

/// What is proposed for a set that cannot be told apart.
struct Separation {
  std::string experiment;               ///< in words; empty: nothing is known
  double expected = 0.0;                ///< standard errors between the first member and the
                                        ///< closest of those ruled out; 0: not known
  std::vector<std::string> rules_out;   ///< members that it would tell from the first
  std::optional<PlannedMotion> motion;  ///< where one was planned
  std::string file;                     ///< the motion's, beside the findings; may be empty
};

/// Instead of a candidate: the cause is no term of a model.
inline constexpr int kNoTerm = std::numeric_limits<int>::max();

/// One cause, or a set that these logs cannot tell apart (best first).
struct NamedCause {
  std::vector<RankedCause> members;
  int candidate = 0;        ///< of the term that the model takes: one of the members, or kNoTerm
  std::vector<int> also;    ///< of more terms that the same name stands for best
  double confidence = 0.0;  ///< that the truth is among the members: confidence.h
  double log_odds = 0.0;    ///< of the first member against nothing in its place
  Gain cross_validated;     ///< of the error on left-out blocks, 95 % interval
  Gain held_out;            ///< on held-out logs; share 0 where none were given
  Gain confirmed;           ///< the same of the whitened error, by which a name is kept
  /// Rms left in the training logs without it / with it, in the channel of the most; of a name that
  /// held-out logs refute.
  double left_without = 1.0;
  bool stands = false;                        ///< though held-out logs cannot tell: confirmation.h
  std::vector<ParameterEstimate> parameters;  ///< of that term
  Separation separation;                      ///< where there is more than one member
};

struct RuledOut {
  std::string name, place, reason;
  double log_odds = 0.0;  ///< on top of the final model, against nothing
};

/// A dependence that no named cause accounts for.
struct Dependence {
  std::string on;  ///< "position x direction", "time, periodically, 12.4 Hz", ...
  std::string place;
  double log_odds = 0.0;  ///< of structure of that form against nothing in its place
  /// Whitened error on the held-out logs; absent: they could not confirm it, since it is of a log's
  /// time or has values of its own in each.
  std::optional<Gain> confirmed = {};
};

struct Unexplained {
  bool none_of_the_known = false;      ///< structure of its own, and no name fits it
  std::vector<Dependence> depends_on;  ///< strongest first
  double named_share = 1.0;            ///< of the log odds of all that was found, what names hold
  /// Cross-validated loss with all named causes, share of what the model at its own values leaves;
  /// 1 at most.
  double remaining = 1.0;
};

/// Training and held-out logs that cannot both be of one model: a cause that is plain in the former
/// and gains nothing sure in the latter, or more left over in the latter.
struct Disagreement {
  std::string name, place;  ///< of the cause; empty: none
  Gain in_training;         ///< of the cause, on left-out blocks
  int channel = -1;         ///< where more is left over
  /// Rms left in the held-out logs / in the training logs, there; of a cause, left in the training
  /// logs without it / with it.
  double ratio = 1.0;
};

struct Verdict {
  std::vector<NamedCause> causes;  ///< largest gain first
  std::vector<Disagreement> disagreements;
  std::vector<RuledOut> ruled_out;
  Unexplained unexplained;
  std::vector<ParameterEstimate> baseline;
  /// rms error / rms of what was measured, of the training logs inside the band. Before: of the
  /// model at its own values, with what is always free fitted (a motor's zero). After: with all
  /// named causes. In findings: by the emitted C (adoption/measure.h), rms error / standard
  /// deviation of what was measured, on the held-out logs where there are any.
  double relative_error_before = 0.0;
  double relative_error_after = 0.0;
  Gain held_out;  ///< of all causes together on the held-out logs; in findings by the emitted C
  /// Where the comparison ends below the band asked for, since a logged position is noise above or
  /// has too few samples a second, the lowest frequency above which a channel is not looked at
  /// [Hz]; 0: nothing is cut.
  double compared_below_hz = 0.0;
  /// The channel in which the held-out logs leave most over beside the training logs, with all
  /// causes in the model; without held-out logs as it stands here.
  Disagreement most_excess;
  bool immaterial = false;  ///< no channel's error before any cause is worth telling
  bool nothing_beyond_noise() const {
    return causes.empty() && !unexplained.none_of_the_known && disagreements.empty();
  }
};

}  // namespace sinew::diagnosis
