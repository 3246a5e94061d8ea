// SPDX-License-Identifier: GPL-3.0-or-later
// Ripples at driven joints: at which orders of their shafts they are looked for.
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "identification/logs/filter.h"
#include "identification/regression/flexible_families.h"
#include "identification/regression/order_spectrum.h"
#include "identification/regression/standstill.h"
#include "identification/subjects/driven_subject.h"
#include "symbolic/effects/effects.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// These are looked for whatever the logs show.
constexpr int kLowOrders = 3;
// What a spectrum may show besides: as many as a shaft has teeth, poles or slots.
constexpr int kHighestOrder = 120;
constexpr std::size_t kMostFound = 4;

VectorXd number(double value) {
  return VectorXd::Constant(1, value);
}

/// Splines in position, speed and load, with and without the direction.
MatrixXd smooth_columns(const Recording& log, const std::vector<Candidate>& families, int channel) {
  std::vector<MatrixXd> parts{MatrixXd::Ones(log.q.rows(), 1)};
  for (const Candidate& c : families)
    if (c.nonlinear.empty() && c.depends_on.find("time") == std::string::npos)
      parts.push_back(c.columns(log, channel, VectorXd()));
  Index wide = 0;
  for (const MatrixXd& part : parts) wide += part.cols();
  MatrixXd all(log.q.rows(), wide);
  wide = 0;
  for (const MatrixXd& part : parts) {
    all.middleCols(wide, part.cols()) = part;
    wide += part.cols();
  }
  return all;
}

/// Least squares by the samples that count.
VectorXd fitted(const MatrixXd& columns, const VectorXd& target, const VectorXd& counts) {
  constexpr double least = 1e-9;  // of a column's energy: splines that nothing moves through
  const MatrixXd counted = counts.asDiagonal() * columns;
  MatrixXd gram = counted.transpose() * counted;
  gram.diagonal().array() += least * std::max(gram.diagonal().maxCoeff(), 1e-300);
  return gram.llt().solve(VectorXd(counted.transpose() * counts.cwiseProduct(target)));
}

bool is_whole(double order) {
  return order > 0.5 && std::abs(order - std::round(order)) < 1e-6;
}

}  // namespace

/// Above what a drive's control follows, a ripple moves the masses and shows in their acceleration
/// alone: accelerations up to three tenths of the sampling rate, and the model's effort with them.
void DrivenSubject::add_fast_motion(Recording& log) const {
  constexpr double kFast = 0.3;  // lines of fifteen joints stand out less with 0.12 and 0.2
  const MatrixXd fast = differentiate(log.signals.at("logged_q"), log.step, kFast / log.step).qdd;
  log.signals[fast_acceleration] = fast;
  log.signals[effort_of_fast_motion] = known_(log, log.q, log.qd, fast);
}

ShaftLog DrivenSubject::shaft_log(std::size_t joint, double turn, const Recording& log) const {
  const auto axis = static_cast<int>(joint);
  ShaftLog shaft;
  shaft.turns = log.q.col(axis) / turn;
  shaft.counts = motion_window(log.standstills[joint], log.time);
  shaft.value = log.target[joint] - log.signals.at(effort_of_fast_motion).col(axis);
  const MatrixXd smooth = smooth_columns(log, flexible_families(ranges(joint), axis, axis), axis);
  const MatrixXd& slow = log.acceleration();
  MatrixXd columns(slow.rows(), slow.cols() + smooth.cols());
  columns << slow, smooth;
  const VectorXd of_columns = fitted(columns, shaft.value, shaft.counts);
  // What the model's masses are off by is told by accelerations that are no noise, and holds for
  // faster ones.
  columns.leftCols(slow.cols()) = log.signals.at(fast_acceleration);
  shaft.value -= columns * of_columns;
  if (!log.band_hz.empty()) shaft.fastest = log.band_hz[joint] * log.step;
  return shaft;
}

/// Above the low orders.
std::vector<OrderLine> DrivenSubject::lines_found(std::size_t joint, double turn) const {
  std::vector<ShaftLog> logs;
  for (const Recording& log : logged_training_) {
    const auto q = log.q.col(static_cast<Index>(joint));
    if (!(q.maxCoeff() - q.minCoeff() >= kLeastTurns * turn)) continue;
    logs.push_back(shaft_log(joint, turn, log));
  }
  const std::vector<OrderLine> lines = order_lines(logs, kLowOrders + 1, kHighestOrder);
  const double motor = model_.joints[joint].motor_turn;
  std::vector<OrderLine> own;
  for (const OrderLine& line : lines) {
    // The same ripple is one of the motor's orders and, by the gear's ratio, one of the output's.
    if (motor > 0.0 && motor < turn && is_whole(line.order * motor / turn)) continue;
    // No ripple is a pure sine: harmonics of a stronger line are its form.
    const auto is_harmonic = [&](const OrderLine& other) { return line.order % other.order == 0; };
    if (own.size() < kMostFound && std::none_of(own.begin(), own.end(), is_harmonic))
      own.push_back(line);
  }
  return own;
}

/// Where the model does not say how far a turn of the motor moves the joint.
void DrivenSubject::add_ripple_of_any_period(std::size_t joint) {
  const EffectPlace where{static_cast<int>(joint), place(joint), model_.joints[joint].revolute};
  Candidate c = effect_candidate(find_effect("ripple"), where, scale(joint));
  const NonlinearParameter visible = visible_periods(ranges(joint));
  NonlinearParameter& wavenumber = c.nonlinear.front();
  wavenumber.low = 2.0 * std::numbers::pi * visible.low;
  wavenumber.high = 2.0 * std::numbers::pi * visible.high;
  wavenumber.grid = visible.grid;
  wavenumber.logarithmic = false;
  problem_.library.push_back(std::move(c));
  library_.push_back({"ripple", joint, {}, {}});
}

/// Once to three times a turn, as often as the shaft's parts say, and where the logs show a line.
void DrivenSubject::add_orders(std::size_t joint, double turn, const std::string& shaft,
                               const std::vector<int>& known) {
  if (turn <= 0.0) return;
  const double rate = 2.0 * std::numbers::pi / turn;
  // A link that turns under gravity has its weight once a turn.
  const bool weight = is_lone_link() && shaft == "output";
  // Less than half a period is a bend as any other: it need not come again.
  const LogScale s = scale(joint);
  const auto shows = [&](double order) { return order * (s.high - s.low) > 0.5 * turn; };
  const auto often = [&](int k) {
    return k == 1 ? std::string("once") : fmt::format("{} times", k);
  };
  const auto take = [&](const char* effect, const std::string& name, double order,
                        CandidateKind kind = CandidateKind::named) {
    if (!shows(order)) return false;
    add(effect, joint, name, number(rate * order), kind);
    return true;
  };
  std::set<int> orders{1, 2, 3};
  orders.insert(known.begin(), known.end());
  const std::vector<OrderLine> lines = lines_found(joint, turn);
  for (const OrderLine& line : lines) orders.insert(line.order);
  for (const int k : orders)
    if (take("ripple", fmt::format("ripple {} per {} turn", often(k), shaft), k)) {
      problem_.library.back().unlikely = weight && k == 1;
      for (const OrderLine& line : lines)
        if (line.order == k)
          lines_.push_back({joint, turn, line, static_cast<int>(problem_.library.size()) - 1});
    }
  for (const double k : {0.73, 1.37, 2.41})
    take("ripple", fmt::format("ripple off every order of the {}", shaft), k, CandidateKind::decoy);
  if (!(s.load > 0.0) && !carries_links(joint)) return;
  for (const int k : orders)
    if (k == 1 || k > kLowOrders)
      take("load_ripple",
           fmt::format("ripple proportional to load, {} per {} turn", often(k), shaft), k);
}

void DrivenSubject::add_ripples(std::size_t joint) {
  const DrivenJoint& driven = model_.joints[joint];
  if (driven.motor_turn > 0.0)
    add_orders(joint, driven.motor_turn, "motor", driven.motor_orders);
  else
    add_ripple_of_any_period(joint);
  add_orders(joint, driven.output_turn, "output", driven.output_orders);
}

}  // namespace sinew::diagnosis
