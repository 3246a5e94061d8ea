// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/hand/hand.h"

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/hand/hand_dynamics.h"
#include "symbolic/hand/hand_members.h"
#include "symbolic/hand/hand_poses.h"
#include "symbolic/tendons/tendons.h"

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

Argument forces(const HandStart& start) {
  return array_argument("f", static_cast<int>(start.channels()), 1, "N", {0.0, 100.0},
                        "tendon forces, pulling");
}

Argument stiffnesses(const HandStart& start) {
  return array_argument("kt", static_cast<int>(start.channels()), 1, "N/m", {1.0e3, 5.0e4},
                        "tendon stiffnesses");
}

std::vector<symbol> of_channels(const std::vector<symbol>& all, const std::vector<int>& channels) {
  std::vector<symbol> own;
  for (const int channel : channels) own.push_back(all[static_cast<std::size_t>(channel)]);
  return own;
}

/// channels x (coordinates + 2): each tendon's own member, and the wrist.
std::vector<ex> whole_coupling(HandStart& start, const std::vector<ex>& wrist) {
  const std::size_t columns = start.coordinates() + 2;
  std::vector<ex> P(start.channels() * columns, ex(0));
  for (const HandMember& member : start.members)
    for (std::size_t t = 0; t < member.channels.size(); ++t)
      for (std::size_t j = 0; j < member.q.size(); ++j)
        P[static_cast<std::size_t>(member.channels[t]) * columns + member.first + j] =
            member.P[t * member.q.size() + j];
  for (std::size_t i = 0; i < start.channels(); ++i)
    for (std::size_t j = 0; j < 2; ++j) P[i * columns + start.coordinates() + j] = wrist[2 * i + j];
  return P;
}
std::vector<ex> whole_coupling(HandStart& start) {
  return whole_coupling(
      start, inlined(start.list, wrist_tendon_jacobian(start.hand.wrist), start.wrist_inputs())[0]);
}

Function hand_coupling_matrix(const Hand& hand) {
  HandStart start(hand);
  start.add_tendons();
  const std::vector<ex> P = whole_coupling(start);
  return {"coupling_matrix",
          "Coupling matrix P = dh/d(q, q_wrist) of the whole hand.",
          "",
          {start.q, start.q_wrist},
          start.list.items(),
          {{"P", static_cast<int>(start.channels()), static_cast<int>(start.coordinates() + 2), P,
            "m/rad", "rows by wrist channel; the last two columns are q71, q73"}}};
}

Function hand_joint_torque(const Hand& hand) {
  HandStart start(hand);
  start.add_tendons();
  const Argument f = forces(start);
  const std::size_t n = start.coordinates() + 2;
  const std::vector<ex> tau = joint_torque(start.list, whole_coupling(start), f.symbols, n);
  return {"joint_torque",
          "Torques on all joints from the tendon forces: tau = -P^T f.",
          "(5.8)",
          {start.q, start.q_wrist, f},
          start.list.items(),
          {{"tau", static_cast<int>(n), 1, tau, "N m", "fingers, crank, q71, q73"}}};
}

/// Stiffness of each member on itself and between it and the wrist.
void add_member(HandStart& start, const HandMember& member, const std::vector<symbol>& f,
                const std::vector<symbol>& kt, const std::vector<ex>& P, std::vector<ex>& K) {
  const std::size_t n = start.coordinates() + 2, own = member.q.size();
  const std::vector<ex> block =
      joint_stiffness(start.list, member.lengths, member.P, member.q,
                      of_channels(f, member.channels), of_channels(kt, member.channels));
  for (std::size_t r = 0; r < own; ++r) {
    for (std::size_t c = 0; c < own; ++c)
      K[(member.first + r) * n + member.first + c] = block[r * own + c];
    for (std::size_t w = n - 2; w < n; ++w) {
      ex sum = 0;
      for (const int channel : member.channels) {
        const auto i = static_cast<std::size_t>(channel);
        sum += kt[i] * P[i * n + member.first + r] * P[i * n + w];
      }
      K[(member.first + r) * n + w] = K[w * n + member.first + r] =
          start.list.define("K_wrist", sum);
    }
  }
}

/// Of fingers and crank, and the wrist's own 2 x 2 block.
Output whole_stiffness(HandStart& start, const Argument& f, const Argument& kt,
                       const std::vector<ex>& P, const std::vector<ex>& wrist) {
  const std::size_t n = start.coordinates() + 2;
  std::vector<ex> K(n * n, ex(0));
  for (const HandMember& member : start.members)
    add_member(start, member, f.symbols, kt.symbols, P, K);
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t c = 0; c < 2; ++c) K[(n - 2 + r) * n + n - 2 + c] = wrist[2 * r + c];
  return {"K", static_cast<int>(n), static_cast<int>(n),
          K,   "N m/rad",           "symmetric; fingers, crank, q71, q73"};
}

void append(std::vector<ex>& values, const std::vector<symbol>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

/// Emitted as calls, so that what takes long can be done in parts.
Function hand_joint_stiffness(const Hand& hand) {
  HandStart start(hand);
  start.add_tendons();
  const Argument f = forces(start), kt = stiffnesses(start);
  const std::vector<ex> P = whole_coupling(start);
  std::vector<ex> inputs = start.wrist_inputs();
  append(inputs, f.symbols);
  append(inputs, kt.symbols);
  const std::vector<ex> wrist = inlined(start.list, wrist_joint_stiffness(hand.wrist), inputs)[0];
  const Output K = whole_stiffness(start, f, kt, P, wrist);
  return {"joint_stiffness",
          "Stiffness of all joints with the motors held; wrist and fingers are coupled.",
          "(5.12)",
          {start.q, start.q_wrist, f, kt},
          start.list.items(),
          {K},
          {"wrist_passage", "wrist_stiffness", "whole_stiffness"}};
}

Argument passage_jacobian(const HandStart& start) {
  return array_argument("P", static_cast<int>(start.channels()), 2, "m/rad", {-0.02, 0.02},
                        "of wrist_passage");
}

Function hand_wrist_stiffness(const Hand& hand) {
  HandStart start(hand);
  const Argument f = forces(start), kt = stiffnesses(start), P = passage_jacobian(start);
  const Argument h = array_argument("h", static_cast<int>(start.channels()), 1, "m", {0.02, 0.1},
                                    "of wrist_passage");
  std::vector<ex> inputs = start.wrist_inputs();
  for (const Argument& argument : {h, P, f, kt}) append(inputs, argument.symbols);
  const std::vector<ex> K = inlined(start.list, wrist_passage_stiffness(hand.wrist), inputs)[0];
  return {"wrist_stiffness",
          "Stiffness of the wrist's bars: the last block of joint_stiffness.",
          "",
          {start.q_wrist, h, P, f, kt},
          start.list.items(),
          {{"K_wrist", 2, 2, K, "N m/rad", "symmetric"}}};
}

Function hand_whole_stiffness(const Hand& hand) {
  HandStart start(hand);
  start.add_tendons();
  const Argument f = forces(start), kt = stiffnesses(start), P_wrist = passage_jacobian(start);
  const Argument K_wrist =
      array_argument("K_wrist", 2, 2, "N m/rad", {-100.0, 100.0}, "of wrist_stiffness");
  std::vector<ex> of_wrist, block;
  append(of_wrist, P_wrist.symbols);
  append(block, K_wrist.symbols);
  const Output K = whole_stiffness(start, f, kt, whole_coupling(start, of_wrist), block);
  return {"whole_stiffness",  "joint_stiffness where the wrist's own block is known.",
          "(5.12)",           {start.q, P_wrist, f, kt, K_wrist},
          start.list.items(), {K}};
}

Function hand_feedforward(const Hand& hand) {
  HandStart start(hand);
  const std::vector<ex> delta =
      inlined(start.list, wrist_feedforward(hand.wrist), start.wrist_inputs())[0];
  return {"feedforward",
          "Motor angles that hold the fingers still while the wrist moves.",
          "",
          {start.q_wrist},
          start.list.items(),
          {{"delta_theta", static_cast<int>(start.channels()), 1, delta, "rad",
            "0 in the reference pose"}}};
}

Function hand_feedforward_rate(const Hand& hand) {
  HandStart start(hand);
  const Argument qd =
      array_argument("qd_wrist", 2, 1, "rad/s", {-3.0, 3.0}, "rates of the bar angles");
  std::vector<ex> inputs = start.wrist_inputs();
  inputs.insert(inputs.end(), qd.symbols.begin(), qd.symbols.end());
  const std::vector<ex> rate = inlined(start.list, wrist_feedforward_rate(hand.wrist), inputs)[0];
  return {"feedforward_rate",
          "Rates of the motor angles of hand_feedforward.",
          "",
          {start.q_wrist, qd},
          start.list.items(),
          {{"delta_theta_rate", static_cast<int>(start.channels()), 1, rate, "rad/s", ""}}};
}

}  // namespace

std::vector<std::string> coordinate_names(const Hand& hand) {
  std::vector<std::string> names;
  for (const HandFinger& finger : hand.fingers) {
    const Coordinates coordinates(finger.mechanism);
    for (const int joint : coordinates.joints())
      names.push_back(finger.mechanism.name + "." +
                      finger.mechanism.joints[static_cast<std::size_t>(joint)].name);
  }
  if (hand.has_four_bar()) names.push_back(hand.four_bar_name + ".theta2");
  return names;
}

Function hand_tendon_lengths(const Hand& hand) {
  HandStart start(hand);
  start.add_tendons();
  std::vector<ex> h =
      inlined(start.list, wrist_tendon_lengths(hand.wrist), start.wrist_inputs())[0];
  for (const HandMember& member : start.members)
    for (std::size_t t = 0; t < member.channels.size(); ++t)
      h[static_cast<std::size_t>(member.channels[t])] += member.lengths[t];
  return {"tendon_lengths",
          "Path lengths of all tendons, wrist and finger together.",
          "(5.1)",
          {start.q, start.q_wrist},
          start.list.items(),
          {{"h", static_cast<int>(start.channels()), 1, h, "m", "by wrist channel"}}};
}

std::vector<Function> hand_functions(const Hand& hand) {
  return {hand_fingertips(hand),      hand_finger_gravity(hand),   hand_tendon_lengths(hand),
          hand_coupling_matrix(hand), hand_joint_torque(hand),     hand_joint_stiffness(hand),
          hand_feedforward(hand),     hand_feedforward_rate(hand), hand_wrist_passage(hand),
          hand_wrist_stiffness(hand), hand_whole_stiffness(hand),  hand_inverse_dynamics(hand)};
}

}  // namespace sinew
