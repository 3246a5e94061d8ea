// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/bodies/finger_carriers.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "generator/assemble.h"
#include "simulation/bodies/finger_bases.h"

namespace sinew {
namespace {

using Solved = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
using Right = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

double dot(const double* a, const double* b, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

FingerCarriers::FingerCarriers(const Hand& hand, const Eigen::Vector3d& gravity,
                               const std::filesystem::path& runtime)
    : bases_(
          assemble({"bases", "", "", {}},
                   {finger_base_pose(hand), finger_base_twist(hand), finger_base_motion(hand)}, {}),
          runtime),
      gravity_(gravity),
      count_(hand.has_four_bar() ? 3 : 2) {
  for (const HandFinger& finger : hand.fingers) {
    fingers_.emplace_back(finger.mechanism, true, runtime);
    on_coupler_.push_back(finger.on_coupler);
    joints_ += static_cast<std::size_t>(fingers_.back().size());
  }
  pose_ = &bases_.find("base_pose");
  twist_ = &bases_.find("base_twist");
  motion_ = &bases_.find("base_motion");
  const std::size_t k = fingers_.size();
  in_.resize(3 * most_carriers + 3);
  base_.resize(k * motion_size);
  held_.assign(std::max(joints_ + most_carriers, motion_size), 0.0);
  poses_.resize(16 * k);
  twists_.resize(twist_size * k);
  forces_.resize(joints_);
  wrench_.resize(k);
  for (Response& each : response_) {
    each.twist.resize(twist_size * k);
    each.joints.resize(joints_);
    each.wrench.resize(k);
  }
}

void FingerCarriers::put_on(const PalmParameters& palm) {
  palm_ = palm;
  if (palm.gravity) gravity_ = *palm.gravity;
  free_ = count_ - (palm.moves ? 0 : 2);
  forces_known_ = false;
  asked_.assign(3 * coordinates() + 6, 0.0);
}

FingerCarriers::Triple FingerCarriers::carriers(const double* free_values,
                                                const double* wrist) const {
  Triple all{};
  std::copy(free_values, free_values + free_, all.begin());
  if (free_ < count_) std::copy(wrist, wrist + 2, all.begin() + static_cast<int>(free_));
  return all;
}

bool FingerCarriers::carries(std::size_t carrier, std::size_t finger) const {
  return carrier + 2 >= count_ || on_coupler_[finger];
}

void FingerCarriers::find_base_motion(const Triple& c, const Triple& rate,
                                      const Triple& acceleration) const {
  double* next = in_.data();
  for (const Triple* each : {&c, &rate, &acceleration})
    next = std::copy(each->begin(), each->begin() + static_cast<int>(count_), next);
  std::copy(gravity_.data(), gravity_.data() + 3, next);
  motion_->call(in_.data(), base_.data());
}

void FingerCarriers::find_twists(const Triple& c, const Triple& rate, double* twist) const {
  double* next = in_.data();
  for (const Triple* each : {&c, &rate})
    next = std::copy(each->begin(), each->begin() + static_cast<int>(count_), next);
  twist_->call(in_.data(), twist);
}

void FingerCarriers::find_forces(const double* q, const double* qd, const double* qdd, double* tau,
                                 bool freely_carried) const {
  for (std::size_t k = 0; k < fingers_.size(); ++k) {
    if (!freely_carried || carries(free_ - 1, k))
      fingers_[k].inverse(q, qd, qdd, &base_[k * motion_size], tau, wrench_[k].data());
    else
      wrench_[k].fill(0.0);
    const int n = fingers_[k].size();
    q += n, qd += n, qdd += n, tau += n;
  }
}

void FingerCarriers::find_responses(const double* q, const Triple& c, bool joints_held) const {
  for (std::size_t j = 0; j < free_; ++j) {
    Response& response = response_[j];
    Triple unit{};
    unit[j] = 1.0;
    find_twists(c, unit, response.twist.data());
    std::fill(response.joints.begin(), response.joints.end(), 0.0);
    std::size_t at = 0;
    for (std::size_t k = 0; k < fingers_.size(); ++k) {
      const FingerDynamics& finger = fingers_[k];
      response.wrench[k].fill(0.0);
      if (carries(j, k)) {
        const double* twist = &response.twist[k * twist_size];
        const double base[motion_size] = {0.0,      0.0,      0.0,      twist[3], twist[4],
                                          twist[5], twist[0], twist[1], twist[2]};
        double* own = &response.joints[at];
        double* wrench = response.wrench[k].data();
        if (joints_held) {
          finger.inverse(q + at, held_.data(), held_.data(), base, own, wrench);
        } else {
          double none[kMostNumbers];
          finger.acceleration(q + at, held_.data(), held_.data(), base, own);
          finger.inverse(q + at, held_.data(), own, base, none, wrench);
        }
      }
      at += static_cast<std::size_t>(finger.size());
    }
  }
}

double FingerCarriers::power(const std::vector<Wrench>& wrench, const double* twist) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < wrench.size(); ++k)
    sum += dot(wrench[k].data(), twist + k * twist_size, twist_size);
  return sum;
}

void FingerCarriers::acceleration(const double* q, const double* qd, const WristMotion& wrist,
                                  const double* tau, double* qdd) const {
  const Triple c = carriers(q + joints_, wrist.q);
  find_base_motion(c, carriers(qd + joints_, wrist.qd), carriers(held_.data(), wrist.qdd));
  std::size_t at = 0;
  for (std::size_t k = 0; k < fingers_.size(); ++k) {
    fingers_[k].acceleration(q + at, qd + at, tau + at, &base_[k * motion_size], qdd + at);
    at += static_cast<std::size_t>(fingers_[k].size());
  }
  if (free_ == 0) return;
  forces_known_ = false;
  // The free carriers with the fingers behind them: what these weigh is what they answer with.
  find_forces(q, qd, qdd, forces_.data(), true);
  find_responses(q, c, false);
  const auto free = static_cast<Eigen::Index>(free_);
  Solved inertia(free, free);
  Right torque(free);
  for (std::size_t i = 0; i < free_; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    torque(row) = tau[joints_ + i] - power(wrench_, response_[i].twist.data());
    for (std::size_t j = 0; j < free_; ++j)
      inertia(row, static_cast<Eigen::Index>(j)) =
          power(response_[j].wrench, response_[i].twist.data()) + (i == j ? own_inertia(i) : 0.0);
  }
  const Right found = inertia.ldlt().solve(torque);
  for (std::size_t j = 0; j < free_; ++j) {
    const double value = qdd[joints_ + j] = found(static_cast<Eigen::Index>(j));
    for (std::size_t i = 0; i < joints_; ++i) qdd[i] += value * response_[j].joints[i];
  }
}

void FingerCarriers::find_motion_forces(const double* q, const double* qd, const double* qdd,
                                        const WristMotion& wrist) const {
  double* next = asked_.data();
  for (const double* each : {q, qd, qdd}) next = std::copy(each, each + coordinates(), next);
  for (const double* each : {wrist.q, wrist.qd, wrist.qdd}) next = std::copy(each, each + 2, next);
  if (forces_known_ && asked_ == known_) return;
  find_base_motion(carriers(q + joints_, wrist.q), carriers(qd + joints_, wrist.qd),
                   carriers(qdd + joints_, wrist.qdd));
  find_forces(q, qd, qdd, forces_.data(), false);
  forces_known_ = true;
  known_ = asked_;
}

void FingerCarriers::inertial_forces(const double* q, const double* qd, const double* qdd,
                                     const WristMotion& wrist, double* tau) const {
  find_motion_forces(q, qd, qdd, wrist);
  std::copy(forces_.begin(), forces_.begin() + static_cast<int>(joints_), tau);
  for (std::size_t j = 0; j < free_; ++j) {
    Triple unit{};
    unit[j] = 1.0;
    find_twists(carriers(q + joints_, wrist.q), unit, twists_.data());
    tau[joints_ + j] = own_inertia(j) * qdd[joints_ + j] + power(wrench_, twists_.data());
  }
}

void FingerCarriers::mass_matrix(const double* q, const WristMotion& wrist, double* M) const {
  const std::size_t n = coordinates();
  std::fill(M, M + n * n, 0.0);
  double block[kMostNumbers];
  std::size_t at = 0;
  for (const FingerDynamics& finger : fingers_) {
    const auto own = static_cast<std::size_t>(finger.size());
    finger.mass_matrix(q + at, block);
    for (std::size_t i = 0; i < own; ++i)
      std::copy(block + i * own, block + (i + 1) * own, M + (at + i) * n + at);
    at += own;
  }
  if (free_ == 0) return;
  find_responses(q, carriers(q + joints_, wrist.q), true);
  for (std::size_t j = 0; j < free_; ++j) {
    const std::size_t column = joints_ + j;
    for (std::size_t i = 0; i < joints_; ++i)
      M[i * n + column] = M[column * n + i] = response_[j].joints[i];
    for (std::size_t i = 0; i < free_; ++i)
      M[(joints_ + i) * n + column] = power(response_[j].wrench, response_[i].twist.data());
    M[column * n + column] += own_inertia(j);
  }
}

double FingerCarriers::energy(const double* q, const double* qd, const WristMotion& wrist) const {
  const Triple c = carriers(q + joints_, wrist.q);
  pose_->call(c.data(), poses_.data());
  find_twists(c, carriers(qd + joints_, wrist.qd), twists_.data());
  double energy = 0.0;
  for (std::size_t j = 0; j < free_; ++j)
    energy += 0.5 * own_inertia(j) * qd[joints_ + j] * qd[joints_ + j];
  for (std::size_t k = 0; k < fingers_.size(); ++k) {
    using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
    const Eigen::Map<const RowMajor> pose(&poses_[16 * k]);
    const double* twist = &twists_[twist_size * k];
    MovingFrame base;
    base.rotation = pose.topLeftCorner<3, 3>();
    base.origin = pose.topRightCorner<3, 1>();
    base.velocity = Eigen::Vector3d(twist[0], twist[1], twist[2]);
    base.spin = Eigen::Vector3d(twist[3], twist[4], twist[5]);
    energy += fingers_[k].energy(q, qd, base, gravity_);
    q += fingers_[k].size();
    qd += fingers_[k].size();
  }
  return energy;
}

double FingerCarriers::base_power(const double* q, const double* qd, const double* qdd,
                                  const WristMotion& wrist) const {
  if (free_ == count_ || (wrist.qd[0] == 0.0 && wrist.qd[1] == 0.0)) return 0.0;
  find_motion_forces(q, qd, qdd, wrist);
  find_twists(carriers(q + joints_, wrist.q), carriers(held_.data(), wrist.qd), twists_.data());
  return power(wrench_, twists_.data());
}

}  // namespace sinew
