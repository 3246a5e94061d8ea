// SPDX-License-Identifier: GPL-3.0-or-later
// Random faults of the sensors, tick after tick: no undefined status, no drift, nothing that is not
// finite. SINEW_SOAK_SECONDS makes it as long as wanted (scripts/verify soak: an hour).
#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <limits>

#include "tests/firmware/hand_at.h"

using namespace sinew::test;

namespace {

constexpr std::uint32_t known_statuses = SINEW_NOT_FINITE | SINEW_OUT_OF_RANGE | SINEW_JUMPED |
                                         SINEW_FROZEN | SINEW_HELD | SINEW_SAFE | HAND_SLACK |
                                         HAND_NOT_CONVERGED | HAND_JOINT_RANGE | HAND_SETPOINT |
                                         HAND_TORQUE_LIMITED | HAND_UNSAFE;

/// A hand whose joints move slowly about the middle, and a sound twin of it.
class Soak {
 public:
  explicit Soak(unsigned seed) : random_(seed) {
    REQUIRE(hand_start(&faulty_, &table()) == HAND_START_FINE);
    REQUIRE(hand_start(&sound_, &table()) == HAND_START_FINE);
  }

  void tick() {
    if (ticks_ % 64 == 0) choose_faults();
    hand_input in = moving();
    hand_step(&sound_, &table(), &in, &sound_out_);
    spoil(in);
    hand_step(&faulty_, &table(), &in, &out_);
    check();
    ++ticks_;
  }
  long ticks() const { return ticks_; }
  long wrong() const { return wrong_; }
  long compared() const { return compared_; }
  double largest_difference() const { return largest_difference_; }
  long faults() const { return faults_; }

 private:
  struct Fault {
    int channel;  ///< motors, levers, potentiometers, setpoints
    int kind;
    double value;
  };

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }

  /// Lever counts and potentiometers with noise, so that nothing is frozen.
  hand_input moving() {
    if (ticks_ % 32 == 0) {
      std::array<double, HAND_COORDINATES> share;
      std::array<double, HAND_TENDONS> count;
      for (std::size_t j = 0; j < share.size(); ++j)
        share[j] = 0.1 * std::sin(1e-3 * static_cast<double>(ticks_) + static_cast<double>(j));
      count.fill(1700.0);
      base_ = input_of(hand_at(share, {0.0, 0.0}, count));
      base_.drive = 1;
    }
    hand_input in = base_;
    for (double& each : in.lever_count) each += std::round(uniform(-1.5, 1.5));
    for (double& each : in.wrist_count) each += std::round(uniform(-1.5, 1.5));
    return in;
  }

  /// Rounds of 64 ticks: quiet ones, in which the faulty hand has to come back, and others.
  void choose_faults() {
    active_.clear();
    const long round = ticks_ / 64;
    quiet_rounds_ = round % 4 >= 2 ? quiet_rounds_ + 1 : 0;
    if (quiet_rounds_ > 0) return;
    const int count = 1 + static_cast<int>(random_() % 6);
    for (int i = 0; i < count; ++i)
      active_.push_back(
          {static_cast<int>(random_() % (2 * HAND_TENDONS + 2 + 3 * HAND_COORDINATES)),
           static_cast<int>(random_() % 7), uniform(-1.0, 1.0)});
  }

  double spoilt(const Fault& fault, double value) {
    switch (fault.kind) {
      case 0:
        return std::numeric_limits<double>::quiet_NaN();
      case 1:
        return fault.value < 0 ? -std::numeric_limits<double>::infinity()
                               : std::numeric_limits<double>::infinity();
      case 2:
        return fault.value * 1e300;
      case 3:
        return 1000.0 * fault.value;  // frozen where it may not be
      case 4:
        return value * (1.0 + fault.value);
      case 5: {  // any bits at all
        const std::uint64_t bits = random_();
        std::memcpy(&value, &bits, sizeof value);
        return value;
      }
      default:
        return random_() % 2 ? value : fault.value;  // loose contact
    }
  }

  void spoil(hand_input& in) {
    for (const Fault& fault : active_) {
      auto* const values = reinterpret_cast<double*>(&in);
      const int at = fault.channel < 2 * HAND_TENDONS + 2 ? fault.channel : fault.channel + 3;
      values[at] = spoilt(fault, values[at]);
      ++faults_;
    }
  }

  void check() {
    const double* first = out_.force;
    const auto* last = reinterpret_cast<const double*>(out_.motor_status);
    bool fine = (out_.status & ~known_statuses) == 0;
    for (; first != last; ++first) fine = fine && sinew_is_finite(*first);
    for (const double torque : out_.motor_torque)
      fine = fine && std::abs(torque) <= table().torque_limit;
    for (const std::uint32_t status : out_.group_status)
      fine = fine && (status & ~known_statuses) == 0;
    wrong_ += !fine;
    if (quiet_rounds_ < 2 || ticks_ % 64 < 60) return;
    // The faults are over for two rounds: what they were must have been forgotten.
    ++compared_;
    for (int j = 0; j < HAND_COORDINATES; ++j)
      largest_difference_ = std::max(largest_difference_, std::abs(out_.q[j] - sound_out_.q[j]));
    for (int i = 0; i < HAND_TENDONS; ++i)
      largest_difference_ = std::max(largest_difference_,
                                     std::abs(out_.motor_torque[i] - sound_out_.motor_torque[i]));
    wrong_ += out_.status != sound_out_.status;
  }

  std::mt19937_64 random_;
  hand_state faulty_{}, sound_{};
  hand_output out_{}, sound_out_{};
  hand_input base_{};
  std::vector<Fault> active_;
  long ticks_ = 0, wrong_ = 0, compared_ = 0, faults_ = 0, quiet_rounds_ = 0;
  double largest_difference_ = 0.0;
};

void require_fine(const Soak& soak) {
  CHECK(soak.wrong() == 0);
  CHECK(soak.faults() > 1000);
  REQUIRE(soak.compared() > 100);
  CHECK(soak.largest_difference() < 1e-6);
}

}  // namespace

// Seen red with the sample given on instead of the last good value, and with torques not limited.
TEST_CASE("random faults of sensors leave no trace", "[hand_step]") {
  Soak soak(1);
  for (int i = 0; i < 20000; ++i) soak.tick();
  require_fine(soak);
}

TEST_CASE("random faults of sensors for as long as wanted", "[.soak]") {
  const char* asked = std::getenv("SINEW_SOAK_SECONDS");
  const double seconds = asked ? std::atof(asked) : 60.0;
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  Soak soak(2);
  while (elapsed() < seconds)
    for (int i = 0; i < 1000; ++i) soak.tick();
  std::cout << soak.ticks() << " ticks with " << soak.faults() << " spoilt samples in " << elapsed()
            << " s; " << soak.compared() << " compared with the sound twin, off by at most "
            << soak.largest_difference() << "\n";
  require_fine(soak);
}
