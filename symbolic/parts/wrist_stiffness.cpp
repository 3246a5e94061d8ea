// SPDX-License-Identifier: GPL-3.0-or-later
// What the tendons through the wrist (6.9) pull with: torques and stiffnesses.
#include <algorithm>
#include <array>

#include "symbolic/parts/wrist_lengths.h"

namespace sinew {
namespace {

using GiNaC::ex;

constexpr Range force_range{0.0, 100.0};        // N
constexpr Range stiffness_range{1.0e3, 5.0e4};  // N/m
constexpr Range moment_arm_range{-0.02, 0.02};  // m/rad
constexpr Range length_range{0.02, 0.1};        // m

/// Sums over the tendons of each layer, taken before anything is differentiated. With w = f/h and a
/// tendon's strand s = L + F e_y - y a, they are w, w y, w y² and, for each layer and for the
/// palm's y axis, what a change of L or a is multiplied by: Σ w s and -Σ w y s.
class Pulls {
 public:
  Pulls(wrist::Lengths& lengths, const std::vector<GiNaC::symbol>& f)
      : lengths_(lengths), per_length_(f.size()) {
    DefinitionList& list = lengths.list();
    for (const wrist::Layer& layer : lengths.strands.layers()) {
      Sums sums;
      ex along_y = 0, by_y_along_y = 0;
      for (const std::size_t i : layer.tendons) {
        const std::string index = "_" + std::to_string(i);
        const ex& y = lengths.strands.palm_y(i);
        // Named, so that the terms of a sum keep this order.
        const ex w = per_length_[i] = list.define("per_length" + index, f[i] / lengths.h[i]);
        const ex by_y = list.define("pull_by_y" + index, y * w);
        sums.weight[0] += w;
        sums.weight[1] += by_y;
        sums.weight[2] += list.define("pull_by_y_squared" + index, y * by_y);
        along_y += list.define("pull" + index, w * lengths.strand_y[i]);
        by_y_along_y += list.define("pull_by_y_along" + index, by_y * lengths.strand_y[i]);
      }
      for (ex& sum : sums.weight) sum = list.define("pull", sum);
      const auto& [w, wy, wyy] = sums.weight;
      const Vector3 &L = layer.first, &a = lengths.start.pose.y;
      sums.on_layer = define(list, "pull", {w * L[0] - wy * a[0], along_y, w * L[2] - wy * a[2]});
      sums.on_axis = define(list, "pull_axis",
                            {wyy * a[0] - wy * L[0], -by_y_along_y, wyy * a[2] - wy * L[2]});
      sums_.push_back(sums);
    }
  }

  /// f/h of a tendon.
  const ex& per_length(std::size_t tendon) const { return per_length_[tendon]; }

  /// Σ f ∂h/∂q_j.
  ex slope(int j) const {
    return weighted([&](const Vector3& value) { return by(value, j); });
  }
  /// Σ f ∂²h/(∂q_i ∂q_j) + (f/h) ∂h/∂q_i ∂h/∂q_j.
  ex curvature(int i, int j) const {
    ex sum = weighted(
        [&](const Vector3& value) { return by(by(value, std::min(i, j)), std::max(i, j)); });
    const Vector3 a_i = by(lengths_.start.pose.y, i), a_j = by(lengths_.start.pose.y, j);
    for (std::size_t layer = 0; layer < sums_.size(); ++layer) {
      const Vector3& L = lengths_.strands.layers()[layer].first;
      const Vector3 L_i = by(L, i), L_j = by(L, j);
      const ex mixed = lengths_.list().define("mixed", dot(L_i, a_j) + dot(a_i, L_j));
      const auto& [w, wy, wyy] = sums_[layer].weight;
      sum += w * lengths_.list().define("along", dot(L_i, L_j)) - wy * mixed +
             wyy * lengths_.list().define("turned", dot(a_i, a_j));
    }
    return sum;
  }

 private:
  struct Sums {
    std::array<ex, 3> weight = {0, 0, 0};
    Vector3 on_layer, on_axis;
  };

  Vector3 by(const Vector3& value, int j) const {
    ForwardDerivative& derivative = lengths_.derivative(j);
    return {derivative.of(value[0]), derivative.of(value[1]), derivative.of(value[2])};
  }

  template <class Derivative>
  ex weighted(const Derivative& derivative) const {
    ex sum = 0;
    Vector3 on_axis{0, 0, 0};
    for (std::size_t layer = 0; layer < sums_.size(); ++layer) {
      sum += dot(sums_[layer].on_layer, derivative(lengths_.strands.layers()[layer].first));
      on_axis = on_axis + sums_[layer].on_axis;
    }
    return sum +
           dot(define(lengths_.list(), "pull_axis", on_axis), derivative(lengths_.start.pose.y));
  }

  wrist::Lengths& lengths_;
  std::vector<ex> per_length_;
  std::vector<Sums> sums_;
};

Argument forces(const WristParameters& parameters) {
  return array_argument("f", wrist::tendon_count(parameters), 1, "N", force_range, "tendon forces");
}

Argument stiffnesses(int count) {
  return array_argument("k", count, 1, "N/m", stiffness_range, "tendon stiffnesses");
}

}  // namespace

Function wrist_joint_torque(const WristParameters& parameters) {
  wrist::Lengths lengths(parameters);
  const Argument f = forces(parameters);
  Pulls pulls(lengths, f.symbols);
  std::vector<ex> tau;
  for (int j = 0; j < 2; ++j) tau.push_back(-pulls.slope(j));
  Function function =
      lengths.start.finish("joint_torque", "", "Torques of the tendons on q71, q73.",
                           {{"tau", 2, 1, tau, "N m", "-P^T f"}});
  function.inputs.push_back(f);
  return function;
}

namespace {

/// Σ f ∂²h + k ∂h ∂h, of which Pulls has f ∂²h + (f/h) ∂h ∂h.
std::vector<ex> joint_stiffness(wrist::Lengths& lengths, const std::vector<GiNaC::symbol>& f,
                                const std::vector<GiNaC::symbol>& k) {
  const Pulls pulls(lengths, f);
  const auto entry = [&](int row, int col) -> ex {
    ex sum = pulls.curvature(row, col);
    for (const wrist::Layer& layer : lengths.strands.layers()) {
      ex of_layer = 0;
      for (const std::size_t i : layer.tendons) {
        // What they need is written down in this order, whatever the compiler's order of operands.
        const ex by_row = lengths.slope(i, row), by_col = lengths.slope(i, col);
        const std::string index = "_" + std::to_string(i);
        const ex across = lengths.list().define("across" + index, k[i] - pulls.per_length(i));
        of_layer += lengths.list().define("K" + index, across * by_row * by_col);
      }
      sum += lengths.list().define("K_of_layer", of_layer);
    }
    return sum;
  };
  const ex mixed = lengths.list().define("K_01", entry(0, 1));
  return {entry(0, 0), mixed, mixed, entry(1, 1)};
}

}  // namespace

Function wrist_joint_stiffness(const WristParameters& parameters) {
  wrist::Lengths lengths(parameters);
  const Argument f = forces(parameters), k = stiffnesses(wrist::tendon_count(parameters));
  const std::vector<ex> K = joint_stiffness(lengths, f.symbols, k.symbols);
  Function function = lengths.start.finish(
      "joint_stiffness", "", "Stiffness of the wrist's bars, motors held.",
      {{"K", 2, 2, K, "N m/rad", "sum of f d2h/dq2, plus P^T diag(k) P; symmetric"}});
  function.inputs.insert(function.inputs.end(), {f, k});
  return function;
}

Function wrist_passage_stiffness(const WristParameters& parameters) {
  const int count = wrist::tendon_count(parameters);
  const Argument h = array_argument("h", count, 1, "m", length_range, "tendon lengths");
  const Argument P =
      array_argument("P", count, 2, "m/rad", moment_arm_range, "their derivatives by q71 and q73");
  const Argument f = forces(parameters), k = stiffnesses(count);
  wrist::Lengths lengths(parameters, h, P);
  const std::vector<ex> K = joint_stiffness(lengths, f.symbols, k.symbols);
  Function function = lengths.start.finish("passage_stiffness", "",
                                           "The same where lengths and Jacobian are known.",
                                           {{"K", 2, 2, K, "N m/rad", "symmetric"}});
  function.inputs.insert(function.inputs.end(), {h, P, f, k});
  return function;
}

Function wrist_finger_stiffness(const WristParameters& parameters, const std::string& name,
                                const std::vector<int>& channels, int joints) {
  wrist::Lengths lengths(parameters);
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
