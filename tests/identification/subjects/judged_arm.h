// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the columns of an arm's logs.
#pragma once

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "identification/logs/data_faults.h"
#include "identification/logs/read_csv.h"
#include "identification/subjects/driven_equations.h"
#include "identification/subjects/driven_readings.h"
#include "identification/subjects/slow_columns.h"
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
        subject_(model_, {}, runtime_, rigid_),
        equations_(model_, subject_.effort(), rigid_.get(),
                   static_cast<Eigen::Index>(nominal.joints.size())) {}

  /// The faults that a log is refused for, by its reader or by the model; empty: none.
  std::vector<DataFault> stops(const ArmLog& logged) {
    try {
      const ReadLog read = read_from(logged);
      FaultList faults("log.csv");
      judge_driven_columns(read.log, read.columns, subject_.problem().training.back(), model_,
                           subject_.effort(), rigid_.get(), runtime_, faults);
      return faults.stops() ? faults.all() : std::vector<DataFault>{};
    } catch (const LogError& error) {
      return error.faults;
    }
  }

  /// What the judge looks at.
  diagnosis::Recording slowly(const ArmLog& logged) {
    const ReadLog read = read_from(logged);
    const diagnosis::SlowColumns slow(read.columns, subject_.problem().training.back(), model_,
                                      nullptr);
    return slow.read_as(nullptr);
  }

  const diagnosis::DrivenEquations& equations() const { return equations_; }

 private:
  struct ReadLog {
    Log log;
    diagnosis::DrivenColumns columns;
  };
  ReadLog read_from(const ArmLog& logged) {
    const std::string path = (folder_.path() / "log.csv").string();
    reference::write_text(path, csv(logged));
    ReadLog read{read_csv(path, robot_channels(nominal_)), {}};
    for (std::size_t j = 1; j <= nominal_.joints.size(); ++j) {
      read.columns.positions.push_back(read.log.channel(fmt::format("q_j{}", j)));
      read.columns.efforts.push_back(read.log.channel(fmt::format("tau_j{}", j)));
    }
    subject_.add_log(read.log, read.columns, false);
    return read;
  }

  std::string runtime_ = SINEW_SOURCE_DIR "/runtime";
  Mechanism nominal_;
  DrivenModel model_;
  std::shared_ptr<const diagnosis::RigidColumns> rigid_;
  diagnosis::DrivenSubject subject_;
  diagnosis::DrivenEquations equations_;
  reference::TemporaryFolder folder_;
};

}  // namespace sinew::test
