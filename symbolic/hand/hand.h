// SPDX-License-Identifier: GPL-3.0-or-later
// The complete hand: fingers on a palm, the four-bar that carries one of them, and the wrist that
// all tendons pass.
//
// Coordinates q: those of the fingers in the order of the description, then the four-bar's crank,
// if there is one; with q_wrist = (q71, q73) behind them they are the columns of every matrix.
// Tendons are numbered by wrist channel. h_i = h_wrist,i(q_wrist) + h_finger,i(q) (5.1).
#pragma once

#include <string>
#include <vector>

#include "symbolic/parts/four_bar.h"
#include "symbolic/model/mechanism.h"
#include "symbolic/parts/wrist.h"

namespace sinew {

struct HandFinger {
  Mechanism mechanism;
  Transform base;             ///< finger base to palm {ABC}, or to the coupler that carries it
  bool on_coupler = false;    ///< rides on the four-bar's coupler
  std::vector<int> channels;  ///< wrist channel of each tendon, from 0
};

struct Hand {
  std::string name;
  std::string description;
  WristParameters wrist;
  std::vector<HandFinger> fingers;
  std::string four_bar_name;  ///< empty: the hand has none
  FourBarParameters four_bar;
  Transform four_bar_base;             ///< linkage plane to palm {ABC}
  std::vector<int> four_bar_channels;  ///< of its two tendons
  bool has_four_bar() const { return !four_bar_name.empty(); }
};

/// Names of the coordinates q, in order.
std::vector<std::string> coordinate_names(const Hand& hand);

/// tendon_lengths(q, q_wrist -> h): of wrist and finger together (5.1).
Function hand_tendon_lengths(const Hand& hand);

/// tendon_lengths(q, q_wrist -> h), coupling_matrix(-> P, channels x coordinates + 2),
/// joint_torque(q, q_wrist, f -> tau), joint_stiffness(q, q_wrist, f, kt -> K),
/// feedforward(q_wrist -> delta_theta), feedforward_rate(q_wrist, qd_wrist -> rate),
/// fingertips(q, q_wrist -> in_palm, in_forearm), finger_gravity(q, q_wrist, gravity -> g), and
/// those of hand_dynamics.h.
/// Throws std::invalid_argument unless every tendon has a channel and every channel one tendon.
std::vector<Function> hand_functions(const Hand& hand);

}  // namespace sinew
