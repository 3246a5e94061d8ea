// SPDX-License-Identifier: GPL-3.0-or-later
// The search over products that are made up, so that it is known where it can get stuck.
#include "identification/likelihood/slot_search.h"

#include <catch2/catch.hpp>

namespace {

using namespace sinew::diagnosis;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Hypotheses of one column each, those with a negative number values of the model's own.
struct MadeUp {
  explicit MadeUp(const std::vector<int>& numbers) : sources(numbers.size()) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      sources[i].name = "cause " + std::to_string(numbers[i]);
      sources[i].linear.resize(1);
      Hypothesis h;
      h.candidate = numbers[i];
      h.source = &sources[i];
      h.log_prior = -11.5;
      h.shapes = {static_cast<int>(i)};
      all.list.push_back(h);
      all.shapes.push_back({static_cast<int>(i), {}, {}, {}});
    }
  }

  Moments moments(const MatrixXd& columns, const VectorXd& y) const {
    Moments m;
    for (Eigen::Index c = 0; c < columns.cols(); ++c) m.of_shape.push_back({c, 1});
    m.coefficient.assign(static_cast<std::size_t>(columns.cols()), 0);
    m.scale = VectorXd::Ones(columns.cols());
    m.gram = columns.transpose() * columns;
    m.target = columns.transpose() * y;
    m.deviance = y.squaredNorm();
    m.rows = 1000.0;
    return m;
  }

  std::vector<Candidate> sources;
  Hypotheses all;
};

std::vector<int> found_of(const Slots& slots) {
  std::vector<int> entries = slots.entries;
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace

// A level and a slope (columns 0 and 1) are hidden. Two forms of friction (2 and 3) together say
// nearly the same, each explains more than the level or the slope does, and beside one of them the
// other is best. Seen red with a search that starts from nothing alone.
TEST_CASE("the model's own values are found where forms stand for them") {
  const MadeUp made({-1, -2, 0, 1});
  constexpr double size = 500.0, missed = 30.0;
  MatrixXd x = MatrixXd::Zero(4, 4);
  x.col(0) << size, 0.0, 0.0, 0.0;
  x.col(1) << 0.0, size, 0.0, 0.0;
  x.col(2) << 0.8 * size, 0.8 * size, 0.5 * size, 0.0;
  x.col(3) << 0.2 * size, 0.2 * size, -0.5 * size, missed;
  const VectorXd y = 0.2 * (x.col(0) + x.col(1));
  const Moments m = made.moments(x, y);
  const SmallErrors errors(m, made.all, 0.0);
  const SlotSearch search(made.all, errors, 8, std::vector<bool>(4, false));
  CHECK(found_of(search.find(Slots{})) == std::vector<int>{2, 3});
  CHECK(found_of(search.find()) == std::vector<int>{0, 1});
}

// A search with other small errors goes on from what the first has found.
TEST_CASE("slots that are given are polished, and dropped where nothing is behind them") {
  const MadeUp made({0, 1, 2});
  MatrixXd x = MatrixXd::Zero(3, 3);
  x.diagonal().setConstant(300.0);
  const VectorXd y = 0.3 * x.col(1);
  const Moments m = made.moments(x, y);
  const SmallErrors errors(m, made.all, 0.0);
  const SlotSearch search(made.all, errors, 8, std::vector<bool>(3, false));
  CHECK(found_of(search.find(Slots{{0, 1}, {0.01, 0.01}, 0.0})) == std::vector<int>{1});
  CHECK(found_of(search.find(Slots{{2}, {0.01}, 0.0})) == std::vector<int>{1});
}
