// SPDX-License-Identifier: GPL-3.0-or-later
// What a judge of columns says of an arm's log.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "identification/logs/data_faults.h"
#include "identification/logs/read_csv.h"
#include "identification/subjects/driven_subject.h"
#include "symbolic/extension/driven_model.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/reference/temporary_folder.h"

namespace sinew::test {

using ColumnJudge = void (*)(const Log&, const diagnosis::DrivenColumns&,
                             const diagnosis::Recording&, const diagnosis::EffortModel&,
                             FaultList&);

/// The faults that `judge` finds in the log of an arm that is taken for `nominal`.
inline std::vector<DataFault> faults_of(const Mechanism& nominal, const ArmLog& logged,
                                        ColumnJudge judge) {
  const reference::TemporaryFolder folder;
  const std::string path = (folder.path() / "log.csv").string();
  reference::write_text(path, csv(logged));
  diagnosis::DrivenSubject subject(driven_model(nominal), {}, SINEW_SOURCE_DIR "/runtime");
  const Log log = read_csv(path, robot_channels(nominal));
  diagnosis::DrivenColumns columns;
  for (std::size_t j = 1; j <= nominal.joints.size(); ++j) {
    columns.positions.push_back(log.channel(fmt::format("q_j{}", j)));
    columns.efforts.push_back(log.channel(fmt::format("tau_j{}", j)));
  }
  subject.add_log(log, columns, false);
  FaultList faults(path);
  judge(log, columns, subject.problem().training.back(), subject.effort(), faults);
  return faults.all();
}

}  // namespace sinew::test
