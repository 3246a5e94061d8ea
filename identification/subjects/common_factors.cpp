// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/common_factors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/subjects/block_regression.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kSlip = 1.4;  // no robot is off by that much everywhere alike

bool is_slip(double factor) {
  return std::max(factor, 1.0 / factor) > kSlip;
}

}  // namespace

void judge_common_factors(const Log& log, const DrivenColumns& columns, const Recording& recording,
                          const EffortModel& model, FaultList& faults) {
  if (columns.efforts.size() < 2 || !columns.forces.empty()) return;
  const SmoothEfforts efforts = smooth_efforts(recording, model);
  std::vector<Share> of_weight, of_inertia;
  for (Index j = 0; j < efforts.qd.cols(); ++j) {
    BlockRegression regression(2);
    MatrixXd parts(efforts.qd.rows(), 2);
    parts << efforts.at_rest.col(j), efforts.said.col(j) - efforts.at_rest.col(j);
    regression.add_joint(efforts, j, parts);
    const std::vector<Share> shares = regression.shares();
    of_weight.push_back(shares.front());
    of_inertia.push_back(shares.back());
  }
  const std::optional<double> weight = common_factor(of_weight),
                              inertia = common_factor(of_inertia);
  if (!weight || *weight <= 0.0) return;
  const long row = log.segments.front().first_row;
  const Channel& first = log.channels[static_cast<std::size_t>(columns.efforts.front())];
  if (is_slip(*weight)) {
    faults.add(FaultKind::unit_slip, Severity::stop, row, row, first.column, first.name,
               fmt::format("all efforts are {:.3g} times what the weights of the model ask for: "
                           "their unit, the model's masses or its gravity",
                           *weight),
               "units are converted only when told: --map \"channel=column [unit]\"");
  } else if (inertia && *inertia > 0.0 && is_slip(*inertia / *weight)) {
    const double factor = std::sqrt(*inertia / *weight);
    faults.add(FaultKind::time_unit, Severity::stop, row, row, 1, "time",
               fmt::format("all joints' inertia is {:.3g} times the model's and their weight is "
                           "the model's own: the time runs {:.3g} times {}",
                           *inertia / *weight, std::max(factor, 1.0 / factor),
                           factor > 1.0 ? "too slow" : "too fast"),
               "units are converted only when told: --map \"time=column [unit]\"");
  }
}

}  // namespace sinew::diagnosis
