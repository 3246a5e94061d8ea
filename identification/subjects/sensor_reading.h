// SPDX-License-Identifier: GPL-3.0-or-later
// What a rig's position sensor reads, and what tells a slow, a loose or a coarse one.
#pragma once

#include <string>

#include "identification/subjects/observed_subject.h"

namespace sinew::diagnosis {

/// Signals of a recording, samples x 1: `name` (the reading), `name`_rate (without what the sensor
/// flickers by while it rests) and `name`_speed (its smooth derivative, below `cutoff`, Hz), both
/// in the reading's unit a second, and `name`_side (which end of a play it is at, side_of_play()).
/// `resolution`: of the reading, 0 where it is unknown; step: s.
void add_reading(const std::string& name, const Eigen::VectorXd& reading, double resolution,
                 double cutoff, Recording& recording);

/// A sensor with steps as a cause that no model can hold.
struct CoarseSensor {
  std::string reading;      ///< the signal
  std::string name, place;  ///< as a report says it
  double cutoff = 0.0;      ///< of the motion [Hz]
  double finest = 0.0;      ///< in the reading's unit; no finer steps are told
};

/// Adds it to the library where all training logs have steps above the finest. After prepare().
void add_coarse_sensor(ObservedSubject& subject, const CoarseSensor& sensor);

}  // namespace sinew::diagnosis
