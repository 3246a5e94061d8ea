// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine is given: uniformly sampled recordings, and physical groups that may explain
// what a baseline leaves over.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "identification/regression/signals.h"

namespace sinew::diagnosis {

/// A stretch of a log's time [s], for instance one in which a joint rests.
struct Standstill {
  double from = 0.0, to = 0.0;
};

/// One log, uniformly sampled. Matrices are samples x axes; unused ones stay empty. SI units.
struct Recording {
  std::string name;
  std::string log;       ///< the log of which this is a stretch; empty: none other is of it
  double step = 0.0;     ///< s
  Eigen::VectorXd time;  ///< s, of the log's own clock
  /// s: where the log begins of which this is a stretch; none: it is the whole log.
  std::optional<double> log_start;
  Eigen::MatrixXd q, qd, qdd;      ///< motion, from differentiate() in filter.h or measured
  Eigen::MatrixXd command;         ///< drive command
  Eigen::MatrixXd load;            ///< load on each axis, for instance tendon force
  Eigen::MatrixXd temperature;     ///< deg C
  Eigen::VectorXd payload;         ///< mass [kg] of a load that is known to be carried; empty: none
  Eigen::MatrixXd payload_effort;  ///< what it asks of the joints: samples x joints; empty: none
  Signals signals;                 ///< anything else a candidate wants
  std::map<std::string, std::shared_ptr<const Eigen::MatrixXd>> wide_signals;
  std::vector<Eigen::VectorXd> target;  ///< per channel: what is measured, force domain
  /// Per channel: what the model under test says of the target; empty: nothing. It is subtracted,
  /// at the model's time, and moves with a delay as every other term does.
  std::vector<Eigen::VectorXd> known;
  /// Per channel, or empty: nothing is told from what is measured there (standstill.h).
  std::vector<std::vector<Standstill>> standstills;
  /// While something pushes that no log has: nothing is told from any channel (contacts/).
  std::vector<Standstill> disturbed;
  /// Per channel, or empty: highest frequency [Hz] at which anything is told from it.
  std::vector<double> band_hz;

  /// What grows with time in a log grows on from stretch to stretch.
  double started() const { return log_start.value_or(time(0)); }

  /// As effects see it: qdd, or the signal "acceleration" where qdd is partly a sensor's noise.
  const Eigen::MatrixXd& acceleration() const {
    const Eigen::MatrixXd* seen = signals.find("acceleration");
    return seen ? *seen : qdd;
  }
};

/// A nonlinear parameter: its bounds are physical limits, its grid starts the search.
struct NonlinearParameter {
  std::string name, unit;
  double low = 0.0, high = 1.0;
  int grid = 5;             ///< starting points between the bounds
  bool logarithmic = true;  ///< spacing of the starting points; needs low > 0

  /// The whole range, and a step of the grid, in the parameter's unit as they are at a value.
  double width_at(double value) const {
    if (!(high > low)) return 0.0;
    return logarithmic ? value * std::log(high / low) : high - low;
  }
  double step_at(double value) const { return width_at(value) / std::max(1, grid - 1); }
};

/// A linear coefficient. An estimate beyond low or high is not this effect.
struct LinearParameter {
  std::string name, unit;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool per_log = false;  ///< a nuisance such as a ripple's phase: one value for each log
  /// Baseline terms only: the value the model under test uses, in so far as it is not in `known`.
  std::optional<double> nominal;
  /// Standard deviation of what it is before any log was seen, about 0; 0: nothing is known of it.
  double spread = 0.0;
  bool per_stretch = false;  ///< where per_log: one for each stretch that is read of a log
  double share = 1.0;        ///< how large it is expected to be beside the candidate's first one
  /// The same in the parameters' units: at most so many times the first one.
  double times_first = std::numeric_limits<double>::infinity();
};

enum class CandidateKind {
  named,     ///< a physical cause
  decoy,     ///< must not win; where it does, the structure is real but none of the named causes
  flexible,  ///< a spline or periodic family without a physical name
  delay      ///< shifts the model's time against the target; columns come from the engine
};

/// Regressor columns (samples x coefficients) of one channel at the given nonlinear parameters;
/// a matrix without columns where the effect does not act on that channel.
using ColumnFunction =
    std::function<Eigen::MatrixXd(const Recording&, int channel, const Eigen::VectorXd& nonlinear)>;

/// A physical group: one name, one place, its parameters and limits.
struct Candidate {
  std::string name;   ///< "viscous asymmetry"
  std::string place;  ///< "motor", "joint 2", "tendon 3"
  CandidateKind kind = CandidateKind::named;
  std::vector<NonlinearParameter> nonlinear;
  std::vector<LinearParameter> linear;
  ColumnFunction columns;
  /// Not proportional to its one coefficient: the columns are a secant to a size of it, which
  /// refine() makes the coefficient itself; without nonlinear parameters, the tangent. Size of the
  /// secant that the search knows beside the tangent; 0: in proportion.
  double secant = 0.0;
  bool unlikely = false;        ///< named only where no other cause explains as much
  bool of_all_places = false;   ///< one law, with one coefficient, at all places of one make
  bool of_body = false;         ///< parameters of a body
  bool of_sensor = false;       ///< how a sensor reads the machine, and no value of it
  bool has_model_form = false;  ///< its columns are the mechanism's own, unlike a friction law's
  bool is_value = false;        ///< no law's form, though its columns are made of what is measured
  bool sized_twice = false;  ///< its one coefficient and its first nonlinear parameter are one size
  bool of_its_time = false;  ///< says what was at some time of a log, which no other log confirms
  bool nuisance = false;     ///< is in every measurement: fitted, and no name for what is wrong
  /// false: a fit with these coefficients and nonlinear parameters is not this effect; may be
  /// empty.
  std::function<bool(const Eigen::VectorXd& coefficients, const Eigen::VectorXd& nonlinear)>
      possible;
  /// The coefficients are mass, first moments and moments of inertia (xx, yy, zz, xy, xz, yz) of a
  /// body within this reach [m] of its frame; such a body has to exist.
  std::optional<double> body_within;
  std::vector<int> channels;  ///< where it acts; empty: asked for every channel
  std::string limit_meaning;  ///< what a violated limit says, for the ruled-out list
  std::string depends_on;     ///< flexible and decoy: "position x direction", "velocity", ...
  std::string isolating_experiment;  ///< the experiment that shows this effect alone
};

/// One parameter of a parameter deviation. It moves baseline coefficients, each by `amount` per
/// unit of the parameter; a coefficient that is simply free has one share of amount 1. Limits are
/// those of the change, not of the whole value.
struct DeviationParameter {
  std::string name, unit;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  struct Share {
    int term = 0;         ///< index into Problem::baseline
    int coefficient = 0;  ///< index into that term's linear parameters; not one per log
    double amount = 1.0;
  };
  std::vector<Share> shares;
  ColumnFunction also;  ///< one column that no baseline coefficient has; may be empty
  double spread = 0.0;  ///< as a linear parameter's
};

/// A value of the model itself that differs from its nominal value: "viscous level", "inertia",
/// "torque constant" (one parameter that scales every nominal value). A baseline coefficient that
/// some deviation moves stays at its nominal value unless a deviation is named; all others are
/// always free and never named.
struct ParameterDeviation {
  std::string name, place;
  std::vector<DeviationParameter> parameters;
  std::string limit_meaning;
  std::string isolating_experiment;
  /// Channels at which its one parameter [s] delays what the nominal model says, against nothing
  /// else; absent: it delays nothing.
  std::optional<std::vector<int>> delayed;
  bool unlikely = false;                   ///< as a candidate's
  std::optional<double> body_within = {};  ///< as a candidate's, of mass and first moments
  bool of_body = false;                    ///< as a candidate's
  bool of_sensor = false;                  ///< as a candidate's
};

/// Everything one diagnosis works on. The baseline's coefficients are re-fitted with every cause.
struct Problem {
  std::vector<Recording> training, holdout;
  std::vector<Candidate> baseline;
  std::vector<Candidate> library;
  int channels = 1;
  /// Of each channel the group whose targets are made of the same measured forces, noise and all:
  /// their errors are counted together, in the targets' unit, and not each channel's by itself.
  /// Empty: each channel is a group of its own.
  std::vector<int> noise_groups;
  /// Channels measure different things (a force, an angle): each counts by its own size.
  bool unlike_channels = false;
  std::vector<ParameterDeviation>
      deviations;  ///< may be empty: then the baseline has no nominal values
  /// Of each channel the step of its logged values, in the targets' unit; 0: none is seen. May be
  /// empty.
  std::vector<double> quantum;
};

/// The channels whose errors are counted together with that one's.
std::vector<int> noise_group(const Problem& problem, int channel);

/// Signal with the model's effort of the logged motion, where the recording is as it was logged: of
/// one that was thinned the filtered effort is no effort of its motion.
inline constexpr const char* effort_of_logged_motion = "effort_of_logged_motion";

/// How the search is done; its own constants: likelihood/decision_constants.h.
struct Settings {
  double band_hz = 0.0;           ///< highest frequency looked at; 0: chosen from the sampling rate
  double edge_s = 0.0;            ///< left away at both ends of every log
  double significance = 0.003;    ///< probability that as plain a push is chance (contacts/)
  double least_share = 0.02;      ///< of what is left over: less is not worth a push's name
  double material_share = 0.001;  ///< of a channel's rms: an error below is not worth telling
  int blocks = 12;
  int most_causes = 8;  ///< or five a channel, where that is more
  unsigned seed = 1;
  /// A part of the samples at a lower rate, no planned motions: an answer in seconds. Nothing is
  /// adopted.
  bool first_look = false;
  bool every_sample = false;  ///< standstills and what is disturbed count as the rest does
};

}  // namespace sinew::diagnosis
