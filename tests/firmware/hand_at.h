// SPDX-License-Identifier: GPL-3.0-or-later
// What the sensors of a hand read in a state, by the emitted models and not by hand_step's own
// polynomials.
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include "hand.h"
#include "hand_step.h"
#include "lever.h"
#include "lever_catalogue.h"

namespace sinew::test {

struct HandAt {
  std::array<double, HAND_COORDINATES> q{};
  std::array<double, 2> q_wrist{};
  std::array<double, HAND_TENDONS> count{}, force{}, theta{};
};

/// l0 / (E S) of models/tendon [m/N].
inline constexpr double tendon_softness = 0.5 / 10000;

inline const hand_parameters& table() {
  return hand_parameters_table;
}

/// Joints and wrist by shares of their ranges from -1 to 1, levers by counts.
inline HandAt hand_at(const std::array<double, HAND_COORDINATES>& share,
                      const std::array<double, 2>& wrist,
                      const std::array<double, HAND_TENDONS>& count) {
  HandAt at;
  at.count = count;
  const auto within = [](double low, double high, double s) {
    return 0.5 * (low + high) + 0.5 * s * (high - low);
  };
  for (std::size_t j = 0; j < at.q.size(); ++j)
    at.q[j] = within(table().joint_low[j], table().joint_high[j], share[j]);
  for (std::size_t i = 0; i < 2; ++i)
    at.q_wrist[i] = within(table().wrist_low[i], table().wrist_high[i], wrist[i]);
  double h[HAND_TENDONS];
  hand_tendon_lengths(at.q.data(), at.q_wrist.data(), h);
  for (std::size_t i = 0; i < at.count.size(); ++i) {
    const sinew_argument& travel = lever_catalogue.functions[0].inputs[0];
    const double free = travel.high[0], end = travel.low[0];
    const double angle = free + count[i] / 4095.0 * (end - free);
    double state[4];
    lever_state(angle, state);
    at.force[i] = state[2];
    const double elongation = state[1] + tendon_softness * state[2];
    at.theta[i] = (elongation + table().closure[i] - h[i]) / table().motor_radius;
  }
  return at;
}

inline hand_input input_of(const HandAt& at) {
  hand_input in;
  std::memset(&in, 0, sizeof in);
  std::copy(at.theta.begin(), at.theta.end(), in.motor_angle);
  std::copy(at.count.begin(), at.count.end(), in.lever_count);
  for (int i = 0; i < 2; ++i)
    in.wrist_count[i] = (at.q_wrist[static_cast<std::size_t>(i)] - table().wrist_offset[i]) /
                        table().wrist_scale[i];
  in.gravity[2] = -9.81;
  std::copy(at.q.begin(), at.q.end(), in.q);
  return in;
}

}  // namespace sinew::test
