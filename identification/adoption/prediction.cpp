// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/prediction.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "identification/regression/cross_validation.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kWindow = 0.05;  // s: longer than a delay, shorter than a controller's way back
constexpr int kWindows = 120, kParts = 12;

/// A mechanism under the measured efforts of a log.
class Prediction {
 public:
  Prediction(EffortAtInstant effort, const Recording& log, Index sample)
      : effort_(std::move(effort)),
        log_(log),
        sample_(sample),
        q_(log.q.row(sample).transpose()),
        qd_(log.qd.row(sample).transpose()),
        qdd_(log.qdd.row(sample).transpose()) {}

  /// To the next sample. Friction next to rest is steep: the effort is taken at the new velocity.
  void advance() {
    effort_.take(log_, sample_);
    VectorXd measured(q_.size());
    for (Index j = 0; j < measured.size(); ++j)
      measured(j) = log_.target[static_cast<std::size_t>(j)](sample_);
    constexpr int kIterations = 4;
    for (int i = 0; i < kIterations; ++i) {
      const VectorXd off = asked(qdd_) - measured;
      qdd_ -= slopes(qdd_).partialPivLu().solve(off);
    }
    asked(qdd_);
    effort_.remember();
    qd_ += log_.step * qdd_;
    q_ += log_.step * qd_;
    ++sample_;
  }

  /// Squared deviation from the measured position.
  VectorXd deviation() const {
    return (q_ - log_.q.row(sample_).transpose()).array().square().matrix();
  }

 private:
  VectorXd asked(const VectorXd& qdd) {
    const VectorXd qd = qd_ + log_.step * qdd;
    return effort_(q_ + log_.step * qd, qd, qdd);
  }

  /// Derivative of the effort by the acceleration, all that follows from it included.
  MatrixXd slopes(const VectorXd& qdd) {
    MatrixXd result(qdd.size(), qdd.size());
    for (Index j = 0; j < qdd.size(); ++j) {
      const double h = 1e-4 * std::max(1.0, std::abs(qdd(j)));
      VectorXd up = qdd, down = qdd;
      up(j) += h;
      down(j) -= h;
      result.col(j) = (asked(up) - asked(down)) / (2.0 * h);
    }
    return result;
  }

  EffortAtInstant effort_;
  const Recording& log_;
  Index sample_;
  VectorXd q_, qd_, qdd_;
};

/// Infinite where a prediction has left all bounds.
VectorXd bounded(const VectorXd& squares) {
  return squares.unaryExpr(
      [](double x) { return std::isfinite(x) ? x : std::numeric_limits<double>::infinity(); });
}

using Errors = std::function<StretchErrors(const EffortModel&, const Recording&)>;

/// One domain of all joints.
void add_domain(const std::string& domain, const Errors& errors, const DrivenSubject& subject,
                const EffortModel& after, std::vector<ChannelFinding>& channels) {
  const Problem& problem = subject.problem();
  const auto& logs = problem.holdout.empty() ? problem.training : problem.holdout;
  const auto joints = static_cast<Index>(channels.size());
  StretchErrors was(0, joints), is(0, joints);
  const auto append = [joints](const StretchErrors& more, StretchErrors& all) {
    all.conservativeResize(all.rows() + more.rows(), joints);
    all.bottomRows(more.rows()) = more;
  };
  for (const Recording& log : logs) {
    append(errors(subject.effort(), log), was);
    append(errors(after, log), is);
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

StretchErrors window_errors(const EffortModel& model, const Recording& log, double seconds,
                            int stretches) {
  const auto length = static_cast<Index>(std::lround(seconds / log.step));
  const Index samples = log.q.rows(), joints = log.q.cols();
  const Index count = std::min<Index>(stretches, (samples - 1) / std::max<Index>(length, 1));
  StretchErrors errors(std::max<Index>(count, 0), joints);
  EffortAtInstant measured(model);
  Index next = 0;
  for (Index k = 0; k < samples && next < count; ++k) {
    if (k == next * (samples - 1 - length) / std::max<Index>(count - 1, 1)) {
      Prediction window(measured, log, k);
      VectorXd sum = VectorXd::Zero(joints);
      for (Index i = 0; i < length; ++i) {
        window.advance();
        sum += window.deviation();
      }
      errors.row(next++) = bounded(sum / static_cast<double>(length)).transpose();
    }
    measured.take(log, k);
    measured(log.q.row(k).transpose(), log.qd.row(k).transpose(), log.qdd.row(k).transpose());
    measured.remember();
  }
  return errors;
}

StretchErrors open_loop_errors(const EffortModel& model, const Recording& log, int stretches) {
  const Index samples = log.q.rows(), joints = log.q.cols();
  StretchErrors errors = StretchErrors::Zero(stretches, joints);
  VectorXd counts = VectorXd::Zero(stretches);
  Prediction prediction(EffortAtInstant(model), log, 0);
  for (Index k = 1; k < samples; ++k) {
    prediction.advance();
    const Index part = k * stretches / samples;
    errors.row(part) += prediction.deviation().transpose();
    counts(part) += 1.0;
  }
  for (Index part = 0; part < stretches; ++part)
    errors.row(part) =
        bounded(errors.row(part).transpose() / std::max(counts(part), 1.0)).transpose();
  return errors;
}

void add_predictions(const DrivenSubject& subject, const EffortModel& after,
                     std::vector<ChannelFinding>& channels) {
  const auto& logs = subject.problem().training;
  const bool by_efforts = std::all_of(logs.begin(), logs.end(), [&](const Recording& log) {
    return log.signals.count("tension") == 0 && log.target.size() == channels.size() &&
           log.q.cols() == static_cast<Index>(channels.size());
  });
  if (!by_efforts) return;
  add_domain(
      "window",
      [](const EffortModel& m, const Recording& r) {
        return window_errors(m, r, kWindow, kWindows);
      },
      subject, after, channels);
  add_domain(
      "open loop",
      [](const EffortModel& m, const Recording& r) { return open_loop_errors(m, r, kParts); },
      subject, after, channels);
}

}  // namespace sinew::diagnosis
