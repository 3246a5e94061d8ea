// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths of the tendons through the wrist (6.9) with their derivatives, for all that is made of
// them.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/parts/wrist_geometry.h"

namespace sinew::wrist {

/// The tendons of one layer: their points differ in y only.
struct Layer {
  Vector3 first;  ///< from the palm point of the layer's first tendon to its forearm point
  GiNaC::ex forearm_y, palm_y;  ///< of the first one
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
  const GiNaC::ex& forearm_y(std::size_t tendon) const { return forearm_y_[tendon]; }
  const GiNaC::ex& palm_y(std::size_t tendon) const { return palm_y_[tendon]; }

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
  std::vector<GiNaC::ex> forearm_y_, palm_y_;
};

inline int tendon_count(const WristParameters& parameters) {
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
    std::array<GiNaC::ex, 3> across;  ///< of 1, y, y² in what x and z have of half the square
    GiNaC::ex along, axis;     ///< L_y, a_y
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
  const GiNaC::ex& slope(std::size_t tendon, int j) {
    std::vector<GiNaC::ex>& column = slopes_[static_cast<std::size_t>(j)];
    if (column.empty()) column = slopes(derivative(j), j == 0 ? "q71" : "q73");
    return column[tendon];
  }
  /// By what the derivative is taken by, named `suffix`.
  std::vector<GiNaC::ex> slopes(ForwardDerivative& by, const std::string& suffix) {
    std::vector<GiNaC::ex> result(h.size());
    for (std::size_t layer = 0; layer < terms_.size(); ++layer) {
      const Terms terms = derived(terms_[layer], by);
      for (const std::size_t i : strands.layers()[layer].tendons) {
        const GiNaC::ex half_square =
            across(terms, i) + strand_y[i] * list().define("strand_y_by", strand(terms, i));
        result[i] = list().define("length_" + std::to_string(i) + "_by_" + suffix,
                                  list().define("half_square_by", half_square) / h[i]);
      }
    }
    return result;
  }
  /// ∂²h/(∂q_i ∂q_j) = (∂²(h²/2)/(∂q_i ∂q_j) - ∂h/∂q_i ∂h/∂q_j)/h.
  GiNaC::ex curvature(std::size_t layer, std::size_t tendon, int i, int j) {
    const Terms terms = second(layer, i, j);
    const GiNaC::ex by_i = list().define("strand_y_by", strand(first(layer, i), tendon));
    const GiNaC::ex by_j = list().define("strand_y_by", strand(first(layer, j), tendon));
    const GiNaC::ex half_square =
        across(terms, tendon) + by_i * by_j +
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
  std::vector<GiNaC::ex> h, strand_y;
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
    for (GiNaC::ex& term : twice.across) term = list().define("twice_across", 2 * term);
    for (const std::size_t i : layer.tendons)
      h[i] = list().define("length_" + std::to_string(i),
                           GiNaC::sqrt(across(twice, i) + strand_y[i] * strand_y[i]));
  }

  GiNaC::ex across(const Terms& terms, std::size_t tendon) {
    const GiNaC::ex& y = strands.palm_y(tendon);
    const GiNaC::ex slope = list().define("across_slope", terms.across[1] + y * terms.across[2]);
    return list().define("across", terms.across[0] + y * slope);
  }
  GiNaC::ex strand(const Terms& terms, std::size_t tendon) const {
    return terms.along - strands.palm_y(tendon) * terms.axis;
  }

  static Terms derived(const Terms& terms, ForwardDerivative& by) {
    const auto& [constant, linear, square] = terms.across;
    return {{by.of(constant), by.of(linear), by.of(square)}, by.of(terms.along), by.of(terms.axis)};
  }

  std::vector<Terms> terms_;
  std::array<std::vector<GiNaC::ex>, 2> slopes_;
};

}  // namespace sinew::wrist
