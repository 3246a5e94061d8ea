// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

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
  HandOnPalm(const Hand& hand, const Eigen::Vector3d& gravity, double crank_inertia,
             const std::filesystem::path& runtime)
      : hand_(assemble({hand.name, hand.description, "", {}}, hand_functions(hand), {}), runtime),
        wrist_(assemble({"wrist", "", "", {}}, wrist_functions(hand.wrist), {}), runtime),
        gravity_(gravity),
        crank_inertia_(crank_inertia) {
    for (const HandFinger& finger : hand.fingers) {
      fingers_.emplace_back(finger.mechanism, true, runtime);
      channels_.push_back(finger.channels);
    }
    names = coordinate_names(hand);
    n_ = names.size();
    m_ = hand.wrist.forearm_points.size();
    tendons = static_cast<int>(m_);
    damping = Eigen::VectorXd::Constant(size(), 1e-4);  // the crank's, as that of a joint
    Eigen::Index at = 0;
    for (const FingerDynamics& finger : fingers_) {
      damping.segment(at, finger.size()) = finger.damping();
      at += finger.size();
    }
    find_functions();
  }

  void lengths(const double* q, const WristMotion& wrist, double* h) const override {
    const std::vector<double>& in = inputs(q, wrist, {});
    lengths_->call(in.data(), h);
  }
  void torque(const double* q, const WristMotion& wrist, const double* f,
              double* tau) const override {
    const std::vector<double>& in = inputs(q, wrist, {f});
    torque_->call(in.data(), out_.data());
    std::copy(out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(n_), tau);
  }
  void coupling(const double* q, const WristMotion& wrist, double* P,
                double* wrist_rate) const override {
    const std::vector<double>& in = inputs(q, wrist, {});
    coupling_->call(in.data(), out_.data());
    for (std::size_t i = 0; i < m_; ++i) {
      const double* row = out_.data() + i * (n_ + n_wrist);
      std::copy(row, row + n_, P + i * n_);
      wrist_rate[i] = row[n_] * wrist.qd[0] + row[n_ + 1] * wrist.qd[1];
    }
  }
  void stiffness(const double* q, const WristMotion& wrist, const double* f, const double* kt,
                 double* K) const override {
    const std::vector<double>& in = inputs(q, wrist, {f, kt});
    stiffness_->call(in.data(), out_.data());
    for (std::size_t i = 0; i < n_; ++i) {
      const double* row = out_.data() + i * (n_ + n_wrist);
      std::copy(row, row + n_, K + i * n_);
    }
  }
  void acceleration(const double* q, const double* qd, const WristMotion& wrist, const double* tau,
                    double* qdd) const override {
    const double* g = finger_gravity(q, wrist);
    std::size_t at = 0;
    for (const FingerDynamics& finger : fingers_) {
      finger.acceleration(q + at, qd + at, g, tau + at, qdd + at);
      at += static_cast<std::size_t>(finger.size());
      g += 3;
    }
    for (; at < n_; ++at) qdd[at] = tau[at] / crank_inertia_;
  }
  void mass_and_bias(const double* q, const double* qd, const WristMotion& wrist, double* M,
                     double* bias) const override {
    const double* g = finger_gravity(q, wrist);
    std::fill(M, M + n_ * n_, 0.0);
    std::fill(bias, bias + n_, 0.0);
    double block[64];
    std::size_t at = 0;
    for (const FingerDynamics& finger : fingers_) {
      const auto size = static_cast<std::size_t>(finger.size());
      finger.mass_and_bias(q + at, qd + at, g, block, bias + at);
      for (std::size_t i = 0; i < size; ++i)
        std::copy(block + i * size, block + (i + 1) * size, M + (at + i) * n_ + at);
      at += size;
      g += 3;
    }
    for (; at < n_; ++at) M[at * n_ + at] = crank_inertia_;
  }
  void bending(const double* q, const WristMotion& wrist, double* angle) const override {
    bending_->call(wrist.q, angle);
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
    std::fill(tau, tau + n_, 0.0);
  }
  double potential(const double* q, const WristMotion& wrist) const override {
    return potential_under(q, finger_gravity(q, wrist));
  }
  /// The potential is linear in gravity, so its change with gravity is the potential of the change.
  double base_power(const double* q, const double* qd, const WristMotion& wrist) const override {
    std::vector<double> moved(q, q + n_);
    WristMotion there = wrist;
    const auto gravity_after = [&](double time) {
      for (std::size_t i = fingers_end(); i < n_; ++i) moved[i] = q[i] + time * qd[i];
      for (std::size_t i = 0; i < n_wrist; ++i) there.q[i] = wrist.q[i] + time * wrist.qd[i];
      const double* g = finger_gravity(moved.data(), there);
      return std::vector<double>(g, g + 3 * fingers_.size());
    };
    std::vector<double> change = gravity_after(rate_step);
    const std::vector<double> before = gravity_after(-rate_step);
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] = (change[i] - before[i]) / (2 * rate_step);
    return potential_under(q, change.data());
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

  std::size_t fingers_end() const {
    std::size_t end = 0;
    for (const FingerDynamics& finger : fingers_) end += static_cast<std::size_t>(finger.size());
    return end;
  }

  /// q, q_wrist, then arrays of one number a tendon.
  const std::vector<double>& inputs(const double* q, const WristMotion& wrist,
                                    std::initializer_list<const double*> per_tendon) const {
    auto next = std::copy(q, q + n_, in_.begin());
    next = std::copy(wrist.q, wrist.q + n_wrist, next);
    for (const double* values : per_tendon) next = std::copy(values, values + m_, next);
    return in_;
  }

  const double* finger_gravity(const double* q, const WristMotion& wrist) const {
    inputs(q, wrist, {});
    std::copy(gravity_.data(), gravity_.data() + 3,
              in_.begin() + static_cast<std::ptrdiff_t>(n_ + n_wrist));
    gravity_of_fingers_->call(in_.data(), g_.data());
    return g_.data();
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
  double crank_inertia_;
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
                                    double crank_inertia, const std::filesystem::path& runtime) {
  return std::make_unique<HandOnPalm>(hand, gravity, crank_inertia, runtime);
}

}  // namespace sinew
