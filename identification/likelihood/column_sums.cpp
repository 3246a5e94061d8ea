// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/column_sums.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kAtOnce = 4;   // blocks whose rows are in memory together
constexpr Index kRowsAtOnce = 1024;  // of each

Index width_of(const BandColumns& columns) {
  for (const MatrixXd& part : columns)
    if (part.cols() > 0) return part.cols();
  return 0;
}

/// Calls `take` with every part of a segment's columns, the place of its first one among all, and
/// its shape (none: of the model's free part).
template <class Take>
void for_each_part(const Hypotheses& all, const std::vector<Index>& width, std::size_t segment,
                   const Take& take) {
  Index first = 0;
  for (const Term& term : all.parts.base.terms) {
    take(term.columns[segment], first, nullptr);
    first += width_of(term.columns);
  }
  for (std::size_t i = 0; i < all.shapes.size(); ++i) {
    take(all.shapes[i].columns[segment], first, &all.shapes[i]);
    first += width[i];
  }
}

/// A segment's columns that act there, in their order, and where they stand among all.
struct ActingColumns {
  std::vector<Eigen::Block<const MatrixXd, Eigen::Dynamic, 1, true>> columns;
  std::vector<Index> at;
};

ActingColumns acting_columns(const Hypotheses& all, const std::vector<Index>& width,
                             std::size_t segment) {
  ActingColumns acting;
  for_each_part(all, width, segment, [&](const MatrixXd& part, Index first, const Shape*) {
    for (Index c = 0; c < part.cols(); ++c) {
      // What belongs to another log does not act in this one.
      if ((part.col(c).array() == 0.0).all()) continue;
      acting.columns.push_back(part.col(c));
      acting.at.push_back(first + c);
    }
  });
  return acting;
}

/// Segments whose rows are whitened together: one, or those that share their noise.
struct Block {
  std::vector<std::size_t> segments;
  const SharedNoise* shared = nullptr;
};

/// Weighted rows of a block's segments: [from, from + count) of each, one segment below the other.
struct Rows {
  MatrixXd x;
  VectorXd y;
};

/// One block's products, the lower half.
struct Products {
  std::vector<Index> at;
  MatrixXd gram;
  VectorXd target;
  double deviance = 0.0, rows = 0.0;
};

/// A block's rows, a few at a time.
class BlockRows {
 public:
  BlockRows(const Hypotheses& all, const ColumnSums& sums, const Weights& weights,
            const Weights& noise_share, const Block& block)
      : all_(all), weights_(weights), noise_share_(noise_share), block_(block) {
    for (const std::size_t s : block.segments) {
      acting_.push_back(acting_columns(all, sums.width, s));
      at_.insert(at_.end(), acting_.back().at.begin(), acting_.back().at.end());
    }
    std::sort(at_.begin(), at_.end());
    at_.erase(std::unique(at_.begin(), at_.end()), at_.end());
  }

  const std::vector<Index>& at() const { return at_; }
  Index rows() const { return weights_[block_.segments.front()].size(); }

  Rows whitened(Index from, Index count) const {
    const auto segments = static_cast<Index>(block_.segments.size());
    Rows rows{MatrixXd::Zero(segments * count, static_cast<Index>(at_.size())),
              VectorXd(segments * count)};
    for (Index i = 0; i < segments; ++i) take(i, from, count, rows);
    if (block_.shared)
      for (Index r = 0; r < count; ++r) unmix(from + r, Eigen::seqN(r, segments, count), rows);
    return rows;
  }

 private:
  void take(Index i, Index from, Index count, Rows& rows) const {
    const std::size_t s = block_.segments[static_cast<std::size_t>(i)];
    const VectorXd weight = weights_[s].segment(from, count);
    rows.y.segment(i * count, count) =
        weight.cwiseProduct(all_.parts.base.target[s].segment(from, count));
    const ActingColumns& acting = acting_[static_cast<std::size_t>(i)];
    for (std::size_t c = 0; c < acting.at.size(); ++c) {
      const auto to = std::lower_bound(at_.begin(), at_.end(), acting.at[c]);
      rows.x.col(to - at_.begin()).segment(i * count, count) =
          weight.cwiseProduct(acting.columns[c].segment(from, count));
    }
  }

  /// Takes what the channels' noise has in common out of one row of each.
  void unmix(Index row, const Eigen::ArithmeticSequence<Index, Index, Index>& own,
             Rows& rows) const {
    MatrixXd covariance = block_.shared->correlation;
    for (Index i = 0; i < covariance.rows(); ++i) {
      const std::size_t s = block_.segments[static_cast<std::size_t>(i)];
      if (noise_share_.empty() || noise_share_[s].size() == 0) continue;
      covariance.row(i) *= noise_share_[s](row);
      covariance.col(i) *= noise_share_[s](row);
    }
    covariance.diagonal().setConstant(1.0 + 1e-9);
    const Eigen::LLT<MatrixXd> factor(covariance);
    const MatrixXd x = rows.x(own, Eigen::all);
    rows.x(own, Eigen::all) = MatrixXd(factor.matrixL().solve(x));
    const VectorXd y = rows.y(own);
    rows.y(own) = VectorXd(factor.matrixL().solve(y));
  }

  const Hypotheses& all_;
  const Weights& weights_;
  const Weights& noise_share_;
  const Block& block_;
  std::vector<ActingColumns> acting_;
  std::vector<Index> at_;
};

Products products_of(const BlockRows& block) {
  const auto wide = static_cast<Index>(block.at().size());
  Products p{block.at(), MatrixXd::Zero(wide, wide), VectorXd::Zero(wide)};
  for (Index from = 0; from < block.rows(); from += kRowsAtOnce) {
    const Rows rows = block.whitened(from, std::min(kRowsAtOnce, block.rows() - from));
    p.gram.selfadjointView<Eigen::Lower>().rankUpdate(rows.x.transpose());
    p.target += rows.x.transpose() * rows.y;
    p.deviance += rows.y.squaredNorm();
    p.rows += static_cast<double>(rows.y.size());
  }
  return p;
}

void add_products(const Products& p, ColumnSums& sums) {
  sums.gram.add(p.at, p.gram);
  sums.target(p.at) += p.target;
  sums.deviance += p.deviance;
  sums.rows += p.rows;
}

/// Squares of what was measured and of every column in one segment.
void add_energies(const Design& design, const Hypotheses& all, std::size_t segment,
                  ColumnSums& sums) {
  const auto s = static_cast<int>(segment);
  const int channel = design.segments()[segment].channel;
  const double samples = design.window(s).squaredNorm();
  VectorXd whole = design.target(s);
  if (const auto known = design.known(s, 0)) whole += *known;
  sums.measured(channel) += whole.squaredNorm();
  sums.samples(channel) += samples;
  Index first = 0;
  for (std::size_t i = 0; i < all.shapes.size(); ++i) {
    const MatrixXd& columns = all.shapes[i].columns[segment];
    if (columns.cols() > 0) {
      sums.energy.row(channel).segment(first, columns.cols()) += columns.colwise().squaredNorm();
      sums.acting.segment(first, columns.cols()).array() += samples;
    }
    first += sums.width[i];
  }
}

bool has_log_coefficients(const Hypotheses& all, const Shape& shape) {
  const auto& linear = all.list[static_cast<std::size_t>(shape.hypothesis)].source->linear;
  return std::any_of(linear.begin(), linear.end(),
                     [](const LinearParameter& p) { return p.per_log; });
}

/// Channels x columns: 1 where a column can act in the training logs. What a held-out log alone
/// has acts nowhere.
MatrixXd acting_channels(const Design& design, const Hypotheses& all, const ColumnSums& sums) {
  MatrixXd acts = MatrixXd::Zero(design.problem().channels, sums.target.size());
  for (std::size_t s = 0; s < design.segments().size(); ++s) {
    const Segment& segment = design.segments()[s];
    if (segment.holdout) continue;
    for_each_part(all, sums.width, s, [&](const MatrixXd& part, Index first, const Shape* shape) {
      const bool look = shape && has_log_coefficients(all, *shape);
      for (Index c = 0; c < part.cols(); ++c)
        if (!look || (part.col(c).array() != 0.0).any()) acts(segment.channel, first + c) = 1.0;
    });
  }
  return acts;
}

ColumnSums no_sums(const Design& design, const Hypotheses& all,
                   const std::vector<SharedNoise>& shared) {
  ColumnSums sums;
  for (const Term& term : all.parts.base.terms) sums.free += width_of(term.columns);
  for (const Shape& shape : all.shapes) sums.width.push_back(width_of(shape.columns));
  const Index own = std::accumulate(sums.width.begin(), sums.width.end(), Index{0});
  const Index channels = design.problem().channels;
  for (const SharedNoise& group : shared) {
    sums.joined.emplace_back();
    for (const std::size_t s : group.segments)
      sums.joined.back().push_back(design.segments()[s].channel);
  }
  sums.target = VectorXd::Zero(sums.free + own);
  sums.gram = RegionProducts(Regions(acting_channels(design, all, sums), sums.joined));
  sums.energy = MatrixXd::Zero(channels, own);
  sums.acting = VectorXd::Zero(own);
  sums.measured = sums.samples = VectorXd::Zero(channels);
  return sums;
}

}  // namespace

void ColumnSums::add(const ColumnSums& other) {
  if (free != other.free || width != other.width || measured.size() != other.measured.size())
    throw std::invalid_argument("sums of different columns do not add up");
  gram += other.gram;
  target += other.target;
  deviance += other.deviance;
  rows += other.rows;
  energy += other.energy;
  acting += other.acting;
  measured += other.measured;
  samples += other.samples;
}

namespace {

/// Segments that have weights, those together that share their noise.
std::vector<Block> blocks_of(const Weights& weights, const std::vector<SharedNoise>& shared) {
  std::vector<Block> blocks;
  std::vector<bool> taken(weights.size(), false);
  for (const SharedNoise& group : shared) {
    blocks.push_back({group.segments, &group});
    for (const std::size_t s : group.segments) taken[s] = true;
  }
  for (std::size_t s = 0; s < weights.size(); ++s)
    if (weights[s].size() > 0 && !taken[s]) blocks.push_back({{s}, nullptr});
  return blocks;
}

ColumnSums summed(const Design& design, const Hypotheses& all, const Weights& weights,
                  const Weights& noise_share, const std::vector<SharedNoise>& shared) {
  ColumnSums sums = no_sums(design, all, shared);
  const std::vector<Block> blocks = blocks_of(weights, shared);
  // Added in their order, whichever is ready first: a sum's last bit depends on it.
  for (std::size_t from = 0; from < blocks.size(); from += kAtOnce) {
    std::vector<Products> part(std::min(kAtOnce, blocks.size() - from));
    tbb::parallel_for(std::size_t{0}, part.size(), [&](std::size_t i) {
      part[i] = products_of(BlockRows(all, sums, weights, noise_share, blocks[from + i]));
    });
    for (const Products& p : part) add_products(p, sums);
  }
  for (std::size_t s = 0; s < weights.size(); ++s)
    if (weights[s].size() > 0) add_energies(design, all, s, sums);
  return sums;
}

}  // namespace

ColumnSums column_sums(const Design& design, const Hypotheses& all, const Weights& weights) {
  return summed(design, all, weights, {}, {});
}

ColumnSums column_sums(const Design& design, const Hypotheses& all, const Whitening& whitening) {
  return summed(design, all, whitening.training, whitening.noise_share, whitening.shared);
}

}  // namespace sinew::diagnosis
