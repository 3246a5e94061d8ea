// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/sensor_reading.h"

#include <algorithm>
#include <map>

#include "identification/logs/dequantise.h"
#include "identification/logs/filter.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rate of a reading without what its sensor flickers by at rest: every flicker would turn the
/// friction of guides or a play over a little, and so would what a smoother swings over at a stop.
/// Reversals come late by the flicker, a step of the reading where there is none.
VectorXd steady_rate(const VectorXd& reading, double resolution, double step) {
  const double play = resolution + 3.0 * white_noise_rms(reading.array());
  VectorXd rate = VectorXd::Zero(reading.size());
  double steady = reading.size() > 0 ? reading(0) : 0.0;
  for (Index k = 1; k < reading.size(); ++k) {
    const double before = steady;
    steady = std::clamp(steady, reading(k) - play, reading(k) + play);
    rate(k) = (steady - before) / step;
  }
  return rate;
}

}  // namespace

void add_reading(const std::string& name, const VectorXd& reading, double resolution, double cutoff,
                 Recording& recording) {
  recording.signals[name] = reading;
  const VectorXd rate = steady_rate(reading, resolution, recording.step);
  recording.signals[name + "_rate"] = rate;
  recording.signals[name + "_side"] = side_of_play(reading, rate, 0.0, 0.0);
  recording.signals[name + "_speed"] = differentiate(reading, recording.step, cutoff).qd;
}

void add_coarse_sensor(ObservedSubject& subject, const CoarseSensor& sensor) {
  Problem& problem = subject.problem();
  SensorSteps known;
  for (const Recording& log : problem.training) {
    known = sensor_steps(log.signals.at(sensor.reading).col(0));
    if (known.step <= sensor.finest) return;
  }
  // What the model would say more, were the sensor not coarse. The motion between two steps is not
  // causal: the model can hold no such term.
  const std::string key = "change by a coarse " + sensor.reading;
  for (auto* logs : {&problem.training, &problem.holdout})
    for (Recording& log : *logs) {
      const VectorXd reading = log.signals.at(sensor.reading).col(0);
      const SensorSteps own = sensor_steps(reading);
      std::map<std::string, MatrixXd> fine;
      fine[sensor.reading] =
          consistent_motion(reading, own.step > 0.0 ? own : known, log.step, sensor.cutoff);
      log.signals[key] = subject.open()(log, subject.learnt(), subject.shapes(), &fine) -
                         subject.open()(log, subject.learnt(), subject.shapes());
    }
  Candidate c;
  c.name = sensor.name;
  c.place = sensor.place;
  c.linear = {{"share", "1", 0.0, 3.0, false, {}}};
  c.limit_meaning = "its steps would lie between the true values";
  c.isolating_experiment = "a slow motion, the reading against a finer sensor";
  c.columns = [key](const Recording& log, int channel, const VectorXd&) -> MatrixXd {
    return log.signals.at(key).col(channel);
  };
  subject.add_candidate(std::move(c), "sensor_quantisation");
}

}  // namespace sinew::diagnosis
