// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/nearest_bodies.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>

#include "symbolic/model/pseudo_inertia.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

constexpr double least_factor =
    1e-4;  // of a Cholesky factor's diagonal: positive, not just not negative
constexpr double pull_to_start = 1e-3;  // for what no log says anything about

/// A link's ten numbers over unconstrained ones.
class BodyChart {
 public:
  BodyChart(const EstimatedBody& link, const BodyParameters& wanted)
      : link_(link), length_(0.25 * link.reach) {
    mass_ = std::max(
        {wanted(0), wanted.segment<3>(1).norm() / link.reach, 1e-3 * link.before(0), 1e-9});
    start_ = link.has_moments() ? factor_of(wanted) : point_of(wanted);
  }

  const VectorXd& start() const { return start_; }
  Index size() const { return start_.size(); }
  /// A logarithm, which must not go to minus infinity.
  bool is_logarithm(Index k) const {
    return link_.has_moments() ? k == 0 || k == 2 || k == 5 || k == 9 : k == 0;
  }

  BodyParameters operator()(const VectorXd& u) const {
    if (link_.has_moments()) {
      Matrix4d L = Matrix4d::Zero();
      Index k = 0;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j <= i; ++j, ++k) L(i, j) = i == j ? std::exp(u(k)) : u(k);
      const Vector4d scale = scales();
      return body_parameters(scale.asDiagonal() * (L * L.transpose()) * scale.asDiagonal());
    }
    BodyParameters body = link_.before;
    body(0) = mass_ * std::exp(u(0));
    const Vector3d v = u.tail<3>();
    body.segment<3>(1) = body(0) * link_.reach * v / std::sqrt(1.0 + v.squaredNorm());
    if (!link_.as_point) return body;
    const Vector3d centre = body.segment<3>(1) / body(0);
    const Vector4d point(centre.x(), centre.y(), centre.z(), 1.0);
    return body_parameters(body(0) * point * point.transpose());
  }

 private:
  Vector4d scales() const {
    const double root = std::sqrt(mass_);
    return {root * length_, root * length_, root * length_, root};
  }

  /// Of the matrix with its eigenvalues made positive.
  VectorXd factor_of(const BodyParameters& wanted) const {
    const Vector4d down = scales().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(
        down.asDiagonal() * pseudo_inertia_matrix(wanted) * down.asDiagonal());
    const double most = std::max(eigen.eigenvalues()(3), 1e-3);
    const Vector4d values = eigen.eigenvalues().cwiseMax(1e-4 * most);
    const Matrix4d J =
        eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
    const Matrix4d L = J.llt().matrixL();
    VectorXd u(10);
    Index k = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j <= i; ++j, ++k) u(k) = i == j ? std::log(L(i, j)) : L(i, j);
    return u;
  }

  VectorXd point_of(const BodyParameters& wanted) const {
    VectorXd u(4);
    const Vector3d share = wanted.segment<3>(1) / (mass_ * link_.reach);
    const double far = std::min(share.norm(), 0.99);
    u(0) = 0.0;
    u.tail<3>() = share.normalized() * far / std::sqrt(1.0 - far * far);
    return u;
  }

  const EstimatedBody& link_;
  double length_, mass_ = 1.0;
  VectorXd start_;
};

/// What was estimated of the changes, in the order of the estimates.
VectorXd picked(const std::vector<EstimatedBody>& links,
                const std::vector<BodyParameters>& bodies) {
  std::vector<double> all;
  for (std::size_t b = 0; b < links.size(); ++b)
    for (const int k : links[b].estimated) all.push_back(bodies[b](k) - links[b].before(k));
  return VectorXd::Map(all.data(), static_cast<Index>(all.size()));
}

std::vector<BodyParameters> wanted_bodies(const std::vector<EstimatedBody>& links,
                                          const VectorXd& estimates) {
  std::vector<BodyParameters> bodies;
  Index at = 0;
  for (const EstimatedBody& link : links) {
    bodies.push_back(link.before);
    for (const int k : link.estimated) bodies.back()(k) += estimates(at++);
  }
  return bodies;
}

/// Misfit, and a weak pull towards the start.
class Misfit {
 public:
  Misfit(const std::vector<EstimatedBody>& links, const std::vector<BodyChart>& charts,
         const VectorXd& estimates, const MatrixXd& information)
      : links_(links), charts_(charts), estimates_(estimates) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(information);
    root_ = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
            eigen.eigenvectors().transpose();
    for (const BodyChart& chart : charts) size_ += chart.size();
  }

  Index size() const { return size_; }
  Index rows() const { return root_.rows() + size_; }

  std::vector<BodyParameters> bodies(const double* u) const {
    std::vector<BodyParameters> list;
    for (const BodyChart& chart : charts_) {
      list.push_back(chart(VectorXd::Map(u, chart.size())));
      u += chart.size();
    }
    return list;
  }

  VectorXd of_estimates(const double* u) const {
    return root_ * (picked(links_, bodies(u)) - estimates_);
  }

  bool operator()(double const* const* blocks, double* residual) const {
    const VectorXd r = of_estimates(blocks[0]);
    if (!r.allFinite()) return false;
    residual = std::copy(r.begin(), r.end(), residual);
    const double* u = blocks[0];
    for (const BodyChart& chart : charts_)
      for (Index k = 0; k < chart.size(); ++k)
        *residual++ = pull_to_start * (*u++ - chart.start()(k));
    return true;
  }

 private:
  const std::vector<EstimatedBody>& links_;
  const std::vector<BodyChart>& charts_;
  const VectorXd& estimates_;
  MatrixXd root_;
  Index size_ = 0;
};

void minimise(const std::vector<BodyChart>& charts, const Misfit& misfit, std::vector<double>& u) {
  auto cost = std::make_unique<ceres::DynamicNumericDiffCostFunction<Misfit, ceres::CENTRAL>>(
      &misfit, ceres::DO_NOT_TAKE_OWNERSHIP);
  cost->AddParameterBlock(static_cast<int>(u.size()));
  cost->SetNumResiduals(static_cast<int>(misfit.rows()));
  ceres::Problem problem;
  problem.AddResidualBlock(cost.release(), nullptr, u.data());
  int at = 0;
  for (const BodyChart& chart : charts)
    for (Index k = 0; k < chart.size(); ++k, ++at)
      if (chart.is_logarithm(k))
        problem.SetParameterLowerBound(u.data(), at, std::log(least_factor));
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 500;
  options.function_tolerance = 1e-10;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
}

bool is_body_matrix(const BodyParameters& body) {
  const Matrix4d J = pseudo_inertia_matrix(body);
  if (!(J.diagonal().minCoeff() > 0.0)) return false;
  const Vector4d down = J.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(down.asDiagonal() * J * down.asDiagonal(),
                                                      Eigen::EigenvaluesOnly);
  return eigen.eigenvalues()(0) > 0.0;
}

}  // namespace

Matrix4d pseudo_inertia_matrix(const BodyParameters& p) {
  Matrix3d I;
  I << p(4), p(7), p(8), p(7), p(5), p(9), p(8), p(9), p(6);
  return pseudo_inertia_about_origin(p(0), p.segment<3>(1), I);
}

BodyParameters body_parameters(const Matrix4d& J) {
  const Matrix3d I = moments_of(J);
  BodyParameters p;
  p << J(3, 3), J(0, 3), J(1, 3), J(2, 3), I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2);
  return p;
}

bool EstimatedBody::has_moments() const {
  return !as_point && std::any_of(estimated.begin(), estimated.end(), [](int k) { return k > 3; });
}

bool are_bodies(const std::vector<EstimatedBody>& links, const VectorXd& estimates) {
  const std::vector<BodyParameters> bodies = wanted_bodies(links, estimates);
  for (std::size_t b = 0; b < links.size(); ++b) {
    if (links[b].has_moments() ? !is_body_matrix(bodies[b])
                               : !(bodies[b](0) > 0.0) ||
                                     bodies[b].segment<3>(1).norm() > links[b].reach * bodies[b](0))
      return false;
  }
  return true;
}

NearestBodies nearest_bodies(const std::vector<EstimatedBody>& links, const VectorXd& estimates,
                             const MatrixXd& information) {
  const std::vector<BodyParameters> wanted = wanted_bodies(links, estimates);
  std::vector<BodyChart> charts;
  std::vector<double> u;
  for (std::size_t b = 0; b < links.size(); ++b) {
    charts.emplace_back(links[b], wanted[b]);
    u.insert(u.end(), charts.back().start().begin(), charts.back().start().end());
  }
  const Misfit misfit(links, charts, estimates, information);
  minimise(charts, misfit, u);
  NearestBodies result;
  const std::vector<BodyParameters> bodies = misfit.bodies(u.data());
  for (std::size_t b = 0; b < links.size(); ++b)
    result.changes.push_back(bodies[b] - links[b].before);
  result.misfit = misfit.of_estimates(u.data()).squaredNorm();
  return result;
}

}  // namespace sinew::diagnosis
