// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/friction_curve.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sinew {
namespace {

using std::numbers::pi;
constexpr long most_blocks = 512;
constexpr int parameters = 5;  // log gamma1, gamma2, gamma3, output ripple (sine, cosine)

/// (model - mean) / deviation of one point.
struct PointResidual {
  FrictionPoint point;
  template <typename T>
  bool operator()(const T* p, T* residual) const {
    using ceres::atan;
    using ceres::exp;
    using std::atan;
    using std::exp;
    const T gamma1 = exp(p[0]);
    T friction(0.0);
    for (std::size_t b = 0; b < point.velocities.size(); ++b)
      friction += point.shares[b] *
                  (p[1] * atan(gamma1 * point.velocities[b]) + p[2] * point.velocities[b]);
    residual[0] =
        (friction + p[3] * point.sine + p[4] * point.cosine - point.torque) / point.deviation;
    return true;
  }
};

/// Means over the travel, block by block: over time a slower phase of the motor's turn would weigh
/// more, and its ripple would not average out.
void take_means(const DriveStretch& s, long first, long count, FrictionPoint& point) {
  const long blocks = std::min({count / 2, 16 * point.periods, most_blocks});
  double travel = 0.0, squares = 0.0;
  for (long b = 0; b < blocks; ++b) {
    const long from = first + b * count / blocks, to = first + (b + 1) * count / blocks;
    const double moved = s.theta(to) - s.theta(from), n = static_cast<double>(to - from);
    // The samples at both ends belong half to the neighbours.
    const auto mean = [&](const Eigen::ArrayXd& x) {
      return (x.segment(from, to - from).sum() + 0.5 * (x(to) - x(from))) / n;
    };
    point.velocities.push_back(moved / (n * s.period));
    point.shares.push_back(moved);
    point.torque += moved * mean(s.torque);
    point.sine += moved * std::sin(0.5 * (s.theta(to) + s.theta(from)));
    point.cosine += moved * std::cos(0.5 * (s.theta(to) + s.theta(from)));
    travel += moved;
    squares += moved * moved / n;
  }
  for (double* sum : {&point.torque, &point.sine, &point.cosine}) *sum /= travel;
  for (double& share : point.shares) share /= travel;
  // White noise: the ripple of whole periods is gone from the mean, and must not widen it.
  point.noise = white_noise_rms(s.torque.segment(first, count));
  point.deviation = std::sqrt(squares) / std::abs(travel);  // of unit noise, until it is known
}

/// Cuts a plateau to whole motor periods and takes its means; false where it is shorter than one.
bool take_point(const DriveStretch& s, const Plateau& plateau, double turn, FrictionPoint& point) {
  const double start = s.theta(plateau.first);
  point.periods = static_cast<long>(std::floor(std::abs(s.theta(plateau.last - 1) - start) / turn));
  if (point.periods < 1) return false;
  const double goal = static_cast<double>(point.periods) * turn;
  long end = plateau.last - 1;
  while (end > plateau.first + 1 && std::abs(s.theta(end - 1) - start) >= goal) --end;
  if (goal - std::abs(s.theta(end - 1) - start) < std::abs(s.theta(end) - start) - goal) --end;
  const long count = end - plateau.first;
  point.velocity = (s.theta(end) - start) / (static_cast<double>(count) * s.period);
  const auto torque = s.torque.segment(plateau.first, count);
  point.low = torque.minCoeff();
  point.high = torque.maxCoeff();
  take_means(s, plateau.first, count, point);
  return true;
}

/// Noise is one sensor's, and each point's estimate of it scatters: weights that scatter along make
/// intervals too narrow. So all points share the median, but those whose noise is another one.
void weigh(std::vector<FrictionPoint>& points) {
  if (points.empty()) return;
  std::vector<double> noises;
  double largest = 0.0;
  for (const FrictionPoint& point : points) {
    noises.push_back(point.noise);
    largest = std::max(largest, std::abs(point.torque));
  }
  const auto middle = noises.begin() + static_cast<std::ptrdiff_t>(noises.size() / 2);
  std::nth_element(noises.begin(), middle, noises.end());
  for (FrictionPoint& point : points) {
    const bool same = point.noise < 1.5 * *middle && *middle < 1.5 * point.noise;
    // A log without noise still has rounding.
    point.deviation =
        std::max(point.deviation * (same ? *middle : point.noise), 1e-9 * largest + 1e-15);
  }
}

std::vector<FrictionPoint> points_of(const std::vector<DriveStretch>& stretches,
                                     double gear_ratio) {
  std::vector<FrictionPoint> points;
  for (const Plateau& plateau : plateaus(stretches)) {
    FrictionPoint point;
    if (take_point(stretches[plateau.stretch], plateau, 2.0 * pi * gear_ratio, point))
      points.push_back(point);
  }
  weigh(points);
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.velocity < b.velocity; });
  return points;
}

void require_velocities(FrictionCurve& curve) {
  const auto count = std::count_if(curve.points.begin(), curve.points.end(),
                                   [](const auto& point) { return point.periods >= 1; });
  if (count <= parameters)
    curve.missing.push_back(
        fmt::format("only {} constant velocities over a whole motor turn; expected at least {}, in "
                    "both directions and spread evenly by their logarithm",
                    count, parameters + 1));
}

/// Smallest of 1 - (distance to the interval's lower end)/friction over the velocities, and of the
/// same for the slopes at standstill. `covariance`: of log gamma1, gamma2, gamma3; `t`: half an
/// interval in standard errors.
double passive_share(const FrictionCurve& curve, const Eigen::Matrix3d& covariance, double t) {
  const double gamma1 = curve.gamma1.value, gamma2 = curve.gamma2.value;
  const auto share = [&](double value, const Eigen::Vector3d& slope) {
    return 1.0 - t * std::sqrt(std::max(0.0, slope.dot(covariance * slope))) / std::abs(value);
  };
  // Towards standstill friction is its slope gamma1 gamma2 + gamma3 times the velocity.
  double least = share(gamma1 * gamma2 + curve.gamma3.value, {gamma1 * gamma2, gamma1, 1.0});
  for (const FrictionPoint& point : curve.points) {
    const double w = point.velocity, x = gamma1 * w;
    least = std::min(least, share(friction_torque(gamma1, gamma2, curve.gamma3.value, w),
                                  {gamma2 * x / (1.0 + x * x), std::atan(x), w}));
  }
  return std::max(0.0, least);
}

using PointCost = ceres::AutoDiffCostFunction<PointResidual, 1, parameters>;

/// Minimises the weighted errors of all points from a coarse guess in p on; whether it converged.
bool minimise(const std::vector<FrictionPoint>& points, double* p) {
  double largest = 0.0, fastest = 0.0;
  for (const FrictionPoint& point : points) {
    largest = std::max(largest, std::abs(point.torque));
    fastest = std::max(fastest, std::abs(point.velocity));
  }
  const double guess[parameters] = {std::log(10.0 / fastest), 0.6 * largest,
                                    0.1 * largest / fastest, 0, 0};
  std::copy(std::begin(guess), std::end(guess), p);
  ceres::Problem problem;
  for (const FrictionPoint& point : points)
    problem.AddResidualBlock(new PointCost(new PointResidual{point}), nullptr, p);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.IsSolutionUsable() && summary.termination_type == ceres::CONVERGENCE;
}

/// Errors at the minimum: (JᵀJ)⁻¹, the sum of weighted squares and that of plain ones.
struct FitErrors {
  Eigen::MatrixXd inverse;
  double squares = 0.0, plain = 0.0;
};

FitErrors errors_at(const std::vector<FrictionPoint>& points, const double* p) {
  FitErrors errors;
  Eigen::MatrixXd J(static_cast<Eigen::Index>(points.size()), parameters);
  for (Eigen::Index i = 0; i < J.rows(); ++i) {
    const FrictionPoint& point = points[static_cast<std::size_t>(i)];
    const PointCost cost(new PointResidual{point});
    double residual = 0.0, row[parameters];
    const double* blocks[] = {p};
    double* jacobians[] = {row};
    cost.Evaluate(blocks, &residual, jacobians);
    J.row(i) = Eigen::Map<Eigen::RowVectorXd>(row, parameters);
    errors.squares += residual * residual;
    errors.plain += residual * residual * point.deviation * point.deviation;
  }
  errors.inverse =
      (J.transpose() * J).ldlt().solve(Eigen::MatrixXd::Identity(parameters, parameters));
  return errors;
}

void fit(FrictionCurve& curve) {
  double p[parameters];
  curve.identified = minimise(curve.points, p);
  const FitErrors errors = errors_at(curve.points, p);
  const auto rows = static_cast<long>(curve.points.size());
  curve.residual = std::sqrt(errors.plain / static_cast<double>(rows));
  const long freedom = rows - parameters;
  const double scale = std::sqrt(errors.squares / static_cast<double>(freedom));
  const auto error = [&](int k) { return scale * std::sqrt(std::max(0.0, errors.inverse(k, k))); };
  const double gamma1 = std::exp(p[0]);
  const Estimate logarithm = estimate(p[0], error(0), freedom);
  curve.gamma1 = {gamma1, gamma1 * error(0), std::exp(logarithm.low), std::exp(logarithm.high)};
  curve.gamma2 = estimate(p[1], error(1), freedom);
  curve.gamma3 = estimate(p[2], error(2), freedom);
  const double quarter = pi / 2;
  curve.plateau = estimate(p[1] * quarter, error(1) * quarter, freedom);
  curve.passive_share = passive_share(curve, scale * scale * errors.inverse.topLeftCorner<3, 3>(),
                                      (curve.gamma2.high - curve.gamma2.value) / error(1));
}

void judge(FrictionCurve& curve) {
  double slowest = std::numeric_limits<double>::infinity(), fastest = 0.0;
  bool forward = false, backward = false;
  for (const FrictionPoint& point : curve.points) {
    slowest = std::min(slowest, std::abs(point.velocity));
    fastest = std::max(fastest, std::abs(point.velocity));
    (point.velocity > 0 ? forward : backward) = true;
  }
  const auto say = [&](const std::string& text) {
    curve.missing.push_back(text);
    curve.identified = false;
  };
  if (!forward || !backward)
    say("the drive moves in one direction only; expected constant velocities both ways");
  const auto doubtful = [](const Estimate& e) {
    return !(e.standard_error < 0.3 * std::abs(e.value));
  };
  if (doubtful(curve.gamma1) || slowest * curve.gamma1.value > 10.0)
    say(
        fmt::format("gamma1 is not determined: the slowest velocity is {:.3g} rad/s; expected some "
                    "where the friction still rises, down to {:.3g} rad/s",
                    slowest, 0.3 / std::max(curve.gamma1.value, 1.0 / slowest)));
  if (doubtful(curve.gamma2) || fastest * curve.gamma1.value < 2.0)
    say(
        fmt::format("gamma2 is not determined: the fastest velocity is {:.3g} rad/s; expected some "
                    "on the plateau, ten times faster",
                    fastest));
  if (doubtful(curve.gamma3))
    say(fmt::format(
        "gamma3 is not determined; expected constant velocities well above {:.3g} rad/s", fastest));
}

}  // namespace

double friction_torque(double gamma1, double gamma2, double gamma3, double velocity) {
  return gamma2 * std::atan(gamma1 * velocity) + gamma3 * velocity;
}

FrictionCurve identify_friction(const std::vector<DriveStretch>& stretches, double gear_ratio) {
  FrictionCurve curve;
  curve.points = points_of(stretches, gear_ratio);
  require_velocities(curve);
  if (!curve.missing.empty()) return curve;
  fit(curve);
  judge(curve);
  return curve;
}

}  // namespace sinew
