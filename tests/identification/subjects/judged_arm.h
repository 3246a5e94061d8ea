// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the columns of an arm's log.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "identification/logs/data_faults.h"
#include "identification/logs/read_csv.h"
#include "identification/subjects/driven_readings.h"
#include "symbolic/extension/driven_model.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/reference/temporary_folder.h"

namespace sinew::test {

/// The faults of columns in the log of an arm that is taken for `nominal`.
inline std::vector<DataFault> faults_of(const Mechanism& nominal, const ArmLog& logged) {
  const reference::TemporaryFolder folder;
  const std::string path = (folder.path() / "log.csv").string();
  reference::write_text(path, csv(logged));
  const DrivenModel model = driven_model(nominal);
  const std::string runtime = SINEW_SOURCE_DIR "/runtime";
  const auto rigid = std::make_shared<const diagnosis::RigidColumns>(nominal, runtime);
  diagnosis::DrivenSubject subject(model, {}, runtime, rigid);
  const Log log = read_csv(path, robot_channels(nominal));
  diagnosis::DrivenColumns columns;
  for (std::size_t j = 1; j <= nominal.joints.size(); ++j) {
    columns.positions.push_back(log.channel(fmt::format("q_j{}", j)));
    columns.efforts.push_back(log.channel(fmt::format("tau_j{}", j)));
  }
  subject.add_log(log, columns, false);
  FaultList faults(path);
  judge_driven_columns(log, columns, subject.problem().training.back(), model, subject.effort(),
                       rigid.get(), runtime, faults);
  return faults.all();
}

}  // namespace sinew::test
