// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/flexible_families.h"

#include <Eigen/QR>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using Eigen::Index;
using Eigen::VectorXd;
namespace diagnosis = sinew::diagnosis;

TEST_CASE("the way since the last reversal starts anew at every turn and not at rest") {
  const Index count = 4000;
  VectorXd q(count), qd(count), expected(count);
  for (Index i = 0; i < count; ++i) {
    const double phase = 2.0 * std::numbers::pi * static_cast<double>(i) / 1000.0;
    q(i) = -std::cos(phase);
    qd(i) = std::sin(phase);
    const bool forwards = std::fmod(phase, 2.0 * std::numbers::pi) < std::numbers::pi;
    expected(i) = forwards ? q(i) + 1.0 : 1.0 - q(i);
  }
  const VectorXd way = diagnosis::way_since_reversal(q, qd, 0.05);
  // Around a turn the direction is undecided: those samples are left out.
  const double rest = std::asin(0.05);
  for (Index i = 0; i < count; ++i) {
    const double phase = 2.0 * std::numbers::pi * static_cast<double>(i) / 1000.0;
    if (std::abs(std::sin(phase)) <= std::sin(2.0 * rest)) continue;
    INFO(i);
    CHECK(std::abs(way(i) - expected(i)) < 0.01);
  }
  // A pause that does not turn does not start anew.
  VectorXd pause = qd;
  pause.segment(200, 50).setZero();
  const VectorXd again = diagnosis::way_since_reversal(q, pause, 0.05);
  CHECK(std::abs(again(260) - expected(260)) < 0.01);
}

TEST_CASE("splines spread over a range sum to one inside it and stay constant outside") {
  const VectorXd x = VectorXd::LinSpaced(101, -1.5, 2.5);
  const Eigen::MatrixXd basis = diagnosis::spline_basis(x, -1.0, 2.0, 9);
  for (Index i = 0; i < x.size(); ++i) CHECK(std::abs(basis.row(i).sum() - 1.0) < 1e-12);
  CHECK((basis.row(0) - basis.row(5)).norm() < 1e-12);
}

TEST_CASE("a tight spot and a soft stop have decoys of their own") {
  const auto decoys = diagnosis::local_decoys({-1.0, 1.0, 2.0, 0.0, 20.0});
  REQUIRE(decoys.size() == 3);
  diagnosis::Recording log;
  log.q = VectorXd::LinSpaced(201, -1.0, 1.0);
  for (const diagnosis::Candidate& c : decoys) {
    CHECK(c.kind == diagnosis::CandidateKind::decoy);
    CHECK_FALSE(c.depends_on.empty());
    const VectorXd at = c.nonlinear.size() == 2 ? VectorXd(Eigen::Vector2d(0.2, 0.1))
                                                : VectorXd(VectorXd::Constant(1, 0.2));
    const Eigen::MatrixXd x = c.columns(log, 0, at);
    REQUIRE(x.cols() == 1);
    const bool above = c.name.find("above") != std::string::npos;
    const bool below = c.name.find("below") != std::string::npos;
    CHECK((x(0, 0) > 1e-9) == below);
    CHECK((x(200, 0) > 1e-9) == above);
  }
}

TEST_CASE("what the model asks for, by any law and by a share that changes over the log") {
  CHECK(diagnosis::varying_values({-1.0, 1.0, 2.0, 0.0, 20.0}).empty());
  const auto shapes = diagnosis::varying_values({-1.0, 1.0, 2.0, 0.0, 20.0, 3.0});
  REQUIRE(shapes.size() == 3);
  diagnosis::Recording log;
  const Index count = 2001;
  log.time = VectorXd::LinSpaced(count, 5.0, 25.0);
  log.qdd = (3.0 * log.time.array()).sin().matrix();
  log.signals["effort"] = (2.0 * log.time.array()).cos().matrix() * 3.0;
  const VectorXd effort = log.signals["effort"].col(0), a = log.qdd.col(0);
  const Eigen::ArrayXd begun = log.time.array() - log.started();
  // A supply that sags, a torque constant that warms up, a vessel that fills.
  const VectorXd hidden[] = {effort.array() * effort.array().square(),
                             effort.array() * (1.0 - 0.3 * begun / 20.0),
                             a.array() * (1.0 + begun / 20.0)};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    INFO(shapes[i].depends_on);
    CHECK(shapes[i].kind == diagnosis::CandidateKind::flexible);
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::MatrixXd x = shapes[i].columns(log, 0, VectorXd());
      const VectorXd left = hidden[k] - x * x.colPivHouseholderQr().solve(hidden[k]);
      CHECK((left.norm() < 0.02 * hidden[k].norm()) == (i == k));
    }
  }
}

// Seen red with a pause that ends a stroke and with strokes that are not counted.
TEST_CASE("a stroke ends where the velocity has changed its sign, and no pause ends one") {
  VectorXd qd(9);
  qd << 0.0, 1.0, 0.0, 1.0, -1.0, 0.0, -1.0, 0.01, 1.0;
  CHECK(diagnosis::stroke_numbers(qd, 0.05) == std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1, 2});
}

// Seen red with neighbours that do not share.
TEST_CASE("every stroke has a column of its own, neighbours share one where there are too many") {
  const diagnosis::FlexibleRanges ranges{-1.0, 1.0, 1.0, 0.0, 20.0};
  const auto families = diagnosis::flexible_families(ranges);
  const auto by_stroke = std::find_if(families.begin(), families.end(),
                                      [](const auto& c) { return c.depends_on == "the stroke"; });
  REQUIRE(by_stroke != families.end());
  for (const int strokes : {7, 100}) {
    diagnosis::Recording log;
    log.qd.resize(10 * strokes, 1);
    for (Index i = 0; i < log.qd.rows(); ++i) log.qd(i, 0) = (i / 10) % 2 == 0 ? 1.0 : -1.0;
    const Eigen::MatrixXd x = by_stroke->columns(log, 0, VectorXd());
    CHECK((x.rowwise().sum().array() - 1.0).abs().maxCoeff() < 1e-12);
    const Index used = (x.colwise().sum().array() > 0.0).count();
    CHECK(used == std::min<Index>(strokes, x.cols()));
    CHECK(x.colwise().sum().maxCoeff() <= (strokes > x.cols() ? 30.0 : 10.0));
  }
}

// Seen red with a speed that is the present one, and with a velocity in place of the direction.
TEST_CASE("friction by the recent speed is what motion has warmed up and rest has cooled") {
  const auto families = diagnosis::flexible_families({-1.0, 1.0, 1.0, 0.0, 40.0});
  const auto recent = std::find_if(families.begin(), families.end(), [](const auto& c) {
    return c.depends_on == "recent speed x direction";
  });
  REQUIRE(recent != families.end());
  diagnosis::Recording log;
  log.step = 0.01;
  log.qd.resize(4000, 1);
  VectorXd friction(4000);
  double warm = 0.0;
  for (Index i = 0; i < 4000; ++i) {
    const double t = log.step * static_cast<double>(i);
    log.qd(i, 0) = (i / 800) % 2 == 0 ? std::cos(3.0 * t) : 0.2 * std::cos(3.0 * t);
    warm += (1.0 - std::exp(-log.step / 2.0)) * (std::abs(log.qd(i, 0)) - warm);
    friction(i) = std::tanh(log.qd(i, 0) / 0.01) * (1.0 - warm);
  }
  const Eigen::MatrixXd x = recent->columns(log, 0, VectorXd::Constant(1, 2.0));
  const VectorXd left = friction - x * x.colPivHouseholderQr().solve(friction);
  CHECK(left.norm() < 1e-9 * friction.norm());
  const Eigen::MatrixXd other = recent->columns(log, 0, VectorXd::Constant(1, 0.2));
  const VectorXd more = friction - other * other.colPivHouseholderQr().solve(friction);
  CHECK(more.norm() > 0.01 * friction.norm());
}

TEST_CASE("many logs have no more columns for their strokes than one") {
  diagnosis::FlexibleRanges ranges{-1.0, 1.0, 1.0, 0.0, 20.0};
  for (const int logs : {1, 3, 20}) {
    ranges.stretches = logs;
    for (const auto& c : diagnosis::flexible_families(ranges))
      if (c.depends_on.starts_with("the stroke")) {
        CHECK(static_cast<int>(c.linear.size()) * logs <= 40);
        CHECK(c.linear.front().per_stretch);  // strokes are counted from each stretch's start
      }
  }
}

// A ripple's phase is one for a log, however many stretches are read of it; a stroke's level is
// each stretch's own. Seen red with phases of each stretch, eighteen columns a period.
TEST_CASE("what swings has a phase for each log, strokes have levels for each stretch") {
  for (const diagnosis::Candidate& c :
       diagnosis::flexible_families({-1.0, 1.0, 2.0, 0.0, 20.0, 3.0}, 0, 0)) {
    INFO(c.name);
    const bool swings =
        c.name == "any period in position" || c.name == "friction swinging at any rate";
    const bool strokes = c.name.find("stroke") != std::string::npos;
    for (const diagnosis::LinearParameter& p : c.linear) {
      CHECK(p.per_log == (swings || strokes));
      CHECK(p.per_stretch == strokes);
    }
  }
}
