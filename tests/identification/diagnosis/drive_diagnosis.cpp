// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/diagnosis/drive_diagnosis.h"

#include <algorithm>

#include "tests/identification/diagnosis/drive_candidates.h"

namespace sinew::test {

Explanation diagnose_drive(const SyntheticDrive& drive, unsigned seed) {
  Problem problem;
  problem.training = {drive.log};
  DriveScales scales = drive_scales(problem.training);
  scales.period_in = drive.period_in;
  scales.period_out = drive.period_out;
  Settings settings;
  settings.edge_s = 0.2;
  settings.seed = seed;
  problem.baseline = drive_baseline(scales);
  scales.presliding = fitted_presliding(problem.training, scales, settings);
  problem.library = drive_library(scales);
  return explain(problem, settings);
}

bool is_member(const NamedCause& cause, const std::string& name) {
  return std::any_of(cause.members.begin(), cause.members.end(),
                     [&](const RankedCause& member) { return member.name == name; });
}

bool is_member(const Verdict& verdict, const std::string& name) {
  return std::any_of(verdict.causes.begin(), verdict.causes.end(),
                     [&](const NamedCause& cause) { return is_member(cause, name); });
}

std::set<std::string> first_names(const Verdict& verdict) {
  std::set<std::string> names;
  for (const NamedCause& cause : verdict.causes) names.insert(cause.members.front().name);
  return names;
}

}  // namespace sinew::test
