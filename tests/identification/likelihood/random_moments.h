// SPDX-License-Identifier: GPL-3.0-or-later
// A search's products that are drawn by chance, and whether two fits of them are the same.
#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>
#include <vector>

#include "identification/likelihood/slot_model.h"

namespace sinew::diagnosis {

/// Six hypotheses, the first of three columns, the second of three shapes, with random products: of
/// one joint, or the first two of one joint, the next two of another, and the last two of both.
struct Random {
  explicit Random(bool of_two_joints = false) : sources(6) {
    const std::vector<std::vector<int>> shapes{{0}, {1, 2, 3}, {4}, {5}, {6}, {7}};
    for (std::size_t h = 0; h < sources.size(); ++h) {
      sources[h].name = "cause " + std::to_string(h);
      sources[h].place = "joint";
      sources[h].linear.resize(h == 0 ? 3 : 1);
      Hypothesis one;
      one.candidate = static_cast<int>(h);
      one.source = &sources[h];
      one.log_prior = -2.0;
      one.shapes = shapes[h];
      all.list.push_back(one);
      for (std::size_t s = 0; s < shapes[h].size(); ++s)
        all.shapes.push_back({static_cast<int>(h), {}, {}, {}});
    }
    sources[1].nonlinear = {{"speed", "rad/s", 0.1, 10.0, 3, true}};
    for (const auto& [shape, at] : {std::pair{1, 0.1}, {2, 1.0}, {3, 10.0}})
      all.shapes[static_cast<std::size_t>(shape)].nonlinear = Eigen::VectorXd::Constant(1, at);
    std::srand(7);
    Eigen::MatrixXd x = 20.0 * Eigen::MatrixXd::Random(40, 10);
    const Eigen::VectorXd y = 20.0 * Eigen::VectorXd::Random(40);
    Eigen::MatrixXd acts = Eigen::MatrixXd::Ones(2, 10);
    if (of_two_joints) {
      x.block(20, 0, 20, 6).setZero();
      x.block(0, 6, 20, 2).setZero();
      acts.row(1).head(6).setZero();
      acts.row(0).segment(6, 2).setZero();
    }
    m.of_shape = {{0, 3}, {3, 1}, {4, 1}, {5, 1}, {6, 1}, {7, 1}, {8, 1}, {9, 1}};
    m.coefficient = {0, 1, 2, 0, 0, 0, 0, 0, 0, 0};
    m.scale = Eigen::VectorXd::Ones(10);
    const Eigen::MatrixXd products = x.transpose() * x;
    m.gram = RegionProducts(of_two_joints ? Regions(acts, {}) : Regions(10));
    for (Eigen::Index c = 0; c < 10; ++c)
      for (Eigen::Index r = c; r < 10; ++r) m.gram.set(r, c, products(r, c));
    m.target = x.transpose() * y;
    m.deviance = y.squaredNorm();
    m.rows = 40.0;
  }

  std::vector<Candidate> sources;
  Hypotheses all;
  Moments m;
};

/// Whether two fits of a model are the same up to rounding.
inline void check_same(const SlotModel& model, const SlotModel::Fit& made,
                       const SlotModel::Fit& anew) {
  CHECK(made.slots.entries == anew.slots.entries);
  CHECK((made.coefficients - anew.coefficients).norm() < 1e-10 * anew.coefficients.norm());
  CHECK((made.inverse - anew.inverse).norm() < 1e-10 * anew.inverse.norm());
  CHECK((made.target - anew.target).norm() < 1e-10 * anew.target.norm());
  const std::vector<double> odds = model.log_odds(made, false);
  const std::vector<double> wanted = model.log_odds(anew, false);
  for (std::size_t e = 0; e < odds.size(); ++e) {
    CHECK((odds[e] == kNoOdds) == (wanted[e] == kNoOdds));
    if (wanted[e] != kNoOdds) CHECK(odds[e] == Approx(wanted[e]).margin(1e-8));
    const auto entry = static_cast<int>(e);
    if (!Regions::can_meet(model.region_of(entry), anew.region)) continue;
    const double variance = model.factor(entry, anew).variance;
    CHECK(model.stays_possible(made, entry, variance) ==
          model.stays_possible(anew, entry, variance));
  }
}

}  // namespace sinew::diagnosis
