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
constexpr Range length_range{0.02, 0.1};        // m

/// The tendons of one layer: their points differ in y only.
struct Layer {
  Vector3 first;         ///< from the palm point of the layer's first tendon to its forearm point
  ex forearm_y, palm_y;  ///< of the first one
  std::vector<std::size_t> tendons = {};
};

/// From the palm point of each tendon to its forearm point: the layer's first strand, a constant
/// along y, and -y times the palm's y axis. So all but the first have one form, and are emitted as
/// a loop.
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
      Layer& layer = layers_[place->second];
      layer.tendons.push_back(i);
      forearm_y_.push_back(F[1] - layer.forearm_y);
      palm_y_.push_back(P[1] - layer.palm_y);
    }
  }

  const std::vector<Layer>& layers() const { return layers_; }
  /// Of the points of a tendon, from those of its layer's first one.
  const ex& forearm_y(std::size_t tendon) const { return forearm_y_[tendon]; }
  const ex& palm_y(std::size_t tendon) const { return palm_y_[tendon]; }

  std::vector<Vector3> all() const {
    std::vector<Vector3> strands(palm_y_.size());
    for (const Layer& layer : layers_)
      for (const std::size_t i : layer.tendons)
        strands[i] =
            define(start_.list, "strand_" + std::to_string(i),
                   layer.first + Vector3{0, forearm_y_[i], 0} - palm_y_[i] * start_.pose.y);
    return strands;
  }

 private:
  void add_layer(const Vector3& forearm, const Vector3& palm) {
    const WristPose& pose = start_.pose;
    const Vector3 first =
        forearm - pose.origin - (palm[0] * pose.x + palm[2] * pose.z) - palm[1] * pose.y;
    layers_.push_back({define(start_.list, "layer_" + std::to_string(layers_.size()), first),
                       forearm[1], palm[1]});
  }

  WristStart& start_;
  std::vector<Layer> layers_;
  std::vector<ex> forearm_y_, palm_y_;
};

int tendon_count(const WristParameters& parameters) {
  return static_cast<int>(parameters.palm_points.size());
}

/// Lengths with their first and second derivatives with respect to q71 and q73. With L the first
/// strand of a layer, a the palm's y axis, F and y of a tendon's points, half the square of its
/// strand is
///   (L_x² + L_z²)/2 - y (L_x a_x + L_z a_z) + y² (a_x² + a_z²)/2 + s_y²/2,  s_y = F + L_y - y a_y:
/// but for s_y a polynomial in y that is the layer's. Only its coefficients are differentiated.
struct Lengths {
  /// Coefficients of a layer, or their derivatives.
  struct Terms {
    std::array<ex, 3> across;  ///< of 1, y, y² in what x and z have of half the square
    ex along, axis;            ///< L_y, a_y
  };

  explicit Lengths(const WristParameters& parameters)
      : start(parameters),
        strands(parameters, start),
        h(parameters.palm_points.size()),
        strand_y(h.size()),
        by_q71(start.list, start.q71(), "q71"),
        by_q73(start.list, start.q73(), "q73") {
    for (const Layer& layer : strands.layers()) {
      add_terms(layer);
      add_lengths(layer);
    }
  }
  /// With lengths and Jacobian known.
  Lengths(const WristParameters& parameters, const Argument& lengths, const Argument& jacobian)
      : start(parameters),
        strands(parameters, start),
        h(lengths.symbols.begin(), lengths.symbols.end()),
        strand_y(h.size()),
        by_q71(start.list, start.q71(), "q71"),
        by_q73(start.list, start.q73(), "q73") {
    for (const Layer& layer : strands.layers()) add_terms(layer);
    for (std::size_t i = 0; i < jacobian.symbols.size(); ++i)
      slopes_[i % 2].push_back(jacobian.symbols[i]);
  }

  /// Column 0 or 1 of the Jacobian.
  const ex& slope(std::size_t tendon, int j) {
    std::vector<ex>& column = slopes_[static_cast<std::size_t>(j)];
    if (column.empty()) column = slopes(derivative(j), j == 0 ? "q71" : "q73");
    return column[tendon];
  }
  /// By what the derivative is taken by, named `suffix`.
  std::vector<ex> slopes(ForwardDerivative& by, const std::string& suffix) {
    std::vector<ex> result(h.size());
    for (std::size_t layer = 0; layer < terms_.size(); ++layer) {
      const Terms terms = derived(terms_[layer], by);
      for (const std::size_t i : strands.layers()[layer].tendons) {
        const ex half_square =
            across(terms, i) + strand_y[i] * list().define("strand_y_by", strand(terms, i));
        result[i] = list().define("length_" + std::to_string(i) + "_by_" + suffix,
                                  list().define("half_square_by", half_square) / h[i]);
      }
    }
    return result;
  }
  /// ∂²h/(∂q_i ∂q_j) = (∂²(h²/2)/(∂q_i ∂q_j) - ∂h/∂q_i ∂h/∂q_j)/h.
  ex curvature(std::size_t layer, std::size_t tendon, int i, int j) {
    const Terms terms = second(layer, i, j);
    const ex by_i = list().define("strand_y_by", strand(first(layer, i), tendon));
    const ex by_j = list().define("strand_y_by", strand(first(layer, j), tendon));
    const ex half_square = across(terms, tendon) + by_i * by_j +
                           strand_y[tendon] * list().define("strand_y_by", strand(terms, tendon));
    return list().define("curvature", half_square - slope(tendon, i) * slope(tendon, j)) /
           h[tendon];
  }
  Terms first(std::size_t layer, int j) { return derived(terms_[layer], derivative(j)); }
  Terms second(std::size_t layer, int i, int j) {
    return derived(first(layer, std::min(i, j)), derivative(std::max(i, j)));
  }
  ForwardDerivative& derivative(int j) { return j == 0 ? by_q71 : by_q73; }
  DefinitionList& list() { return start.list; }

  WristStart start;
  Strands strands;
  std::vector<ex> h, strand_y;
  ForwardDerivative by_q71, by_q73;

 private:
  void add_terms(const Layer& layer) {
    const Vector3 &L = layer.first, &a = start.pose.y;
    terms_.push_back({{list().define("across", (L[0] * L[0] + L[2] * L[2]) / 2),
                       list().define("across_by_y", -(L[0] * a[0] + L[2] * a[2])),
                       list().define("across_by_y_squared", (a[0] * a[0] + a[2] * a[2]) / 2)},
                      L[1],
                      a[1]});
    for (const std::size_t i : layer.tendons)
      strand_y[i] = list().define("strand_y_" + std::to_string(i),
                                  strands.forearm_y(i) + strand(terms_.back(), i));
  }
  void add_lengths(const Layer& layer) {
    Terms twice = terms_.back();
    for (ex& term : twice.across) term = list().define("twice_across", 2 * term);
    for (const std::size_t i : layer.tendons)
      h[i] = list().define("length_" + std::to_string(i),
                           GiNaC::sqrt(across(twice, i) + strand_y[i] * strand_y[i]));
  }

  ex across(const Terms& terms, std::size_t tendon) {
    const ex& y = strands.palm_y(tendon);
    const ex slope = list().define("across_slope", terms.across[1] + y * terms.across[2]);
    return list().define("across", terms.across[0] + y * slope);
  }
  ex strand(const Terms& terms, std::size_t tendon) const {
    return terms.along - strands.palm_y(tendon) * terms.axis;
  }

  static Terms derived(const Terms& terms, ForwardDerivative& by) {
    const auto& [constant, linear, square] = terms.across;
    return {{by.of(constant), by.of(linear), by.of(square)}, by.of(terms.along), by.of(terms.axis)};
  }

  std::vector<Terms> terms_;
  std::array<std::vector<ex>, 2> slopes_;
};

/// Sums over the tendons of each layer, taken before anything is differentiated. With w = f/h and a
/// tendon's strand s = L + F e_y - y a, they are w, w y, w y² and, for each layer and for the
/// palm's y axis, what a change of L or a is multiplied by: Σ w s and -Σ w y s.
class Pulls {
 public:
  Pulls(Lengths& lengths, const std::vector<GiNaC::symbol>& f)
      : lengths_(lengths), per_length_(f.size()) {
    DefinitionList& list = lengths.list();
    for (const Layer& layer : lengths.strands.layers()) {
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
  const Lengths lengths(parameters);
  return lengths.start.finish(
      "tendon_lengths", "(6.9)", "Lengths of the tendons through the wrist.",
      {{"h", tendon_count(parameters), 1, lengths.h, "m", "tendon lengths"}});
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
  std::vector<ex> H(4 * lengths.h.size());
  for (const auto& [row, col] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 1}})
    for (std::size_t layer = 0; layer < lengths.strands.layers().size(); ++layer)
      for (const std::size_t i : lengths.strands.layers()[layer].tendons) {
        const ex value = lengths.curvature(layer, i, row, col);
        H[4 * i + std::size_t(2 * row + col)] = H[4 * i + std::size_t(2 * col + row)] = value;
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
  Lengths lengths(parameters);
  WristStart& start = lengths.start;
  std::vector<ex> change = lengths.h;
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
  const std::vector<ex> rates = lengths.slopes(rate, "t");
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

/// Σ f ∂²h + k ∂h ∂h, of which Pulls has f ∂²h + (f/h) ∂h ∂h.
std::vector<ex> joint_stiffness(Lengths& lengths, const std::vector<GiNaC::symbol>& f,
                                const std::vector<GiNaC::symbol>& k) {
  const Pulls pulls(lengths, f);
  const auto entry = [&](int row, int col) -> ex {
    ex sum = pulls.curvature(row, col);
    for (const Layer& layer : lengths.strands.layers()) {
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
  Lengths lengths(parameters);
  const Argument f = forces(parameters), k = stiffnesses(tendon_count(parameters));
  const std::vector<ex> K = joint_stiffness(lengths, f.symbols, k.symbols);
  Function function = lengths.start.finish(
      "joint_stiffness", "", "Stiffness of the wrist's bars, motors held.",
      {{"K", 2, 2, K, "N m/rad", "sum of f d2h/dq2, plus P^T diag(k) P; symmetric"}});
  function.inputs.insert(function.inputs.end(), {f, k});
  return function;
}

Function wrist_passage_stiffness(const WristParameters& parameters) {
  const int count = tendon_count(parameters);
  const Argument h = array_argument("h", count, 1, "m", length_range, "tendon lengths");
  const Argument P =
      array_argument("P", count, 2, "m/rad", moment_arm_range, "their derivatives by q71 and q73");
  const Argument f = forces(parameters), k = stiffnesses(count);
  Lengths lengths(parameters, h, P);
  const std::vector<ex> K = joint_stiffness(lengths, f.symbols, k.symbols);
  Function function = lengths.start.finish("passage_stiffness", "",
                                           "The same where lengths and Jacobian are known.",
                                           {{"K", 2, 2, K, "N m/rad", "symmetric"}});
  function.inputs.insert(function.inputs.end(), {h, P, f, k});
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
