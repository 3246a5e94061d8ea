// SPDX-License-Identifier: GPL-3.0-or-later
// An arm's joints stay apart in the search, and no motion is larger than what is compared.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

#include "identification/logs/read_csv.h"
#include "identification/subjects/driven_subject.h"
#include "identification/subjects/rigid_candidates.h"
#include "symbolic/extension/driven_model.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/reference/temporary_folder.h"

namespace {

using namespace sinew;
using diagnosis::DrivenSubject;

/// The arm's log at 1 kHz with the encoders' steps, read and prepared.
DrivenSubject subject_with_steps(const Mechanism& arm) {
  constexpr double step = 2.0 * std::numbers::pi / (1 << 18);
  const reference::TemporaryFolder folder;
  const std::string path = (folder.path() / "log.csv").string();
  test::ArmLog logged = test::draw_log(arm, 5, {0.5, 0.2}, 0.001);
  logged.q = (logged.q / step).array().round() * step;
  reference::write_text(path, test::csv(logged));
  const std::filesystem::path runtime = SINEW_SOURCE_DIR "/runtime";
  DrivenSubject subject(driven_model(arm), {}, runtime,
                        std::make_shared<const diagnosis::RigidColumns>(arm, runtime));
  const Log log = read_csv(path, robot_channels(arm));
  diagnosis::DrivenColumns columns;
  for (Eigen::Index j = 0; j < test::kArmJoints; ++j) {
    columns.positions.push_back(log.channel(fmt::format("q_j{}", j + 1)));
    columns.efforts.push_back(log.channel(fmt::format("tau_j{}", j + 1)));
  }
  subject.add_log(log, columns, false);
  subject.prepare({});
  return subject;
}

}  // namespace

// Seen red with columns at the joints that feel it: the products of every joint's columns with
// every other's were kept, which took seven joints 91 s for 54. A coefficient at each of them let
// an arm's missing mass leave a push (the gate link_mass 71).
TEST_CASE("what is fitted in any case acts at its own joint") {
  const DrivenSubject subject = subject_with_steps(test::arm_of_five());
  std::size_t of_steps = 0;
  for (const diagnosis::Candidate& c : subject.problem().library) {
    if (!c.nuisance) continue;
    INFO(c.name << " " << c.place);
    CHECK(c.channels.size() == 1);
    of_steps += c.name == "quantisation of the position sensor" ? 1 : 0;
  }
  CHECK(of_steps == static_cast<std::size_t>(test::kArmJoints));
}

// Seen red with every signal worked out at the logs' rate: seven joints took 1.1 GB for 0.7.
TEST_CASE("logs and planned motions are worked out at the rate that is compared") {
  const DrivenSubject subject = subject_with_steps(test::arm_of_five());
  const diagnosis::Recording& compared = subject.problem().training.front();
  const diagnosis::Recording& logged = subject.logged_training().front();
  REQUIRE_FALSE(compared.band_hz.empty());
  REQUIRE(*std::max_element(compared.band_hz.begin(), compared.band_hz.end()) < 30.0);
  CHECK(logged.step == Approx(0.001));
  CHECK(compared.step == Approx(0.002));
  REQUIRE_FALSE(compared.wide_signals.empty());
  for (const auto& [name, signal] : compared.wide_signals)
    CHECK(signal->rows() == compared.time.size());
  CHECK(logged.wide_signals.empty());
  const auto experiments = subject.experiments(1);
  REQUIRE_FALSE(experiments.empty());
  for (const diagnosis::PlannedExperiment& e : experiments) {
    INFO(e.motion.name);
    CHECK(e.motion.step == Approx(logged.step));
    const diagnosis::Recording planned = e.recording();
    CHECK(planned.step == Approx(compared.step));
    const double played = e.motion.step * static_cast<double>(e.motion.position.rows() - 1);
    CHECK(planned.time(planned.time.size() - 1) == Approx(played).margin(planned.step));
  }
}
