// SPDX-License-Identifier: GPL-3.0-or-later
// Arms whose joints are coupled: an exchanged column, a wrong unit and a reversed sign are found by
// the model, and an arm that only lacks something is not taken for a faulty log.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/identification/subjects/judged_arm.h"

namespace {

using namespace sinew;
using namespace sinew::test;
using Eigen::Index;

/// What is measured of an arm whose drives have rotors that the model does not know.
ArmLog with_rotors(const Mechanism& arm, std::uint64_t seed) {
  ArmLog log = draw_log(arm, seed, {0.3, 0.2});
  const Eigen::Index n = log.q.rows();
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    const Eigen::Index from = std::max<Eigen::Index>(k - 25, 0), to = std::min(k + 25, n - 1);
    const double half = 0.5 * log.step * double(to - from);
    log.tau.row(k) +=
        0.05 * (log.q.row(to) - 2.0 * log.q.row((from + to) / 2) + log.q.row(from)) / (half * half);
  }
  return log;
}

/// An arm that carries something and has a link of another mass.
Mechanism heavier(Mechanism arm) {
  arm.bodies.back().mass *= 8.0;
  arm.bodies[2].mass *= 1.5;
  return arm;
}

std::string text(const std::vector<DataFault>& faults) {
  std::string all;
  for (const DataFault& fault : faults) all += message(fault) + "\n";
  return all;
}

}  // namespace

TEST_CASE("an arm whose model is incomplete is no faulty log", "[slow][thorough]") {
  // A load, gravity and the other joints may drive a joint back all the time. Seen to fail with the
  // model's share of each joint off by itself instead of each link's: all loaded arms are refused.
  const Mechanism nominal = arm_of_five();
  const Mechanism loaded = heavier(nominal);
  JudgedArm arm(nominal);
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    CHECK(text(arm.stops(draw_log(nominal, seed, {}))).empty());
    CHECK(text(arm.stops(draw_log(nominal, seed, {1.0, 0.0}))).empty());
    CHECK(text(arm.stops(draw_log(loaded, seed, {}))).empty());
  }
}

TEST_CASE("a wrong column of an arm is found by the model and named", "[slow][thorough]") {
  // Seen to fail as the test before: the motor's effort, and one factor of a half.
  const Mechanism nominal = arm_of_five();
  JudgedArm arm(nominal);
  struct Planted {
    const char* name;
    FaultKind kind;
    std::function<void(ArmLog&, Index, Index)> plant;
    bool or_degrees = false;
  };
  const Planted all[] = {
      {"effort reversed", FaultKind::reversed_sign,
       [](ArmLog& l, Index a, Index) { l.tau.col(a) *= -1.0; }},
      {"effort in N·mm", FaultKind::unit_slip,
       [](ArmLog& l, Index a, Index) { l.tau.col(a) *= 1000.0; }},
      {"effort of the motor before a gear of 80", FaultKind::unit_slip,
       [](ArmLog& l, Index a, Index) { l.tau.col(a) /= 80.0; }},
      {"efforts exchanged", FaultKind::swapped_columns,
       [](ArmLog& l, Index a, Index b) { l.tau.col(a).swap(l.tau.col(b)); }},
      {"positions exchanged", FaultKind::swapped_columns,
       [](ArmLog& l, Index a, Index b) { l.q.col(a).swap(l.q.col(b)); }},
      {"position in deg", FaultKind::unit_slip,
       [](ArmLog& l, Index a, Index) { l.q.col(a) *= 180.0 / std::numbers::pi; }},
      {"position and effort exchanged", FaultKind::swapped_columns,
       [](ArmLog& l, Index a, Index) { l.q.col(a).swap(l.tau.col(a)); }, true}};
  for (const Planted& planted : all) {
    int found = 0, tried = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      ArmLog log = draw_log(nominal, seed, {0.02, 0.0});
      const auto a = static_cast<Index>(seed % kArmJoints), b = (a + 2) % kArmJoints;
      planted.plant(log, a, b);
      const std::vector<DataFault> faults = arm.stops(log);
      ++tried;
      const std::string name = fmt::format("j{}", a + 1), other = fmt::format("j{}", b + 1);
      const bool right = std::any_of(faults.begin(), faults.end(), [&](const DataFault& f) {
        const bool here =
            f.channel.ends_with("_" + name) ||
            (planted.kind == FaultKind::swapped_columns && f.channel.ends_with("_" + other));
        // An effort of more than half a turn passes for degrees first, where it stands for a
        // position.
        const bool kind =
            f.kind == planted.kind || (planted.or_degrees && f.kind == FaultKind::unit_slip);
        return kind && here;
      });
      if (!right) WARN(planted.name << ", seed " << seed << ": " << text(faults));
      found += right;
    }
    INFO(planted.name);
    CHECK(found == tried);
  }
}

TEST_CASE("a factor or a sign of one effort is told with its column", "[slow]") {
  // Seen to fail with each joint's share off by itself: a half at the first joint passes.
  const Mechanism nominal = arm_of_five();
  JudgedArm arm(nominal);
  for (const int joint : {1, 2, 4})
    for (const double factor : {3.0, 0.5, 50.0, -1.0}) {
      INFO("joint " << joint << ", times " << factor);
      ArmLog log = draw_log(nominal, 1, {});
      log.tau.col(joint - 1) *= factor;
      const std::vector<DataFault> faults = arm.stops(log);
      REQUIRE(faults.size() == 1);
      CHECK(faults.front().channel == fmt::format("tau_j{}", joint));
      CHECK(faults.front().kind ==
            (factor < 0.0 ? FaultKind::reversed_sign : FaultKind::unit_slip));
    }
}

TEST_CASE("an arm that lacks friction, a load or a mass has no factor of its own", "[slow]") {
  // Planted defect, seen to fail: with masses known within 1e-4 (kMassOrFriction) the hand of twice
  // the mass is told as a unit.
  const Mechanism nominal = arm_of_five();
  Mechanism loaded = nominal;
  loaded.bodies.back().mass *= 2.0;
  loaded.bodies.back().inertia *= 2.0;
  JudgedArm arm(nominal);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    INFO("seed " << seed);
    CHECK(arm.stops(draw_log(nominal, seed, {0.5, 0.3})).empty());
    CHECK(arm.stops(draw_log(loaded, seed, {0.5, 0.3})).empty());
    CHECK(arm.stops(draw_log(loaded, seed, {})).empty());
  }
}

TEST_CASE("an arm with a cable at a joint is no faulty log", "[slow]") {
  // Seen red with an offset alone in place of a curve over the position: five of these are told as
  // columns that are not what they say.
  for (const Mechanism& nominal : {upper_and_lower_arm(), arm_of_five()}) {
    JudgedArm arm(nominal);
    for (std::uint64_t seed = 3; seed <= 5; ++seed)
      for (Index joint = 0; joint < Index(nominal.joints.size()); ++joint)
        for (const double strength : {2.0, 6.0}) {  // of the effort
          INFO("seed " << seed << ", joint " << joint << ", strength " << strength);
          ArmLog log = draw_log(nominal, seed, {});
          const double usual = std::sqrt(log.tau.col(joint).squaredNorm() / double(log.q.rows()));
          log.tau.col(joint) += strength * usual * log.q.col(joint);
          CHECK(text(arm.stops(log)).empty());
        }
  }
}

TEST_CASE("an arm that lacks rotors, friction or a load has no slip in common", "[slow]") {
  const Mechanism nominal = arm_of_five();
  const Mechanism loaded = heavier(nominal);
  JudgedArm arm(nominal);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    INFO("seed " << seed);
    CHECK(arm.stops(with_rotors(nominal, seed)).empty());
    CHECK(arm.stops(with_rotors(loaded, seed)).empty());
  }
}

TEST_CASE("a factor of all efforts, or of the clock, is told as a slip of its unit", "[slow]") {
  // Seen to fail where columns of unlike quantities were exchanged as often as others: 1.5 passes.
  const Mechanism nominal = arm_of_five();
  JudgedArm arm(nominal);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const double factor : {1.5, 4.448, 0.2}) {
      INFO("seed " << seed << ", efforts times " << factor);
      ArmLog log = with_rotors(nominal, seed);
      log.tau *= factor;
      const std::vector<DataFault> faults = arm.stops(log);
      REQUIRE(faults.size() == 1);
      CHECK(faults.front().kind == FaultKind::unit_slip);
      CHECK_THAT(faults.front().meaning,
                 Catch::Contains(fmt::format("{:.2g}", factor).substr(0, 2)));
    }
    for (const double factor : {1.5, 0.5}) {
      INFO("seed " << seed << ", time times " << factor);
      ArmLog log = with_rotors(nominal, seed);
      log.step *= factor;
      const std::vector<DataFault> faults = arm.stops(log);
      REQUIRE(faults.size() == 1);
      CHECK(faults.front().kind == FaultKind::time_unit);
    }
  }
}

TEST_CASE("an arm whose efforts do what nothing explains is no faulty log", "[slow]") {
  // Planted defect: without kMostLeft clocks and exchanged columns are told of the largest swings.
  const Mechanism nominal = arm_of_five();
  JudgedArm arm(nominal);
  for (const double size : {0.4, 1.0, 3.0})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      INFO(size << " of the efforts, seed " << seed);
      ArmLog log = draw_log(nominal, seed, {});
      for (Index c = 0; c < log.tau.cols(); ++c) {
        const Eigen::ArrayXd turn =
            5.0 * log.step *
            Eigen::ArrayXd::LinSpaced(log.tau.rows(), 0.0, double(log.tau.rows() - 1));
        const double spread =
            std::sqrt((log.tau.col(c).array() - log.tau.col(c).mean()).square().mean());
        log.tau.col(c).array() += size * spread * (turn + double(c)).sin();
      }
      CHECK(text(arm.stops(log)).empty());
    }
}
