// SPDX-License-Identifier: GPL-3.0-or-later
// What tendons' candidates are made of: forces that agree with the model, and rests in the guides.
#include "identification/subjects/tendon_candidates.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/identification/subjects/tendon_finger_log.h"

namespace {

using namespace sinew;
using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const char* const kRuntime = SINEW_SOURCE_DIR "/runtime";
constexpr Index kJoints = test::TendonFingerLog::joints, kTendons = test::TendonFingerLog::tendons;

/// With what the model says of its joints.
Recording known(const test::TendonFingerLog& finger, double first_force) {
  Recording r = finger.with([&](Recording& log) { log.signals["tension"].col(0) *= first_force; });
  for (Index c = 0; c < kJoints; ++c) r.known.push_back(r.target[static_cast<std::size_t>(c)]);
  return r;
}

/// Away from the filter's ends.
VectorXd middle(const VectorXd& x) {
  return x.segment(1000, x.size() - 2000);
}

}  // namespace

TEST_CASE(
    "forces that agree with the model move its joints, and are those measured where they do") {
  // Seen to fail with the measured forces themselves.
  const test::TendonFingerLog finger;
  const TendonColumns columns(finger.model(), kRuntime);
  for (const double factor : {1.0, 1.3}) {
    Recording r = known(finger, factor);
    columns.add_agreeing_tension(r);
    const MatrixXd agreeing = r.signals.at("agreeing_tension");
    Recording moved = r;
    moved.signals["tension"] = agreeing;
    const MatrixXd torque = columns.joint_torque(moved);
    for (Index j = 0; j < kJoints; ++j) {
      const VectorXd said = middle(r.known[static_cast<std::size_t>(j)]);
      // The slow part: the model's torque of motions up to 1.5 Hz passes a filter of 5 Hz.
      CHECK((middle(torque.col(j)) - said).norm() < 0.02 * said.norm());
    }
    const MatrixXd measured = r.signals.at("tension");
    const double off = (agreeing - measured).middleRows(1000, 6000).cwiseAbs().maxCoeff();
    if (factor == 1.0)
      CHECK(off < 0.05);
    else
      CHECK(off > 1.0);
  }
}

TEST_CASE("a tendon rests in its guide while its joints move against each other") {
  // Seen to fail where a rest is what is next to no speed of the tendon's largest: it creeps.
  const test::TendonFingerLog finger;
  const TendonColumns columns(finger.model(), kRuntime);
  constexpr double kFrom = 3.0, kTo = 4.0, kCreep = 0.01;  // s, rad/s
  const Recording r = [&] {
    Recording log = finger.with([&](Recording& plain) {
      for (Index k = 0; k < plain.time.size(); ++k) {
        const bool rests = plain.time(k) > kFrom && plain.time(k) < kTo;
        plain.qd(k, 0) = 1.0 + 0.5 * std::sin(plain.time(k));
        plain.qd(k, 1) = plain.qd(k, 0) + (rests ? kCreep : 2.0);
      }
    });
    log.signals["smooth_qd"] = log.qd;
    return log;
  }();
  const auto tendons = columns.stillness(r, 60.0);
  REQUIRE(tendons.size() == static_cast<std::size_t>(kTendons));
  // Its way is the sum of both angles.
  CHECK(find_standstills({tendons[0]}, r.time).empty());
  const auto rests = find_standstills({tendons[1]}, r.time);  // the difference
  REQUIRE(rests.size() == 1);
  CHECK(rests[0].from == Approx(kFrom).margin(0.05));
  CHECK(rests[0].to == Approx(kTo).margin(0.05));
}
