// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/torque_constants.h"

#include <cmath>
#include <optional>

#include "identification/subjects/block_regression.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;

/// The share of a current in 1 of the model's effort is the constant's inverse.
std::optional<FittedConstant> constant_of(const Share& share) {
  constexpr double kTold = 0.2;  // largest standard error, as a share
  if (!(share.value > 0.0) || !(share.standard_error < kTold * share.value)) return std::nullopt;
  return FittedConstant{1.0 / share.value, share.standard_error / (share.value * share.value),
                        false};
}

}  // namespace

std::vector<FittedConstant> fit_torque_constants(const std::vector<Recording>& logs,
                                                 const EffortModel& model,
                                                 const std::vector<std::size_t>& joints) {
  std::vector<BlockRegression> regressions(joints.size(), BlockRegression(1));
  for (const Recording& log : logs) {
    const SmoothEfforts efforts = smooth_efforts(log, model);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const auto joint = static_cast<Index>(joints[j]);
      regressions[j].add_joint(efforts, joint, efforts.said.col(joint));
    }
  }
  std::vector<std::optional<FittedConstant>> found;
  double sum = 0.0, count = 0.0;
  for (const BlockRegression& regression : regressions) {
    found.push_back(constant_of(regression.shares().front()));
    if (!found.back()) continue;
    sum += std::log(found.back()->value);
    count += 1.0;
  }
  if (count == 0.0) return {};
  std::vector<FittedConstant> constants;
  for (const auto& each : found)
    constants.push_back(each ? *each : FittedConstant{std::exp(sum / count), 0.0, true});
  return constants;
}

}  // namespace sinew::diagnosis
