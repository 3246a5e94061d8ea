// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <random>

#include "identification/regression/nearest_bodies.h"

using namespace sinew::diagnosis;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

const std::vector<int> all_ten{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};

/// A box of 0.2 kg, 0.1 m from its origin.
BodyParameters box() {
  BodyParameters p;
  p << 0.2, 0.02, 0.0, 0.0, 3e-4, 2.3e-3, 2.4e-3, 1e-5, 0.0, -2e-5;
  return p;
}

double least_eigenvalue(const BodyParameters& p) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(pseudo_inertia_matrix(p)).eigenvalues()(0);
}

MatrixXd random_information(unsigned seed, int size, int rank) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  MatrixXd half(rank, size);
  for (double& x : half.reshaped()) x = normal(random);
  return half.transpose() * half;
}

}  // namespace

TEST_CASE("ten numbers and their matrix are the same thing") {
  CHECK((body_parameters(pseudo_inertia_matrix(box())) - box()).norm() < 1e-15);
}

TEST_CASE("what is a body already stays") {
  const std::vector<EstimatedBody> one{{all_ten, BodyParameters::Zero(), 0.5}};
  CHECK(are_bodies(one, box()));
  const NearestBodies same = nearest_bodies(one, box(), MatrixXd::Identity(10, 10) * 1e10);
  CHECK(same.misfit < 1.0);
}

TEST_CASE("the nearest body is one, and no other body is nearer by a hundredth") {
  // Planted defect: eigenvalues made positive and no more (the start): bodies by chance nearer.
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    VectorXd estimate = box();
    // Noise in proportion to each number's own size; what it gives is no body.
    const VectorXd size = VectorXd(box()).cwiseAbs().cwiseMax(1e-4);
    do {
      for (int k = 0; k < 10; ++k) estimate(k) = box()(k) + 0.7 * size(k) * normal(random);
    } while (are_bodies({{all_ten, BodyParameters::Zero(), 0.5}}, estimate));
    const VectorXd unit = size.cwiseInverse();
    const MatrixXd information =
        unit.asDiagonal() * random_information(seed, 10, seed % 2 ? 10 : 6) * unit.asDiagonal();
    const std::vector<EstimatedBody> one{{all_ten, BodyParameters::Zero(), 0.5}};
    const NearestBodies nearest = nearest_bodies(one, estimate, information);
    const BodyParameters& found = nearest.changes.front();
    CHECK(least_eigenvalue(found) > 0.0);
    CHECK(nearest.misfit == Approx((found - estimate).dot(information * (found - estimate)))
                                .epsilon(1e-6)
                                .margin(1e-6));
    // Bodies between the found one and any other are bodies: a nearer one would show by a small
    // step towards it.
    for (int trial = 0; trial < 200; ++trial) {
      Eigen::Matrix4d other = pseudo_inertia_matrix(found);
      Eigen::Matrix4d part;
      for (double& x : part.reshaped()) x = normal(random);
      const Eigen::Vector4d scale(0.05, 0.05, 0.05, 0.4);
      const Eigen::Matrix4d J = scale.asDiagonal() * (part * part.transpose()) * scale.asDiagonal();
      const BodyParameters there =
          body_parameters(0.999 * other + 0.001 * J) - BodyParameters(estimate);
      CHECK(there.dot(information * there) > 0.99 * nearest.misfit - 1e-3);
    }
  }
}

TEST_CASE("a link's change leaves the whole link a body") {
  const EstimatedBody link{all_ten, box(), 0.5};
  VectorXd change = VectorXd::Zero(10);
  change(0) = -0.25;  // more than it has
  change(6) = -3e-3;
  CHECK_FALSE(are_bodies({link}, change));
  const MatrixXd information =
      VectorXd(box()).cwiseAbs().cwiseMax(1e-4).cwiseInverse().cwiseAbs2().asDiagonal();
  const NearestBodies nearest = nearest_bodies({link}, change, information);
  CHECK(least_eigenvalue(box() + nearest.changes.front()) > 0.0);
  CHECK(nearest.changes.front()(0) < -0.1);
}

TEST_CASE("what logs tell nothing about is whatever makes a body") {
  // Mass, first moment and one moment are known well, as of a link that turns about one axis; the
  // other numbers came out 0. Planted defect: a unit matrix in place of the information: what is
  // known moves by more than its error, the moment to 0.0044; the misfit of the test above is
  // 0.0000005 instead of 19.
  VectorXd estimate = VectorXd::Zero(10);
  estimate(0) = 0.1, estimate(1) = 0.02, estimate(6) = 5e-3;
  VectorXd known = VectorXd::Zero(10);
  known(0) = 1e6, known(1) = 1e8, known(6) = 1e10;
  const std::vector<EstimatedBody> one{{all_ten, BodyParameters::Zero(), 0.5}};
  CHECK_FALSE(are_bodies(one, estimate));
  const NearestBodies nearest = nearest_bodies(one, estimate, known.asDiagonal());
  CHECK(nearest.misfit < 0.1);
  CHECK(nearest.changes.front()(6) == Approx(5e-3).epsilon(1e-3));
  CHECK(least_eigenvalue(nearest.changes.front()) > 0.0);
}

TEST_CASE("mass and first moments alone: a positive mass within reach") {
  const EstimatedBody point{{0, 1, 2, 3}, BodyParameters::Zero(), 0.2};
  const VectorXd light = Eigen::Vector4d(-0.01, 0.002, 0, 0);
  CHECK_FALSE(are_bodies({point}, light));
  const VectorXd error = Eigen::Vector4d(0.02, 1e-4, 1e-4, 1e-4);
  const NearestBodies nearest =
      nearest_bodies({point}, light, error.cwiseAbs2().cwiseInverse().asDiagonal());
  const BodyParameters& found = nearest.changes.front();
  CHECK(found(0) > 0.0);
  CHECK(found.segment<3>(1).norm() <= 0.2 * found(0) * (1 + 1e-9));
  CHECK(found(1) == Approx(0.002).epsilon(0.1));
  CHECK(found.tail<6>().isZero(0.0));
  CHECK(are_bodies({point}, Eigen::Vector4d(0.02, 0.002, 0, 0)));
}

TEST_CASE("a point's moments tell how far away it is") {
  // First moments are known well, the mass hardly, moments somewhat. Planted defect: no moments for
  // a point: the least mass that is within reach.
  const double mass = 0.3;
  const Eigen::Vector4d place(0.1, -0.02, 0.05, 1.0);
  const BodyParameters point = body_parameters(mass * place * place.transpose());
  VectorXd error(10);
  error << 1.0, 1e-4, 1e-4, 1e-4, 2e-4, 2e-4, 2e-4, 2e-4, 2e-4, 2e-4;
  EstimatedBody link{all_ten, BodyParameters::Zero(), 2.5};
  link.as_point = true;
  VectorXd estimate = point;
  estimate(0) = -0.1;
  const NearestBodies nearest =
      nearest_bodies({link}, estimate, error.cwiseAbs2().cwiseInverse().asDiagonal());
  CHECK((nearest.changes.front().tail<9>() - point.tail<9>()).norm() < 2e-4);
  CHECK(nearest.changes.front()(0) == Approx(mass).epsilon(0.1));
}

TEST_CASE("two links are fitted together") {
  const std::vector<EstimatedBody> both{{all_ten, BodyParameters::Zero(), 0.5},
                                        {{0, 1, 2, 3}, BodyParameters::Zero(), 0.5}};
  VectorXd estimate(14);
  estimate << -box(), 0.1, 0.01, 0, 0;
  const NearestBodies nearest = nearest_bodies(both, estimate, random_information(3, 14, 14));
  REQUIRE(nearest.changes.size() == 2);
  CHECK(least_eigenvalue(nearest.changes[0]) > 0.0);
  CHECK(nearest.changes[1](0) > 0.0);
}
