// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/likelihood/drive_stretches.h"

#include <fmt/format.h>

#include "tests/identification/diagnosis/drive_candidates.h"

namespace sinew::test {
namespace {

Recording stretch_of(const Recording& log, Eigen::Index first, Eigen::Index count) {
  Recording part = log;
  for (Eigen::MatrixXd* x : {&part.q, &part.qd, &part.qdd, &part.load})
    *x = Eigen::MatrixXd(x->middleRows(first, count));
  part.time = Eigen::VectorXd(log.time.segment(first, count)).array() - log.time(first);
  part.target.front() = Eigen::VectorXd(log.target.front().segment(first, count));
  return part;
}

}  // namespace

DriveStretches drive_stretches(const std::vector<std::string>& effects,
                               const std::vector<double>& sizes, std::size_t count, double duration,
                               unsigned seed) {
  const SyntheticDrive drive =
      simulate_drive(effects, sizes, duration * static_cast<double>(count), seed);
  DriveStretches made;
  made.settings.edge_s = 0.2;
  made.period_in = drive.period_in;
  made.period_out = drive.period_out;
  const Eigen::Index rows = drive.log.time.size() / static_cast<Eigen::Index>(count);
  for (std::size_t i = 0; i < count; ++i) {
    made.logs.push_back(stretch_of(drive.log, rows * static_cast<Eigen::Index>(i), rows));
    made.logs.back().name = fmt::format("log {}", i + 1);
  }
  return made;
}

Problem DriveStretches::problem(const std::vector<std::size_t>& training) const {
  Problem problem;
  for (const std::size_t i : training) problem.training.push_back(logs[i]);
  DriveScales scales = drive_scales(problem.training);
  scales.period_in = period_in;
  scales.period_out = period_out;
  problem.baseline = drive_baseline(scales);
  scales.presliding = fitted_presliding(problem.training, scales, settings);
  problem.library = drive_library(scales);
  return problem;
}

}  // namespace sinew::test
