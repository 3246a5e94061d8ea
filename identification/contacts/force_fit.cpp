// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/contacts/force_fit.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "identification/likelihood/decision_constants.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kOwnError = 0.03;     // of what is left over: lever arms are known no better
constexpr double kMostSamples = 1500;  // that a point is fitted to
constexpr double kLooser = 3.0;        // than their rms over a disturbance, most of it flanks

/// A sample of a disturbance in units of its noise.
struct Sample {
  std::size_t disturbance = 0;
  VectorXd left;    ///< channels, and a zero for each component of the force
  MatrixXd effort;  ///< channels x 12 at a link, x 1 elsewhere, and the force's own components as
                    ///< shares of what is expected
};

/// Of what a sample leaves over, with the error that what is found there brings.
MatrixXd covariance_at(const ForceNoise& noise, const LeftOver& r, Index sample) {
  MatrixXd covariance = noise.covariance;
  covariance.diagonal() += (kOwnError * r.residual.row(sample).transpose()).cwiseAbs2();
  // Impacts in a gear are pushes without it (tests/identification/subjects/geared_joints.cpp).
  covariance.diagonal() += (kFormError * r.explained.row(sample).transpose()).cwiseAbs2();
  // What few samples elsewhere tell of a coefficient may be anything here.
  covariance.diagonal() += r.extrapolated.row(sample).transpose().cwiseAbs2();
  // A motion that is sampled may be a step early or late, as where it turns or is hit.
  covariance.diagonal() += r.within_step.row(sample).transpose().cwiseAbs2();
  covariance.diagonal() += noise.standing.cwiseAbs2().cwiseProduct(
      (1.0 - r.counts.row(sample).array().square()).matrix().transpose());
  return covariance;
}

/// What a sample leaves over, in units of the noise.
double deviance_at(const Eigen::LLT<MatrixXd>& factor, const LeftOver& r, Index sample) {
  return factor.matrixL().solve(r.residual.row(sample).transpose()).squaredNorm();
}

/// Of what one disturbance leaves over where no force is fitted.
double deviance_without_force(const Disturbances& disturbances, const Disturbance& one,
                              const ForceNoise& noise) {
  const LeftOver& r = disturbances.left_over[one.recording];
  double sum = 0.0;
  for (Index k = one.first; k < one.last; ++k)
    sum += deviance_at(Eigen::LLT<MatrixXd>(covariance_at(noise, r, k)), r, k);
  return noise.independent * sum;
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

/// What a force at a point of the link asks, affine in the point; elsewhere there is none.
MatrixXd at_point(const Sample& s, const Vector3d& point) {
  if (s.effort.cols() == 1) return s.effort;
  MatrixXd effort = s.effort.leftCols(3);
  for (Index i = 0; i < 3; ++i)
    effort += point(i) * (s.effort.middleCols(3 * (i + 1), 3) - s.effort.leftCols(3));
  return effort;
}

/// Least squares of one sample.
VectorXd force_of(const MatrixXd& effort, const VectorXd& left) {
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
  const Index components = samples.front().effort.cols() == 1 ? 1 : 3;
  for (int turn = 0; turn < kTurns; ++turn) {
    double sum = 0.0;
    for (const Sample& s : samples) {
      const MatrixXd a = at_point(s, point);
      const MatrixXd covariance =
          (a.transpose() * a + MatrixXd::Identity(components, components) / square).inverse();
      sum += (covariance * (a.transpose() * s.left)).squaredNorm() + covariance.trace();
    }
    square = std::max(sum / static_cast<double>(components * static_cast<Index>(samples.size())),
                      1e-300);
  }
  return square;
}

/// How large a force's components are expected to be: nothing else limits one that points to a
/// joint's axis, of which the joint tells nothing. Gives the weight of a unit of them.
double expect_forces(const Vector3d& centre, std::vector<Sample>& samples) {
  const double weight = 1.0 / (kLooser * std::sqrt(mean_square_of_forces(samples, centre)));
  for (Sample& s : samples) {
    const Index channels = s.left.size(), components = s.effort.cols() == 1 ? 1 : 3;
    s.left.conservativeResize(channels + components);
    s.left.tail(components).setZero();
    s.effort.conservativeResize(channels + components, Eigen::NoChange);
    for (Index first = 0; first < s.effort.cols(); first += components)
      s.effort.block(channels, first, components, components) =
          weight * MatrixXd::Identity(components, components);
  }
  return weight;
}

/// What a sample's force costs: by how much the logs narrow what was expected of it, whose weight
/// `effort` ends with. In twice the log likelihood.
double price_of(const MatrixXd& effort, double weight) {
  const MatrixXd narrowed = effort / weight;
  return std::log((narrowed.transpose() * narrowed).determinant());
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

/// A force and its standard error along itself.
struct EstimatedForce {
  VectorXd force;
  double error = 0.0;
};

EstimatedForce estimate(const MatrixXd& effort, const VectorXd& left) {
  EstimatedForce e{force_of(effort, left)};
  const VectorXd along = e.force.normalized();
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
  void add(std::size_t disturbance, const EstimatedForce& e, double deviance, double price) {
    FittedForce& f = fit_.forces[disturbance];
    f.course.row(at_[disturbance]++) = e.force.transpose();
    if (e.force.norm() > f.peak) {
      f.peak = e.force.norm();
      f.peak_error = e.error;
    }
    fit_.deviance += noise_.independent * deviance;
    fit_.price += noise_.independent * price;
    f.worth -= noise_.independent * (deviance + price);
  }
  /// For the direction of each disturbance.
  void charge_directions() {
    const double price = 2.0 * noise_.price;
    for (FittedForce& f : fit_.forces) {
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
                     const ForcePlace& place, const std::vector<Sample>& samples, double weight,
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
    const double deviance = residual.left_of(s, x.data()).squaredNorm();
    if (one_direction) {
      const Vector3d along = residual.direction(x.data(), s.disturbance);
      courses.add(s.disturbance, estimate_along(along, effort, s.left), deviance,
                  price_of(effort * along, weight));
    } else {
      courses.add(s.disturbance, estimate(effort, s.left), deviance, price_of(effort, weight));
    }
  }
  if (one_direction) courses.charge_directions();
  return fit;
}

ForceFit fit_elsewhere(const Disturbances& disturbances, const ForceNoise& noise,
                       const ForcePlace& place, const std::vector<Sample>& samples, double weight) {
  ForceFit fit;
  fit.place = &place;
  Courses courses(disturbances, noise, 1, fit);
  for (const Sample& s : samples) {
    const EstimatedForce e = estimate(s.effort, s.left);
    courses.add(s.disturbance, e, (s.left - s.effort * e.force).squaredNorm(),
                price_of(s.effort, weight));
  }
  return fit;
}

/// Friction holds any effort up to its level, which is as large as what it holds anywhere.
VectorXd most_at_rest(const Disturbances& disturbances) {
  VectorXd most = disturbances.training.standing;
  for (const LeftOver& r : disturbances.left_over)
    most = most.cwiseMax(r.residual.cwiseProduct((r.counts.array() == 0.0).cast<double>().matrix())
                             .cwiseAbs()
                             .colwise()
                             .maxCoeff()
                             .transpose());
  return most;
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
  noise.standing = most_at_rest(disturbances);
  noise.price = std::log(std::max(independent, 2.0));
  return noise;
}

double log_loss_at(const ForceNoise& noise, const LeftOver& r, Index sample) {
  const Eigen::LLT<MatrixXd> factor(covariance_at(noise, r, sample));
  return deviance_at(factor, r, sample) +
         2.0 * MatrixXd(factor.matrixL()).diagonal().array().log().sum();
}

ForceFit fit_force(const Disturbances& disturbances, const ForceNoise& noise,
                   const ForcePlace& place) {
  std::vector<Sample> samples = in_units_of_noise(disturbances, noise, place);
  const double weight = expect_forces(place.centre, samples);
  if (!place.at_link) return fit_elsewhere(disturbances, noise, place, samples, weight);
  ForceFit straight = fit_at_link(disturbances, noise, place, samples, weight, true);
  ForceFit any = fit_at_link(disturbances, noise, place, samples, weight, false);
  return straight.score() <= any.score() ? straight : any;
}

}  // namespace sinew::diagnosis
