// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/nonlinear_position.h"

#include <Eigen/LU>
#include <string>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/expressions/piecewise.h"
#include "symbolic/tendons/tendons.h"

namespace sinew {
namespace {

using GiNaC::ex;
using Vector = std::vector<ex>;

/// lengths(q -> h, P): what every iteration evaluates.
Function lengths_and_coupling(const Mechanism& mechanism) {
  const Argument q = joint_positions(mechanism);
  DefinitionList list;
  const Vector h = tendon_lengths(list, mechanism, build_joint_tree(mechanism), q.symbols),
               P = coupling_matrix(list, h, q.symbols);
  const int m = static_cast<int>(mechanism.tendons.size());
  return {"lengths", "",           "",
          {q},       list.items(), {{"h", m, 1, h, "m", ""}, {"P", m, q.rows, P, "", ""}}};
}

bool determined(const Function& lengths) {
  const std::vector<double> values = rounded_values(lengths, lengths.inputs[0].reference);
  const Eigen::Index m = lengths.outputs[1].rows, n = lengths.outputs[1].cols;
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> P(
      values.data() + m, m, n);
  Eigen::FullPivLU<Eigen::MatrixXd> lu(P.transpose() * P);
  lu.setThreshold(1e-9);
  return lu.rank() == n;
}

/// L D Lᵀ of a symmetric matrix, pivots kept away from zero.
struct Factors {
  std::vector<Vector> L;
  Vector D;
  ex least;  ///< smallest of (pivot - its floor); negative where a pivot was raised

  Factors(DefinitionList& list, const std::vector<Vector>& H, double smallest) {
    const std::size_t n = H.size();
    L.assign(n, Vector(n, 0));
    // A tenth of a μm per rad counts as no moment arm at all.
    const ex tiny = GiNaC::numeric(10).power(-14);
    for (std::size_t j = 0; j < n; ++j) {
      ex pivot = H[j][j];
      for (std::size_t k = 0; k < j; ++k) pivot -= L[j][k] * L[j][k] * D[k];
      pivot = list.define("pivot", pivot);
      const ex floor = list.define("pivot_floor", exact_number(smallest) * H[j][j] + tiny);
      const ex above = list.define("above", pivot - floor);
      least = j == 0 ? above : list.define("least", minimum(least, above));
      D.push_back(list.define("D", maximum(pivot, floor)));
      for (std::size_t i = j + 1; i < n; ++i) {
        ex entry = H[i][j];
        for (std::size_t k = 0; k < j; ++k) entry -= L[i][k] * L[j][k] * D[k];
        L[i][j] = list.define("L", entry / D[j]);
      }
    }
  }

  Vector solve(DefinitionList& list, Vector b) const {
    const std::size_t n = D.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k) b[i] -= L[i][k] * b[k];
      b[i] = list.define("forward", b[i]);
    }
    for (std::size_t i = n; i-- > 0;) {
      b[i] = b[i] / D[i];
      for (std::size_t k = i + 1; k < n; ++k) b[i] -= L[k][i] * b[k];
      b[i] = list.define("solution", b[i]);
    }
    return b;
  }
};

std::vector<Vector> normal_matrix(DefinitionList& list, const Vector& P, std::size_t n) {
  std::vector<Vector> H(n, Vector(n, 0));
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c <= r; ++c) {
      ex sum = 0;
      for (std::size_t i = 0; i < P.size() / n; ++i) sum += P[i * n + r] * P[i * n + c];
      H[r][c] = H[c][r] = list.define("H", sum);
    }
  return H;
}

/// What the search knows of a point.
struct Evaluated {
  Vector q, gradient;
  ex cost;  ///< half the sum of squares [m²]
  std::vector<Vector> H;
};

class PositionSearch {
 public:
  PositionSearch(const Function& lengths, const NonlinearPositionSettings& settings)
      : lengths_(lengths), settings_(settings), q_(lengths.inputs[0]) {
    h_ = make_argument("h", lengths.outputs[0].rows, 1, "m", "tendon path lengths", {0.0, 0.1});
    const std::vector<double> at = rounded_values(lengths, moved_reference());
    h_.reference.assign(at.begin(), at.begin() + h_.rows);
    for (std::size_t i = 0; i < h_.ranges.size(); ++i)
      h_.ranges[i] = {h_.reference[i] - 0.01, h_.reference[i] + 0.01};
  }

  Function function(const std::string& name, const std::string& doc, int iterations) {
    Argument start = make_argument("q_start", q_.rows, 1, q_.unit,
                                   "where the search starts, e.g. the last result", {0, 0});
    start.ranges = q_.ranges;
    start.reference = q_.reference;
    Evaluated best = at(entered(start));
    ex lambda = exact_number(settings_.damping);
    for (int i = 0; i < iterations; ++i) {
      const Evaluated trial = at(moved(best, lambda));
      const ex better = list_.define("better", best.cost - trial.cost);
      best = pick(better, trial, best);
      if (i + 1 < iterations)
        lambda = list_.define("lambda", choose(better, lambda / 10, lambda * 10));
    }
    return finish(name, doc, start, best);
  }

 private:
  /// Away from where the search starts, so that it has something to find.
  std::vector<double> moved_reference() const {
    std::vector<double> q = q_.reference;
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] += 0.125 * (q_.ranges[i].high - q_.ranges[i].low);
    return q;
  }

  double span(std::size_t i) const { return q_.ranges[i].high - q_.ranges[i].low; }

  /// No start, however wrong, is carried on.
  Vector entered(const Argument& start) {
    Vector q;
    for (std::size_t i = 0; i < start.symbols.size(); ++i)
      q.push_back(list_.define(
          "start", clamped(start.symbols[i], exact_number(q_.ranges[i].low - span(i) / 2),
                           exact_number(q_.ranges[i].high + span(i) / 2))));
    return q;
  }

  Evaluated at(const Vector& q) {
    const auto values = inlined(list_, lengths_, q);
    const std::size_t n = q.size();
    Evaluated point{q, Vector(n, 0), 0, normal_matrix(list_, values[1], n)};
    for (std::size_t i = 0; i < values[0].size(); ++i) {
      const ex error = list_.define("error", values[0][i] - h_.symbols[i]);
      point.cost += error * error / 2;
      for (std::size_t j = 0; j < n; ++j) point.gradient[j] += error * values[1][i * n + j];
    }
    point.cost = list_.define("cost", point.cost);
    for (ex& entry : point.gradient) entry = list_.define("gradient", entry);
    return point;
  }

  Vector step(const Evaluated& p, const ex& lambda, ex* least = nullptr) {
    std::vector<Vector> H = p.H;
    for (std::size_t i = 0; i < H.size(); ++i)
      H[i][i] = list_.define("damped", H[i][i] * (1 + lambda));
    const Factors factors(list_, H, settings_.smallest_pivot);
    if (least) *least = factors.least;
    Vector b;
    for (const ex& entry : p.gradient) b.push_back(-entry);
    b = factors.solve(list_, b);
    for (std::size_t i = 0; i < b.size(); ++i) {
      const ex limit = exact_number(settings_.largest_step * span(i));
      b[i] = list_.define("step", clamped(b[i], -limit, limit));
    }
    return b;
  }

  Vector moved(const Evaluated& p, const ex& lambda) {
    Vector q = step(p, lambda);
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = list_.define("q_try", p.q[i] + q[i]);
    return q;
  }

  ex pick(const ex& condition, const ex& a, const ex& b) {
    return list_.define("kept", choose(condition, a, b));
  }
  Vector pick(const ex& condition, const Vector& a, const Vector& b) {
    Vector result;
    for (std::size_t i = 0; i < a.size(); ++i) result.push_back(pick(condition, a[i], b[i]));
    return result;
  }
  Evaluated pick(const ex& condition, const Evaluated& a, const Evaluated& b) {
    Evaluated point{pick(condition, a.q, b.q), pick(condition, a.gradient, b.gradient),
                    pick(condition, a.cost, b.cost), a.H};
    for (std::size_t r = 0; r < a.H.size(); ++r)
      for (std::size_t c = 0; c <= r; ++c)
        point.H[r][c] = point.H[c][r] = pick(condition, a.H[r][c], b.H[r][c]);
    return point;
  }

  Function finish(const std::string& name, const std::string& doc, const Argument& start,
                  const Evaluated& found) {
    ex least;
    ex sum = 0;
    for (const ex& left : step(found, 0, &least)) sum += left * left;
    const ex correction = list_.define("correction", GiNaC::sqrt(list_.define("square", sum)));
    const ex worst = minimum(exact_number(settings_.tolerance) - correction, least);
    return {name,
            doc,
            "(5.24)",
            {h_, start},
            list_.items(),
            {{"q", q_.rows, 1, found.q, q_.unit, "joint positions"},
             {"correction", 1, 1, {correction}, q_.unit, "next Gauss-Newton step"},
             {"status",
              1,
              1,
              {choose(worst, 0, 1)},
              "1",
              "0 converged, 1 not",
              {"converged", "not_converged"}}}};
  }

  const Function& lengths_;
  const NonlinearPositionSettings& settings_;
  Argument q_, h_;
  DefinitionList list_;
};

Function covariance(const Function& lengths, const NonlinearPositionSettings& settings) {
  const Argument& q = lengths.inputs[0];
  const auto n = static_cast<std::size_t>(q.rows);
  const Argument sigma =
      scalar_argument("sigma", "m", {0.0, 0.002}, "standard deviation of a length");
  DefinitionList list;
  const auto values = inlined(list, lengths, {q.symbols.begin(), q.symbols.end()});
  const Factors factors(list, normal_matrix(list, values[1], n), settings.smallest_pivot);
  const ex variance = list.define("variance", sigma.symbols[0] * sigma.symbols[0]);
  Vector result(n * n);
  for (std::size_t c = 0; c < n; ++c) {
    Vector unit(n, 0);
    unit[c] = variance;
    const Vector column = factors.solve(list, unit);
    for (std::size_t r = c; r < n; ++r) result[r * n + c] = result[c * n + r] = column[r];
  }
  return {"link_position_covariance",
          "Covariance of link_position for independent errors of the lengths: sigma^2 (P^T P)^-1.",
          "(5.24)",
          {q, sigma},
          list.items(),
          {{"covariance", q.rows, q.rows, result, q.unit + "^2", "symmetric"},
           {"status",
            1,
            1,
            {choose(factors.least, 0, 1)},
            "1",
            "0 fine, 1 where the lengths do not determine the positions",
            {"fine", "not_determined"}}}};
}

}  // namespace

std::vector<Function> nonlinear_position_functions(const Mechanism& mechanism,
                                                   const NonlinearPositionSettings& settings) {
  if (Coordinates(mechanism).count() > settings.most_coordinates) return {};
  const Function lengths = lengths_and_coupling(mechanism);
  if (!determined(lengths)) return {};
  return {
      PositionSearch(lengths, settings)
          .function("link_position", "Joint positions from tendon lengths by Levenberg-Marquardt.",
                    settings.iterations),
      PositionSearch(lengths, settings)
          .function("link_position_warm",
                    "Joint positions by one Levenberg-Marquardt iteration, from a start a tick "
                    "away.",
                    1),
      covariance(lengths, settings)};
}

}  // namespace sinew
