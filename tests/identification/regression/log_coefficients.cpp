// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "identification/regression/design.h"

using namespace sinew::diagnosis;

namespace {

Recording stretch(const std::string& name, const std::string& log) {
  constexpr Eigen::Index rows = 2000;
  Recording r;
  r.name = name;
  r.log = log;
  r.step = 0.01;
  r.time = Eigen::VectorXd::LinSpaced(rows, 0.0, r.step * (rows - 1));
  r.q = r.qd = r.qdd = Eigen::MatrixXd::Zero(rows, 1);
  r.target = {Eigen::VectorXd(r.time.array().sin())};
  return r;
}

std::vector<int> owners(const Design& design, const Candidate& candidate) {
  std::vector<int> list;
  for (const Design::Coefficient& c : design.coefficients(candidate)) list.push_back(c.recording);
  return list;
}

}  // namespace

// A log of which stretches are read keeps its encoder's zero. Seen red with a coefficient for each
// stretch, which gave a ripple of a long log eighteen columns a shape.
TEST_CASE("a coefficient of each log is one for all stretches of a log") {
  Problem problem;
  problem.training = {stretch("a part 1", "a"), stretch("a part 2", "a"), stretch("b", "b")};
  problem.holdout = {stretch("a part 3", "a"), stretch("c", ""), stretch("d", "")};
  Candidate ripple;
  ripple.name = "ripple";
  ripple.linear.resize(1);
  ripple.linear.front().per_log = true;
  ripple.columns = [](const Recording& log, int, const Eigen::VectorXd&) -> Eigen::MatrixXd {
    return log.time.array().cos().matrix();
  };
  Settings settings;
  settings.edge_s = 0.2;
  const Design design(problem, settings);
  // A held-out log is another one, whatever its name.
  CHECK(owners(design, ripple) == std::vector<int>{0, 2, 3, 4, 5});
  const BandColumns columns = design.columns(ripple, Eigen::VectorXd());
  REQUIRE(columns.size() == 6);
  CHECK(columns[1].col(0).norm() > 0.0);
  CHECK(columns[1].rightCols(4).norm() == 0.0);
  CHECK(columns[2].col(0).norm() == 0.0);
  CHECK(columns[2].col(1).norm() > 0.0);
}

// The first stroke of one stretch is not that of the next. Seen red with one level for both.
TEST_CASE("what counts from the start of a stretch has a coefficient for each stretch") {
  Problem problem;
  problem.training = {stretch("a part 1", "a"), stretch("a part 2", "a")};
  Candidate stroke;
  stroke.name = "first stroke";
  stroke.linear.resize(1);
  stroke.linear.front().per_log = stroke.linear.front().per_stretch = true;
  stroke.columns = [](const Recording& log, int, const Eigen::VectorXd&) -> Eigen::MatrixXd {
    return log.time.array().cos().matrix();
  };
  Settings settings;
  settings.edge_s = 0.2;
  const Design design(problem, settings);
  CHECK(owners(design, stroke) == std::vector<int>{0, 1});
  const BandColumns columns = design.columns(stroke, Eigen::VectorXd());
  CHECK(columns[1].col(0).norm() == 0.0);
  CHECK(columns[1].col(1).norm() > 0.0);
}
