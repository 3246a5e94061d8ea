// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "simulation/bodies/finger_carriers.h"
#include "simulation/bodies/hand_tendons.h"
#include "simulation/bodies/joints.h"

namespace sinew {
namespace {

constexpr double crank_damping = 1e-4;  // N·m·s/rad, as that of a joint

/// Coordinates: the fingers', then those of the carriers that move freely: the crank, and q71 and
/// q73 where the palm does.
class HandOnPalm : public Joints {
 public:
  HandOnPalm(const Hand& hand, const Eigen::Vector3d& gravity, const PalmParameters& palm,
             const std::filesystem::path& runtime)
      : carriers_(hand, gravity, runtime),
        tendons_(hand, carriers_.fingers(), runtime),
        own_names_(coordinate_names(hand)),
        reference_{reference_q71(hand.wrist), reference_q73(hand.wrist)} {
    tendons = tendons_.count();
    put_on(palm);
  }

  void put_on(const PalmParameters& palm) {
    names = own_names_;
    if (palm.moves) names.insert(names.end(), {"q71", "q73"});
    slides.assign(names.size(), false);
    carriers_.put_on(palm);
    moves_ = palm.moves;
    damping = Eigen::VectorXd::Constant(size(), crank_damping);
    rest = Eigen::VectorXd::Zero(size());
    if (moves_) {
      damping.tail(2).setConstant(palm.damping);
      rest.tail(2) << reference_[0], reference_[1];
    }
    Eigen::Index at = 0;
    for (const FingerDynamics& finger : carriers_.fingers()) {
      damping.segment(at, finger.size()) = finger.damping();
      at += finger.size();
    }
  }

  void lengths(const double* q, const WristMotion& wrist, double* h) const override {
    tendons_.lengths(q, bars(q, wrist), h);
  }
  void torque(const double* q, const WristMotion& wrist, const double* f,
              double* tau) const override {
    tendons_.torque(q, f, tau);
    if (moves_) tendons_.wrist_torque(bars(q, wrist), f, tau + size() - 2);
  }
  void coupling(const double* q, const WristMotion& wrist, double* P,
                double* wrist_rate) const override {
    tendons_.coupling(q, bars(q, wrist), static_cast<std::size_t>(size()), moves_, P);
    const double at_rest[2] = {0.0, 0.0};
    tendons_.wrist_rate(bars(q, wrist), moves_ ? at_rest : wrist.qd, wrist_rate);
  }
  void stiffness(const double* q, const WristMotion& wrist, const double* f, const double* kt,
                 double* K) const override {
    tendons_.stiffness(q, bars(q, wrist), f, kt, static_cast<std::size_t>(size()), moves_, K);
  }
  void acceleration(const double* q, const double* qd, const WristMotion& wrist, const double* tau,
                    double* qdd) const override {
    carriers_.acceleration(q, qd, wrist, tau, qdd);
  }
  void inertial_forces(const double* q, const double* qd, const double* qdd,
                       const WristMotion& wrist, double* tau) const override {
    carriers_.inertial_forces(q, qd, qdd, wrist, tau);
  }
  void mass_matrix(const double* q, const WristMotion& wrist, double* M) const override {
    carriers_.mass_matrix(q, wrist, M);
  }
  void bending(const double* q, const WristMotion& wrist, double* angle) const override {
    tendons_.bending(q, bars(q, wrist), angle);
  }
  void tip_torque(const double*, const double*, double* tau) const override {
    std::fill(tau, tau + size(), 0.0);
  }
  double energy(const double* q, const double* qd, const WristMotion& wrist) const override {
    return carriers_.energy(q, qd, wrist);
  }
  double base_power(const double* q, const double* qd, const double* qdd,
                    const WristMotion& wrist) const override {
    return carriers_.base_power(q, qd, qdd, wrist);
  }

 private:
  /// The wrist's bar angles: coordinates where it moves freely, else prescribed.
  const double* bars(const double* q, const WristMotion& wrist) const {
    return moves_ ? q + size() - 2 : wrist.q;
  }

  FingerCarriers carriers_;
  HandTendons tendons_;
  std::vector<std::string> own_names_;
  double reference_[2];  ///< rad, bar angles of the reference pose
  bool moves_ = false;
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
