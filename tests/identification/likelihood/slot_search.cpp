// SPDX-License-Identifier: GPL-3.0-or-later
// The search over products that are made up, so that it is known where it can get stuck.
#include "identification/likelihood/slot_search.h"

#include <algorithm>
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
    m.gram = RegionProducts(MatrixXd(columns.transpose() * columns));
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
  // Where another search has left them: seen red with rivals of single slots alone.
  CHECK(found_of(search.from_rivals(search.find(Slots{}))) == std::vector<int>{0, 1});
}

// The cause fits a little better, by less than what tells two names apart. Seen red with the best
// one as it is.
TEST_CASE("of names that are not told apart the model's own value is told") {
  const MadeUp made({0, -1});
  MatrixXd x = MatrixXd::Zero(2, 2);
  x.col(0) << 500.0, 0.0;
  x.col(1) << 500.0, 5.0;
  const Moments m = made.moments(x, 0.3 * x.col(0));
  const SmallErrors errors(m, made.all, 0.0);
  const SlotSearch search(made.all, errors, 8, std::vector<bool>(2, false));
  const Slots found = search.from_rivals(search.find());
  REQUIRE(found_of(found) == std::vector<int>{0});
  CHECK(search.credible(found, 0).size() == 2);
  CHECK(found_of(search.with_names(found)) == std::vector<int>{1});
}

// A sensor's offset is none: the likelier name stays. Seen red with all deviations before others:
// the spring of a lone joint was told as its sensor's offset, a low-pass as a delay.
TEST_CASE("a sensor's reading is told where it is the likeliest name alone") {
  MadeUp made({0, -1});
  made.sources[1].of_sensor = true;
  MatrixXd x = MatrixXd::Zero(2, 2);
  x.col(0) << 500.0, 0.0;
  x.col(1) << 500.0, 5.0;
  const auto told = [&](int hidden) {
    const Moments m = made.moments(x, 0.3 * x.col(hidden));
    const SmallErrors errors(m, made.all, 0.0);
    const SlotSearch search(made.all, errors, 8, std::vector<bool>(2, false));
    return found_of(search.with_names(search.from_rivals(search.find())));
  };
  CHECK(told(0) == std::vector<int>{0});
  CHECK(told(1) == std::vector<int>{1});
}

// Where logs tell a combination only: seen red where the first of two that are as good is told.
TEST_CASE("of a rotor and a body that are not told apart the rotor is told") {
  MadeUp made({-1, -2});
  made.sources[0].of_body = true;
  const MatrixXd x = MatrixXd::Constant(1, 2, 500.0);
  const Moments m = made.moments(x, 0.3 * x.col(0));
  const SmallErrors errors(m, made.all, 0.0);
  const SlotSearch search(made.all, errors, 8, std::vector<bool>(2, false));
  const Slots found = search.from_rivals(search.find());
  REQUIRE(found.entries.size() == 1);
  CHECK(search.credible(found, 0).size() == 2);
  CHECK(found_of(search.with_names(found)) == std::vector<int>{1});
}

// Structure that fits a hundredth more of what is left over. A law may be off by a twenty-fifth, a
// value of the model is off by nothing. Seen red with one share for both: a force sensor that
// saturates was told as its scale, whose odds lacked less than that.
TEST_CASE("a law may lack something against structure, a value of the model nothing") {
  MadeUp made({0, 1});
  made.all.list[1].named = false;
  MatrixXd x = MatrixXd::Zero(2, 2);
  x.col(0) << 500.0, 0.0;
  x.col(1) << 500.0, 50.0;
  const Moments m = made.moments(x, 0.3 * x.col(1));
  const SmallErrors errors(m, made.all, 0.0);
  const auto told = [&](bool is_law) {
    made.all.list[0].is_law = is_law;
    SlotSearch search(made.all, errors, 8, std::vector<bool>(2, false));
    const Slots found = search.find(Slots{});
    REQUIRE(found_of(found) == std::vector<int>{1});
    search.set_names_alone(true);
    CHECK((search.may_lack(search.find(Slots{})) > 0.0) == is_law);
    search.set_names_alone(false);
    return found_of(search.with_names(found));
  };
  CHECK(told(true) == std::vector<int>{0});
  CHECK(told(false) == std::vector<int>{1});
}

// What a link carries and what its drawing has wrong. Seen red where each is a cause by itself.
TEST_CASE("of two hypotheses of one body one is told") {
  MadeUp made({0, 1, 2});
  for (std::size_t i = 0; i < 3; ++i) {
    made.sources[i].place = "link";
    made.sources[i].of_body = i < 2;
  }
  const MatrixXd x = 500.0 * MatrixXd::Identity(3, 3);
  const Moments m = made.moments(x, 0.3 * x.rowwise().sum());
  const SmallErrors errors(m, made.all, 0.0);
  const SlotSearch search(made.all, errors, 8, std::vector<bool>(3, false));
  const std::vector<int> found = found_of(search.find());
  REQUIRE(found.size() == 2);
  CHECK(found.back() == 2);
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

// Seen red with limits looked at for what is added alone.
TEST_CASE("what is added may not push what was found beyond its limits") {
  constexpr double size = 400.0, apart = 80.0;
  MatrixXd x = MatrixXd::Zero(3, 3);
  x.col(0) << size, apart, 0.0;
  x.col(1) << size, 0.0, 0.0;
  x.col(2) << 0.0, 0.0, size;
  const VectorXd y = 0.5 * x.col(0) - 0.2 * x.col(1);
  const auto is_rival = [&](double low) {
    MadeUp made({0, 1, 2});
    made.sources[1].linear[0].low = low;
    const Moments m = made.moments(x, y);
    const SmallErrors errors(m, made.all, 0.0);
    const SlotSearch search(made.all, errors, 8, std::vector<bool>(3, false));
    const std::vector<Rival> list = search.rivals({{1, 2}, {0.01, 0.01}, 0.0}, 1);
    return std::any_of(list.begin(), list.end(), [](const Rival& r) { return r.hypothesis == 0; });
  };
  CHECK(is_rival(-1.0));
  CHECK_FALSE(is_rival(0.0));
}

// Two joints with two causes each that resemble each other, and a link that acts on both.
TEST_CASE("joints that do not meet are searched each by itself, and what acts on both with them") {
  const MadeUp made({0, 1, 2, 3, 4});
  constexpr double size = 300.0;
  MatrixXd x = MatrixXd::Zero(6, 5), acts = MatrixXd::Zero(2, 5);
  x.col(0).head(3) << size, 0.0, 0.0;
  x.col(1).head(3) << 0.9 * size, 0.3 * size, 0.0;
  x.col(2).tail(3) << size, 0.0, 0.0;
  x.col(3).tail(3) << 0.9 * size, 0.3 * size, 0.0;
  x.col(4) << 0.0, 0.0, size, 0.0, 0.0, size;
  acts.row(0) << 1.0, 1.0, 0.0, 0.0, 1.0;
  acts.row(1) << 0.0, 0.0, 1.0, 1.0, 1.0;
  const VectorXd y = 0.2 * x.col(1) + 0.2 * x.col(2) + 0.1 * x.col(4);
  const auto found = [&](const Regions& regions) {
    Moments m = made.moments(x, y);
    const MatrixXd dense = m.gram.dense();
    m.gram = RegionProducts(regions);
    for (Eigen::Index c = 0; c < 5; ++c)
      for (Eigen::Index r = c; r < 5; ++r) m.gram.set(r, c, dense(r, c));
    const SmallErrors errors(m, made.all, 1e-3);
    const SlotSearch search(made.all, errors, 8, std::vector<bool>(5, false));
    const Slots slots = search.from_rivals(search.find());
    CHECK(slots.log_posterior > 0.0);
    return std::pair{found_of(slots), slots.log_posterior};
  };
  const auto by_joint = found(Regions(acts, {})), at_once = found(Regions(5));
  CHECK(by_joint.first == std::vector<int>{1, 2, 4});
  CHECK(at_once.first == by_joint.first);
  CHECK(by_joint.second == Approx(at_once.second).epsilon(1e-9));
}
