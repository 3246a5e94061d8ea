// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of joints that do not meet, against the same columns taken as one region.
#include "identification/likelihood/regions.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "identification/likelihood/small_errors.h"

namespace {

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kRows = 30, kOwn = 4, kLinks = 2, kChannels = 3;

/// Three channels with columns of their own and two columns that act in all of them, mixed.
struct Arm {
  Arm() {
    std::srand(11);
    const Index columns = kChannels * kOwn + kLinks;
    x = MatrixXd::Zero(kChannels * kRows, columns);
    acts = MatrixXd::Zero(kChannels, columns);
    for (Index c = 0; c < columns; ++c)
      for (Index channel = 0; channel < kChannels; ++channel)
        if (c >= kChannels * kOwn || c % kChannels == channel) {
          x.col(c).segment(channel * kRows, kRows) = VectorXd::Random(kRows) * 30.0;
          acts(channel, c) = 1.0;
        }
    y = VectorXd::Random(x.rows()) * 5.0;
    for (Index c = 0; c < columns; ++c) {
      sources.emplace_back();
      sources.back().linear.resize(1);
    }
    for (Index c = 0; c < columns; ++c) {
      Hypothesis h;
      h.candidate = static_cast<int>(c);
      h.source = &sources[static_cast<std::size_t>(c)];
      h.shapes = {static_cast<int>(c), static_cast<int>(c)};
      all.list.push_back(h);
      all.shapes.push_back({static_cast<int>(c), {}, {}, {}});
    }
  }

  Moments moments(const Regions& regions) const {
    Moments m;
    const MatrixXd dense = x.transpose() * x;
    m.gram = RegionProducts(regions);
    for (Index c = 0; c < dense.cols(); ++c) {
      m.of_shape.push_back({c, 1});
      for (Index r = c; r < dense.rows(); ++r) m.gram.set(r, c, dense(r, c));
    }
    m.coefficient.assign(static_cast<std::size_t>(dense.cols()), 0);
    m.scale = VectorXd::Ones(dense.cols());
    m.target = x.transpose() * y;
    m.deviance = y.squaredNorm();
    return m;
  }

  MatrixXd x, acts;
  VectorXd y;
  std::vector<Candidate> sources;
  Hypotheses all;
};

}  // namespace

TEST_CASE("channels that share their noise are one region, columns of several act everywhere") {
  const Arm arm;
  const Regions three(arm.acts, {});
  REQUIRE(three.count() == 3);
  CHECK(three.own(Regions::kEverywhere) == kLinks);
  for (int r = 0; r < 3; ++r) CHECK(three.own(r) == kOwn);
  CHECK(three.of(0) != three.of(1));
  CHECK_FALSE(three.meet(0, 1));
  CHECK(three.meet(0, arm.x.cols() - 1));
  const Regions two(arm.acts, {{0, 2}});
  REQUIRE(two.count() == 2);
  CHECK(two.of(0) == two.of(2));
  CHECK(two.of(1) != two.of(0));
  // Joined one after the other, in any order.
  CHECK(Regions(arm.acts, {{2, 1}, {1, 0}}).count() == 1);
  MatrixXd acts = arm.acts;
  acts.col(5).setZero();
  const Regions without(acts, {});
  CHECK(without.of(5) == Regions::kNowhere);
  CHECK_FALSE(without.meet(5, 5));
}

// Seen red with what errors everywhere take left out, and with the regions' own errors left out
// where columns act everywhere.
TEST_CASE("small errors are the same region by region and all at once") {
  const Arm arm;
  const Moments by_region = arm.moments(Regions(arm.acts, {}));
  const Moments at_once = arm.moments(Regions(arm.x.cols()));
  constexpr double share = 0.05;
  const SmallErrors some(by_region, arm.all, share), same(at_once, arm.all, share);
  std::vector<Index> columns(static_cast<std::size_t>(arm.x.cols()));
  std::iota(columns.begin(), columns.end(), Index{0});
  // Of two shapes the first one stands for both. The variance of rows with these errors, without
  // any products.
  const Index rows = arm.x.rows();
  const MatrixXd covariance =
      MatrixXd::Identity(rows, rows) + share * share * arm.x * arm.x.transpose();
  const MatrixXd exact = arm.x.transpose() * covariance.llt().solve(arm.x);
  CHECK((same.gram(columns, columns) - exact).cwiseAbs().maxCoeff() < 1e-8 * exact.maxCoeff());
  for (int region = 0; region < 3; ++region) {
    const std::vector<Index>& own = by_region.regions().columns(region);
    CHECK((some.gram(own, own) - exact(own, own)).cwiseAbs().maxCoeff() < 1e-8 * exact.maxCoeff());
  }
  const VectorXd target = arm.x.transpose() * covariance.llt().solve(arm.y);
  CHECK((some.target() - target).norm() < 1e-8 * target.norm());
  CHECK(some.log_likelihood() == Approx(same.log_likelihood()).epsilon(1e-10));
}

TEST_CASE("products of columns that cannot meet are not kept") {
  const Arm arm;
  RegionProducts products(Regions(arm.acts, {}));
  const MatrixXd dense = arm.x.transpose() * arm.x;
  std::vector<Index> at(static_cast<std::size_t>(arm.x.cols()));
  std::iota(at.begin(), at.end(), Index{0});
  products.add(at, dense.triangularView<Eigen::Lower>());
  CHECK((products.dense() - dense).cwiseAbs().maxCoeff() < 1e-9);
  products.set(1, 0, 5.0);  // of two channels
  CHECK(products(1, 0) == 0.0);
  // Seen red with the lower half left as it came.
  const RegionProducts by_region(
      Regions(arm.acts, {}),
      [&](const std::vector<Index>& rows, const std::vector<Index>& columns) -> MatrixXd {
        MatrixXd part = dense(rows, columns);
        for (Index r = 0; r < part.rows(); ++r)
          for (Index c = 0; c < part.cols(); ++c)
            if (rows[static_cast<std::size_t>(r)] < columns[static_cast<std::size_t>(c)] &&
                arm.acts.col(rows[static_cast<std::size_t>(r)]) ==
                    arm.acts.col(columns[static_cast<std::size_t>(c)]))
              part(r, c) = 1e9;  // the upper half of a region's is not read
        return part;
      });
  CHECK((by_region.dense() - dense).cwiseAbs().maxCoeff() < 1e-9);
  RegionProducts twice = products;
  twice += products;
  CHECK((twice.dense() - 2.0 * dense).cwiseAbs().maxCoeff() < 1e-9);
  RegionProducts others(dense);
  CHECK((others.dense() - dense).cwiseAbs().maxCoeff() < 1e-9);
  CHECK_THROWS_AS(others += products, std::invalid_argument);
}
