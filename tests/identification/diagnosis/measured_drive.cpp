// SPDX-License-Identifier: GPL-3.0-or-later
// The two measured logs, where they are present.
#include <algorithm>
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

bool ruled_out(const Verdict& verdict, const std::string& name) {
  return std::any_of(verdict.ruled_out.begin(), verdict.ruled_out.end(),
                     [&](const RuledOut& r) { return r.name == name; });
}

}  // namespace

TEST_CASE("the positioning drive's causes are named without help", "[slow]") {
  const std::optional<Recording> log = read_positioning_drive();
  if (!log) return sinew::test::skip("../shared/data/emps is absent");
  Problem problem;
  problem.training = {*log};
  DriveScales scales = drive_scales(problem.training);
  scales.period_in = 2.5e-3;
  Settings settings;
  settings.edge_s = 0.1;
  problem.baseline = drive_baseline(scales);
  scales.presliding = fitted_presliding(problem.training, scales, settings);
  problem.library = drive_library(scales);
  const Verdict verdict = explain(problem, settings).verdict;

  CHECK(find_cause(verdict, "viscous asymmetry"));
  CHECK(find_cause(verdict, "friction concave in speed"));
  CHECK(find_cause(verdict, "ripple, input order 1"));
  const NamedCause* delay = find_cause(verdict, "delay");
  REQUIRE(delay);
  CHECK(delay->parameters.front().value == Approx(8e-4).margin(2e-4));
  CHECK(ruled_out(verdict, "Stribeck friction"));
  CHECK(ruled_out(verdict, "input ripple off order"));
  for (const NamedCause& cause : verdict.causes) CHECK(cause.members.size() == 1);
}

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
