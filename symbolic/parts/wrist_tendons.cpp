// SPDX-License-Identifier: GPL-3.0-or-later
// Tendons through the wrist (6.9): lengths, their derivatives and bending, and the motor angles
// that take them up.
#include <algorithm>
#include <array>

#include "symbolic/parts/wrist_lengths.h"

namespace sinew {
namespace {

using GiNaC::ex;

constexpr Range rate_range{-3.0, 3.0};  // rad/s

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
  const wrist::Lengths lengths(parameters);
  return lengths.start.finish(
      "tendon_lengths", "(6.9)", "Lengths of the tendons through the wrist.",
      {{"h", wrist::tendon_count(parameters), 1, lengths.h, "m", "tendon lengths"}});
}

Function wrist_tendon_jacobian(const WristParameters& parameters) {
  wrist::Lengths lengths(parameters);
  std::vector<ex> P;
  for (std::size_t i = 0; i < lengths.h.size(); ++i)
    P.insert(P.end(), {lengths.slope(i, 0), lengths.slope(i, 1)});
  return lengths.start.finish("tendon_jacobian", "", "Derivatives of the lengths by q71 and q73.",
                              {{"P", wrist::tendon_count(parameters), 2, P, "m/rad", "dh/dq"}});
}

Function wrist_tendon_hessian(const WristParameters& parameters) {
  wrist::Lengths lengths(parameters);
  std::vector<ex> H(4 * lengths.h.size());
  for (const auto& [row, col] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 1}})
    for (std::size_t layer = 0; layer < lengths.strands.layers().size(); ++layer)
      for (const std::size_t i : lengths.strands.layers()[layer].tendons) {
        const ex value = lengths.curvature(layer, i, row, col);
        H[4 * i + std::size_t(2 * row + col)] = H[4 * i + std::size_t(2 * col + row)] = value;
      }
  return lengths.start.finish(
      "tendon_hessian", "", "Second derivatives of the lengths by q71 and q73.",
      {{"H", wrist::tendon_count(parameters), 4, H, "m/rad^2", "each row a symmetric 2x2 matrix"}});
}

Function wrist_bending_angles(const WristParameters& parameters) {
  WristStart start(parameters);
  const wrist::Strands strands(parameters, start);
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
                      {{"angles", wrist::tendon_count(parameters), 1, angles, "rad",
                        "against the forearm's and the palm's x axis"}});
}

Function wrist_feedforward(const WristParameters& parameters) {
  wrist::Lengths lengths(parameters);
  WristStart& start = lengths.start;
  std::vector<ex> change = lengths.h;
  for (std::size_t i = 0; i < change.size(); ++i)  // named, so that the difference is taken first
    change[i] =
        start.list.define("change_" + std::to_string(i),
                          change[i] - reference_length(start.links, parameters.forearm_points[i],
                                                       parameters.palm_points[i]));
  return start.finish("feedforward", "",
                      "Motor angles that hold the fingers still while the wrist moves.",
                      {{"delta_theta", wrist::tendon_count(parameters), 1,
                        taken_up(parameters, change), "rad", "0 in the reference pose"}});
}

Function wrist_feedforward_rate(const WristParameters& parameters) {
  wrist::Lengths lengths(parameters);
  const Argument dq71 = scalar_argument("dq71", "rad/s", rate_range, "rate of q71");
  const Argument dq73 = scalar_argument("dq73", "rad/s", rate_range, "rate of q73");
  ForwardDerivative rate(lengths.start.list, GiNaC::symbol("t"), "t");
  rate.seed(lengths.start.q71(), dq71.symbols[0]);
  rate.seed(lengths.start.q73(), dq73.symbols[0]);
  const std::vector<ex> rates = lengths.slopes(rate, "t");
  Function function = lengths.start.finish("feedforward_rate", "",
                                           "Rates of the motor angles of wrist_feedforward.",
                                           {{"delta_theta_rate", wrist::tendon_count(parameters), 1,
                                             taken_up(parameters, rates), "rad/s", ""}});
  function.inputs.insert(function.inputs.end(), {dq71, dq73});
  return function;
}

}  // namespace sinew
