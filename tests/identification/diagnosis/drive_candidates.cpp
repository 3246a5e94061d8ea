// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/diagnosis/drive_candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/regression/baseline.h"
#include "identification/regression/flexible_families.h"
#include "identification/regression/noise_model.h"
#include "identification/regression/position_noise.h"
#include "identification/regression/refine.h"

namespace sinew::test {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Function = std::function<MatrixXd(const Recording&, const VectorXd&)>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Candidate make(const std::string& name, std::vector<NonlinearParameter> nonlinear,
               std::vector<LinearParameter> linear, Function function,
               const std::string& limit = {}) {
  Candidate c;
  c.name = name;
  c.place = "motor";
  c.nonlinear = std::move(nonlinear);
  c.linear = std::move(linear);
  c.columns = [function](const Recording& log, int, const VectorXd& p) { return function(log, p); };
  c.limit_meaning = limit;
  return c;
}

LinearParameter any(const std::string& name) {
  return {name, "", -kInfinity, kInfinity, false, {}};
}
LinearParameter positive(const std::string& name) {
  return {name, "", 0.0, kInfinity, false, {}};
}
LinearParameter own_phase(const std::string& name) {
  return {name, "", -kInfinity, kInfinity, true, {}};
}

ArrayXd velocity(const Recording& log) {
  return log.qd.col(0).array();
}

MatrixXd periodic(const ArrayXd& angle) {
  MatrixXd x(angle.size(), 2);
  x.col(0) = angle.sin();
  x.col(1) = angle.cos();
  return x;
}

/// Friction state that follows the displacement and saturates at 1 within `length` (Dahl).
ArrayXd dahl_state(const Recording& log, double length) {
  ArrayXd z(log.q.rows());
  double state = 0.0;
  for (Index i = 0; i < z.size(); ++i) {
    const double travel = i == 0 ? 0.0 : (log.q(i, 0) - log.q(i - 1, 0)) / length;
    // Exact over one sample for constant speed.
    state = travel >= 0.0 ? 1.0 - (1.0 - state) * std::exp(-travel)
                          : -1.0 + (1.0 + state) * std::exp(travel);
    z(i) = state;
  }
  return z;
}

/// Direction of friction: the state of the baseline's Coulomb friction.
ArrayXd direction(const Recording& log, double length) {
  return dahl_state(log, length);
}

/// 1 while the play is being crossed, else 0: there the load's inertia is not felt.
ArrayXd in_play(const Recording& log, double gap) {
  ArrayXd free(log.q.rows());
  double position = 0.5 * gap;
  for (Index i = 0; i < free.size(); ++i) {
    if (i > 0) position = std::clamp(position + log.q(i, 0) - log.q(i - 1, 0), 0.0, gap);
    free(i) = position > 0.0 && position < gap ? 1.0 : 0.0;
  }
  return free;
}

MatrixXd second_difference(const MatrixXd& x, double step) {
  MatrixXd d = MatrixXd::Zero(x.rows(), x.cols());
  const Index k = std::max<Index>(1, static_cast<Index>(std::lround(2e-3 / step)));
  const double h = static_cast<double>(k) * step;
  for (Index i = k; i + k < x.rows(); ++i)
    d.row(i) = (x.row(i + k) - 2.0 * x.row(i) + x.row(i - k)) / (h * h);
  return d;
}

void add_friction(const DriveScales& s, std::vector<Candidate>& list) {
  const double v = s.speed, soft = s.presliding;
  list.push_back(
      make("viscous asymmetry", {}, {any("difference")},
           [](const Recording& log, const VectorXd&) -> MatrixXd { return velocity(log).abs(); }));
  list.push_back(make(
      "Stribeck friction", {{"Stribeck velocity", "", 0.01 * v, 0.3 * v, 5, true}},
      {positive("extra at rest")},
      [soft](const Recording& log, const VectorXd& p) -> MatrixXd {
        return direction(log, soft) * (-(velocity(log) / p(0)).square()).exp();
      },
      "friction rises, not falls, as the drive starts to move"));
  list.push_back(make(
      "friction concave in speed", {{"bend", "", 0.05 * v, 1.0 * v, 5, true}},
      {positive("plateau")},
      [](const Recording& log, const VectorXd& p) -> MatrixXd {
        return (velocity(log) / p(0)).atan();
      },
      "friction would bend upwards"));
  list.push_back(make(
      "quadratic friction", {}, {positive("coefficient")},
      [](const Recording& log, const VectorXd&) -> MatrixXd {
        return velocity(log) * velocity(log).abs();
      },
      "friction would bend downwards"));
  list.push_back(make(
      "drift of friction", {{"time constant", "s", 0.05 * s.duration, 2.0 * s.duration, 3, true}},
      {any("change")}, [soft](const Recording& log, const VectorXd& p) -> MatrixXd {
        return direction(log, soft) * (-(log.time.array() - log.time(0)) / p(0)).exp();
      }));
  list.push_back(make("friction varies with position", {}, {any("slope")},
                      [soft, s](const Recording& log, const VectorXd&) -> MatrixXd {
                        return direction(log, soft) *
                               (log.q.col(0).array() - 0.5 * (s.low + s.high));
                      }));
  if (s.load > 0.0)
    list.push_back(make(
        "load-dependent friction", {}, {positive("share")},
        [soft](const Recording& log, const VectorXd&) -> MatrixXd {
          return direction(log, soft) * log.load.col(0).array().abs();
        },
        "friction would fall with load"));
}

void add_ripple(const DriveScales& s, double period, const std::string& name, CandidateKind kind,
                bool by_load, std::vector<Candidate>& list) {
  const double rate = 2.0 * std::numbers::pi / period;
  (void)s;
  list.push_back(make(name, {}, {own_phase("sine"), own_phase("cosine")},
                      [rate, by_load](const Recording& log, const VectorXd&) -> MatrixXd {
                        MatrixXd x = periodic(rate * log.q.col(0).array());
                        if (by_load) x = log.load.col(0).cwiseAbs().asDiagonal() * x;
                        return x;
                      }));
  list.back().kind = kind;
  list.back().depends_on = "position, periodic at no known order";
}

void add_ripples(const DriveScales& s, std::vector<Candidate>& list) {
  const auto orders = [&](double period, const std::string& side) {
    if (period <= 0.0) return;
    for (const int k : {1, 2, 3})
      add_ripple(s, period / k, "ripple, " + side + " order " + std::to_string(k),
                 CandidateKind::named, false, list);
    for (const double k : {0.73, 1.37, 2.41})
      add_ripple(s, period / k, side + " ripple off order", CandidateKind::decoy, false, list);
    if (s.load > 0.0)
      add_ripple(s, period, "ripple proportional to load, " + side + " order 1",
                 CandidateKind::named, true, list);
  };
  orders(s.period_in, "input");
  orders(s.period_out, "output");
}

void add_dynamics(const DriveScales& s, std::vector<Candidate>& list) {
  const double reach = s.high - s.low;
  list.push_back(make(
      "gear elasticity", {}, {positive("jounce coefficient")},
      [](const Recording& log, const VectorXd&) -> MatrixXd {
        return second_difference(log.qdd.leftCols(1), log.step);
      },
      "the spring would be negative"));
  list.push_back(make(
      "backlash", {{"gap", "", 1e-4 * reach, 3e-2 * reach, 5, true}},
      {{"inertia behind the gap", "", -kInfinity, 0.0, false, {}}},
      [](const Recording& log, const VectorXd& p) -> MatrixXd {
        return in_play(log, p(0)) * log.qdd.col(0).array();
      },
      "the drive would be heavier inside the gap"));
  Candidate delay = make("delay", {{"delay", "s", -0.02, 0.02, 9, false}}, {positive("delay")}, {},
                         "the force would follow the motion");
  delay.kind = CandidateKind::delay;
  list.push_back(delay);
}

void add_position(const DriveScales& s, std::vector<Candidate>& list) {
  const double middle = 0.5 * (s.low + s.high), half = 0.5 * (s.high - s.low);
  list.push_back(
      make("spring", {}, {any("stiffness")},
           [](const Recording& log, const VectorXd&) -> MatrixXd { return log.q.col(0); }));
  std::vector<LinearParameter> powers;
  for (int k = 1; k <= 7; ++k) {
    powers.push_back(any("degree " + std::to_string(k)));
    powers.back().share = std::pow(0.6, k - 1);  // of smooth torques
  }
  list.push_back(make("position-dependent cable torque", {}, powers,
                      [middle, half](const Recording& log, const VectorXd&) -> MatrixXd {
                        const ArrayXd x =
                            ((log.q.col(0).array() - middle) / half).min(1.0).max(-1.0);
                        MatrixXd t(x.size(), 7);
                        for (int k = 1; k <= 7; ++k)
                          t.col(k - 1) = (static_cast<double>(k) * x.acos()).cos();
                        return t;
                      }));
  list.push_back(make("offset drift", {}, {any("rate")},
                      [](const Recording& log, const VectorXd&) -> MatrixXd {
                        return log.time.array() - log.time(0);
                      }));
  if (s.revolute)
    list.push_back(make("gravity left out", {}, {any("sine"), any("cosine")},
                        [](const Recording& log, const VectorXd&) -> MatrixXd {
                          return periodic(log.q.col(0).array());
                        }));
}

/// What is in every measurement, fitted beside everything as the program does it
/// (driven_library.cpp): friction turns over ways of all lengths, and of the acceleration that
/// which is faster than the motion is the position sensor's noise.
void add_nuisances(const DriveScales& s, std::vector<Candidate>& list) {
  std::vector<double> lengths;
  std::vector<LinearParameter> levels;
  for (const double share : {1e-5, 1e-4, 1e-3, 1e-2}) {
    lengths.push_back(share * (s.high - s.low));
    levels.push_back(any("level " + std::to_string(lengths.size())));
  }
  list.push_back(make("how friction turns at reversals", {}, levels,
                      [lengths, soft = s.presliding](const Recording& log, const VectorXd&) {
                        MatrixXd x(log.q.rows(), static_cast<Index>(lengths.size()));
                        for (std::size_t k = 0; k < lengths.size(); ++k)
                          x.col(static_cast<Index>(k)) =
                              direction(log, lengths[k]) - direction(log, soft);
                        return x;
                      }));
  list.back().kind = CandidateKind::flexible;
  list.back().nuisance = true;
  list.push_back(make("noise of the position sensor", {}, {any("share")},
                      [](const Recording& log, const VectorXd&) -> MatrixXd {
                        const Motion smooth =
                            differentiate(log.q, log.step, smooth_cutoff(log.step));
                        return smooth.qdd - log.qdd;
                      }));
  list.back().nuisance = true;
}

}  // namespace

DriveScales drive_scales(const std::vector<Recording>& logs) {
  DriveScales s;
  s.speed = 0.0;
  s.low = kInfinity;
  s.high = -kInfinity;
  s.duration = 0.0;
  for (const Recording& log : logs) {
    s.speed = std::max(s.speed, log.qd.cwiseAbs().maxCoeff());
    s.low = std::min(s.low, log.q.minCoeff());
    s.high = std::max(s.high, log.q.maxCoeff());
    s.duration = std::max(s.duration, log.step * static_cast<double>(log.q.rows()));
    if (log.load.size() > 0) s.load = std::max(s.load, log.load.cwiseAbs().maxCoeff());
  }
  return s;
}

std::vector<Candidate> drive_baseline(const DriveScales& s) {
  const double reach = s.high - s.low;
  // Every real drive creeps before it slides; a length that is fitted keeps that from being taken
  // for something missing.
  return {
      make("inertia", {}, {positive("inertia")},
           [](const Recording& log, const VectorXd&) -> MatrixXd { return log.qdd.col(0); }),
      make("viscous friction", {}, {positive("coefficient")},
           [](const Recording& log, const VectorXd&) -> MatrixXd { return log.qd.col(0); }),
      make("Coulomb friction", {{"presliding length", "", 1e-5 * reach, 1e-2 * reach, 4, true}},
           {positive("level")},
           [](const Recording& log, const VectorXd& p) -> MatrixXd {
             return dahl_state(log, p(0));
           }),
      make("offset", {}, {any("offset")}, [](const Recording& log, const VectorXd&) -> MatrixXd {
        return VectorXd::Ones(log.q.rows());
      })};
}

double fitted_presliding(const std::vector<Recording>& logs, const DriveScales& scales,
                         const Settings& settings) {
  Problem problem;
  problem.training = logs;
  problem.baseline = drive_baseline(scales);
  const Design design(problem, settings);
  Model model = baseline_model(design);
  refine(design, own_noise(design, model).weights, model);
  return model.terms[2].nonlinear(0);
}

std::vector<Candidate> drive_library(const DriveScales& scales) {
  std::vector<Candidate> list;
  add_friction(scales, list);
  add_ripples(scales, list);
  add_dynamics(scales, list);
  add_position(scales, list);
  add_nuisances(scales, list);
  const FlexibleRanges ranges{scales.low, scales.high, scales.speed, scales.load, scales.duration};
  for (auto* shapes : {flexible_families, local_decoys})
    for (Candidate& shape : shapes(ranges, 0, 0)) list.push_back(std::move(shape));
  return list;
}

}  // namespace sinew::test
