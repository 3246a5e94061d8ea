// SPDX-License-Identifier: GPL-3.0-or-later
#include <kdl/chain.hpp>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <stdexcept>

#include "benchmarks/contestant.h"

namespace sinew::benchmarks {
namespace {

KDL::Vector vector_of(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// One segment a joint, as robots read from URDF come to KDL: the joint placed in the parent, the
/// tip in the frame of the body that the joint carries.
KDL::Chain chain_of(const Mechanism& mechanism) {
  KDL::Chain chain;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.parent != static_cast<int>(i) - 1 || joint.type != JointType::revolute)
      throw std::runtime_error(joint.name + ": KDL's solver is given chains of revolute joints");
    const Eigen::Matrix3d& r = joint.origin.rotation;
    const KDL::Rotation rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0),
                                 r(2, 1), r(2, 2));
    const KDL::Frame origin(rotation, vector_of(joint.origin.translation));
    const Body& body = mechanism.bodies[i];
    const Eigen::Matrix3d& inertia = body.inertia;
    const KDL::RotationalInertia about_centre(inertia(0, 0), inertia(1, 1), inertia(2, 2),
                                              inertia(0, 1), inertia(0, 2), inertia(1, 2));
    chain.addSegment(KDL::Segment(
        KDL::Joint(origin.p, rotation * vector_of(joint.axis), KDL::Joint::RotAxis), origin,
        KDL::RigidBodyInertia(body.mass, vector_of(body.centre_of_mass), about_centre)));
  }
  return chain;
}

class Robot {
 public:
  explicit Robot(const Mechanism& mechanism)
      : chain_(chain_of(mechanism)),
        solver_(chain_, vector_of(mechanism.gravity)),
        parameters_(chain_, vector_of(mechanism.gravity)),
        q_(chain_.getNrOfJoints()),
        qd_(q_.rows()),
        qdd_(q_.rows()),
        torque_(q_.rows()),
        mass_(q_.rows()),
        outside_(chain_.getNrOfSegments(), KDL::Wrench::Zero()) {}

  void inverse_dynamics(const double* q, const double* qd, const double* qdd, double* out) {
    const Eigen::Index n = q_.rows();
    q_.data = Eigen::Map<const Eigen::VectorXd>(q, n);
    qd_.data = Eigen::Map<const Eigen::VectorXd>(qd, n);
    if (qdd != nullptr)
      qdd_.data = Eigen::Map<const Eigen::VectorXd>(qdd, n);
    else
      qdd_.data.setZero();
    if (solver_.CartToJnt(q_, qd_, qdd_, outside_, torque_) < 0)
      throw std::runtime_error("KDL's inverse dynamics failed");
    Eigen::Map<Eigen::VectorXd>(out, n) = torque_.data;
  }

  void mass_matrix(const double* q, double* out) {
    const Eigen::Index n = q_.rows();
    q_.data = Eigen::Map<const Eigen::VectorXd>(q, n);
    if (parameters_.JntToMass(q_, mass_) < 0) throw std::runtime_error("KDL's mass matrix failed");
    Eigen::Map<Eigen::MatrixXd>(out, n, n) = mass_.data;
  }

 private:
  KDL::Chain chain_;
  KDL::ChainIdSolver_RNE solver_;
  KDL::ChainDynParam parameters_;
  KDL::JntArray q_, qd_, qdd_, torque_;
  KDL::JntSpaceInertiaMatrix mass_;
  KDL::Wrenches outside_;
};

}  // namespace

std::vector<Contestant> from_kdl(const Mechanism& mechanism) {
  const auto robot = std::make_shared<Robot>(mechanism);
  using In = const double*;
  const std::string maker = "Orocos KDL";
  return {
      {maker, Quantity::inverse_dynamics,
       [robot](In q, In qd, In u, double* out) { robot->inverse_dynamics(q, qd, u, out); }},
      {maker, Quantity::bias,
       [robot](In q, In qd, In, double* out) { robot->inverse_dynamics(q, qd, nullptr, out); }},
      {maker, Quantity::mass_matrix,
       [robot](In q, In, In, double* out) { robot->mass_matrix(q, out); }},
  };
}

}  // namespace sinew::benchmarks
