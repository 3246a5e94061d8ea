// SPDX-License-Identifier: GPL-3.0-or-later
// Tendons through the wrist (6.9): lengths, derivatives and what follows from them.
#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/parts/wrist_geometry.h"

namespace sinew {
namespace {

using GiNaC::ex;

constexpr Range force_range{0.0, 100.0};        // N
constexpr Range stiffness_range{1.0e3, 5.0e4};  // N/m
constexpr Range rate_range{-3.0, 3.0};          // rad/s
constexpr Range moment_arm_range{-0.02, 0.02};  // m/rad

/// From the palm point of each tendon to its forearm point. Within a layer the points differ in y
/// only: what the layer has in common is defined once.
class Strands {
 public:
  Strands(const WristParameters& parameters, WristStart& start) : start_(start) {
    const auto &forearm = parameters.forearm_points, &palm = parameters.palm_points;
    if (forearm.size() != palm.size())
      throw std::invalid_argument("each wrist tendon needs a forearm point and a palm point");
    for (std::size_t i = 0; i < palm.size(); ++i) add(forearm[i], palm[i]);
  }

  const std::vector<Vector3>& all() const { return strands_; }

  std::vector<ex> lengths() {
    std::vector<ex> result;
    for (std::size_t i = 0; i < strands_.size(); ++i)
      result.push_back(start_.list.define("length_" + std::to_string(i),
                                          GiNaC::sqrt(dot(strands_[i], strands_[i]))));
    return result;
  }

 private:
  void add(const Eigen::Vector3d& forearm, const Eigen::Vector3d& palm) {
    const Vector3 F = exact_vector(forearm), P = exact_vector(palm);
    const std::array<double, 4> key{forearm[0], forearm[2], palm[0], palm[2]};
    if (!layers_.count(key))
      layers_[key] = define(start_.list, "layer_" + std::to_string(layers_.size()),
                            Vector3{F[0], 0, F[2]} - start_.pose.origin -
                                (P[0] * start_.pose.x + P[2] * start_.pose.z));
    strands_.push_back(define(start_.list, "strand_" + std::to_string(strands_.size()),
                              layers_[key] + Vector3{0, F[1], 0} - P[1] * start_.pose.y));
  }

  WristStart& start_;
  std::map<std::array<double, 4>, Vector3> layers_;
  std::vector<Vector3> strands_;
};

int tendon_count(const WristParameters& parameters) {
  return static_cast<int>(parameters.palm_points.size());
}

/// Lengths with their first and second derivatives with respect to q71 and q73.
struct Lengths {
  explicit Lengths(const WristParameters& parameters)
      : start(parameters),
        h(Strands(parameters, start).lengths()),
        by_q71(start.list, start.q71(), "q71"),
        by_q73(start.list, start.q73(), "q73") {}

  /// Column 0 or 1 of the Jacobian.
  ex slope(std::size_t tendon, int j) { return derivative(j).of(h[tendon]); }
  ex curvature(std::size_t tendon, int i, int j) {
    return derivative(std::max(i, j)).of(slope(tendon, std::min(i, j)));
  }
  ForwardDerivative& derivative(int j) { return j == 0 ? by_q71 : by_q73; }

  WristStart start;
  std::vector<ex> h;
  ForwardDerivative by_q71, by_q73;
};

Argument forces(const WristParameters& parameters) {
  return array_argument("f", tendon_count(parameters), 1, "N", force_range, "tendon forces");
}

Argument stiffnesses(int count) {
  return array_argument("k", count, 1, "N/m", stiffness_range, "tendon stiffnesses");
}

/// Motor angles that take up a change of tendon lengths, or their rates.
std::vector<ex> taken_up(const WristParameters& parameters, const std::vector<ex>& changes) {
  std::vector<ex> result;
  for (const ex& change : changes)
    result.push_back(-change / exact_number(parameters.motor_radius));
  return result;
}

/// Length in the reference pose, where {ABC} is parallel to {0} with its origin at (a, b/2, c/2).
ex reference_length(const WristLinks& links, const Eigen::Vector3d& forearm,
                    const Eigen::Vector3d& palm) {
  const Vector3 strand =
      exact_vector(forearm) - exact_vector(palm) - Vector3{links.a, links.b / 2, links.c / 2};
  return rational_root(GiNaC::ex_to<GiNaC::numeric>(dot(strand, strand)));
}

}  // namespace

Function wrist_tendon_lengths(const WristParameters& parameters) {
  WristStart start(parameters);
  const std::vector<ex> h = Strands(parameters, start).lengths();
  return start.finish("tendon_lengths", "(6.9)", "Lengths of the tendons through the wrist.",
                      {{"h", tendon_count(parameters), 1, h, "m", "tendon lengths"}});
}

Function wrist_tendon_jacobian(const WristParameters& parameters) {
  Lengths lengths(parameters);
  std::vector<ex> P;
  for (std::size_t i = 0; i < lengths.h.size(); ++i)
    P.insert(P.end(), {lengths.slope(i, 0), lengths.slope(i, 1)});
  return lengths.start.finish("tendon_jacobian", "", "Derivatives of the lengths by q71 and q73.",
                              {{"P", tendon_count(parameters), 2, P, "m/rad", "dh/dq"}});
}

Function wrist_tendon_hessian(const WristParameters& parameters) {
  Lengths lengths(parameters);
  std::vector<ex> H;
  for (std::size_t i = 0; i < lengths.h.size(); ++i) {
    const ex mixed = lengths.curvature(i, 0, 1);
    H.insert(H.end(), {lengths.curvature(i, 0, 0), mixed, mixed, lengths.curvature(i, 1, 1)});
  }
  return lengths.start.finish(
      "tendon_hessian", "", "Second derivatives of the lengths by q71 and q73.",
      {{"H", tendon_count(parameters), 4, H, "m/rad^2", "each row a symmetric 2x2 matrix"}});
}

Function wrist_bending_angles(const WristParameters& parameters) {
  WristStart start(parameters);
  const Strands strands(parameters, start);
  const Vector3 &x = start.pose.x, forearm{1, 0, 0};
  std::vector<ex> angles;
  for (const Vector3& back : strands.all()) {
    const Vector3 towards_palm = ex(-1) * back;
    ex sum = 0;
    for (const Vector3& axis : {forearm, x}) {
      const Vector3 aside = define(start.list, "aside", cross(axis, towards_palm));
      sum += GiNaC::atan2(GiNaC::sqrt(dot(aside, aside)), dot(axis, towards_palm));
    }
    angles.push_back(sum);
  }
  return start.finish("bending_angles", "", "Total bending of each tendon in the wrist.",
                      {{"angles", tendon_count(parameters), 1, angles, "rad",
                        "against the forearm's and the palm's x axis"}});
}

Function wrist_feedforward(const WristParameters& parameters) {
  WristStart start(parameters);
  std::vector<ex> change = Strands(parameters, start).lengths();
  for (std::size_t i = 0; i < change.size(); ++i)  // named, so that the difference is taken first
    change[i] =
        start.list.define("change_" + std::to_string(i),
                          change[i] - reference_length(start.links, parameters.forearm_points[i],
                                                       parameters.palm_points[i]));
  return start.finish("feedforward", "",
                      "Motor angles that hold the fingers still while the wrist moves.",
                      {{"delta_theta", tendon_count(parameters), 1, taken_up(parameters, change),
                        "rad", "0 in the reference pose"}});
}

Function wrist_feedforward_rate(const WristParameters& parameters) {
  Lengths lengths(parameters);
  const Argument dq71 = scalar_argument("dq71", "rad/s", rate_range, "rate of q71");
  const Argument dq73 = scalar_argument("dq73", "rad/s", rate_range, "rate of q73");
  std::vector<ex> rates;
  for (std::size_t i = 0; i < lengths.h.size(); ++i) {
    const ex by_q71 = lengths.slope(i, 0), by_q73 = lengths.slope(i, 1);
    rates.push_back(by_q71 * dq71.symbols[0] + by_q73 * dq73.symbols[0]);
  }
  Function function = lengths.start.finish("feedforward_rate", "",
                                           "Rates of the motor angles of wrist_feedforward.",
                                           {{"delta_theta_rate", tendon_count(parameters), 1,
                                             taken_up(parameters, rates), "rad/s", ""}});
  function.inputs.insert(function.inputs.end(), {dq71, dq73});
  return function;
}

Function wrist_joint_torque(const WristParameters& parameters) {
  Lengths lengths(parameters);
  const Argument f = forces(parameters);
  std::vector<ex> tau(2);
  for (std::size_t i = 0; i < lengths.h.size(); ++i)
    for (int j = 0; j < 2; ++j) tau[std::size_t(j)] -= lengths.slope(i, j) * f.symbols[i];
  Function function =
      lengths.start.finish("joint_torque", "", "Torques of the tendons on q71, q73.",
                           {{"tau", 2, 1, tau, "N m", "-P^T f"}});
  function.inputs.push_back(f);
  return function;
}

Function wrist_joint_stiffness(const WristParameters& parameters) {
  Lengths lengths(parameters);
  const Argument f = forces(parameters), k = stiffnesses(tendon_count(parameters));
  const auto entry = [&](int row, int col) {
    ex sum = 0;
    for (std::size_t i = 0; i < lengths.h.size(); ++i) {
      // What they need is written down in this order, whatever the compiler's order of operands.
      const ex by_row = lengths.slope(i, row), by_col = lengths.slope(i, col);
      const ex curvature = lengths.curvature(i, row, col);
      // Named, so that a tendon's terms stay together.
      sum += lengths.start.list.define("K_" + std::to_string(i),
                                       f.symbols[i] * curvature + k.symbols[i] * by_row * by_col);
    }
    return sum;
  };
  const ex mixed = lengths.start.list.define("K_01", entry(0, 1));
  const std::vector<ex> K{entry(0, 0), mixed, mixed, entry(1, 1)};
  Function function = lengths.start.finish(
      "joint_stiffness", "", "Stiffness of the wrist's bars, motors held.",
      {{"K", 2, 2, K, "N m/rad", "sum of f d2h/dq2, plus P^T diag(k) P; symmetric"}});
  function.inputs.insert(function.inputs.end(), {f, k});
  return function;
}

Function wrist_finger_stiffness(const WristParameters& parameters, const std::string& name,
                                const std::vector<int>& channels, int joints) {
  Lengths lengths(parameters);
  const int count = static_cast<int>(channels.size());
  const Argument k = stiffnesses(count);
  const Argument P = array_argument("P_finger", count, joints, "m/rad", moment_arm_range,
                                    "coupling matrix of the finger");
  std::vector<ex> K(std::size_t(2 * joints));
  for (std::size_t t = 0; t < channels.size(); ++t)
    for (int row = 0; row < 2; ++row) {
      const std::size_t tendon = static_cast<std::size_t>(channels[t]);
      const ex weight =
          lengths.start.list.define("weight", k.symbols[t] * lengths.slope(tendon, row));
      for (int j = 0; j < joints; ++j)
        K[std::size_t(row * joints + j)] +=
            weight * P.symbols[t * std::size_t(joints) + std::size_t(j)];
    }
  Function function = lengths.start.finish(
      name, "", "Stiffness between the wrist's bars and a finger's joints, motors held.",
      {{"K", 2, joints, K, "N m/rad", "P_wrist^T diag(k) P_finger"}});
  function.inputs.insert(function.inputs.end(), {k, P});
  return function;
}

}  // namespace sinew
