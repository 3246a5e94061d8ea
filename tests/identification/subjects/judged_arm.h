// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the columns of an arm's logs.
#pragma once

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "identification/logs/data_faults.h"
#include "identification/logs/read_csv.h"
#include "identification/subjects/driven_readings.h"
#include "symbolic/extension/driven_model.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/reference/temporary_folder.h"

namespace sinew::test {

/// Reads logs that are taken for those of one arm and judges them, as `sinew diagnose` does.
class JudgedArm {
 public:
  explicit JudgedArm(const Mechanism& nominal)
      : nominal_(nominal),
        model_(driven_model(nominal)),
        rigid_(std::make_shared<const diagnosis::RigidColumns>(nominal, runtime_)),
        subject_(model_, {}, runtime_, rigid_) {}

  /// The faults that a log is refused for, by its reader or by the model; empty: none.
  std::vector<DataFault> stops(const ArmLog& logged) {
    const std::string path = (folder_.path() / "log.csv").string();
    reference::write_text(path, csv(logged));
    try {
      const Log log = read_csv(path, robot_channels(nominal_));
      diagnosis::DrivenColumns columns;
      for (std::size_t j = 1; j <= nominal_.joints.size(); ++j) {
        columns.positions.push_back(log.channel(fmt::format("q_j{}", j)));
        columns.efforts.push_back(log.channel(fmt::format("tau_j{}", j)));
      }
      subject_.add_log(log, columns, false);
      FaultList faults(path);
      judge_driven_columns(log, columns, subject_.problem().training.back(), model_,
                           subject_.effort(), rigid_.get(), runtime_, faults);
      return faults.stops() ? faults.all() : std::vector<DataFault>{};
    } catch (const LogError& error) {
      return error.faults;
    }
  }

 private:
  std::string runtime_ = SINEW_SOURCE_DIR "/runtime";
  Mechanism nominal_;
  DrivenModel model_;
  std::shared_ptr<const diagnosis::RigidColumns> rigid_;
  diagnosis::DrivenSubject subject_;
  reference::TemporaryFolder folder_;
};

}  // namespace sinew::test
