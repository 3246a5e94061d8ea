// SPDX-License-Identifier: GPL-3.0-or-later
// A measured log, where it is present.
#include <catch2/catch.hpp>

#include "identification/likelihood/explain.h"
#include "tests/identification/diagnosis/drive_candidates.h"
#include "tests/identification/diagnosis/drive_logs.h"
#include "tests/skip.h"

namespace {

using namespace sinew::diagnosis;
using namespace sinew::test;

const NamedCause* find_cause(const Verdict& verdict, const std::string& name) {
  for (const NamedCause& cause : verdict.causes)
    if (cause.members.front().name == name) return &cause;
  return nullptr;
}

}  // namespace

TEST_CASE("the cable's torque is found in the master arm's joint") {
  const std::optional<Recording> log = read_cable_joint();
  if (!log) return sinew::test::skip("../shared/data/dvrk_mtm is absent");
  Problem problem;
  problem.training = {*log};
  DriveScales scales = drive_scales(problem.training);
  Settings settings;
  settings.edge_s = 0.1;
  problem.baseline = drive_baseline(scales);
  scales.presliding = fitted_presliding(problem.training, scales, settings);
  problem.library = drive_library(scales);
  const Verdict verdict = explain(problem, settings).verdict;
  CHECK(find_cause(verdict, "position-dependent cable torque"));
  CHECK(verdict.relative_error_after < 0.25 * verdict.relative_error_before);
}
