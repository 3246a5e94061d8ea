// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes without a physical name: what a dependence looks like when none of the causes fits it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/regression/candidate.h"

namespace sinew::diagnosis {

/// Ranges the shapes are spread over, for one axis.
struct FlexibleRanges {
  double low = 0.0, high = 1.0;  ///< of the position
  double speed = 1.0;            ///< largest |velocity|
  double load = 0.0;             ///< largest |load|; 0: no load channel
  double duration = 60.0;        ///< s
  double effort = 0.0;           ///< largest |effort| that the model asks for; 0: it asks for none
  int stretches = 1;  ///< read of all logs: what is another in each gets the fewer columns
};

/// Flexible families of one axis (column of the recording's matrices), acting on one channel:
/// cubic B-splines in position, velocity, time, load, way since the last reversal, some of them
/// times the direction; position and velocity together; friction by the recent speed; a sine of any
/// period in position, and a friction that waxes and wanes in time.
std::vector<Candidate> flexible_families(const FlexibleRanges& ranges, int axis = 0,
                                         int channel = 0);

/// Whether it is a sine of any period in position.
bool is_periodic_in_position(const Candidate& family);

/// Values of the model that are none: its effort by any law (B-splines in it), and its effort and
/// what goes with the acceleration by a share that changes over the log (times B-splines in time).
/// Reads the signal "effort".
std::vector<Candidate> varying_values(const FlexibleRanges& ranges, int axis = 0, int channel = 0);

/// Signal of a log, a value a sample.
using LogSignal = std::function<Eigen::VectorXd(const Recording&)>;

/// What depends on `values` alone, by any law: B-splines in them. low < high.
Candidate any_law(const std::string& depends_on, const LogSignal& values, double low, double high,
                  int axis, int channel);

/// Whatever `term` is in a log, by a share that changes over the log: times B-splines in time.
/// `depends_on`: "time x force". duration: of the longest log, s.
Candidate changing_in_time(const std::string& depends_on, const LogSignal& term, double duration,
                           int axis, int channel);

/// Search for a sine over the position: from two periods over the range to what the band shows,
/// in periods per rad or m.
NonlinearParameter visible_periods(const FlexibleRanges& ranges);

/// Decoys of the same axis: a force at one place only, and forces beyond a position. They compete
/// with the named causes: a series of ripples must not stand in for a tight spot.
std::vector<Candidate> local_decoys(const FlexibleRanges& ranges, int axis = 0, int channel = 0);

/// Cubic B-spline basis with `count` functions on [low, high]; constant continuation outside.
Eigen::MatrixXd spline_basis(const Eigen::VectorXd& x, double low, double high, int count);

/// Way since the velocity last changed its sign, samples as given. Speeds below `rest` turn
/// nothing.
Eigen::VectorXd way_since_reversal(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity,
                                   double rest);

/// Of every sample the number of its stroke, from 0: one ends where the velocity has changed its
/// sign. Speeds below `rest` turn nothing.
std::vector<int> stroke_numbers(const Eigen::VectorXd& velocity, double rest);

}  // namespace sinew::diagnosis
