// SPDX-License-Identifier: GPL-3.0-or-later
// hand_step against the emitted models, and under faults of its sensors.
#include <catch2/catch.hpp>

#include <limits>
#include <memory>

#include "fifth.h"
#include "index.h"
#include "middle.h"
#include "ring.h"
#include "tests/firmware/hand_at.h"
#include "thumb.h"
#include "wrist.h"

using namespace sinew::test;

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr int n = HAND_COORDINATES + 2;

/// A hand that has settled in a state.
struct Running {
  hand_state state{};
  hand_output out{};
  hand_input in{};

  explicit Running(const HandAt& at, int ticks = 60) : in(input_of(at)) {
    REQUIRE(hand_start(&state, &table()) == HAND_START_FINE);
    for (int i = 0; i < ticks; ++i) tick();
  }
  void tick() { hand_step(&state, &table(), &in, &out); }
};

HandAt drawn(unsigned seed, double reach = 0.9) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(-reach, reach), counts(200.0, 3900.0);
  std::array<double, HAND_COORDINATES> q;
  std::array<double, 2> wrist;
  std::array<double, HAND_TENDONS> count;
  for (double& each : q) each = share(random);
  for (double& each : wrist) each = share(random);
  for (double& each : count) each = counts(random);
  return hand_at(q, wrist, count);
}

double largest_difference(const double* a, const double* b, int count) {
  double largest = 0.0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Whether every double of the output is finite.
bool all_finite(const hand_output& out) {
  const double* first = out.force;
  const auto* last = reinterpret_cast<const double*>(out.motor_status);
  for (; first != last; ++first)
    if (!sinew_is_finite(*first)) return false;
  return true;
}

}  // namespace

TEST_CASE("the hand's inverse dynamics is that of its fingers", "[hand_step]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    double q[HAND_JOINTS], qd[HAND_JOINTS], qdd[HAND_JOINTS], tau[HAND_JOINTS], own[HAND_JOINTS];
    for (int j = 0; j < HAND_JOINTS; ++j) {
      q[j] = share(random);
      qd[j] = 5.0 * share(random);
      qdd[j] = 50.0 * share(random);
    }
    double g[3 * HAND_FINGERS] = {};
    for (int f = 0; f < HAND_FINGERS; ++f) g[3 * f + 2] = -9.81;  // as the fingers' models have it
    hand_inverse_dynamics(q, qd, qdd, g, tau);
    thumb_inverse_dynamics(q, qd, qdd, own);
    index_inverse_dynamics(q + 4, qd + 4, qdd + 4, own + 4);
    middle_inverse_dynamics(q + 8, qd + 8, qdd + 8, own + 8);
    ring_inverse_dynamics(q + 12, qd + 12, qdd + 12, own + 12);
    fifth_inverse_dynamics(q + 15, qd + 15, qdd + 15, own + 15);
    CHECK(largest_difference(tau, own, HAND_JOINTS) < 1e-13);
    // Turned about the whole hand, gravity does the same work: sideways and back cancel.
    for (double& each : g) each = share(random) * 9.81;
    double opposite[3 * HAND_FINGERS], other[HAND_JOINTS], none[HAND_JOINTS];
    for (int k = 0; k < 3 * HAND_FINGERS; ++k) opposite[k] = -g[k];
    const double zero[3 * HAND_FINGERS] = {};
    hand_inverse_dynamics(q, qd, qdd, g, tau);
    hand_inverse_dynamics(q, qd, qdd, opposite, other);
    hand_inverse_dynamics(q, qd, qdd, zero, none);
    for (int j = 0; j < HAND_JOINTS; ++j)
      CHECK(std::abs(tau[j] + other[j] - 2.0 * none[j]) < 1e-13);
  }
}

TEST_CASE("lengths and couplings through the wrist are the wrist's", "[hand_step]") {
  const double bars[2] = {0.5, 1.0};
  double h[HAND_TENDONS], P[2 * HAND_TENDONS], own_h[HAND_TENDONS], own_P[2 * HAND_TENDONS];
  hand_wrist_passage(bars, h, P);
  wrist_tendon_lengths(bars[0], bars[1], own_h);
  wrist_tendon_jacobian(bars[0], bars[1], own_P);
  CHECK(largest_difference(h, own_h, HAND_TENDONS) < 1e-15);
  CHECK(largest_difference(P, own_P, 2 * HAND_TENDONS) < 1e-15);
}

// Seen red with the sign of R theta turned, and with the wrist's length left out.
TEST_CASE("hand_step finds the state behind the sensors", "[hand_step]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const HandAt at = drawn(seed);
    Running hand(at);
    CHECK((hand.out.status & ~static_cast<std::uint32_t>(HAND_JOINT_RANGE)) == 0);
    // 7 mN by which the polynomials are off, a tendon's softness of 5e-5 m/N, a pulley of 3.6 mm.
    CHECK(largest_difference(hand.out.q, at.q.data(), HAND_COORDINATES) < 1e-4);
    CHECK(largest_difference(hand.out.q_wrist, at.q_wrist.data(), 2) < 1e-12);
    CHECK(largest_difference(hand.out.force, at.force.data(), HAND_TENDONS) < 0.01);
    double tau[n], K[n * n];
    hand_joint_torque(hand.out.q, hand.out.q_wrist, hand.out.force, tau);
    CHECK(largest_difference(hand.out.joint_torque, tau, n) < 1e-12);
    CHECK(hand.out.stiffness_age <= table().turns);
    hand_joint_stiffness(hand.out.q, hand.out.q_wrist, hand.out.force, hand.out.stiffness, K);
    CHECK(largest_difference(hand.out.joint_stiffness, K, n * n) < 1e-9);
    double feedforward[HAND_TENDONS];
    hand_feedforward(hand.out.q_wrist, feedforward);
    // The table's reference pose is rounded to a microradian.
    CHECK(largest_difference(hand.out.wrist_feedforward, feedforward, HAND_TENDONS) < 1e-5);
  }
}

// Seen red with the polynomial's last coefficient left out, and with the tendon's own softness
// put in series.
TEST_CASE("stiffness is the derivative of the force along the elongation", "[hand_step]") {
  for (const double count : {300.0, 1500.0, 2600.0, 3800.0}) {
    std::array<double, HAND_TENDONS> counts;
    counts.fill(count);
    const Running hand(hand_at({}, {}, counts));
    counts.fill(count - 5.0);
    const Running before(hand_at({}, {}, counts));
    counts.fill(count + 5.0);
    const Running after(hand_at({}, {}, counts));
    // R theta is the elongation where nothing else moves.
    const double slope =
        (after.out.force[3] - before.out.force[3]) /
        (table().motor_radius * (after.in.motor_angle[3] - before.in.motor_angle[3]));
    CHECK(hand.out.stiffness[3] == Approx(slope).epsilon(0.005));
  }
}

// Seen red with rates that are 1 % off.
TEST_CASE("the wrist's rates are those of its lengths", "[hand_step]") {
  const HandAt at = drawn(4, 0.3);
  Running hand(at);
  constexpr double speed = 2.0;  // rad/s
  double before[HAND_TENDONS];
  for (int i = 0; i < 100; ++i) {
    for (int k = 0; k < 2; ++k)
      hand.in.wrist_count[k] += speed * table().period / table().wrist_scale[k];
    std::copy(hand.out.wrist_length, hand.out.wrist_length + HAND_TENDONS, before);
    hand.tick();
  }
  CHECK(hand.out.qd_wrist[0] == Approx(speed).epsilon(1e-3));
  for (int i = 0; i < HAND_TENDONS; ++i) {
    const double rate = (hand.out.wrist_length[i] - before[i]) / table().period;
    CHECK(std::abs(hand.out.wrist_rate[i] - rate) < 2e-4);
    CHECK(hand.out.wrist_feedforward_rate[i] ==
          Approx(-hand.out.wrist_rate[i] / table().motor_radius));
  }
}

// Seen red with the feedforward's sign turned.
TEST_CASE("the motors' references hold the wanted posture", "[hand_step]") {
  HandAt at = drawn(7, 0.5);
  std::array<double, HAND_TENDONS> counts;
  counts.fill(1600.0);
  at = hand_at({}, {0.2, -0.1}, counts);
  Running hand(at);
  hand.in.drive = 1;
  for (int i = 0; i < 20; ++i) hand.tick();
  CHECK((hand.out.status & ~static_cast<std::uint32_t>(HAND_TORQUE_LIMITED)) == 0);
  // What the feedforward adds to the forces gives the joints the torque that gravity takes.
  double more[HAND_TENDONS], tau[n], expected[HAND_JOINTS], g[HAND_FINGERS * 3];
  const double zero[HAND_COORDINATES] = {};
  hand_finger_gravity(hand.out.q, hand.out.q_wrist, hand.in.gravity, g);
  hand_inverse_dynamics(hand.out.q, zero, zero, g, expected);
  for (int i = 0; i < HAND_TENDONS; ++i)
    more[i] =
        (hand.out.motor_feedforward[i] - hand.out.friction_feedforward[i]) / table().motor_radius -
        table().pretension;
  hand_joint_torque(hand.out.q, hand.out.q_wrist, more, tau);
  CHECK(largest_difference(tau, expected, HAND_JOINTS) < 1e-6);
  CHECK(largest_difference(hand.out.joint_feedforward, expected, HAND_JOINTS) < 1e-9);
}

TEST_CASE("one bad sample changes one tick and none after it", "[hand_step]") {
  const HandAt at = drawn(11);
  for (const double bad : {no_value, 1e308, -1.0, std::numeric_limits<double>::infinity()}) {
    for (int where = 0; where < 3; ++where) {
      Running hand(at), other(at);
      double& sample = where == 0   ? hand.in.motor_angle[9]
                       : where == 1 ? hand.in.lever_count[9]
                                    : hand.in.wrist_count[1];
      const double good = sample;
      sample = bad;
      hand.tick();
      other.tick();
      CHECK(all_finite(hand.out));
      const std::uint32_t status = where == 0   ? hand.out.motor_status[9]
                                   : where == 1 ? hand.out.lever_status[9]
                                                : hand.out.wrist_status[1];
      if (!(where == 0 && bad == -1.0)) CHECK((status & SINEW_HELD) != 0);
      CHECK(largest_difference(hand.out.q, other.out.q, HAND_COORDINATES) <
            1e-9 + (where == 0 && bad == -1.0));
      sample = good;
      for (int i = 0; i < 3; ++i) {
        hand.tick();
        other.tick();
      }
      if (where == 0 && bad == -1.0) continue;  // within the range, and no fault unless it jumps
      CHECK(hand.out.status == other.out.status);
      CHECK(std::memcmp(hand.out.q, other.out.q, sizeof other.out.q) == 0);
    }
  }
}

// Seen red with the torque of the finger's motors kept, and with the finger not told as unsafe.
TEST_CASE("a lost sensor makes its finger safe after the stated time, and it comes back",
          "[hand_step]") {
  std::array<double, HAND_TENDONS> counts;
  counts.fill(1600.0);
  Running hand(hand_at({}, {}, counts));
  hand.in.drive = 1;
  for (int i = 0; i < 30; ++i) hand.tick();
  const double count = hand.in.lever_count[10];
  hand.in.lever_count[10] = no_value;
  for (std::uint32_t i = 1; i < table().lever_limits.hold_ticks; ++i) {
    hand.tick();
    CHECK(hand.out.lever_status[10] == (SINEW_NOT_FINITE | SINEW_HELD));
    CHECK((hand.out.group_status[1] & HAND_UNSAFE) == 0);
  }
  const double before = hand.out.q[5];
  hand.tick();
  CHECK((hand.out.lever_status[10] & SINEW_SAFE) != 0);
  CHECK((hand.out.group_status[1] & HAND_UNSAFE) != 0);
  for (int i = 8; i < 16; ++i) CHECK(hand.out.motor_torque[i] == 0.0);
  CHECK(hand.out.motor_torque[0] != 0.0);
  CHECK(hand.out.q[5] == before);
  CHECK(hand.out.force[10] < 0.1);
  hand.in.lever_count[10] = count;
  for (std::uint32_t i = 0; i < table().lever_limits.settle_ticks + 3; ++i) {
    hand.in.lever_count[10] += 0.01;
    hand.tick();
  }
  CHECK((hand.out.status & HAND_UNSAFE) == 0);
  CHECK(hand.out.motor_torque[10] != 0.0);
}

TEST_CASE("a frozen lever is found while the others live", "[hand_step]") {
  std::array<double, HAND_TENDONS> counts;
  counts.fill(1600.0);
  Running hand(hand_at({}, {}, counts), 1);
  for (std::uint32_t i = 0; i < table().lever_limits.frozen_ticks + 5; ++i) {
    for (int k = 0; k < HAND_TENDONS; ++k)
      if (k != 20) hand.in.lever_count[k] = 1600.0 + (i % 2U);
    for (double& each : hand.in.wrist_count) each += i % 2U ? 1.0 : -1.0;
    hand.tick();
  }
  CHECK((hand.out.lever_status[20] & SINEW_FROZEN) != 0);
  CHECK(hand.out.lever_status[21] == SINEW_FINE);
}

// Seen red with the checksum's test left out: every damaged table was taken.
TEST_CASE("a damaged table is refused at start", "[hand_step]") {
  const auto copy = std::make_unique<hand_parameters>(table());
  hand_state state;
  for (std::size_t bit = 0; bit < 8 * offsetof(hand_parameters, version); bit += 997) {
    auto* byte = reinterpret_cast<unsigned char*>(copy.get()) + bit / 8;
    *byte = static_cast<unsigned char>(*byte ^ (1U << bit % 8));
    CHECK(hand_start(&state, copy.get()) != HAND_START_FINE);
    *byte = static_cast<unsigned char>(*byte ^ (1U << bit % 8));
  }
  copy->version += 1;
  CHECK(hand_start(&state, copy.get()) == HAND_START_VERSION);
  CHECK(hand_start(&state, &table()) == HAND_START_FINE);
}
