// SPDX-License-Identifier: GPL-3.0-or-later
// Logs faster than their comparison needs: what is worked out at which rate.
#include <algorithm>
#include <catch2/catch.hpp>

#include "identification/adoption/measure.h"
#include "tests/identification/subjects/arm_subject.h"
#include "tests/identification/subjects/loaded_arm.h"

namespace {

using namespace sinew;
using diagnosis::DrivenSubject;

}  // namespace

// Seen red with logs that are not thinned.
TEST_CASE("logs and planned motions are worked out at the rate that is compared") {
  const Mechanism arm = test::arm_of_five();
  const DrivenSubject subject =
      test::prepared_arm(arm, test::with_encoder_steps(test::draw_log(arm, 5, {0.5, 0.2}, 0.001)));
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

// Seen red with a thinned recording without its payload_effort: a log at 1 kHz was measured as if
// nothing were carried.
TEST_CASE("a load of known mass is none in fast logs either") {
  const Mechanism arm = test::arm_of_five();
  const CarriedPayload carried{{}, "l5", test::kLoad, test::kLoadCentre};
  diagnosis::Settings settings;
  settings.band_hz = 60.0;
  const DrivenSubject subject =
      test::prepared_arm(arm, test::draw_log(test::loaded(arm), 1, {}, 0.001), settings, &carried);
  REQUIRE(subject.problem().training.front().step > 0.0015);
  const diagnosis::Design design(subject.problem(), settings);
  for (const auto& channel : diagnosis::measure(subject, design, {}, subject.effort())) {
    INFO("joint " << channel.channel + 1);
    CHECK((channel.measured - channel.before).norm() < 0.02 * channel.measured.norm());
  }
}
