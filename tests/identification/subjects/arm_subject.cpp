// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/subjects/arm_subject.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <numbers>
#include <string>

#include "identification/logs/read_csv.h"
#include "identification/subjects/rigid_candidates.h"
#include "symbolic/extension/driven_model.h"
#include "tests/reference/temporary_folder.h"

namespace sinew::test {

diagnosis::DrivenSubject prepared_arm(const Mechanism& nominal, const ArmLog& logged,
                                      const diagnosis::Settings& settings,
                                      const CarriedPayload* carried) {
  const reference::TemporaryFolder folder;
  const std::string path = (folder.path() / "log.csv").string();
  reference::write_text(path, csv(logged));
  const std::filesystem::path runtime = SINEW_SOURCE_DIR "/runtime";
  diagnosis::DrivenSubject subject(
      driven_model(nominal), {}, runtime,
      std::make_shared<const diagnosis::RigidColumns>(nominal, runtime));
  const Log log = read_csv(path, robot_channels(nominal));
  diagnosis::DrivenColumns columns;
  for (Eigen::Index j = 0; j < kArmJoints; ++j) {
    columns.positions.push_back(log.channel(fmt::format("q_j{}", j + 1)));
    columns.efforts.push_back(log.channel(fmt::format("tau_j{}", j + 1)));
  }
  subject.add_log(log, columns, false, carried);
  subject.take_payloads();
  subject.prepare(settings);
  return subject;
}

ArmLog with_encoder_steps(ArmLog log, double step) {
  log.q = (log.q / step).array().round() * step;
  return log;
}

}  // namespace sinew::test
