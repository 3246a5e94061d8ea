// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/weight_feedforward.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>
#include <stdexcept>

#include "simulation/plant/plant.h"

namespace sinew {
namespace {

using Eigen::VectorXd;

constexpr double knot_spacing = 1e-3;    // s
constexpr double least_share = 0.05;      // of the pretension that stays in every tendon
constexpr double force_tolerance = 1e-9;  // N
constexpr int most_steps = 30;

/// By Catmull and Rom: through the middle two of four values, with the slopes of their neighbours.
struct Cubic {
  double values[4], rates[4];  ///< weights of the four; rates a knot

  explicit Cubic(double s)
      : values{0.5 * s * (-1 + s * (2 - s)), 1 + 0.5 * s * s * (-5 + 3 * s),
               0.5 * s * (1 + s * (4 - 3 * s)), 0.5 * s * s * (s - 1)},
        rates{0.5 * (-1 + s * (4 - 3 * s)), 0.5 * s * (-10 + 9 * s), 0.5 * (1 + s * (8 - 9 * s)),
              0.5 * s * (3 * s - 2)} {}
};

}  // namespace

WeightFeedforward::WeightFeedforward(const PlantParts& parts, const VectorXd& posture,
                                     double pretension)
    : posture_(posture),
      pretension_(pretension),
      first_elongation_(parts.tendon->elongation_at(pretension)) {
  const Joints& joints = *parts.joints;
  const WristMotion reference;
  MotionJacobian::Matrix P(joints.tendons, joints.size());
  VectorXd ignored(joints.tendons);
  joints.coupling(posture_.data(), reference, P.data(), ignored.data());
  force_by_torque_ =
      -Eigen::MatrixXd(P.transpose()).completeOrthogonalDecomposition().pseudoInverse();
  pretension_torque_ = -pretension_ * P.transpose() * VectorXd::Ones(joints.tendons);
  elongation_.setConstant(joints.tendons, first_elongation_);
  guess_.setConstant(joints.tendons, parts.tendon->free_angle());
}

void WeightFeedforward::follow(const TendonModel& tendon, const VectorXd& force, double time) {
  const int count = static_cast<int>(force.size());
  for (int i = 0; i < count; ++i)
    if (force(i) < least_share * pretension_)
      throw std::domain_error(fmt::format(
          "weight_feedforward: tendon {} would go slack at {:.4g} s; expected more pretension",
          i + 1, time));
  for (int step = 0; step < most_steps; ++step) {
    tendon.at(count, elongation_.data(), guess_.data(), states_);
    guess_ = states_.lever_angle;
    const VectorXd missing = force - states_.force;
    if (missing.cwiseAbs().maxCoeff() <= force_tolerance) return;
    // From the flat start of a spring a whole step may lead beyond its travel.
    elongation_ = (elongation_ + missing.cwiseQuotient(states_.stiffness))
                      .cwiseMin(0.5 * (elongation_.array() + tendon.longest()).matrix());
  }
  throw std::domain_error(fmt::format(
      "weight_feedforward: a tendon would need more than its lever's travel gives at {:.4g} s; "
      "expected less pretension",
      time));
}

VectorXd WeightFeedforward::angle_at(const PlantParts& parts, const WristMotion& wrist,
                                     double time) {
  const VectorXd at_rest = VectorXd::Zero(posture_.size());
  VectorXd torque(posture_.size());
  parts.joints->inertial_forces(posture_.data(), at_rest.data(), at_rest.data(), wrist,
                                torque.data());
  const VectorXd more = force_by_torque_ * (torque - pretension_torque_);
  follow(*parts.tendon, (pretension_ + more.array()).matrix(), time);
  return (elongation_.array() - first_elongation_) / parts.motor->radius();
}

void WeightFeedforward::add(const PlantParts& parts, const Signal* flexion, const Signal* abduction,
                            double time, VectorXd& angle, VectorXd& rate) {
  const auto knot = [&](long index) -> const VectorXd& {
    Knot& found = knots_[index % 8];
    if (found.index == index) return found.angle;
    const double at = static_cast<double>(index) * knot_spacing;
    WristMotion wrist;
    if (parts.wrist) wrist = track_.at(*parts.wrist, flexion, abduction, at);
    found.index = -1;  // stays so where the tendons cannot give it
    found.angle = angle_at(parts, wrist, at);
    found.index = index;
    return found.angle;
  };
  const double place = time / knot_spacing;
  const long index = static_cast<long>(place);
  const Cubic cubic(place - static_cast<double>(index));
  const auto put = [&](std::size_t of_four, const VectorXd& value) {
    angle += cubic.values[of_four] * value;
    rate += cubic.rates[of_four] / knot_spacing * value;
  };
  // Nothing is known from before the start: as straight on as after it.
  put(0, index > 0 ? knot(index - 1) : VectorXd(2 * knot(0) - knot(1)));
  for (std::size_t i = 1; i < 4; ++i) put(i, knot(index - 1 + static_cast<long>(i)));
}

}  // namespace sinew
