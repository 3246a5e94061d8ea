// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/contacts/disturbances.h"

#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What is looked for, and how finely. Pushes of 7 to 10 times the noise were to be found; at 3
// times the rms what friction does as a joint sets out was found as well.
constexpr double kTimesUsual = 4.0;  // rms
constexpr double kCell = 0.05;       // s: a knock lasts longer
constexpr double kPeriods = 1.5;     // of the band's edge: a cell has three independent samples
constexpr double kPause = 0.25;      // s: a longer one parts two disturbances, or two visits
constexpr double kMaterial = 0.01;   // of the channel's rms: as for bursts (unquiet_channels.cpp)
// Definitions: what most, half, usual and often are.
constexpr double kFriction = 0.8;   // of the cells in which friction holds a joint are usual
constexpr double kMost = 0.5;       // of the training logs
constexpr double kComesBack = 0.5;  // of the neighbours in state, beyond chance
constexpr Index kNeighbours = 16;
constexpr int kOften = 3;      // disturbances: what comes back does so more than once
constexpr double kMuch = 0.1;  // of all that is disturbed

/// Samples of one cell.
Index cell_length(const LeftOver& r) {
  return std::max<Index>(
      2, static_cast<Index>(std::lround(r.rate_hz * std::max(kCell, kPeriods / r.band_hz))));
}

/// Whether a joint moves all through a cell. A lone joint's friction holds all of its effort at
/// rest: it moves as far around the cell as the filter reaches, or what held it is left over there.
bool moves(const LeftOver& r, int channel, Index first, Index length) {
  const bool lone = r.residual.cols() == 1;
  const auto reach = lone ? static_cast<Index>(std::ceil(r.reach * r.rate_hz)) : Index{0};
  const Index from = std::max<Index>(0, first - reach),
              to = std::min(r.time.size(), first + length + reach);
  return (r.counts.col(channel).segment(from, to - from).array() == 1.0).all();
}

double rms_in(const MatrixXd& x, int channel, Index first, Index length) {
  return x.col(channel).segment(first, length).norm() / std::sqrt(static_cast<double>(length));
}

double mean_square(const LeftOver& r, int channel, Index first, Index length) {
  const double rms = rms_in(r.residual, channel, first, length);
  return rms * rms;
}

/// The value that a share of the others is below.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Levels at first: of most cells. At standstill next to nothing is left over, or as much as
/// friction holds: the latter is what counts, and stays.
UsualLevels first_levels(const std::vector<LeftOver>& logs, bool held_out) {
  const auto channels = logs.front().residual.cols();
  UsualLevels usual{VectorXd::Zero(channels), VectorXd::Zero(channels)};
  for (int c = 0; c < static_cast<int>(channels); ++c) {
    std::vector<double> moving, standing;
    for (const LeftOver& r : logs) {
      const Index length = cell_length(r);
      for (Index k = 0; r.held_out == held_out && k + length <= r.time.size(); k += length)
        (moves(r, c, k, length) ? moving : standing).push_back(mean_square(r, c, k, length));
    }
    const double level = quantile(moving, 0.5);
    std::erase_if(standing, [&](double square) { return square < level; });
    usual.moving(c) = std::sqrt(level);
    usual.standing(c) = std::sqrt(std::max(level, quantile(standing, kFriction)));
  }
  return usual;
}

/// In motion, of all that is not set aside.
VectorXd moving_level(const Disturbances& d, bool held_out) {
  VectorXd sum = VectorXd::Zero(d.left_over.front().residual.cols()), weight = sum;
  for (std::size_t i = 0; i < d.left_over.size(); ++i) {
    const LeftOver& r = d.left_over[i];
    if (r.held_out != held_out) continue;
    const VectorXd in = (!d.aside[i]).cast<double>().matrix();
    sum += r.residual.cwiseProduct(r.counts).cwiseAbs2().transpose() * in;
    weight += r.counts.cwiseAbs2().transpose() * in;
  }
  return sum.cwiseQuotient(weight.cwiseMax(1e-300)).cwiseSqrt();
}

/// What the filter spreads of an event belongs to it, and so does a short pause.
void widen(const LeftOver& r, SetAside& aside) {
  const auto reach = static_cast<Index>(std::ceil(r.reach * r.rate_hz));
  const auto pause = static_cast<Index>(kPause * r.rate_hz);
  Index last = -1;  // that is set aside
  for (Index k = 0; k < aside.size(); ++k) {
    if (!aside(k)) continue;
    if (last >= 0 && k - last <= pause) aside.segment(last, k - last) = true;
    last = k;
  }
  const SetAside core = aside;
  for (Index k = 0; k < core.size(); ++k) {
    if (!core(k)) continue;
    const Index from = std::max<Index>(0, k - reach), to = std::min(core.size(), k + reach + 1);
    aside.segment(from, to - from) = true;
  }
}

SetAside disturbed(const LeftOver& r, const UsualLevels& usual, const VectorXd& material) {
  SetAside aside = SetAside::Constant(r.time.size(), false);
  const Index length = cell_length(r);
  for (Index k = 0; k + length <= r.time.size(); k += std::max<Index>(1, length / 2))
    for (int c = 0; c < static_cast<int>(material.size()); ++c) {
      const double level = moves(r, c, k, length) ? usual.moving(c) : usual.standing(c);
      const double least = std::max(kTimesUsual * level, material(c));
      if (rms_in(r.residual, c, k, length) > least) aside.segment(k, length) = true;
    }
  widen(r, aside);
  return aside;
}

std::vector<Disturbance> stretches(const std::vector<SetAside>& aside) {
  std::vector<Disturbance> list;
  for (std::size_t i = 0; i < aside.size(); ++i)
    for (Index k = 0; k < aside[i].size(); ++k) {
      if (!aside[i](k)) continue;
      if (k == 0 || !aside[i](k - 1)) list.push_back({i, k, k});
      list.back().last = k + 1;
    }
  return list;
}

double share_aside(const std::vector<LeftOver>& logs, const std::vector<SetAside>& aside) {
  double all = 0.0, set = 0.0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    if (logs[i].held_out) continue;
    all += static_cast<double>(aside[i].size());
    set += static_cast<double>(aside[i].count());
  }
  return set / std::max(all, 1.0);
}

/// The channel that is disturbed most.
int most_disturbed(const Disturbances& d) {
  VectorXd excess = VectorXd::Zero(d.training.moving.size());
  for (const Disturbance& one : d.list)
    excess += d.left_over[one.recording]
                  .residual.middleRows(one.first, one.last - one.first)
                  .colwise()
                  .squaredNorm()
                  .transpose()
                  .cwiseQuotient(d.training.moving.cwiseAbs2().cwiseMax(1e-300));
  Index channel = 0;
  excess.maxCoeff(&channel);
  return static_cast<int>(channel);
}

/// Position, velocity and what the model asks for, each by its own spread: samples x 3.
MatrixXd state(const LeftOver& r, int channel) {
  MatrixXd x(r.time.size(), 3);
  x << r.position.col(channel), r.velocity.col(channel),
      r.measured.col(channel) - r.residual.col(channel);
  x.rowwise() -= x.colwise().mean().eval();
  for (Index c = 0; c < x.cols(); ++c)
    x.col(c) /= std::max(std::sqrt(x.col(c).squaredNorm() / static_cast<double>(x.rows())), 1e-300);
  return x;
}

/// Of the samples whose state is nearest to that of one, all but those around its own stretch, the
/// share that is disturbed.
double disturbed_neighbours(const MatrixXd& x, const SetAside& aside, Index sample, Index first,
                            Index last) {
  std::vector<std::pair<double, Index>> others;
  for (Index k = 0; k < x.rows(); ++k)
    if (k < first || k >= last) others.emplace_back((x.row(k) - x.row(sample)).squaredNorm(), k);
  const auto nearest = std::min<std::size_t>(kNeighbours, others.size());
  if (nearest == 0) return 0.0;
  std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(nearest),
                    others.end());
  Index count = 0;
  for (std::size_t i = 0; i < nearest; ++i) count += aside(others[i].second) ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(nearest);
}

/// How much likelier than by chance a sample is disturbed where one of nearly the same state is: 1
/// where the state alone tells, 0 where it tells nothing.
double told_by_state(const Disturbances& d) {
  const int channel = most_disturbed(d);
  double sum = 0.0, by_chance = 0.0, count = 0.0;
  int times = 0;
  for (const Disturbance& one : d.list) {
    const LeftOver& r = d.left_over[one.recording];
    if (r.held_out) continue;
    ++times;
    const MatrixXd x = state(r, channel);
    const auto own = static_cast<Index>(kPause * r.rate_hz);
    const SetAside& aside = d.aside[one.recording];
    const double chance = static_cast<double>(aside.count()) / static_cast<double>(aside.size());
    for (Index k = one.first; k < one.last; ++k) {
      sum += disturbed_neighbours(x, aside, k, one.first - own, one.last + own);
      by_chance += chance;
      count += 1.0;
    }
  }
  if (times < kOften) return 0.0;
  return count > by_chance ? std::max(0.0, (sum - by_chance) / (count - by_chance)) : 0.0;
}

}  // namespace

bool differ(const Disturbances& one, const Disturbances& other) {
  Index either = 0, both = 0;
  for (std::size_t i = 0; i < one.aside.size(); ++i) {
    either += (one.aside[i] || other.aside[i]).count();
    both += (one.aside[i] && other.aside[i]).count();
  }
  return static_cast<double>(either - both) > kMuch * static_cast<double>(either);
}

namespace {

/// What is disturbed in each of several, or in the last if nothing is in all.
Disturbances in_all(const std::vector<Disturbances>& several) {
  Disturbances common = several.back();
  for (const Disturbances& other : several)
    for (std::size_t i = 0; i < common.aside.size(); ++i)
      common.aside[i] = common.aside[i] && other.aside[i];
  common.list = stretches(common.aside);
  return common.in_training() ? common : several.back();
}

}  // namespace

Disturbances settled(Disturbances known,
                     const std::function<Disturbances(const Disturbances&)>& next) {
  std::vector<Disturbances> before;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    Disturbances plainer = next(known);
    if (!plainer.in_training() || !differ(plainer, known)) return known;
    before.push_back(std::move(known));
    const auto again = std::find_if(before.begin(), before.end(),
                                    [&](const Disturbances& one) { return !differ(plainer, one); });
    if (again != before.end()) return in_all({again, before.end()});
    known = std::move(plainer);
  }
  return known;
}

Disturbances find_disturbances(const FitInTime& fit) {
  Disturbances found;
  for (std::size_t i = 0; i < fit.recordings(); ++i)
    found.aside.push_back(SetAside::Constant(fit.samples(i), false));
  const VectorXd material = kMaterial * fit.measured_rms().cwiseMax(1e-300);
  found.left_over = fit(found.aside, material);
  found.training = first_levels(found.left_over, false);
  found.held_out = first_levels(found.left_over, true);
  for (int turn = 0; turn < kMostTurns; ++turn) {
    std::vector<SetAside> aside;
    for (const LeftOver& r : found.left_over)
      aside.push_back(disturbed(r, found.levels_of(r), material));
    bool same = true;
    for (std::size_t i = 0; i < aside.size(); ++i)
      same = same && (aside[i] == found.aside[i]).all();
    found.aside = std::move(aside);
    if (same || share_aside(found.left_over, found.aside) > kMost) break;
    leave_over(fit, found);
  }
  found.list = stretches(found.aside);
  if (share_aside(found.left_over, found.aside) > kMost || told_by_state(found) > kComesBack)
    found.list.clear();
  return found;
}

void leave_over(const FitInTime& fit, Disturbances& disturbances) {
  const VectorXd least = kMaterial * fit.measured_rms().cwiseMax(1e-300);
  for (int turn = 0; turn < 2; ++turn) {
    disturbances.left_over = fit(disturbances.aside, disturbances.training.moving.cwiseMax(least));
    disturbances.training.moving = moving_level(disturbances, false);
    disturbances.held_out.moving = moving_level(disturbances, true);
  }
}

}  // namespace sinew::diagnosis
