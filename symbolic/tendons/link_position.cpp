// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/link_position.h"

#include <array>
#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/piecewise.h"
#include "symbolic/expressions/vector3.h"

namespace sinew {
namespace {

using GiNaC::ex;
using Pair = std::array<ex, 2>;

constexpr Range length_range{0.0, 0.1};   // m
const GiNaC::numeric widest_angle(3, 2);  // rad; nearly a right angle, more than any thumb

/// Tendon lengths and coupling matrix at given angles.
struct Coupling {
  std::vector<ex> h;
  std::vector<Pair> P;
};

std::vector<ex> lengths_at(DefinitionList& list, const ThumbBaseParameters& base, const Pair& q) {
  const ex c10 = list.define("cos_q10", GiNaC::cos(q[0])),
           s10 = list.define("sin_q10", GiNaC::sin(q[0]));
  const ex c11 = list.define("cos_q11", GiNaC::cos(q[1])),
           s11 = list.define("sin_q11", GiNaC::sin(q[1]));
  std::vector<ex> h;
  for (std::size_t i = 0; i < base.base_points.size(); ++i) {
    const Vector3 p = exact_vector(base.distal_points[i]);
    const ex x = p[0] + exact_number(base.length);
    const ex along = list.define("along", exact_number(base.offset) + x * c11 - p[2] * s11);
    const ex up = list.define("up", x * s11 + p[2] * c11);
    const Vector3 point{along * c10 - p[1] * s10, along * s10 + p[1] * c10, up};
    const Vector3 gap = define(list, "gap", point - exact_vector(base.base_points[i]));
    const ex free = base.free_lengths.empty() ? ex(0) : ex(exact_number(base.free_lengths[i]));
    h.push_back(list.define("stretch", GiNaC::sqrt(dot(gap, gap))) + free);
  }
  return h;
}

Coupling coupling_at(DefinitionList& list, const ThumbBaseParameters& base, const Pair& q) {
  Coupling result;
  result.h = lengths_at(list, base, q);
  // The angles are symbols here: inputs or definitions.
  ForwardDerivative by_q10(list, GiNaC::ex_to<GiNaC::symbol>(q[0]), "q10");
  ForwardDerivative by_q11(list, GiNaC::ex_to<GiNaC::symbol>(q[1]), "q11");
  for (const ex& h : result.h)
    result.P.push_back({list.define("P_0", by_q10.of(h)), list.define("P_1", by_q11.of(h))});
  return result;
}

void check(const ThumbBaseParameters& base) {
  const std::size_t count = base.base_points.size();
  if (count < 2 || base.distal_points.size() != count)
    throw std::invalid_argument(
        "the thumb's base needs two tendons or more, with both points each");
  if (!base.free_lengths.empty() && base.free_lengths.size() != count)
    throw std::invalid_argument("the thumb's base needs one free length per tendon, or none");
}

/// PᵀP and its determinant, kept away from zero.
struct Normal {
  ex H00, H01, H11, determinant;
  Normal(DefinitionList& list, const Coupling& c, const LinkPositionSettings& settings) {
    for (const Pair& row : c.P) {
      H00 += row[0] * row[0];
      H01 += row[0] * row[1];
      H11 += row[1] * row[1];
    }
    H00 = list.define("H_00", H00);
    H01 = list.define("H_01", H01);
    H11 = list.define("H_11", H11);
    determinant = list.define("determinant", H00 * H11 - H01 * H01);
    floor = list.define("determinant_floor",
                        exact_number(settings.smallest_determinant) * (H00 * H11) + least);
  }
  ex floor;
  const GiNaC::numeric least =
      GiNaC::numeric(10).power(-24);  // m⁴/rad⁴: a hundredth of a μm per rad
};

/// What the search knows about a point.
struct EvaluatedPair {
  Pair q, gradient;
  ex cost;  ///< half the sum of squares [m²]
  ex H00, H01, H11;
};

class Search {
 public:
  Search(const ThumbBaseParameters& base, const LinkPositionSettings& settings)
      : base_(base), settings_(settings) {
    check(base);
    const int count = static_cast<int>(base.base_points.size());
    h = array_argument("h", count, 1, "m", length_range, "base tendon lengths");
    // Away from where the search starts, so that it has something to find.
    const double angle = 0.25 * base.angle.low + 0.75 * base.angle.high;
    h.reference = rounded_values(base_tendon_lengths(base), {angle, angle});
  }

  EvaluatedPair at(const Pair& q) {
    const Coupling c = coupling_at(list, base_, q);
    const Normal normal(list, c, settings_);
    EvaluatedPair point{q, {}, 0, normal.H00, normal.H01, normal.H11};
    for (std::size_t i = 0; i < c.h.size(); ++i) {
      const ex error = list.define("error", c.h[i] - h.symbols[i]);
      point.cost += error * error / 2;
      for (std::size_t j = 0; j < 2; ++j) point.gradient[j] += error * c.P[i][j];
    }
    point.cost = list.define("cost", point.cost);
    for (std::size_t j = 0; j < 2; ++j)
      point.gradient[j] = list.define("gradient_" + std::to_string(j), point.gradient[j]);
    return point;
  }

  /// Step of (PᵀP + λ diag) δ = -gradient, limited.
  Pair step(const EvaluatedPair& p, const ex& lambda) {
    const ex a = list.define("a", p.H00 * (1 + lambda)), d = list.define("d", p.H11 * (1 + lambda));
    const ex floor =
        exact_number(settings_.smallest_determinant) * (a * d) + GiNaC::numeric(10).power(-24);
    const ex safe = list.define("safe", maximum(a * d - p.H01 * p.H01, floor));
    return {limited((p.H01 * p.gradient[1] - d * p.gradient[0]) / safe),
            limited((p.H01 * p.gradient[0] - a * p.gradient[1]) / safe)};
  }

  Pair moved(const Pair& q, const Pair& by) {
    return {list.define("q10", q[0] + by[0]), list.define("q11", q[1] + by[1])};
  }

  /// Angles given from outside, limited so that no start, however wrong, is carried on.
  Pair entered(const ex& q10, const ex& q11) {
    return {list.define("start_q10", clamped(q10, -widest_angle, widest_angle)),
            list.define("start_q11", clamped(q11, -widest_angle, widest_angle))};
  }

  ex limited(const ex& step) {
    const ex limit = exact_number(settings_.largest_step);
    return list.define("step", clamped(step, -limit, limit));
  }

  /// `a` where condition >= 0, else `b`, item by item.
  ex pick(const ex& condition, const ex& a, const ex& b) {
    return list.define("kept", choose(condition, a, b));
  }
  Pair pick(const ex& condition, const Pair& a, const Pair& b) {
    return {pick(condition, a[0], b[0]), pick(condition, a[1], b[1])};
  }
  EvaluatedPair pick(const ex& condition, const EvaluatedPair& a, const EvaluatedPair& b) {
    return {pick(condition, a.q, b.q),       pick(condition, a.gradient, b.gradient),
            pick(condition, a.cost, b.cost), pick(condition, a.H00, b.H00),
            pick(condition, a.H01, b.H01),   pick(condition, a.H11, b.H11)};
  }

  Function finish(const std::string& name, const std::string& doc, const Argument& start,
                  const EvaluatedPair& found) {
    const Pair left = step(found, 0);
    const ex correction =
        list.define("correction", GiNaC::sqrt(left[0] * left[0] + left[1] * left[1]));
    const ex status = choose(exact_number(settings_.tolerance) - correction, 0, 1);
    return {
        name,
        doc,
        "(5.24)",
        {h, start},
        list.items(),
        {{"q", 2, 1, {found.q[0], found.q[1]}, "rad", "q10, q11"},
         {"correction", 1, 1, {correction}, "rad", "next Gauss-Newton step"},
         {"status", 1, 1, {status}, "1", "0 converged, 1 not", {"converged", "not_converged"}}}};
  }

  Argument start() const {
    Argument start = array_argument("q_start", 2, 1, "rad", base_.angle,
                                    "where the search starts, e.g. the last result");
    start.reference = std::vector<double>(2, (base_.angle.low + base_.angle.high) / 2);
    return start;
  }

  Argument h;
  DefinitionList list;

 private:
  const ThumbBaseParameters& base_;
  const LinkPositionSettings& settings_;
};

/// One iteration of Algorithm 1 on what it carries along.
struct Descent {
  Pair q, gradient;
  ex step, cost;
};

Descent descend(Search& search, const Descent& now) {
  const Pair by{search.limited(-now.step * now.gradient[0]),
                search.limited(-now.step * now.gradient[1])};
  const EvaluatedPair trial = search.at(search.moved(now.q, by));
  // An equal cost counts as progress, so that one that is not a number does not.
  const ex better = search.list.define("better", now.cost - trial.cost);
  return {search.pick(better, trial.q, now.q), search.pick(better, trial.gradient, now.gradient),
          search.pick(better, now.step, now.step / 2), search.pick(better, trial.cost, now.cost)};
}

}  // namespace

Function link_position(const ThumbBaseParameters& base, const LinkPositionSettings& settings) {
  Search search(base, settings);
  const Argument start = search.start();
  EvaluatedPair best = search.at(search.entered(start.symbols[0], start.symbols[1]));
  ex lambda = exact_number(settings.damping);
  for (int i = 0; i < settings.iterations; ++i) {
    const EvaluatedPair trial = search.at(search.moved(best.q, search.step(best, lambda)));
    const ex better = search.list.define("better", best.cost - trial.cost);
    best = search.pick(better, trial, best);
    if (i + 1 < settings.iterations) lambda = search.pick(better, lambda / 10, lambda * 10);
  }
  return search.finish("link_position", "Angles of the thumb's base by Levenberg-Marquardt.", start,
                       best);
}

Function link_position_gradient(const ThumbBaseParameters& base,
                                const LinkPositionSettings& settings) {
  Search search(base, settings);
  const Argument start = search.start();
  const EvaluatedPair first = search.at(search.entered(start.symbols[0], start.symbols[1]));
  Descent now{first.q, first.gradient, exact_number(settings.gradient_step), first.cost};
  for (int i = 0; i < settings.gradient_iterations; ++i) now = descend(search, now);
  return search.finish(
      "link_position_gradient",
      "Angles of the thumb's base by the corrected gradient search of Algorithm 1.", start,
      search.at(now.q));
}

Function link_position_gradient_step(const ThumbBaseParameters& base,
                                     const LinkPositionSettings& settings) {
  Search search(base, settings);
  Argument state = array_argument("search", 6, 1, "rad, m^2/rad, rad/m^2, m^2", base.angle,
                                  "q10, q11, gradient (2), step, smallest cost");
  state.ranges = {base.angle, base.angle, {-1e-3, 1e-3}, {-1e-3, 1e-3}, {0, settings.gradient_step},
                  {0, 1e-3}};
  const auto& s = state.symbols;
  const Descent next = descend(search, {search.entered(s[0], s[1]), {s[2], s[3]}, s[4], s[5]});
  return {"link_position_gradient_step",
          "One iteration of the corrected gradient search.",
          "(5.24)",
          {search.h, state},
          search.list.items(),
          {{"next",
            6,
            1,
            {next.q[0], next.q[1], next.gradient[0], next.gradient[1], next.step, next.cost},
            "rad, m^2/rad, rad/m^2, m^2",
            "the state after it"}}};
}

Function link_position_status(const ThumbBaseParameters& base,
                              const LinkPositionSettings& settings) {
  Search search(base, settings);
  Argument q = array_argument("q", 2, 1, "rad", base.angle, "q10, q11, an estimate");
  const EvaluatedPair point = search.at(search.entered(q.symbols[0], q.symbols[1]));
  const Pair left = search.step(point, 0);
  const ex correction =
      search.list.define("correction", GiNaC::sqrt(left[0] * left[0] + left[1] * left[1]));
  return {
      "link_position_status",
      "Whether a search has arrived, whichever it was: the Gauss-Newton step left at its result.",
      "(5.24)",
      {search.h, q},
      search.list.items(),
      {{"correction", 1, 1, {correction}, "rad", "next Gauss-Newton step"},
       {"status",
        1,
        1,
        {choose(exact_number(settings.tolerance) - correction, 0, 1)},
        "1",
        "0 converged, 1 not",
        {"converged", "not_converged"}}}};
}

Function link_position_covariance(const ThumbBaseParameters& base,
                                  const LinkPositionSettings& settings) {
  check(base);
  const Argument q = array_argument("q", 2, 1, "rad", base.angle, "q10, q11");
  const Argument sigma =
      scalar_argument("sigma", "m", {0.0, 0.002}, "standard deviation of a length");
  DefinitionList list;
  const Normal normal(list, coupling_at(list, base, {q.symbols[0], q.symbols[1]}), settings);
  const ex deviation = list.define("deviation", clamped(sigma.symbols[0], 0, 1));
  const ex scale =
      list.define("scale", deviation * deviation / maximum(normal.determinant, normal.floor));
  const ex mixed = list.define("mixed", -normal.H01 * scale);
  return {"link_position_covariance",
          "Covariance of the thumb's base angles for noise on the lengths.",
          "(5.24)",
          {q, sigma},
          list.items(),
          {{"covariance",
            2,
            2,
            {normal.H11 * scale, mixed, mixed, normal.H00 * scale},
            "rad^2",
            "sigma^2 (P^T P)^-1"},
           {"status",
            1,
            1,
            {choose(normal.determinant - normal.floor, 0, 1)},
            "1",
            "0 fine, 1 where the lengths do not determine the angles",
            {"fine", "not_determined"}}}};
}

Function base_tendon_lengths(const ThumbBaseParameters& base) {
  check(base);
  const Argument q = array_argument("q", 2, 1, "rad", base.angle, "q10, q11");
  DefinitionList list;
  const std::vector<ex> h = lengths_at(list, base, {q.symbols[0], q.symbols[1]});
  return {"base_tendon_lengths",
          "Lengths of the base tendons.",
          "(5.20)",
          {q},
          list.items(),
          {{"h", static_cast<int>(h.size()), 1, h, "m", ""}}};
}

std::vector<Function> link_position_functions(const ThumbBaseParameters& base,
                                              const LinkPositionSettings& settings) {
  return {link_position(base, settings),
          link_position_gradient(base, settings),
          link_position_gradient_step(base, settings),
          link_position_status(base, settings),
          link_position_covariance(base, settings),
          base_tendon_lengths(base)};
}

}  // namespace sinew
