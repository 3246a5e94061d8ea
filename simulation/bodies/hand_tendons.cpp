// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/bodies/hand_tendons.h"

#include <algorithm>

#include "generator/assemble.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/parts/wrist.h"

namespace sinew {
namespace {

/// Numbers of one member: tendons by coordinates.
constexpr std::size_t most_numbers = 256;

std::vector<Function> path_functions(const Hand& hand) {
  const WristParameters& wrist = hand.wrist;
  std::vector<Function> functions{wrist_tendon_lengths(wrist), wrist_tendon_jacobian(wrist),
                                  wrist_joint_torque(wrist), wrist_joint_stiffness(wrist),
                                  wrist_bending_angles(wrist)};
  if (!hand.has_four_bar()) return functions;
  Function lengths = four_bar_tendon_lengths(hand.four_bar);
  lengths.name = "crank_lengths";
  const std::vector<GiNaC::symbol> crank = lengths.inputs[0].symbols;
  DefinitionList list;
  const std::vector<GiNaC::ex> h = inlined(list, lengths, {crank[0]})[0];
  const std::vector<GiNaC::ex> P = jacobian(list, h, crank);
  const Function coupling{
      "crank_coupling", "Derivatives of the crank's tendons.",  "", lengths.inputs,
      list.items(),     {{"P", 2, 1, P, "m/rad", "dh/dtheta2"}}};
  functions.push_back(lengths);
  functions.push_back(coupling);
  return functions;
}

}  // namespace

HandTendons::HandTendons(const Hand& hand, const std::vector<FingerDynamics>& fingers,
                         const std::filesystem::path& runtime)
    : wrist_(assemble({"paths", "", "", {}}, path_functions(hand), {}), runtime),
      crank_channels_(hand.four_bar_channels),
      m_(hand.wrist.forearm_points.size()) {
  for (std::size_t k = 0; k < fingers.size(); ++k) {
    const auto size = static_cast<std::size_t>(fingers[k].size());
    if (size * hand.fingers[k].channels.size() > most_numbers)
      throw std::runtime_error(hand.fingers[k].mechanism.name + ": too many joints to simulate");
    members_.push_back({fingers[k], hand.fingers[k].channels, crank_, size});
    crank_ += size;
  }
  lengths_ = {&wrist_.find("tendon_lengths"), std::vector<double>(m_)};
  jacobian_ = {&wrist_.find("tendon_jacobian"), std::vector<double>(2 * m_)};
  torque_ = &wrist_.find("joint_torque");
  stiffness_ = &wrist_.find("joint_stiffness");
  bending_ = &wrist_.find("bending_angles");
  if (hand.has_four_bar()) {
    crank_lengths_ = &wrist_.find("crank_lengths");
    crank_coupling_ = &wrist_.find("crank_coupling");
  }
  in_.resize(2 + 2 * m_);
  P_.resize(m_ * (crank_ + 3));
}

const double* HandTendons::Passed::at(const double* bars) const {
  if (!std::equal(bars, bars + 2, pose)) {
    function->call(bars, values.data());
    std::copy(bars, bars + 2, pose);
  }
  return values.data();
}

void HandTendons::lengths(const double* q, const double* bars, double* h) const {
  const double* wrist = lengths_.at(bars);
  std::copy(wrist, wrist + m_, h);
  double own[most_numbers];
  for (const Member& member : members_) {
    member.finger.lengths(q + member.first, own);
    for (std::size_t i = 0; i < member.channels.size(); ++i) h[member.channels[i]] += own[i];
  }
  if (!crank_lengths_) return;
  crank_lengths_->call(q + crank_, own);
  for (std::size_t i = 0; i < crank_channels_.size(); ++i) h[crank_channels_[i]] += own[i];
}

void HandTendons::torque(const double* q, const double* f, double* tau) const {
  double own[most_numbers];
  for (const Member& member : members_) {
    for (std::size_t i = 0; i < member.channels.size(); ++i) own[i] = f[member.channels[i]];
    member.finger.torque(q + member.first, own, tau + member.first);
  }
  if (!crank_coupling_) return;
  crank_coupling_->call(q + crank_, own);
  tau[crank_] = 0.0;
  for (std::size_t i = 0; i < crank_channels_.size(); ++i)
    tau[crank_] -= own[i] * f[crank_channels_[i]];
}

void HandTendons::wrist_torque(const double* bars, const double* f, double* tau) const {
  std::copy(f, f + m_, std::copy(bars, bars + 2, in_.begin()));
  torque_->call(in_.data(), tau);
}

void HandTendons::coupling(const double* q, const double* bars, std::size_t columns,
                           bool with_wrist, double* P) const {
  std::fill(P, P + m_ * columns, 0.0);
  double own[most_numbers];
  for (const Member& member : members_) {
    member.finger.coupling(q + member.first, own);
    for (std::size_t i = 0; i < member.channels.size(); ++i)
      std::copy(own + i * member.size, own + (i + 1) * member.size,
                P + static_cast<std::size_t>(member.channels[i]) * columns + member.first);
  }
  if (crank_coupling_) {
    crank_coupling_->call(q + crank_, own);
    for (std::size_t i = 0; i < crank_channels_.size(); ++i)
      P[static_cast<std::size_t>(crank_channels_[i]) * columns + crank_] = own[i];
  }
  if (!with_wrist) return;
  const double* wrist = jacobian_.at(bars);
  for (std::size_t i = 0; i < m_; ++i)
    std::copy(wrist + 2 * i, wrist + 2 * i + 2, P + (i + 1) * columns - 2);
}

void HandTendons::wrist_rate(const double* bars, const double* rates, double* h_rate) const {
  const double* wrist = jacobian_.at(bars);
  for (std::size_t i = 0; i < m_; ++i)
    h_rate[i] = wrist[2 * i] * rates[0] + wrist[2 * i + 1] * rates[1];
}

void HandTendons::stiffness(const double* q, const double* bars, const double* f, const double* kt,
                            std::size_t columns, bool with_wrist, double* K) const {
  std::fill(K, K + columns * columns, 0.0);
  double own_f[most_numbers], own_kt[most_numbers], block[most_numbers];
  for (const Member& member : members_) {
    for (std::size_t i = 0; i < member.channels.size(); ++i) {
      own_f[i] = f[member.channels[i]];
      own_kt[i] = kt[member.channels[i]];
    }
    member.finger.stiffness(q + member.first, own_f, own_kt, block);
    for (std::size_t i = 0; i < member.size; ++i)
      std::copy(block + i * member.size, block + (i + 1) * member.size,
                K + (member.first + i) * columns + member.first);
  }
  if (crank_coupling_) {
    crank_coupling_->call(q + crank_, block);
    for (std::size_t i = 0; i < crank_channels_.size(); ++i)
      K[crank_ * columns + crank_] += block[i] * block[i] * kt[crank_channels_[i]];
  }
  if (!with_wrist) return;
  coupling(q, bars, columns, true, P_.data());
  add_wrist_stiffness(bars, f, kt, columns, K);
}

void HandTendons::add_wrist_stiffness(const double* bars, const double* f, const double* kt,
                                      std::size_t columns, double* K) const {
  std::copy(kt, kt + m_, std::copy(f, f + m_, std::copy(bars, bars + 2, in_.begin())));
  double own[4];
  stiffness_->call(in_.data(), own);
  for (std::size_t w = 0; w < 2; ++w) {
    const std::size_t row = columns - 2 + w;
    for (std::size_t j = 0; j < columns - 2; ++j) {
      double sum = 0.0;
      for (std::size_t i = 0; i < m_; ++i)
        sum += kt[i] * P_[i * columns + row] * P_[i * columns + j];
      K[row * columns + j] = K[j * columns + row] = sum;
    }
    std::copy(own + 2 * w, own + 2 * w + 2, K + row * columns + columns - 2);
  }
}

void HandTendons::bending(const double* q, const double* bars, double* angle) const {
  bending_->call(bars, angle);
  double own[most_numbers];
  for (const Member& member : members_) {
    member.finger.bending(q + member.first, own);
    for (std::size_t i = 0; i < member.channels.size(); ++i) angle[member.channels[i]] += own[i];
  }
}

}  // namespace sinew
