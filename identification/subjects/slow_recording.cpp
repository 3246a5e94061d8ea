// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/slow_recording.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/logs/filter.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double highest_cutoff = 10.0;  // Hz

}  // namespace

double column_cutoff(double step) {
  return std::min(highest_cutoff, 0.1 / step);
}

Recording slow_recording(const Recording& recording) {
  Recording slow;
  const auto end = static_cast<Index>(std::ceil(driven_edge / recording.step));
  const Index rows = recording.q.rows() - 2 * end;
  if (rows < kFewestPoints) return slow;
  const double cutoff = column_cutoff(recording.step);
  const Index stride = std::max<Index>(1, rows / kMostPoints), count = (rows - 1) / stride + 1;
  const auto thinned = [&](const MatrixXd& x) -> MatrixXd {
    return x(Eigen::seqN(end, count, stride), Eigen::all);
  };
  const auto smooth = [&](const MatrixXd& x) -> MatrixXd {
    return thinned(differentiate(x, recording.step, cutoff).q);
  };
  const Motion motion = differentiate(recording.q, recording.step, cutoff);
  slow.name = recording.name;
  slow.log = recording.log;
  slow.q = thinned(motion.q);
  slow.qd = thinned(motion.qd);
  slow.qdd = thinned(motion.qdd);
  slow.step = recording.step * static_cast<double>(stride);
  slow.time = VectorXd::LinSpaced(count, 0.0, slow.step * static_cast<double>(count - 1));
  for (const VectorXd& target : recording.target) slow.target.push_back(smooth(target));
  if (recording.load.size() > 0) slow.load = smooth(recording.load);
  if (recording.payload.size() > 0) slow.payload = thinned(recording.payload);
  if (recording.payload_effort.size() > 0) slow.payload_effort = smooth(recording.payload_effort);
  if (const MatrixXd* tension = recording.signals.find("tension"))
    slow.signals["tension"] = smooth(*tension);
  if (const MatrixXd* arms = recording.signals.find("moment_arm"))
    slow.signals["moment_arm"] = thinned(*arms);
  return slow;
}

double share_left_over(const VectorXd& measured, const VectorXd& model) {
  const double size = measured.squaredNorm();
  const double left = (measured - model).squaredNorm();
  return size > 0.0 && std::isfinite(left) ? left / size : std::numeric_limits<double>::infinity();
}

}  // namespace sinew::diagnosis
