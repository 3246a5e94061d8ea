// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/bodies/finger_bases.h"

#include <deque>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/dynamics/kinematics.h"
#include "symbolic/dynamics/spatial.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// How a frame moves against {0}, in its own axes: velocity and acceleration of its origin, the
/// latter less gravity, angular velocity and acceleration.
struct FrameMotion {
  Vector3ex v, w, a, alpha;
};

Vector3ex turned_into(const Matrix3ex& R, const Vector3ex& v) {
  Vector3ex result;
  for (std::size_t j = 0; j < 3; ++j) result[j] = R[0][j] * v[0] + R[1][j] * v[1] + R[2][j] * v[2];
  return result;
}

/// One derivation: the carriers' symbols and what of them the bases' motion follows from.
class Bases {
 public:
  explicit Bases(const Hand& hand)
      : hand_(hand),
        c_(carriers("c", "rad", {0.0, 0.0})),
        cd_(carriers("cd", "rad/s", {-3.0, 3.0})),
        cdd_(carriers("cdd", "rad/s^2", {-30.0, 30.0})),
        gravity_(
            array_argument("gravity", 3, 1, "m/s^2", {-9.81, 9.81}, "in the forearm frame {0}")) {
    c_.ranges.clear();
    if (hand.has_four_bar()) c_.ranges.push_back(hand.four_bar.theta2);
    for (const Range& range : bar_ranges(hand.wrist)) c_.ranges.push_back(range);
    for (std::size_t j = 0; j < c_.symbols.size(); ++j) {
      by_.emplace_back(list_, c_.symbols[j], "c" + std::to_string(j));
      by_rate_.emplace_back(list_, cd_.symbols[j], "cd" + std::to_string(j));
    }
    const std::size_t bars = c_.symbols.size() - 2;
    palm_ = from_homogeneous(
        inlined(list_, wrist_pose(hand.wrist), {c_.symbols[bars], c_.symbols[bars + 1]})[0]);
    if (hand.has_four_bar())
      coupler_ = from_homogeneous(
          inlined(list_, four_bar_coupler_pose(hand.four_bar), {c_.symbols[0]})[0]);
  }

  Function pose_function() {
    std::vector<ex> rows;
    for (const HandFinger& finger : hand_.fingers) {
      PoseEx pose = palm_;
      for (const PoseEx& step : steps_to(finger)) pose = product(pose, step);
      for (std::size_t i = 0; i < 3; ++i) {
        rows.insert(rows.end(), pose.R[i].begin(), pose.R[i].end());
        rows.push_back(pose.p[i]);
      }
      rows.insert(rows.end(), {0, 0, 0, 1});
    }
    return {"base_pose",
            "Poses of the fingers' bases, homogeneous, one below the other.",
            "",
            {c_},
            list_.items(),
            {{"T", 4 * fingers(), 4, rows, "1 and m", "map the bases' frames to {0}"}}};
  }

  Function twist_function() {
    std::vector<ex> rows;
    for (const FrameMotion& m : motions(false)) {
      rows.insert(rows.end(), m.v.begin(), m.v.end());
      rows.insert(rows.end(), m.w.begin(), m.w.end());
    }
    return {"base_twist",
            "Velocities of the fingers' bases against the forearm, in the "
            "bases' frames.",
            "",
            {c_, cd_},
            list_.items(),
            {{"twist", fingers(), 6, rows, "m/s, rad/s", "velocity of the origin, angular"}}};
  }

  Function motion_function() {
    std::vector<ex> rows;
    for (const FrameMotion& m : motions(true))
      for (const Vector3ex* each : {&m.w, &m.alpha, &m.a})
        rows.insert(rows.end(), each->begin(), each->end());
    return {"base_motion",
            "What the equations of motion of the fingers need to know of their "
            "bases' motion.",
            "",
            {c_, cd_, cdd_, gravity_},
            list_.items(),
            {{"motion", fingers(), 9, rows, "rad/s, rad/s^2, m/s^2",
              "angular velocity and acceleration, acceleration of the origin "
              "less gravity"}}};
  }

 private:
  int fingers() const { return static_cast<int>(hand_.fingers.size()); }

  Argument carriers(const std::string& name, const std::string& unit, const Range& range) const {
    return array_argument(name, hand_.has_four_bar() ? 3 : 2, 1, unit, range,
                          hand_.has_four_bar() ? "theta2, q71, q73" : "q71, q73");
  }

  /// From the palm to a finger's base.
  std::vector<PoseEx> steps_to(const HandFinger& finger) const {
    if (!finger.on_coupler) return {from_transform(finger.base)};
    return {from_transform(hand_.four_bar_base), coupler_, from_transform(finger.base)};
  }

  std::vector<FrameMotion> motions(bool second) {
    FrameMotion rest;
    for (std::size_t i = 0; i < 3; ++i) {
      rest.v[i] = rest.w[i] = rest.alpha[i] = 0;
      rest.a[i] = -gravity_.symbols[i];
    }
    const FrameMotion palm = carried(rest, palm_, second);
    std::vector<FrameMotion> result;
    for (const HandFinger& finger : hand_.fingers) {
      FrameMotion motion = palm;
      for (const PoseEx& step : steps_to(finger)) motion = carried(motion, step, second);
      result.push_back(motion);
    }
    return result;
  }

  /// Motion of a frame at a pose that may change with the carriers' angles; with `second` its
  /// accelerations, too.
  FrameMotion carried(const FrameMotion& carrier, const PoseEx& pose, bool second) {
    const Vector3ex p_rate = rate("p_rate", pose.p);
    Matrix3ex columns, column_rates;
    for (std::size_t j = 0; j < 3; ++j) {
      columns[j] = {pose.R[0][j], pose.R[1][j], pose.R[2][j]};
      column_rates[j] = rate("R_rate", columns[j]);
    }
    // In the frame's own axes: w_x = z . dy/dt and so on.
    Vector3ex own_spin, turned = define(list_, "turned", turned_into(pose.R, carrier.w));
    for (std::size_t i = 0; i < 3; ++i)
      own_spin[i] = list_.define("own_spin", dot(columns[(i + 2) % 3], column_rates[(i + 1) % 3]));
    FrameMotion motion;
    motion.w = define(list_, "w", turned + own_spin);
    const Vector3ex around = define(list_, "around", cross(carrier.w, pose.p));
    motion.v = define(list_, "v", turned_into(pose.R, carrier.v + around + p_rate));
    if (!second) return motion;
    Vector3ex own_rate;
    for (std::size_t i = 0; i < 3; ++i) own_rate[i] = acceleration("own_rate", own_spin[i]);
    motion.alpha = define(list_, "alpha",
                          turned_into(pose.R, carrier.alpha) + own_rate + cross(turned, own_spin));
    Vector3ex p_second;
    for (std::size_t i = 0; i < 3; ++i) p_second[i] = acceleration("p_second", p_rate[i]);
    const Vector3ex whole = carrier.a + cross(carrier.alpha, pose.p) + cross(carrier.w, around) +
                            ex(2) * cross(carrier.w, p_rate) + p_second;
    motion.a = define(list_, "a", turned_into(pose.R, define(list_, "whole", whole)));
    return motion;
  }

  /// d(value)/dt of what depends on the carriers' angles.
  Vector3ex rate(const std::string& name, const Vector3ex& value) {
    Vector3ex result;
    for (std::size_t i = 0; i < 3; ++i) {
      ex sum = 0;
      for (std::size_t j = 0; j < by_.size(); ++j) sum += by_[j].of(value[i]) * cd_.symbols[j];
      result[i] = list_.define(name, sum);
    }
    return result;
  }

  /// d/dt of what is linear in the carriers' rates.
  ex acceleration(const std::string& name, const ex& of_rates) {
    ex sum = 0;
    for (std::size_t j = 0; j < by_.size(); ++j) {
      sum += by_[j].of(of_rates) * cd_.symbols[j];
      sum += by_rate_[j].of(of_rates) * cdd_.symbols[j];
    }
    return list_.define(name, sum);
  }

  PoseEx product(const PoseEx& a, const PoseEx& b) {
    PoseEx result;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        result.R[i][j] = list_.define(
            "R", a.R[i][0] * b.R[0][j] + a.R[i][1] * b.R[1][j] + a.R[i][2] * b.R[2][j]);
      result.p[i] = list_.define("p", dot(a.R[i], b.p) + a.p[i]);
    }
    return result;
  }

  const Hand& hand_;
  Argument c_, cd_, cdd_, gravity_;
  DefinitionList list_;
  std::deque<ForwardDerivative> by_,
      by_rate_;  ///< one a carrier: by its angle, by its rate
  PoseEx palm_, coupler_;
};

}  // namespace

Function finger_base_pose(const Hand& hand) {
  return Bases(hand).pose_function();
}

Function finger_base_twist(const Hand& hand) {
  return Bases(hand).twist_function();
}

Function finger_base_motion(const Hand& hand) {
  return Bases(hand).motion_function();
}

}  // namespace sinew
