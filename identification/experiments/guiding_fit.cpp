// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/guiding_fit.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace sinew {
namespace {

constexpr double too_vague = 0.5;  // relative standard error of a parameter that says something
using std::numbers::pi;

/// T share (1 - e^(-C1 alpha)) - F over p = (log C1, share), or the capstan law over (log mu).
struct Distance {
  GuidingMeasurement point;
  template <typename T>
  bool operator()(const T* p, T* residual) const {
    residual[0] =
        point.tension * p[1] * (T(1.0) - exp(-exp(p[0]) * point.bending)) - point.friction;
    return true;
  }
};
struct CapstanDistance {
  GuidingMeasurement point;
  template <typename T>
  bool operator()(const T* p, T* residual) const {
    residual[0] = point.tension * (T(1.0) - exp(-exp(p[0]) * point.bending)) - point.friction;
    return true;
  }
};

struct Fit {
  bool converged = false;
  double squares = 0.0;
  std::vector<double> p, error;  ///< error: standard errors
};

template <typename Residual, int parameters>
Fit fit(const std::vector<GuidingMeasurement>& points, std::vector<double> p) {
  using Cost = ceres::AutoDiffCostFunction<Residual, 1, parameters>;
  ceres::Problem problem;
  for (const GuidingMeasurement& point : points)
    problem.AddResidualBlock(new Cost(new Residual{point}), nullptr, p.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 300;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  const auto rows = static_cast<Eigen::Index>(points.size());
  Eigen::Matrix<double, Eigen::Dynamic, parameters> J(rows, parameters);
  Fit result{summary.IsSolutionUsable(), 0.0, p,
             std::vector<double>(parameters, std::numeric_limits<double>::infinity())};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Cost cost(new Residual{points[static_cast<std::size_t>(i)]});
    double residual = 0.0, row[parameters];
    const double* blocks[] = {p.data()};
    double* jacobians[] = {row};
    cost.Evaluate(blocks, &residual, jacobians);
    J.row(i) = Eigen::Map<Eigen::Matrix<double, 1, parameters>>(row);
    result.squares += residual * residual;
  }
  const Eigen::Matrix<double, parameters, parameters> normal = J.transpose() * J;
  const auto inverse =
      normal.ldlt().solve(Eigen::Matrix<double, parameters, parameters>::Identity()).eval();
  const double variance = result.squares / std::max(1.0, static_cast<double>(rows - parameters));
  for (int k = 0; k < parameters; ++k)
    if (inverse(k, k) > 0.0 && std::isfinite(inverse(k, k)))
      result.error[static_cast<std::size_t>(k)] = std::sqrt(variance * inverse(k, k));
  return result;
}

/// A parameter fitted by its logarithm.
Estimate of_logarithm(double logarithm, double error, long freedom) {
  const Estimate e = estimate(logarithm, error, freedom);
  const double value = std::exp(logarithm);
  return {value, value * error, std::exp(e.low), std::exp(e.high)};
}

double start_of_mu(const std::vector<GuidingMeasurement>& points) {
  double bent = 0.0, lost = 0.0;
  for (const GuidingMeasurement& p : points) {
    bent += p.tension * p.bending;
    lost += p.friction;
  }
  return std::clamp(bent > 0.0 ? lost / bent : 0.1, 1e-4, 2.0);
}

void judge(GuidingFit& g, const GuidingSeries& series, const Fit& both, const Fit& one) {
  const auto n = static_cast<double>(series.points.size());
  g.capstan_identified = one.converged && g.mu.standard_error < too_vague * g.mu.value;
  g.fitted_identified = both.converged && g.C1.standard_error < too_vague * g.C1.value &&
                        g.share.standard_error < too_vague * std::abs(g.share.value);
  if (!g.capstan_identified)
    g.missing.push_back(
        "the friction is lost in the scatter; expected larger bending angles or more measurements");
  if (!g.fitted_identified)
    g.missing.push_back(fmt::format(
        "C0 and C1 are not apart: up to {:.3g} rad the friction grows like a straight line, which "
        "only C0 C1 = {:.3g} N/rad follows from; expected bending angles of {:.3g} rad and more",
        g.largest_bending, g.mean_tension * g.share.value * g.C1.value,
        std::max(2.0 * g.largest_bending, pi)));
  const double excess = one.squares - both.squares, floor = both.squares / (n - 2.0);
  if (floor > 0.0 && excess > 0.0)
    g.capstan_contradicted =
        excess / floor > boost::math::quantile(boost::math::fisher_f(1.0, n - 2.0), 0.95);
}

}  // namespace

Estimate GuidingFit::C0(double tension) const {
  return {share.value * tension, share.standard_error * tension, share.low * tension,
          share.high * tension};
}

double GuidingFit::fitted(double tension, double bending) const {
  return share.value * tension * (1.0 - std::exp(-C1.value * bending));
}

double GuidingFit::capstan(double tension, double bending) const {
  return tension * (1.0 - std::exp(-mu.value * bending));
}

GuidingFit fit_guiding(const GuidingSeries& series) {
  GuidingFit g;
  const auto n = static_cast<long>(series.points.size());
  std::vector<double> angles;
  for (const GuidingMeasurement& p : series.points) {
    g.mean_tension += p.tension / static_cast<double>(n);
    g.largest_bending = std::max(g.largest_bending, p.bending);
    if (p.bending > 0.0) angles.push_back(p.bending);
  }
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  if (n < 4 || angles.size() < 3) {
    g.missing.push_back(
        fmt::format("{} measurements at {} bending angles; expected four at three angles or more",
                    n, angles.size()));
    return g;
  }
  const double mu = start_of_mu(series.points);
  const Fit one = fit<CapstanDistance, 1>(series.points, {std::log(mu)});
  const Fit both = fit<Distance, 2>(series.points, {one.p[0], 1.0});
  g.mu = of_logarithm(one.p[0], one.error[0], n - 1);
  g.C1 = of_logarithm(both.p[0], both.error[0], n - 2);
  g.share = estimate(both.p[1], both.error[1], n - 2);
  g.fitted_residual = std::sqrt(both.squares / static_cast<double>(n));
  g.capstan_residual = std::sqrt(one.squares / static_cast<double>(n));
  judge(g, series, both, one);
  return g;
}

}  // namespace sinew
