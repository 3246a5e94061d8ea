// SPDX-License-Identifier: GPL-3.0-or-later
// What hand_step does by turns: whole, of one tick, and no older than it says.
#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <vector>

#include "sinew_checksum.h"
#include "tests/firmware/hand_at.h"

using namespace sinew::test;

namespace {

constexpr int n = HAND_COORDINATES + 2;

/// The table's hand with another number of turns.
std::unique_ptr<hand_parameters> with_turns(std::uint32_t turns) {
  auto copy = std::make_unique<hand_parameters>(table());
  copy->turns = turns;
  copy->checksum = sinew_checksum(0, copy.get(), offsetof(hand_parameters, checksum));
  return copy;
}

/// A hand of which everything moves in every tick, and all ticks so far.
class MovingHand {
 public:
  explicit MovingHand(std::uint32_t turns) : parameters_(with_turns(turns)) {
    std::array<double, HAND_TENDONS> counts;
    counts.fill(1600.0);
    const HandAt at = hand_at({}, {0.2, -0.1}, counts);
    in_ = input_of(at);
    in_.drive = 1;
    REQUIRE(hand_start(&state_, parameters_.get()) == HAND_START_FINE);
  }

  void tick() {
    const double phase = 0.05 * static_cast<double>(ins.size());
    for (int i = 0; i < HAND_TENDONS; ++i) {
      in_.motor_angle[i] += 4e-4 * std::cos(phase + i);
      in_.lever_count[i] += 3.0 * std::cos(phase - i);
    }
    for (double& each : in_.wrist_count) each += 20.0 * std::cos(phase);
    for (int j = 0; j < HAND_COORDINATES; ++j) {
      in_.q[j] += 1e-3 * std::cos(phase + j);
      in_.qd[j] = 3.0 * std::cos(phase + j);
      in_.qdd[j] = 9.0 * std::sin(phase - j);
    }
    hand_step(&state_, parameters_.get(), &in_, &out_);
    ins.push_back(in_);
    outs.push_back(out_);
  }

  std::vector<hand_input> ins;
  std::vector<hand_output> outs;

 private:
  std::unique_ptr<hand_parameters> parameters_;
  hand_state state_{};
  hand_input in_{};
  hand_output out_{};
};

/// Sensors come up, and the reference has reached the wanted motion.
constexpr std::size_t settled = 200, ticks = 400;

MovingHand moved(std::uint32_t turns) {
  MovingHand hand(turns);
  for (std::size_t t = 0; t < ticks; ++t) hand.tick();
  REQUIRE((hand.outs.back().status & HAND_UNSAFE) == 0);
  return hand;
}

}  // namespace

// Seen red with the wrist's own block left out, with the forces of the turn after it, and with
// finger blocks of the angles of the turn after it.
TEST_CASE("the stiffness matrix is a whole one of one tick", "[hand_step]") {
  for (const std::uint32_t turns : {1U, static_cast<std::uint32_t>(HAND_TURNS)}) {
    const MovingHand hand = moved(turns);
    int differing = 0;
    for (std::size_t t = settled; t < ticks; ++t) {
      const hand_output& of = hand.outs[t - hand.outs[t].stiffness_age];
      double K[n * n];
      hand_joint_stiffness(of.q, of.q_wrist, of.force, of.stiffness, K);
      differing += std::memcmp(K, hand.outs[t].joint_stiffness, sizeof K) != 0;
    }
    CHECK(differing == 0);
  }
}

// Seen red with the thumb's torques by the coupling of the turn after it, and with torques handed
// over before the forces for them.
TEST_CASE("the joints' feedforward and the forces for it are of one motion", "[hand_step]") {
  for (const std::uint32_t turns : {1U, static_cast<std::uint32_t>(HAND_TURNS)}) {
    const MovingHand hand = moved(turns);
    double largest = 0.0, of_forces = 0.0;
    for (std::size_t t = settled; t < ticks; ++t) {
      const hand_output& out = hand.outs[t];
      const hand_input& wanted = hand.ins[t - out.feedforward_age];
      const double* bars = hand.outs[t - out.feedforward_age].q_wrist;
      double g[3 * HAND_FINGERS], tau[HAND_JOINTS], more[HAND_TENDONS], given[n];
      hand_finger_gravity(wanted.q, bars, wanted.gravity, g);
      hand_inverse_dynamics(wanted.q, wanted.qd, wanted.qdd, g, tau);
      for (int i = 0; i < HAND_TENDONS; ++i)
        more[i] = (out.motor_feedforward[i] - out.friction_feedforward[i]) / table().motor_radius -
                  table().pretension;
      hand_joint_torque(wanted.q, bars, more, given);
      for (int j = 0; j < HAND_JOINTS; ++j) {
        largest = std::max(largest, std::abs(out.joint_feedforward[j] - tau[j]));
        of_forces = std::max(of_forces, std::abs(given[j] - tau[j]));
      }
    }
    CHECK(largest < 1e-12);
    CHECK(of_forces < 1e-9);
  }
}

// Seen red with a motor that had no turn, with all of them in every tick, and with ages that began
// anew in the turn that hands over.
TEST_CASE("what comes by turns is as old as it says and no older than stated", "[hand_step]") {
  constexpr std::uint32_t turns = HAND_TURNS;
  const MovingHand hand = moved(turns);
  CHECK(hand.outs.front().stiffness_age >= HAND_NONE_YET);
  CHECK(hand.outs.front().feedforward_age >= HAND_NONE_YET);
  for (std::size_t t = settled; t < ticks; ++t) {
    const hand_output &now = hand.outs[t], &last = hand.outs[t - 1];
    const auto follows = [](std::uint32_t age, std::uint32_t before) {
      return age == before + 1 || (before == turns && age == 1);
    };
    CHECK(follows(now.stiffness_age, last.stiffness_age));
    CHECK(follows(now.feedforward_age, last.feedforward_age));
  }
  for (int i = 0; i < HAND_TENDONS; ++i)
    for (std::size_t t = settled; t + turns < ticks; t += turns) {
      int changes = 0;
      for (std::size_t k = t; k < t + turns; ++k)
        changes += hand.outs[k + 1].friction_feedforward[i] != hand.outs[k].friction_feedforward[i];
      CHECK(changes == 1);
    }
  const MovingHand every_tick = moved(1);
  CHECK(every_tick.outs.back().stiffness_age == 0);
  CHECK(every_tick.outs.back().feedforward_age == 0);
}

TEST_CASE("a table with another number of turns is refused", "[hand_step]") {
  hand_state state;
  for (const std::uint32_t turns : {0U, 2U, 4U, 7U})
    CHECK(hand_start(&state, with_turns(turns).get()) == HAND_START_VERSION);
}
