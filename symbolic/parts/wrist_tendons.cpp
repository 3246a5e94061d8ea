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
/// only: a strand is its layer's first one, a constant along y, and -y times the palm's y axis, y
/// from the first one's palm point. So all but the first have one form, and are emitted as a loop.
class Strands {
 public:
  Strands(const WristParameters& parameters, WristStart& start) : start_(start) {
    const auto &forearm = parameters.forearm_points, &palm = parameters.palm_points;
    if (forearm.size() != palm.size())
      throw std::invalid_argument("each wrist tendon needs a forearm point and a palm point");
    std::map<std::array<double, 4>, std::size_t> index;
    for (std::size_t i = 0; i < palm.size(); ++i) {
      const std::array<double, 4> key{forearm[i][0], forearm[i][2], palm[i][0], palm[i][2]};
      const auto [place, is_new] = index.try_emplace(key, layers_.size());
      const Vector3 F = exact_vector(forearm[i]), P = exact_vector(palm[i]);
      if (is_new) add_layer(F, P);
      add(layers_[place->second], F[1], P[1]);
    }
  }

  /// The strands of one layer.
  struct Layer {
    Vector3 first;
    ex forearm_y, palm_y;  ///< of the first one
    std::vector<std::size_t> tendons = {};
  };
  const std::vector<Layer>& layers() const { return layers_; }
  const Vector3& operator[](std::size_t tendon) const { return strands_[tendon]; }
  const std::vector<Vector3>& all() const { return strands_; }
  /// Of a palm point, from that of the layer's first tendon.
  const ex& y(std::size_t tendon) const { return y_[tendon]; }

  std::vector<ex> lengths() {
    std::vector<ex> result;
    for (std::size_t i = 0; i < strands_.size(); ++i)
      result.push_back(start_.list.define("length_" + std::to_string(i),
                                          GiNaC::sqrt(dot(strands_[i], strands_[i]))));
    return result;
  }

 private:
  void add_layer(const Vector3& forearm, const Vector3& palm) {
    const WristPose& pose = start_.pose;
    const Vector3 first =
        forearm - pose.origin - (palm[0] * pose.x + palm[2] * pose.z) - palm[1] * pose.y;
    layers_.push_back({define(start_.list, "layer_" + std::to_string(layers_.size()), first),
                       forearm[1], palm[1]});
  }

  void add(Layer& layer, const ex& forearm_y, const ex& palm_y) {
    layer.tendons.push_back(strands_.size());
    y_.push_back(palm_y - layer.palm_y);
    const Vector3 along_y{0, forearm_y - layer.forearm_y, 0};
    strands_.push_back(define(start_.list, "strand_" + std::to_string(strands_.size()),
                              layer.first + along_y - y_.back() * start_.pose.y));
  }

  WristStart& start_;
  std::vector<Layer> layers_;
  std::vector<Vector3> strands_;
  std::vector<ex> y_;
};

int tendon_count(const WristParameters& parameters) {
  return static_cast<int>(parameters.palm_points.size());
}

/// Lengths with their first and second derivatives with respect to q71 and q73.
struct Lengths {
  explicit Lengths(const WristParameters& parameters)
      : start(parameters),
        strands(parameters, start),
        h(strands.lengths()),
        by_q71(start.list, start.q71(), "q71"),
        by_q73(start.list, start.q73(), "q73") {}

  /// Column 0 or 1 of the Jacobian.
  ex slope(std::size_t tendon, int j) { return derivative(j).of(h[tendon]); }
  ex curvature(std::size_t tendon, int i, int j) {
    return derivative(std::max(i, j)).of(slope(tendon, std::min(i, j)));
  }
  ForwardDerivative& derivative(int j) { return j == 0 ? by_q71 : by_q73; }

  WristStart start;
  Strands strands;
  std::vector<ex> h;
  ForwardDerivative by_q71, by_q73;
};

/// Sums of forces over the tendons of each layer, taken before anything is differentiated: the
/// pose's derivatives are multiplied once instead of once a tendon. With the pulls p = f s/|s|,
///   Σ f d|s| = Σ over the layers (Σ p) · d(layer) - (Σ y p) · d(palm's y axis).
class Pulls {
 public:
  Pulls(Lengths& lengths, const std::vector<GiNaC::symbol>& f)
      : lengths_(lengths), per_length_(f.size()) {
    for (const Strands::Layer& layer : lengths.strands.layers()) {
      Vector3 sum, by_y;
      for (std::size_t i : layer.tendons) {
        const std::string index = std::to_string(i);
        per_length_[i] = list().define("per_length_" + index, f[i] / lengths.h[i]);
        const ex by_y_of_it =
            list().define("by_y_per_length_" + index, lengths.strands.y(i) * per_length_[i]);
        // Named, so that the terms of a sum keep this order.
        const Vector3& strand = lengths.strands[i];
        sum = sum + define(list(), "pull_" + index, per_length_[i] * strand);
        by_y = by_y + define(list(), "pull_by_y_" + index, by_y_of_it * strand);
      }
      sums_.push_back({define(list(), "pull", sum), define(list(), "pull_by_y", by_y)});
    }
  }

  /// f/|s| of a tendon.
  const ex& per_length(std::size_t tendon) const { return per_length_[tendon]; }

  /// Σ f ∂|s|/∂q_j.
  ex slope(int j) const {
    return weighted([&](const ex& value) { return lengths_.derivative(j).of(value); });
  }
  /// Σ p · ∂²s/(∂q_i ∂q_j).
  ex curvature(int i, int j) const {
    return weighted([&](const ex& value) {
      return lengths_.derivative(std::max(i, j)).of(lengths_.derivative(std::min(i, j)).of(value));
    });
  }

 private:
  struct Sums {
    Vector3 of_pulls, by_y;
  };

  template <class Derivative>
  ex weighted(const Derivative& derivative) const {
    ex sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      ex by_y = 0;
      for (std::size_t layer = 0; layer < sums_.size(); ++layer) {
        const ex moved = derivative(lengths_.strands.layers()[layer].first[k]);
        sum += sums_[layer].of_pulls[k] * moved;
        by_y += sums_[layer].by_y[k];
      }
      const ex turned = derivative(lengths_.start.pose.y[k]);
      sum -= list().define("pull_by_y", by_y) * turned;
    }
    return sum;
  }
  DefinitionList& list() const { return lengths_.start.list; }

  Lengths& lengths_;
  std::vector<ex> per_length_;
  std::vector<Sums> sums_;
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
  ForwardDerivative rate(lengths.start.list, GiNaC::symbol("t"), "t");
  rate.seed(lengths.start.q71(), dq71.symbols[0]);
  rate.seed(lengths.start.q73(), dq73.symbols[0]);
  std::vector<ex> rates;
  for (const ex& length : lengths.h) rates.push_back(rate.of(length));
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

/// Σ (f/|s|) ∂s/∂q_i · ∂s/∂q_j + (k - f/|s|) P_i P_j, over a layer. The first product is a
/// polynomial in the tendon's y.
ex stiffness_of_layer(Lengths& lengths, const Pulls& pulls, const Strands::Layer& layer,
                      const std::vector<GiNaC::symbol>& k, int i, int j) {
  DefinitionList& list = lengths.start.list;
  const auto by = [&](const Vector3& vector, int variable) {
    Vector3 derivative;
    for (std::size_t c = 0; c < 3; ++c) derivative[c] = lengths.derivative(variable).of(vector[c]);
    return derivative;
  };
  const Vector3 layer_i = by(layer.first, i), layer_j = by(layer.first, j);
  const Vector3 axis_i = by(lengths.start.pose.y, i), axis_j = by(lengths.start.pose.y, j);
  const ex constant = list.define("along", dot(layer_i, layer_j));
  const ex linear = list.define("along_by_y", dot(layer_i, axis_j) + dot(axis_i, layer_j));
  const ex square = list.define("along_by_y_squared", dot(axis_i, axis_j));
  ex sum = 0;
  for (std::size_t t : layer.tendons) {
    // What they need is written down in this order, whatever the compiler's order of operands.
    const ex by_i = lengths.slope(t, i), by_j = lengths.slope(t, j);
    const ex& y = lengths.strands.y(t);
    const ex& per_length = pulls.per_length(t);
    const std::string index = std::to_string(t);
    const ex slope = list.define("slope_" + index, linear - y * square);
    const ex along = list.define("along_" + index, constant - y * slope);
    const ex across = list.define("across_" + index, k[t] - per_length);
    sum += list.define("K_" + index,  // named, so that a tendon's terms stay together
                       per_length * along + across * by_i * by_j);
  }
  return list.define("K_of_layer", sum);
}

}  // namespace

/// ∂²|s| = (∂s · ∂s - ∂|s| ∂|s| + s · ∂²s)/|s|.
Function wrist_joint_stiffness(const WristParameters& parameters) {
  Lengths lengths(parameters);
  const Argument f = forces(parameters), k = stiffnesses(tendon_count(parameters));
  Pulls pulls(lengths, f.symbols);
  const auto entry = [&](int row, int col) -> ex {
    ex sum = pulls.curvature(row, col);
    for (const Strands::Layer& layer : lengths.strands.layers())
      sum += stiffness_of_layer(lengths, pulls, layer, k.symbols, row, col);
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
