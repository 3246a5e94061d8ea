// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/cross_validation.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <random>

#include "identification/regression/pseudo_inverse.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A stretch of one segment; stretches of the same log and time share a block.
struct Stretch {
  std::size_t segment = 0;
  Index first = 0, count = 0;
  int block = 0;
};

std::vector<Stretch> cut(const Design& design, bool holdout, int blocks, int& total) {
  std::vector<int> recordings;
  std::vector<double> seconds;  // of each, as its first segment sees it
  double duration = 0.0;
  for (const Segment& s : design.segments())
    if (s.holdout == holdout &&
        std::find(recordings.begin(), recordings.end(), s.recording) == recordings.end()) {
      recordings.push_back(s.recording);
      seconds.push_back(static_cast<double>(s.samples) / s.rate_hz);
      duration += seconds.back();
    }
  std::vector<Stretch> list;
  total = 0;
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    const int here = std::max(3, static_cast<int>(std::lround(seconds[r] / duration * blocks)));
    for (std::size_t i = 0; i < design.segments().size(); ++i) {
      const Segment& s = design.segments()[i];
      if (s.recording != recordings[r] || s.holdout != holdout) continue;
      for (int b = 0; b < here; ++b) {
        const Index from = s.samples * b / here, to = s.samples * (b + 1) / here;
        list.push_back({i, from, to - from, total + b});
      }
    }
    total += here;
  }
  return list;
}

/// Places among all coefficients of the columns that act on a segment, the target's (one more than
/// the last coefficient) at the end.
std::vector<Index> active_columns(const Model& model, std::size_t segment) {
  const std::vector<Index> first = first_columns(model);
  std::vector<Index> at;
  for (std::size_t t = 0; t < model.terms.size(); ++t)
    for (Index c = 0; c < model.terms[t].columns[segment].cols(); ++c) at.push_back(first[t] + c);
  at.push_back(first.back());
  return at;
}

/// Time-domain rows of one segment, its active columns by term, the target last; without a
/// whitening in the target's unit.
MatrixXd time_columns(const Design& design, const Model& model, const VectorXd* weight,
                      std::size_t segment) {
  const Segment& s = design.segments()[segment];
  MatrixXd x(s.samples, static_cast<Index>(active_columns(model, segment).size()));
  const auto to_time = [&](const MatrixXd& band) {
    return from_band(weight ? MatrixXd(weight->asDiagonal() * band) : band, s.samples);
  };
  Index place = 0;
  for (const Term& term : model.terms) {
    const MatrixXd& part = term.columns[segment];
    if (part.cols() > 0) x.middleCols(place, part.cols()) = to_time(part);
    place += part.cols();
  }
  x.rightCols(1) = to_time(model.target[segment]);
  return x;
}

/// The plain rows of one stretch, condensed to what gives its squared error for any coefficients.
struct PlainErrors {
  Index block = 0, channel = 0;
  std::vector<Index> at;
  MatrixXd gram;  // of the active columns, in the squares of the channel's unit

  /// error: minus the coefficients, and 1 for the target.
  void add_to(BlockLosses& losses, const VectorXd& error) const {
    const VectorXd own = error(at);
    losses.plain(block, channel) += own.dot(gram * own);
  }
};

PlainErrors plain_errors(const Design& design, const Stretch& stretch, const MatrixXd& x,
                         const std::vector<Index>& at, double unit) {
  const auto rows = x.middleRows(stretch.first, stretch.count);
  const int channel = design.segments()[stretch.segment].channel;
  return {stretch.block, channel, at, rows.transpose() * rows / (unit * unit)};
}

/// A segment's share of every block's moments.
struct SegmentMoments {
  std::vector<Index> at;           ///< its active columns
  std::vector<MatrixXd> whitened;  ///< gram of each of its stretches
  std::vector<PlainErrors> plain;
};

/// `stretches`: the segment's own.
SegmentMoments segment_moments(const Design& design, const Model& model, const VectorXd& weight,
                               const std::vector<Stretch>& stretches) {
  SegmentMoments moments;
  if (stretches.empty()) return moments;
  const std::size_t segment = stretches.front().segment;
  const MatrixXd x = time_columns(design, model, &weight, segment);
  const MatrixXd raw = time_columns(design, model, nullptr, segment);
  const double unit = design.unit(design.segments()[segment].channel);
  moments.at = active_columns(model, segment);
  for (const Stretch& stretch : stretches) {
    const auto rows = x.middleRows(stretch.first, stretch.count);
    moments.whitened.push_back(rows.transpose() * rows);
    moments.plain.push_back(plain_errors(design, stretch, raw, moments.at, unit));
  }
  return moments;
}

BlockLosses no_losses(const Design& design, int blocks) {
  return {MatrixXd::Zero(blocks, design.problem().channels), VectorXd::Zero(blocks)};
}

}  // namespace

VectorXd channels_of(const Design& design, const Term& term) {
  const Problem& problem = design.problem();
  VectorXd channels = VectorXd::Zero(problem.channels);
  for (std::size_t s = 0; s < design.segments().size(); ++s)
    if (term.columns[s].cols() > 0)
      for (const int c : noise_group(problem, design.segments()[s].channel)) channels(c) = 1.0;
  return channels;
}

BlockLosses cross_validate(const Design& design, const Model& model, const Weights& weights,
                           int blocks) {
  int total = 0;
  const std::vector<Stretch> stretches = cut(design, false, blocks, total);
  const Index wide = first_columns(model).back();
  const MatrixXd none = MatrixXd::Zero(wide + 1, wide + 1);
  std::vector<MatrixXd> whitened(static_cast<std::size_t>(total), none);
  std::vector<std::vector<PlainErrors>> plain(whitened.size());
  BlockLosses losses = no_losses(design, total);
  std::vector<std::vector<Stretch>> own(design.segments().size());
  for (const Stretch& stretch : stretches) own[stretch.segment].push_back(stretch);
  std::vector<SegmentMoments> moments(own.size());
  tbb::parallel_for(0, static_cast<int>(own.size()), [&](int i) {
    const auto s = static_cast<std::size_t>(i);
    moments[s] = segment_moments(design, model, weights[s], own[s]);
  });
  for (std::size_t s = 0; s < own.size(); ++s)
    for (std::size_t k = 0; k < own[s].size(); ++k) {
      const auto b = static_cast<std::size_t>(own[s][k].block);
      whitened[b](moments[s].at, moments[s].at) += moments[s].whitened[k];
      plain[b].push_back(std::move(moments[s].plain[k]));
      losses.samples(own[s][k].block) += static_cast<double>(own[s][k].count);
    }
  MatrixXd all = none;
  all.diagonal().head(wide) = prior_precision(model);
  for (const MatrixXd& gram : whitened) all += gram;
  tbb::parallel_for(0, total, [&](int b) {
    const MatrixXd others = all - whitened[static_cast<std::size_t>(b)];
    VectorXd error(wide + 1);
    error.head(wide) = -scaled_pseudo_inverse(others.topLeftCorner(wide, wide), 1e-9) *
                       others.topRightCorner(wide, 1);
    error(wide) = 1.0;
    for (const PlainErrors& part : plain[static_cast<std::size_t>(b)]) part.add_to(losses, error);
  });
  return losses;
}

namespace {

/// Columns of the coefficients the training knows nothing of: nuisances of the held-out logs.
std::vector<Index> held_out_nuisances(const Design& design, const Model& model) {
  std::vector<Index> own;
  Index at = 0;
  for (const Term& term : model.terms)
    for (const auto& c : design.coefficients(*term.candidate)) {
      if (c.recording >= static_cast<int>(design.problem().training.size())) own.push_back(at);
      ++at;
    }
  return own;
}

/// Errors of one block: its nuisances are fitted to the other blocks (`all`: moments of every
/// block).
VectorXd block_error(const LinearFit& fit, const std::vector<PlainErrors>& block,
                     const std::vector<Index>& nuisances, const MatrixXd& all) {
  const Index wide = fit.coefficients.size();
  VectorXd error(wide + 1);
  error.head(wide) = -fit.coefficients;
  error(wide) = 1.0;
  if (nuisances.empty()) return error;
  for (const Index i : nuisances) error(i) = 0.0;
  MatrixXd others = all;
  for (const PlainErrors& part : block) others(part.at, part.at) -= part.gram;
  const VectorXd fitted =
      scaled_pseudo_inverse(others(nuisances, nuisances), 1e-9) * (others * error)(nuisances);
  for (std::size_t i = 0; i < nuisances.size(); ++i)
    error(nuisances[i]) = -fitted(static_cast<Index>(i));
  return error;
}

}  // namespace

BlockLosses held_out(const Design& design, const Model& model, const LinearFit& fit, int blocks) {
  int total = 0;
  const std::vector<Stretch> stretches = cut(design, true, blocks, total);
  const Index wide = first_columns(model).back();
  std::vector<std::vector<PlainErrors>> plain(static_cast<std::size_t>(total));
  MatrixXd all = MatrixXd::Zero(wide + 1, wide + 1);
  BlockLosses losses = no_losses(design, total);
  std::size_t last = design.segments().size();
  MatrixXd x;
  std::vector<Index> active;
  for (const Stretch& stretch : stretches) {
    if (stretch.segment != last) {
      x = time_columns(design, model, nullptr, stretch.segment);
      active = active_columns(model, stretch.segment);
      last = stretch.segment;
    }
    const double unit = design.unit(design.segments()[stretch.segment].channel);
    const PlainErrors part = plain_errors(design, stretch, x, active, unit);
    all(active, active) += part.gram;
    plain[static_cast<std::size_t>(stretch.block)].push_back(part);
    losses.samples(stretch.block) += static_cast<double>(stretch.count);
  }
  const std::vector<Index> nuisances = held_out_nuisances(design, model);
  for (const std::vector<PlainErrors>& block : plain) {
    const VectorXd error = block_error(fit, block, nuisances, all);
    for (const PlainErrors& part : block) part.add_to(losses, error);
  }
  return losses;
}

std::vector<VectorXd> held_out_errors(const Design& design, const Model& model,
                                      const LinearFit& fit, int blocks, const Weights& whitening) {
  int total = 0;
  const std::vector<Stretch> stretches = cut(design, true, blocks, total);
  const Index wide = first_columns(model).back();
  std::vector<MatrixXd> rows;  // of every stretch: its active columns, and the target
  std::vector<std::vector<PlainErrors>> of_block(static_cast<std::size_t>(total));
  MatrixXd all = MatrixXd::Zero(wide + 1, wide + 1);
  MatrixXd x;
  std::size_t last = design.segments().size();
  for (const Stretch& stretch : stretches) {
    if (stretch.segment != last)
      x = time_columns(design, model, &whitening[stretch.segment], stretch.segment);
    last = stretch.segment;
    const std::vector<Index> active = active_columns(model, stretch.segment);
    const PlainErrors part = plain_errors(design, stretch, x, active, 1.0);
    all(active, active) += part.gram;
    of_block[static_cast<std::size_t>(stretch.block)].push_back(part);
    rows.push_back(x.middleRows(stretch.first, stretch.count));
  }
  const std::vector<Index> nuisances = held_out_nuisances(design, model);
  std::vector<VectorXd> errors(design.segments().size());
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& stretch = stretches[i];
    const VectorXd error =
        block_error(fit, of_block[static_cast<std::size_t>(stretch.block)], nuisances, all);
    VectorXd& sum = errors[stretch.segment];
    const Index before = sum.size();
    sum.conservativeResize(before + stretch.count);
    sum.tail(stretch.count) = rows[i] * error(active_columns(model, stretch.segment));
  }
  return errors;
}

Gain likelihood_gain(const std::vector<VectorXd>& before, const std::vector<VectorXd>& after) {
  double gained = 0.0, variance = 0.0, error = 0.0;
  for (std::size_t s = 0; s < before.size(); ++s) {
    const VectorXd of_row = before[s].cwiseAbs2() - after[s].cwiseAbs2();
    gained += of_row.sum();
    variance += of_row.squaredNorm();
    error += before[s].squaredNorm();
  }
  Gain gain;
  if (error <= 0.0) return gain;
  constexpr double of_interval = 1.96;
  gain.share = gained / error;
  gain.low = (gained - of_interval * std::sqrt(variance)) / error;
  gain.high = (gained + of_interval * std::sqrt(variance)) / error;
  return gain;
}

Gain block_bootstrap_gain(const VectorXd& before, const VectorXd& after, double level,
                          unsigned seed) {
  Gain gain;
  if (before.size() == 0 || before.sum() <= 0.0) return gain;
  gain.share = 1.0 - after.sum() / before.sum();
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<Index> pick(0, before.size() - 1);
  std::vector<double> draws(1000);
  for (double& draw : draws) {
    double top = 0.0, bottom = 0.0;
    for (Index i = 0; i < before.size(); ++i) {
      const Index b = pick(random);
      top += after(b);
      bottom += before(b);
    }
    draw = 1.0 - top / bottom;
  }
  std::sort(draws.begin(), draws.end());
  const double tail = 0.5 * (1.0 - level) * static_cast<double>(draws.size());
  gain.low = draws[static_cast<std::size_t>(tail)];
  gain.high = draws[draws.size() - 1 - static_cast<std::size_t>(tail)];
  return gain;
}

double standard_errors_above_zero(const Gain& gain) {
  constexpr double of_interval = 1.96;
  return of_interval * gain.share / std::max(gain.share - gain.low, 1e-300);
}

bool is_sure(const Gain& gain) {
  return gain.share > 0.0 && standard_errors_above_zero(gain) > 1.6;
}

}  // namespace sinew::diagnosis
