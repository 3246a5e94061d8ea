// SPDX-License-Identifier: GPL-3.0-or-later
// Several joints at once: a cause is named at its place, and a long log does not take long.
#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <random>

#include "identification/regression/flexible_families.h"
#include "tests/identification/diagnosis/drive_candidates.h"
#include "tests/identification/diagnosis/drive_diagnosis.h"

namespace {

using namespace sinew::test;
using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Joints that move on sums of sines, with inertia, viscous friction and noise; joint 2 has
/// friction that differs by direction, the last one a ripple.
Recording joints(int count, double duration, double step, double ripple_rate) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> unit;
  const auto n = static_cast<Index>(duration / step);
  Recording log;
  log.name = "joints";
  log.step = step;
  log.time = VectorXd::LinSpaced(n, 0.0, step * static_cast<double>(n - 1));
  for (MatrixXd* m : {&log.q, &log.qd, &log.qdd}) *m = MatrixXd::Zero(n, count);
  for (int j = 0; j < count; ++j) {
    for (const double hz : {0.17, 0.43, 1.1, 2.3}) {
      const double w = 2.0 * M_PI * hz * (0.8 + 0.4 * unit(random)), phase = 6.0 * unit(random);
      const ArrayXd angle = w * log.time.array() + phase;
      log.q.col(j).array() += 0.3 / std::sqrt(hz) * angle.sin();
      log.qd.col(j).array() += 0.3 / std::sqrt(hz) * w * angle.cos();
      log.qdd.col(j).array() -= 0.3 / std::sqrt(hz) * w * w * angle.sin();
    }
    VectorXd y = 0.02 * log.qdd.col(j) + 0.5 * log.qd.col(j);
    if (j == 1) y += 0.12 * log.qd.col(j).cwiseAbs();
    if (j == count - 1) y.array() += 0.08 * (ripple_rate * log.q.col(j).array() + 0.4).sin();
    double state = 0.0;
    const double pole = std::exp(-2.0 * M_PI * 5.0 * step);
    for (double& value : y) {
      state = pole * state + std::sqrt(1.0 - pole * pole) * gauss(random);
      value += 0.06 * state + 0.01 * gauss(random);
    }
    log.target.push_back(std::move(y));
  }
  return log;
}

/// A candidate of one drive, moved to a joint of many.
Candidate at_joint(Candidate c, int joint) {
  c.place = "joint " + std::to_string(joint + 1);
  c.channels = {joint};
  if (c.columns)
    c.columns = [from = c.columns, joint](const Recording& log, int, const VectorXd& p) {
      Recording one;
      one.step = log.step;
      one.time = log.time;
      one.q = log.q.col(joint);
      one.qd = log.qd.col(joint);
      one.qdd = log.qdd.col(joint);
      return from(one, 0, p);
    };
  return c;
}

Problem many(int count, double duration, double step) {
  Problem problem;
  problem.channels = count;
  problem.training = {joints(count, duration, step, 40.0)};
  const Recording& log = problem.training.front();
  for (int j = 0; j < count; ++j) {
    DriveScales scales;
    scales.speed = log.qd.col(j).cwiseAbs().maxCoeff();
    scales.low = log.q.col(j).minCoeff();
    scales.high = log.q.col(j).maxCoeff();
    scales.duration = duration;
    scales.period_in = 2.0 * M_PI / 40.0;
    for (const Candidate& c : drive_baseline(scales)) problem.baseline.push_back(at_joint(c, j));
    for (const Candidate& c : drive_library(scales))
      if (c.kind != CandidateKind::flexible && c.kind != CandidateKind::decoy)
        problem.library.push_back(at_joint(c, j));
    for (const Candidate& c :
         flexible_families({scales.low, scales.high, scales.speed, 0.0, duration}, j, j))
      problem.library.push_back(c);
  }
  return problem;
}

std::set<std::string> names_with_places(const Verdict& verdict) {
  std::set<std::string> names;
  for (const NamedCause& cause : verdict.causes)
    names.insert(cause.members.front().name + " @ " + cause.members.front().place);
  return names;
}

}  // namespace

TEST_CASE("among several joints a cause is named at its own") {
  Settings settings;
  const Problem problem = many(3, 20.0, 2e-3);
  CHECK(names_with_places(explain(problem, settings).verdict) ==
        std::set<std::string>{"viscous asymmetry @ joint 2", "ripple, input order 1 @ joint 3"});
}

TEST_CASE("study: time for 60 s of twelve joints at 3 kHz", "[.study]") {
  const Problem problem = many(12, 60.0, 1.0 / 3000.0);
  const auto start = std::chrono::steady_clock::now();
  const Verdict verdict = explain(problem, Settings{}).verdict;
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  fmt::print("{} candidates: {:.1f} s\n", problem.library.size(), taken.count());
  for (const std::string& name : names_with_places(verdict)) fmt::print("  {}\n", name);
}
