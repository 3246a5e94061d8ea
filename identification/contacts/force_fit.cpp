// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/contacts/force_fit.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kOwnError = 0.03;  // of what is left over: lever arms are known no better
// Of a found cause, none of which has exactly its law's form: without it impacts in a gear are
// pushes (tests/identification/subjects/geared_joints.cpp). The likelihood has the same
// (decision_constants.h).
constexpr double kFormError = 0.2;
constexpr double kMostSamples = 1500;  // that a point is fitted to
constexpr double kLooser = 3.0;        // than their rms over a disturbance, most of it flanks
constexpr double kRankLimit = 1e-9;

/// A sample of a disturbance in units of its noise.
struct Sample {
  std::size_t disturbance = 0;
  VectorXd left;    ///< channels, and at a link three zeros
  MatrixXd effort;  ///< channels x 12 at a link, and the force itself as a share of its rms; x 1
                    ///< elsewhere
};

/// Of what a sample leaves over, with the error that what is found there brings.
MatrixXd covariance_at(const ForceNoise& noise, const LeftOver& r, Index sample) {
  MatrixXd covariance = noise.covariance;
  covariance.diagonal() += (kOwnError * r.residual.row(sample).transpose()).cwiseAbs2();
  covariance.diagonal() += (kFormError * r.explained.row(sample).transpose()).cwiseAbs2();
  // A motion that is sampled turns a step early or late.
  covariance.diagonal() += r.within_step.row(sample).transpose().cwiseAbs2();
  covariance.diagonal() += noise.standing.cwiseAbs2().cwiseProduct(
      (1.0 - r.counts.row(sample).array().square()).matrix().transpose());
  return covariance;
}

std::vector<Sample> in_units_of_noise(const Disturbances& disturbances, const ForceNoise& noise,
                                      const ForcePlace& place) {
  std::vector<Sample> samples;
  for (std::size_t d = 0; d < disturbances.list.size(); ++d) {
    const Disturbance& one = disturbances.list[d];
    const LeftOver& r = disturbances.left_over[one.recording];
    const Index channels = r.residual.cols();
    for (Index k = one.first; k < one.last; ++k) {
      const Eigen::LLT<MatrixXd> factor(covariance_at(noise, r, k));
      Sample s{d, factor.matrixL().solve(r.residual.row(k).transpose()), {}};
      const VectorXd row = place.effort[d].row(k - one.first).transpose();
      s.effort = factor.matrixL().solve(
          Eigen::Map<const MatrixXd>(row.data(), channels, row.size() / channels));
      samples.push_back(std::move(s));
    }
  }
  return samples;
}

/// What a force at a point of the link asks: affine in the point.
MatrixXd at_point(const Sample& s, const Vector3d& point) {
  MatrixXd effort = s.effort.leftCols(3);
  for (Index i = 0; i < 3; ++i)
    effort += point(i) * (s.effort.middleCols(3 * (i + 1), 3) - s.effort.leftCols(3));
  return effort;
}

/// Least squares of one sample.
Vector3d force_of(const MatrixXd& effort, const VectorXd& left) {
  return (effort.transpose() * effort).inverse() * (effort.transpose() * left);
}

/// Of a force's components, by evidence.
double mean_square_of_forces(const std::vector<Sample>& samples, const Vector3d& point) {
  constexpr int kTurns = 20;
  double left = 0.0, effort = 0.0;
  for (const Sample& s : samples) {
    left += s.left.squaredNorm();
    effort += at_point(s, point).squaredNorm();
  }
  double square = left / std::max(effort, 1e-300);
  for (int turn = 0; turn < kTurns; ++turn) {
    double sum = 0.0;
    for (const Sample& s : samples) {
      const MatrixXd a = at_point(s, point);
      const Matrix3d covariance = (a.transpose() * a + Matrix3d::Identity() / square).inverse();
      sum += (covariance * (a.transpose() * s.left)).squaredNorm() + covariance.trace();
    }
    square = std::max(sum / (3.0 * static_cast<double>(samples.size())), 1e-300);
  }
  return square;
}

/// A joint's axis tells nothing of a force that points to it: there a force is as large as
/// elsewhere or smaller.
void expect_forces(const Vector3d& centre, std::vector<Sample>& samples) {
  const double weight = 1.0 / (kLooser * std::sqrt(mean_square_of_forces(samples, centre)));
  for (Sample& s : samples) {
    const Index channels = s.left.size();
    s.left.conservativeResize(channels + 3);
    s.left.tail(3).setZero();
    s.effort.conservativeResize(channels + 3, Eigen::NoChange);
    for (Index point = 0; point < 4; ++point)
      s.effort.block(channels, 3 * point, 3, 3) = weight * Matrix3d::Identity();
  }
}

/// The direction in which most of a disturbance's forces act.
Vector3d main_direction(const std::vector<Sample>& samples, const Vector3d& point,
                        std::size_t disturbance) {
  Matrix3d moment = Matrix3d::Zero();
  for (const Sample& s : samples) {
    if (s.disturbance != disturbance) continue;
    const MatrixXd effort = at_point(s, point);
    const Vector3d force = force_of(effort, s.left);
    moment += (effort * force).squaredNorm() * force.normalized() * force.normalized().transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(moment);
  return eigen.eigenvectors().col(2);
}

/// What one place leaves over at a point and, where there are any, directions.
struct LinkResidual {
  const std::vector<Sample>& samples;
  Vector3d centre;
  double size;
  bool one_direction;

  Vector3d direction(const double* x, std::size_t disturbance) const {
    return Eigen::Map<const Vector3d>(x + 3 + 3 * disturbance).normalized();
  }
  VectorXd left_of(const Sample& s, const double* x) const {
    const MatrixXd effort = at_point(s, Eigen::Map<const Vector3d>(x));
    if (!one_direction) return s.left - effort * force_of(effort, s.left);
    const VectorXd along = effort * direction(x, s.disturbance);
    const double square = along.squaredNorm();
    return square > 0.0 ? VectorXd(s.left - along * (along.dot(s.left) / square)) : s.left;
  }
  bool operator()(const double* const* parameters, double* residuals) const {
    Eigen::Map<Vector3d> from_centre(residuals);
    from_centre = (Eigen::Map<const Vector3d>(parameters[0]) - centre) / size;
    Index at = 3;
    for (const Sample& s : samples) {
      Eigen::Map<VectorXd>(residuals + at, s.left.size()) = left_of(s, parameters[0]);
      at += s.left.size();
    }
    // Far away, where nothing is told from anything, there may be no numbers.
    return Eigen::Map<const VectorXd>(residuals, at).allFinite();
  }
};

std::vector<Sample> thinned(const std::vector<Sample>& samples) {
  const auto every =
      static_cast<std::size_t>(std::ceil(static_cast<double>(samples.size()) / kMostSamples));
  std::vector<Sample> kept;
  for (std::size_t i = 0; i < samples.size(); i += std::max<std::size_t>(every, 1))
    kept.push_back(samples[i]);
  return kept;
}

/// The point and the directions that leave least over.
std::vector<double> search_point(const LinkResidual& residual, std::size_t disturbances) {
  std::vector<double> x(3);
  Eigen::Map<Vector3d>(x.data()) = residual.centre;
  if (residual.one_direction)
    for (std::size_t d = 0; d < disturbances; ++d) {
      const Vector3d start = main_direction(residual.samples, residual.centre, d);
      x.insert(x.end(), start.data(), start.data() + 3);
    }
  using Cost = ceres::DynamicNumericDiffCostFunction<LinkResidual, ceres::FORWARD>;
  auto* cost = new Cost(new LinkResidual(residual));
  cost->AddParameterBlock(static_cast<int>(x.size()));
  cost->SetNumResiduals(
      static_cast<int>(3 + residual.samples.size() *
                               static_cast<std::size_t>(residual.samples.front().left.size())));
  ceres::Problem problem;
  problem.AddResidualBlock(cost, nullptr, x.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 30;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return x;
}

/// How many components of a force at a point show at all.
double components(const std::vector<Sample>& samples, const Vector3d& point) {
  Matrix3d gram = Matrix3d::Zero();
  for (const Sample& s : samples) {
    const MatrixXd effort = at_point(s, point).topRows(s.left.size() - 3);
    gram += effort.transpose() * effort;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(gram);
  const double limit = kRankLimit * std::max(eigen.eigenvalues()(2), 1e-300);
  return static_cast<double>((eigen.eigenvalues().array() > limit).count());
}

/// A force and its standard error along itself.
struct EstimatedForce {
  Vector3d force;
  double error = 0.0;
};

EstimatedForce estimate(const MatrixXd& effort, const VectorXd& left) {
  EstimatedForce e{force_of(effort, left)};
  const Vector3d along = e.force.normalized();
  e.error = std::sqrt(along.dot((effort.transpose() * effort).inverse() * along));
  return e;
}

/// The same along one direction.
EstimatedForce estimate_along(const Vector3d& direction, const MatrixXd& effort,
                              const VectorXd& left) {
  const VectorXd asked = effort * direction;
  const double square = std::max(asked.squaredNorm(), 1e-300);
  return {direction * (asked.dot(left) / square), 1.0 / std::sqrt(square)};
}

/// Enters what the samples leave over and their forces, in the order of time.
class Courses {
 public:
  Courses(const Disturbances& disturbances, const ForceNoise& noise, Index wide, ForceFit& fit)
      : noise_(noise), fit_(fit), at_(disturbances.list.size(), 0) {
    for (const Disturbance& d : disturbances.list) {
      fit_.forces.emplace_back();
      fit_.forces.back().course = MatrixXd::Zero(d.last - d.first, wide);
      fit_.forces.back().worth = deviance_without_force(disturbances, d, noise);
    }
  }
  void add(std::size_t disturbance, const VectorXd& force, double error, double deviance) {
    FittedForce& f = fit_.forces[disturbance];
    f.course.row(at_[disturbance]++) = force.transpose();
    if (force.norm() > f.peak) {
      f.peak = force.norm();
      f.peak_error = error;
    }
    fit_.deviance += noise_.independent * deviance;
    f.worth -= noise_.independent * deviance;
  }
  /// Numbers of each sample, and of each disturbance beside them.
  void charge(double of_sample, double of_disturbance) {
    for (FittedForce& f : fit_.forces) {
      const double price =
          noise_.price *
          (of_sample * noise_.independent * static_cast<double>(f.course.rows()) + of_disturbance);
      fit_.price += price;
      f.worth -= price;
    }
  }

 private:
  const ForceNoise& noise_;
  ForceFit& fit_;
  std::vector<Index> at_;
};

ForceFit fit_at_link(const Disturbances& disturbances, const ForceNoise& noise,
                     const ForcePlace& place, const std::vector<Sample>& samples,
                     bool one_direction) {
  ForceFit fit;
  fit.place = &place;
  fit.one_direction = one_direction;
  const std::vector<Sample> few = thinned(samples);
  const LinkResidual residual{few, place.centre, std::max(place.size, 1e-3), one_direction};
  const std::vector<double> x = search_point(residual, disturbances.list.size());
  fit.point = Eigen::Map<const Vector3d>(x.data());
  fit.price = 3.0 * noise.price;
  Courses courses(disturbances, noise, 3, fit);
  for (const Sample& s : samples) {
    const MatrixXd effort = at_point(s, fit.point);
    const EstimatedForce e =
        one_direction ? estimate_along(residual.direction(x.data(), s.disturbance), effort, s.left)
                      : estimate(effort, s.left);
    courses.add(s.disturbance, e.force, e.error, residual.left_of(s, x.data()).squaredNorm());
  }
  courses.charge(one_direction ? 1.0 : components(samples, fit.point), one_direction ? 2.0 : 0.0);
  return fit;
}

ForceFit fit_elsewhere(const Disturbances& disturbances, const ForceNoise& noise,
                       const ForcePlace& place, const std::vector<Sample>& samples) {
  ForceFit fit;
  fit.place = &place;
  Courses courses(disturbances, noise, 1, fit);
  for (const Sample& s : samples) {
    const VectorXd asked = s.effort.col(0);
    const double square = std::max(asked.squaredNorm(), 1e-300);
    const double force = asked.dot(s.left) / square;
    courses.add(s.disturbance, VectorXd::Constant(1, force), 1.0 / std::sqrt(square),
                (s.left - asked * force).squaredNorm());
  }
  courses.charge(1.0, 0.0);
  return fit;
}

}  // namespace

ForceNoise force_noise(const Disturbances& disturbances, double material_share) {
  const Index channels = disturbances.training.moving.size();
  ForceNoise noise;
  noise.covariance = MatrixXd::Zero(channels, channels);
  MatrixXd weight = MatrixXd::Zero(channels, channels);
  VectorXd measured = VectorXd::Zero(channels);
  double independent = 0.0, samples = 0.0;
  for (std::size_t i = 0; i < disturbances.left_over.size(); ++i) {
    const LeftOver& r = disturbances.left_over[i];
    noise.independent = std::min(1.0, 2.0 * r.band_hz / r.rate_hz);
    independent += noise.independent * static_cast<double>(r.time.size());
    if (r.held_out) continue;
    measured += r.measured.cwiseAbs2().colwise().sum().transpose();
    samples += static_cast<double>(r.time.size());
    for (Index k = 0; k < r.time.size(); ++k) {
      if (disturbances.aside[i](k)) continue;
      const VectorXd counts = r.counts.row(k).transpose();
      const VectorXd left = r.residual.row(k).transpose().cwiseProduct(counts);
      noise.covariance += left * left.transpose();
      weight += counts * counts.transpose();
    }
  }
  measured /= std::max(samples, 1.0);
  noise.covariance.array() /= weight.array().max(1.0);
  // What is not worth telling counts as noise; of a log without any it is all there is.
  noise.covariance.diagonal() += material_share * material_share * measured;
  noise.covariance.diagonal().array() += 1e-300;
  noise.standing = disturbances.training.standing;
  noise.price = std::log(std::max(independent, 2.0));
  return noise;
}

double deviance_at(const ForceNoise& noise, const LeftOver& r, Index sample) {
  const Eigen::LLT<MatrixXd> factor(covariance_at(noise, r, sample));
  return factor.matrixL().solve(r.residual.row(sample).transpose()).squaredNorm();
}

double deviance_without_force(const Disturbances& disturbances, const Disturbance& one,
                              const ForceNoise& noise) {
  const LeftOver& r = disturbances.left_over[one.recording];
  double sum = 0.0;
  for (Index k = one.first; k < one.last; ++k) sum += deviance_at(noise, r, k);
  return noise.independent * sum;
}

ForceFit fit_force(const Disturbances& disturbances, const ForceNoise& noise,
                   const ForcePlace& place) {
  std::vector<Sample> samples = in_units_of_noise(disturbances, noise, place);
  if (!place.at_link) return fit_elsewhere(disturbances, noise, place, samples);
  expect_forces(place.centre, samples);
  ForceFit straight = fit_at_link(disturbances, noise, place, samples, true);
  ForceFit any = fit_at_link(disturbances, noise, place, samples, false);
  return straight.score() <= any.score() ? straight : any;
}

}  // namespace sinew::diagnosis
