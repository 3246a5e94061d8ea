// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/lever_subject.h"

#include <algorithm>
#include <string>

#include "identification/logs/filter.h"
#include "identification/subjects/effect_candidate.h"
#include "identification/subjects/sensor_reading.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double coarse_count = 3.0;  // counts; finer steps are what a 12-bit sensor has

/// Highest frequency of the motion [Hz], at a sampling period [s]: a calibration is drawn slowly,
/// counts are steps.
double calibration_cutoff(double period) {
  return std::min(15.0, 0.1 / period);
}

VectorXd column_of(const Log& log, const sinew::Segment& segment, const std::string& channel) {
  return segment.samples.col(log.channel(channel)).matrix();
}

/// Neither deviations nor state: the force and the elongation of the lever as it should be.
MatrixXd nominal(const ObservedModel& model, const Recording& r, const Observation& observation) {
  Index deviations = 0;
  std::vector<double> shapes;
  for (const ObservationEffect& e : observation.effects) {
    deviations += static_cast<Index>(e.deviations.size());
    for (const ObservationParameter& p : e.shapes) shapes.push_back(p.high);
  }
  return model(r, VectorXd::Zero(deviations),
               VectorXd::Map(shapes.data(), static_cast<Index>(shapes.size())));
}

Recording recording_of(const Log& log, const sinew::Segment& segment, const ObservedModel& model,
                       const Observation& observation, bool with_elongation) {
  Recording r;
  r.step = log.period;
  const Index n = segment.samples.rows();
  r.time = VectorXd::LinSpaced(n, segment.start,
                               segment.start + log.period * static_cast<double>(n - 1));
  r.log_start = log.segments.front().start;
  const double cutoff = calibration_cutoff(log.period);
  add_reading("count", column_of(log, segment, "count"), 1.0, cutoff, r);
  const bool bent = log.channel("bend") >= 0;
  r.signals["bend"] = bent ? column_of(log, segment, "bend") : VectorXd::Zero(n);
  r.target.push_back(column_of(log, segment, "force"));
  if (with_elongation) r.target.push_back(column_of(log, segment, "elongation"));
  const MatrixXd said = nominal(model, r, observation);
  const Motion travel = differentiate(said.col(1), log.period, cutoff);
  r.q = said.col(1);
  r.qd = travel.qd;
  r.qdd = travel.qdd;
  r.load = said.col(0);
  return r;
}

void complete_lever(ObservedSubject& subject, bool with_elongation) {
  const Problem& problem = subject.problem();
  add_coarse_sensor(subject, {"count", "quantisation of the lever sensor", "sensor",
                              calibration_cutoff(problem.training.front().step), coarse_count});
  const LogScale s = scale_of(problem.training, 0);
  for (int channel = 0; channel < (with_elongation ? 2 : 1); ++channel)
    for (Candidate& c :
         flexible_families({s.low, s.high, s.speed, s.load, s.duration}, 0, channel)) {
      c.place = channel == 0 ? "force" : "elongation";
      subject.add_candidate(std::move(c), "");
    }
  const LogSignal force = [](const Recording& log) -> VectorXd { return log.load.col(0); };
  Candidate warming = changing_in_time("time x force", force, s.duration, 0, 0);
  warming.place = "force";
  subject.add_candidate(std::move(warming), "");
}

}  // namespace

ObservedRig lever_rig(const LeverRig& rig, const std::string& model, bool with_elongation) {
  ObservedRig result;
  result.observation = lever_observation(rig, model);
  result.channels = {{"force", "N"}};
  if (with_elongation) result.channels.push_back({"elongation", "m"});
  const auto [low, high] = std::minmax(rig.lever.count_free, rig.lever.count_end);
  result.specs = lever_channels(low, high);
  result.position = "elongation";
  result.position_unit = "m";
  result.recording = [observation = result.observation, with_elongation](
                         const Log& log, const sinew::Segment& segment, const ObservedModel& open) {
    return recording_of(log, segment, open, observation, with_elongation);
  };
  result.complete = [with_elongation](ObservedSubject& s) { complete_lever(s, with_elongation); };
  return result;
}

}  // namespace sinew::diagnosis
