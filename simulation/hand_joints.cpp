// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>

#include "generator/assemble.h"
#include "simulation/finger_dynamics.h"
#include "simulation/joints.h"
#include "symbolic/wrist.h"

namespace sinew {
namespace {

constexpr std::size_t n_wrist = 2;
constexpr double rate_step = 1e-5;  // s, of the derivative of gravity in the turning frames

class HandOnPalm : public Joints {
 public:
  HandOnPalm(const Hand& hand, const Eigen::Vector3d& gravity, const PalmParameters& palm,
             const std::filesystem::path& runtime)
      : hand_(assemble({hand.name, hand.description, "", {}}, hand_functions(hand), {}), runtime),
        wrist_(assemble({"wrist", "", "", {}}, {wrist_bending_angles(hand.wrist)}, {}), runtime),
        gravity_(gravity),
        own_names_(coordinate_names(hand)),
        reference_{reference_q71(hand.wrist), reference_q73(hand.wrist)} {
    for (const HandFinger& finger : hand.fingers) {
      fingers_.emplace_back(finger.mechanism, true, runtime);
      channels_.push_back(finger.channels);
    }
    n_ = own_names_.size();
    m_ = hand.wrist.forearm_points.size();
    tendons = static_cast<int>(m_);
    find_functions();
    put_on(palm);
  }

  void put_on(const PalmParameters& palm) {
    palm_ = palm;
    names = own_names_;
    if (palm_.moves) names.insert(names.end(), {"q71", "q73"});
    slides.assign(names.size(), false);
    damping = Eigen::VectorXd::Constant(size(), 1e-4);  // the crank's, as that of a joint
    rest = Eigen::VectorXd::Zero(size());
    if (palm_.moves) {
      damping.tail(2).setConstant(palm_.damping);
      rest.tail(2) << reference_[0], reference_[1];
    }
    Eigen::Index at = 0;
    for (const FingerDynamics& finger : fingers_) {
      damping.segment(at, finger.size()) = finger.damping();
      at += finger.size();
    }
  }

  void lengths(const double* q, const WristMotion& wrist, double* h) const override {
    lengths_->call(inputs(q, wrist, {}), h);
  }
  void torque(const double* q, const WristMotion& wrist, const double* f,
              double* tau) const override {
    torque_->call(inputs(q, wrist, {f}), out_.data());
    std::copy(out_.begin(), out_.begin() + size(), tau);
  }
  void coupling(const double* q, const WristMotion& wrist, double* P,
                double* wrist_rate) const override {
    coupling_->call(inputs(q, wrist, {}), out_.data());
    const auto columns = static_cast<std::size_t>(size());
    for (std::size_t i = 0; i < m_; ++i) {
      const double* row = out_.data() + i * (n_ + n_wrist);
      std::copy(row, row + columns, P + i * columns);
      wrist_rate[i] = palm_.moves ? 0.0 : row[n_] * wrist.qd[0] + row[n_ + 1] * wrist.qd[1];
    }
  }
  void stiffness(const double* q, const WristMotion& wrist, const double* f, const double* kt,
                 double* K) const override {
    stiffness_->call(inputs(q, wrist, {f, kt}), out_.data());
    const auto columns = static_cast<std::size_t>(size());
    for (std::size_t i = 0; i < columns; ++i) {
      const double* row = out_.data() + i * (n_ + n_wrist);
      std::copy(row, row + columns, K + i * columns);
    }
  }
  void acceleration(const double* q, const double* qd, const WristMotion& wrist, const double* tau,
                    double* qdd) const override {
    const double* g = finger_gravity(q, wrist_of(q, wrist));
    std::size_t at = 0;
    for (const FingerDynamics& finger : fingers_) {
      finger.acceleration(q + at, qd + at, g, tau + at, qdd + at);
      at += static_cast<std::size_t>(finger.size());
      g += 3;
    }
    for (; at < n_; ++at) qdd[at] = tau[at] / palm_.crank_inertia;
    if (!palm_.moves) return;
    double weight[n_wrist];
    wrist_gradient(q, weight);
    for (std::size_t i = 0; i < n_wrist; ++i)
      qdd[n_ + i] = (tau[n_ + i] - weight[i]) / palm_.inertia;
  }
  void mass_and_bias(const double* q, const double* qd, const WristMotion& wrist, double* M,
                     double* bias) const override {
    const double* g = finger_gravity(q, wrist_of(q, wrist));
    const auto columns = static_cast<std::size_t>(size());
    std::fill(M, M + columns * columns, 0.0);
    std::fill(bias, bias + columns, 0.0);
    double block[64];
    std::size_t at = 0;
    for (const FingerDynamics& finger : fingers_) {
      const auto own = static_cast<std::size_t>(finger.size());
      finger.mass_and_bias(q + at, qd + at, g, block, bias + at);
      for (std::size_t i = 0; i < own; ++i)
        std::copy(block + i * own, block + (i + 1) * own, M + (at + i) * columns + at);
      at += own;
      g += 3;
    }
    for (; at < n_; ++at) M[at * columns + at] = palm_.crank_inertia;
    for (; at < columns; ++at) M[at * columns + at] = palm_.inertia;
    if (palm_.moves) wrist_gradient(q, bias + n_);
  }
  void bending(const double* q, const WristMotion& wrist, double* angle) const override {
    bending_->call(wrist_of(q, wrist), angle);
    double own[64];
    std::size_t at = 0;
    for (std::size_t k = 0; k < fingers_.size(); ++k) {
      fingers_[k].bending(q + at, own);
      for (std::size_t i = 0; i < channels_[k].size(); ++i)
        angle[static_cast<std::size_t>(channels_[k][i])] += own[i];
      at += static_cast<std::size_t>(fingers_[k].size());
    }
  }
  void tip_torque(const double*, const double*, double* tau) const override {
    std::fill(tau, tau + size(), 0.0);
  }
  double potential(const double* q, const WristMotion& wrist) const override {
    return potential_under(q, finger_gravity(q, wrist_of(q, wrist)));
  }
  /// The potential is linear in gravity, so its change with gravity is the potential of the change.
  double base_power(const double* q, const double* qd, const WristMotion& wrist) const override {
    const double rate[3] = {qd[n_ - 1], palm_.moves ? 0.0 : wrist.qd[0],
                            palm_.moves ? 0.0 : wrist.qd[1]};
    if (rate[0] == 0.0 && rate[1] == 0.0 && rate[2] == 0.0) return 0.0;
    return potential_along(q, wrist_of(q, wrist), rate);
  }

 private:
  void find_functions() {
    lengths_ = &hand_.find("tendon_lengths");
    coupling_ = &hand_.find("coupling_matrix");
    torque_ = &hand_.find("joint_torque");
    stiffness_ = &hand_.find("joint_stiffness");
    gravity_of_fingers_ = &hand_.find("finger_gravity");
    bending_ = &wrist_.find("bending_angles");
    in_.resize(n_ + n_wrist + 2 * m_);
    out_.resize((n_ + n_wrist) * std::max(m_, n_ + n_wrist));
    g_.resize(3 * fingers_.size());
  }

  /// The wrist's bar angles: coordinates where it moves freely, else prescribed.
  const double* wrist_of(const double* q, const WristMotion& wrist) const {
    return palm_.moves ? q + n_ : wrist.q;
  }

  /// q, q_wrist, then arrays of one number a tendon.
  const double* inputs(const double* q, const WristMotion& wrist,
                       std::initializer_list<const double*> per_tendon) const {
    auto next = std::copy(q, q + n_, in_.begin());
    const double* bars = wrist_of(q, wrist);
    next = std::copy(bars, bars + n_wrist, next);
    for (const double* values : per_tendon) next = std::copy(values, values + m_, next);
    return in_.data();
  }

  const double* finger_gravity(const double* q, const double* bars) const {
    std::copy(q, q + n_, in_.begin());
    const auto end = static_cast<std::ptrdiff_t>(n_);
    std::copy(bars, bars + n_wrist, in_.begin() + end);
    std::copy(gravity_.data(), gravity_.data() + 3,
              in_.begin() + end + static_cast<std::ptrdiff_t>(n_wrist));
    gravity_of_fingers_->call(in_.data(), g_.data());
    return g_.data();
  }

  /// Change of the potential [W or N·m] where only crank, q71 and q73 go on, at these rates, and
  /// turn gravity in the fingers' bases.
  double potential_along(const double* q, const double* bars, const double (&rate)[3]) const {
    std::vector<double> moved(q, q + n_);
    const auto gravity_after = [&](double time) {
      const double there[n_wrist] = {bars[0] + time * rate[1], bars[1] + time * rate[2]};
      moved[n_ - 1] = q[n_ - 1] + time * rate[0];
      const double* g = finger_gravity(moved.data(), there);
      return std::vector<double>(g, g + g_.size());
    };
    std::vector<double> change = gravity_after(rate_step);
    const std::vector<double> before = gravity_after(-rate_step);
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] = (change[i] - before[i]) / (2 * rate_step);
    return potential_under(q, change.data());
  }

  /// Torque of the fingers' weight against q71 and q73 [N·m].
  void wrist_gradient(const double* q, double* weight) const {
    weight[0] = potential_along(q, q + n_, {0.0, 1.0, 0.0});
    weight[1] = potential_along(q, q + n_, {0.0, 0.0, 1.0});
  }

  double potential_under(const double* q, const double* g) const {
    double sum = 0.0;
    for (const FingerDynamics& finger : fingers_) {
      sum += finger.potential(q, {g[0], g[1], g[2]});
      q += finger.size();
      g += 3;
    }
    return sum;
  }

  CompiledModel hand_, wrist_;
  std::vector<FingerDynamics> fingers_;
  std::vector<std::vector<int>> channels_;
  Eigen::Vector3d gravity_;
  PalmParameters palm_;
  std::vector<std::string> own_names_;
  double reference_[n_wrist];  ///< rad, bar angles of the reference pose
  std::size_t n_ = 0, m_ = 0;
  mutable std::vector<double> in_, out_, g_;  ///< for one call after the other
  const sinew_function* lengths_ = nullptr;
  const sinew_function* coupling_ = nullptr;
  const sinew_function* torque_ = nullptr;
  const sinew_function* stiffness_ = nullptr;
  const sinew_function* gravity_of_fingers_ = nullptr;
  const sinew_function* bending_ = nullptr;
};

}  // namespace

std::unique_ptr<Joints> hand_joints(const Hand& hand, const Eigen::Vector3d& gravity,
                                    const PalmParameters& palm,
                                    const std::filesystem::path& runtime) {
  return std::make_unique<HandOnPalm>(hand, gravity, palm, runtime);
}

std::unique_ptr<Joints> on_other_palm(const Joints& hand, const PalmParameters& palm) {
  const auto* known = dynamic_cast<const HandOnPalm*>(&hand);
  if (!known) throw std::invalid_argument("only a hand has a palm");
  auto copy = std::make_unique<HandOnPalm>(*known);
  copy->put_on(palm);
  return copy;
}

}  // namespace sinew
