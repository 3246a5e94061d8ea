// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers on a base that moves: the emitted equations against Newton and Euler's, written out here
// for bodies on a base in any motion, and the emitted motion of the bases against differences of
// their emitted poses.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "generator/assemble.h"
#include "simulation/bodies/finger_bases.h"
#include "simulation/bodies/finger_dynamics.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/hand/read_hand.h"
#include "symbolic/model/read_mechanism.h"
#include "tests/reference/chain.h"
#include "tests/simulation/scenario_run.h"

using namespace sinew_tests;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Of the base's frame, in its axes; acceleration less gravity.
struct BaseMotion {
  Vector3d spin, spin_rate, acceleration;
};

struct Needed {
  VectorXd joints;  ///< torque of each moving joint
  Vector3d force, moment;
};

/// Forces of a motion: q, qd, qdd of all moving joints. Everything in the base's axes.
Needed newton_euler(const sinew::Mechanism& mechanism, const VectorXd& q, const VectorXd& qd,
                    const VectorXd& qdd, const BaseMotion& base) {
  const sinew::reference::Chain<double> chain(mechanism);
  const auto poses = chain.base_poses(q);
  const auto& joints = chain.joints();
  std::vector<Vector3d> spin, spin_rate, acceleration, force, moment;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto parent = static_cast<std::size_t>(std::max(joints[i].parent, 0));
    const bool first = joints[i].parent < 0;
    const Vector3d w = first ? base.spin : spin[parent];
    const Vector3d alpha = first ? base.spin_rate : spin_rate[parent];
    const Vector3d from = first ? Vector3d::Zero() : Vector3d(poses[parent].translation);
    const Vector3d r = poses[i].translation - from;
    Vector3d a =
        (first ? base.acceleration : acceleration[parent]) + alpha.cross(r) + w.cross(w.cross(r));
    Vector3d own = w, own_rate = alpha;
    const Vector3d axis = poses[i].rotation * joints[i].axis;
    if (joints[i].coordinate >= 0) {
      const double rate = qd(joints[i].coordinate), second = qdd(joints[i].coordinate);
      if (joints[i].type == sinew::JointType::revolute) {
        own += axis * rate;
        own_rate += axis * second + w.cross(axis) * rate;
      } else {
        a += axis * second + 2.0 * w.cross(axis) * rate;
      }
    }
    const sinew::Body& body = mechanism.bodies[i];
    const Vector3d c = poses[i].rotation * body.centre_of_mass;
    const Eigen::Matrix3d I = poses[i].rotation * body.inertia * poses[i].rotation.transpose();
    const Vector3d F = body.mass * (a + own_rate.cross(c) + own.cross(own.cross(c)));
    spin.push_back(own);
    spin_rate.push_back(own_rate);
    acceleration.push_back(a);
    force.push_back(F);
    moment.push_back(I * own_rate + own.cross(I * own) +
                     (Vector3d(poses[i].translation) + c).cross(F));
  }
  Needed needed{VectorXd::Zero(chain.coordinates()), Vector3d::Zero(), Vector3d::Zero()};
  for (std::size_t i = joints.size(); i-- > 0;) {
    if (joints[i].coordinate >= 0) {
      const Vector3d axis = poses[i].rotation * joints[i].axis, at = poses[i].translation;
      needed.joints(joints[i].coordinate) = joints[i].type == sinew::JointType::revolute
                                                ? axis.dot(moment[i] - at.cross(force[i]))
                                                : axis.dot(force[i]);
    }
    const bool first = joints[i].parent < 0;
    const auto parent = static_cast<std::size_t>(std::max(joints[i].parent, 0));
    (first ? needed.force : force[parent]) += force[i];
    (first ? needed.moment : moment[parent]) += moment[i];
  }
  return needed;
}

/// Moving joints from coordinates: joints that follow another one (5.16).
MatrixXd map_of(const sinew::Mechanism& mechanism) {
  const sinew::Coordinates coordinates(mechanism);
  const auto n = static_cast<std::size_t>(coordinates.count());
  sinew::DefinitionList list;
  const sinew::JointMap joints = coordinates.at(list, std::vector<GiNaC::ex>(n, 0));
  MatrixXd J(sinew::coordinate_count(mechanism), coordinates.count());
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<GiNaC::ex> unit(n, 0);
    unit[k] = 1;
    const auto column = joints.velocities(unit);
    for (std::size_t i = 0; i < column.size(); ++i)
      J(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          GiNaC::ex_to<GiNaC::numeric>(column[i].evalf()).to_double();
  }
  return J;
}

}  // namespace

TEST_CASE("a finger on a moving base obeys Newton and Euler", "[moving_base]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto some = [&](double size) { return [&, size] { return size * unit(random); }; };
  for (const char* name : {"index", "thumb", "ring"}) {
    const sinew::Mechanism mechanism = sinew::read_mechanism(source + "/models/" + name);
    const sinew::FingerDynamics finger(mechanism, true, source + "/runtime");
    const MatrixXd J = map_of(mechanism);
    const auto n = finger.size();
    double worst = 0.0, missing = 0.0;
    for (int sample = 0; sample < 20; ++sample) {
      const VectorXd q = VectorXd::NullaryExpr(n, some(1.0)),
                     qd = VectorXd::NullaryExpr(n, some(10)),
                     qdd = VectorXd::NullaryExpr(n, some(100));
      VectorXd base(9), tau(n), wrench(6), back(n);
      for (int i = 0; i < 9; ++i) base(i) = (i < 3 ? 5.0 : 20.0) * unit(random);
      const BaseMotion motion{base.head<3>(), base.segment<3>(3), base.tail<3>()};
      finger.inverse(q.data(), qd.data(), qdd.data(), base.data(), tau.data(), wrench.data());
      const Needed needed = newton_euler(mechanism, J * q, J * qd, J * qdd, motion);
      const VectorXd wanted = J.transpose() * needed.joints;
      VectorXd whole(6);
      whole << needed.force, needed.moment;
      worst = std::max(
          {worst, (tau - wanted).norm() / wanted.norm(), (wrench - whole).norm() / whole.norm()});
      // Planted defect: without the base's angular velocity.
      const Needed other = newton_euler(mechanism, J * q, J * qd, J * qdd,
                                        {Vector3d::Zero(), motion.spin_rate, motion.acceleration});
      missing = std::max(missing, (J.transpose() * other.joints - wanted).norm() / wanted.norm());
      finger.acceleration(q.data(), qd.data(), tau.data(), base.data(), back.data());
      worst = std::max(worst, (back - qdd).norm() / qdd.norm());
    }
    CAPTURE(name, worst, missing);
    CHECK(worst < 1e-11);
    CHECK(missing > 1e-3);
  }
}

TEST_CASE("the fingers' bases move as their poses do", "[moving_base]") {
  const sinew::Hand hand = sinew::read_hand(source + "/models/hand").hand;
  const sinew::CompiledModel bases(
      sinew::assemble({"bases", "", "", {}},
                      {sinew::finger_base_pose(hand), sinew::finger_base_twist(hand),
                       sinew::finger_base_motion(hand)},
                      {}),
      source + "/runtime");
  const double c0[3] = {1.6, 0.7, 1.1}, rate[3] = {1.5, -2.0, 1.2}, second[3] = {10, 20, -30};
  const Vector3d gravity(1.0, -2.0, -9.0);
  const auto poses = [&](double t) {
    std::vector<double> c;
    for (int j = 0; j < 3; ++j) c.push_back(c0[j] + t * rate[j] + 0.5 * t * t * second[j]);
    return bases("base_pose", c);
  };
  std::vector<double> in(c0, c0 + 3);
  in.insert(in.end(), rate, rate + 3);
  const std::vector<double> twist = bases("base_twist", in);
  in.insert(in.end(), second, second + 3);
  in.insert(in.end(), gravity.data(), gravity.data() + 3);
  const std::vector<double> motion = bases("base_motion", in);

  const double h = 1e-3;
  std::vector<std::vector<double>> at;
  for (int i = -2; i <= 2; ++i) at.push_back(poses(i * h));
  using Pose = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  for (std::size_t k = 0; k < hand.fingers.size(); ++k) {
    const auto pose = [&](int i) {
      return Pose(Eigen::Map<const Pose>(&at[static_cast<std::size_t>(i + 2)][16 * k]));
    };
    const Pose first = (pose(-2) - 8 * pose(-1) + 8 * pose(1) - pose(2)) / (12 * h);
    const Pose other =
        (-pose(-2) + 16 * pose(-1) - 30 * pose(0) + 16 * pose(1) - pose(2)) / (12 * h * h);
    const Eigen::Matrix3d R = pose(0).topLeftCorner<3, 3>();
    const Eigen::Matrix3d spin = R.transpose() * first.topLeftCorner<3, 3>();
    // R^T ddR = [alpha x] + [w x]^2, the latter symmetric
    const Eigen::Matrix3d rates = R.transpose() * other.topLeftCorner<3, 3>();
    const Eigen::Matrix3d turning = 0.5 * (rates - rates.transpose());
    const auto vee = [](const Eigen::Matrix3d& m) -> Vector3d {
      return Vector3d(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)) / 2;
    };
    VectorXd wanted(15), found(15);
    wanted << R.transpose() * first.topRightCorner<3, 1>(), vee(spin), vee(spin), vee(turning),
        R.transpose() * (other.topRightCorner<3, 1>() - gravity);
    for (int i = 0; i < 6; ++i) found(i) = twist[6 * k + static_cast<std::size_t>(i)];
    for (int i = 0; i < 9; ++i) found(6 + i) = motion[9 * k + static_cast<std::size_t>(i)];
    CAPTURE(k, wanted.transpose(), found.transpose());
    CHECK((found - wanted).norm() < 1e-6 * wanted.norm());
    CHECK(wanted.segment<3>(9).norm() > 1.0);
  }
}
