// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/prediction.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "identification/regression/cross_validation.h"
#include "identification/regression/position_noise.h"
#include "simulation/plant/driven_plant.h"
#include "simulation/plant/integrate.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kParts = 12;

VectorXd row_of(const MatrixXd& values, Index sample) {
  return values.rows() > 0 ? VectorXd(values.row(sample).transpose()) : VectorXd();
}

/// A plant under the measured efforts of a log, moved by the simulation's fixed steps.
class Predicted {
 public:
  Predicted(Plant& plant, const Recording& log)
      : log_(log),
        motion_(motion_as_read(log)),
        time_(log.time.array() - log.started()),
        drives_(plant.drives()),
        plant_(plant) {
    drives_.forget();
    plant_.set_past(drives_.past());
  }

  /// What effects remember when the log gets to a sample after the other, along its own motion.
  void follow(Index sample) {
    if (!drives_.needs_steps()) return;
    for (; followed_ < sample; ++followed_) {
      DrivenInstant now{time_(followed_),
                        log_.step,
                        row_of(motion_.q, followed_),
                        row_of(motion_.qd, followed_),
                        {},
                        row_of(log_.load, followed_),
                        {}};
      now.tension = tensions(followed_);
      drives_.remember(now, row_of(motion_.qdd, followed_));
    }
    plant_.set_past(drives_.past());
  }

  /// From the measured state at a sample on: squared deviation from the measured position at each
  /// later one.
  void run(Index from, Index steps, const std::function<void(Index, const VectorXd&)>& at) {
    VectorXd state = plant_.initial_state();
    state.head(log_.q.cols()) = row_of(motion_.q, from);
    state.segment(state.size() / 2, log_.q.cols()) = row_of(motion_.qd, from);
    Index sample = from;
    integrate_stretch(plant_, time_(from), state, steps, [&](double, const double* y) {
      ++sample;
      const Eigen::Map<const VectorXd> q(y, log_.q.cols());
      at(sample, (q - row_of(motion_.q, sample)).array().square().matrix());
    });
  }

 private:
  VectorXd tensions(Index sample) const {
    const MatrixXd* found = log_.signals.find("tension");
    return found ? row_of(*found, sample) : VectorXd();
  }

  const Recording& log_;
  Motion motion_;
  VectorXd time_;  ///< s, since the log's start
  Drives drives_;
  Plant& plant_;
  Index followed_ = 0;
};

std::vector<double> listed(const VectorXd& values) {
  return {values.begin(), values.end()};
}

/// The log's efforts as commands of a driven_plant(), without what a known payload takes of them.
Plant plant_of(const Drives& drives, const Recording& log) {
  Scenario scenario;
  scenario.file = log.name;
  scenario.step = log.step;
  const std::vector<double> time = listed(log.time.array() - log.started());
  const auto add = [&](const std::string& channel, const VectorXd& values) {
    scenario.commands[channel].add(SampledSignal{time, listed(values)});
  };
  std::vector<std::string> names;
  for (Index j = 0; j < log.q.cols(); ++j) {
    names.push_back(std::to_string(j));
    VectorXd effort = log.target[static_cast<std::size_t>(j)];
    if (log.payload_effort.size() > 0) effort -= log.payload_effort.col(j);
    add("tau_" + names.back(), effort);
    if (log.load.size() > 0) add("load_" + names.back(), log.load.col(j));
  }
  if (const MatrixXd* found = log.signals.find("tension"))
    for (Index t = 0; t < found->cols(); ++t)
      add("tension_" + std::to_string(t + 1), found->col(t));
  return driven_plant(drives, names, scenario);
}

/// A run that leaves all bounds ends.
void run_or_leave(Predicted& predicted, Index from, Index steps,
                  const std::function<void(Index, const VectorXd&)>& at,
                  const std::function<void()>& left) {
  try {
    predicted.run(from, steps, at);
  } catch (const std::runtime_error&) {
    left();
  }
}

/// Infinite where a prediction has left all bounds.
VectorXd bounded(const VectorXd& squares) {
  return squares.unaryExpr(
      [](double x) { return std::isfinite(x) ? x : std::numeric_limits<double>::infinity(); });
}

using Errors = std::function<StretchErrors(Plant&, const Recording&)>;

/// Drives are derived symbolically, which no two threads may do at once.
struct BothDrives {
  Drives before, after;
};

/// One domain of all joints.
void add_domain(const std::string& domain, const Errors& errors, const DrivenSubject& subject,
                const BothDrives& drives, std::vector<ChannelFinding>& channels) {
  const auto& logs =
      subject.logged_holdout().empty() ? subject.logged_training() : subject.logged_holdout();
  const auto joints = static_cast<Index>(channels.size());
  std::vector<StretchErrors> parts(2 * logs.size());  // before and after, log by log
  tbb::parallel_for(0, static_cast<int>(parts.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    Plant plant = plant_of(i % 2 == 0 ? drives.before : drives.after, logs[k / 2]);
    parts[k] = errors(plant, logs[k / 2]);
  });
  StretchErrors was(0, joints), is(0, joints);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    StretchErrors& all = k % 2 == 0 ? was : is;
    all.conservativeResize(all.rows() + parts[k].rows(), joints);
    all.bottomRows(parts[k].rows()) = parts[k];
  }
  if (was.rows() == 0) return;
  for (Index j = 0; j < joints; ++j) {
    const VectorXd before = was.col(j), now = is.col(j);
    // An axis that falls over in either model has no error worth a number.
    if (!before.allFinite() || !now.allFinite()) continue;
    const bool revolute = subject.model().joints[static_cast<std::size_t>(j)].revolute;
    channels[static_cast<std::size_t>(j)].domains.push_back(
        {domain, revolute ? "rad" : "m", std::sqrt(before.mean()), std::sqrt(now.mean()),
         block_bootstrap_gain(before, now, 0.95, 1)});
  }
}

}  // namespace

StretchErrors window_errors(Plant& plant, const Recording& log, double seconds, int stretches) {
  const auto length = static_cast<Index>(std::lround(seconds / log.step));
  const Index samples = log.q.rows(), joints = log.q.cols();
  const Index count =
      std::max<Index>(0, std::min<Index>(stretches, (samples - 1) / std::max<Index>(length, 1)));
  StretchErrors errors(count, joints);
  if (count == 0) return errors;
  Predicted predicted(plant, log);
  for (Index window = 0; window < count; ++window) {
    const Index from = window * (samples - 1 - length) / std::max<Index>(count - 1, 1);
    predicted.follow(from);
    VectorXd sum = VectorXd::Zero(joints);
    run_or_leave(
        predicted, from, length, [&](Index, const VectorXd& squares) { sum += squares; },
        [&] { sum.setConstant(std::numeric_limits<double>::infinity()); });
    errors.row(window) = bounded(sum / static_cast<double>(length)).transpose();
  }
  return errors;
}

StretchErrors open_loop_errors(Plant& plant, const Recording& log, int stretches) {
  const Index samples = log.q.rows(), joints = log.q.cols();
  StretchErrors errors = StretchErrors::Zero(stretches, joints);
  VectorXd counts = VectorXd::Zero(stretches);
  Predicted predicted(plant, log);
  run_or_leave(
      predicted, 0, samples - 1,
      [&](Index sample, const VectorXd& squares) {
        const Index part = sample * stretches / samples;
        errors.row(part) += squares.transpose();
        counts(part) += 1.0;
      },
      [&] { errors.setConstant(std::numeric_limits<double>::infinity()); });
  for (Index part = 0; part < stretches; ++part)
    errors.row(part) =
        bounded(errors.row(part).transpose() / std::max(counts(part), 1.0)).transpose();
  return errors;
}

StretchErrors window_errors(const EffortModel& model, const Recording& log, double seconds,
                            int stretches) {
  Plant plant = plant_of(model.drives(), log);
  return window_errors(plant, log, seconds, stretches);
}

StretchErrors open_loop_errors(const EffortModel& model, const Recording& log, int stretches) {
  Plant plant = plant_of(model.drives(), log);
  return open_loop_errors(plant, log, stretches);
}

void add_predictions(const DrivenSubject& subject, const EffortModel& after,
                     std::vector<ChannelFinding>& channels) {
  const auto& logs = subject.logged_training();
  const auto by_tendons = [](const Recording& log) { return log.signals.count("tension") > 0; };
  const bool tendons = std::any_of(logs.begin(), logs.end(), by_tendons);
  if (std::any_of(logs.begin(), logs.end(), [&](const Recording& log) {
        return log.target.size() != channels.size() ||
               log.q.cols() != static_cast<Index>(channels.size());
      }))
    return;
  const BothDrives drives{subject.effort().drives(), after.drives()};
  add_domain(
      "window",
      [&](Plant& plant, const Recording& r) {
        return window_errors(plant, r, prediction_window,
                             tendons ? tendon_windows : effort_windows);
      },
      subject, drives, channels);
  if (tendons) return;
  add_domain(
      "open loop",
      [](Plant& plant, const Recording& r) { return open_loop_errors(plant, r, kParts); }, subject,
      drives, channels);
}

}  // namespace sinew::diagnosis
