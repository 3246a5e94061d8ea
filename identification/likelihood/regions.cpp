// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/regions.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Every channel's first one of those that are of its region.
std::vector<int> first_channels(Index channels, const std::vector<std::vector<int>>& joined) {
  std::vector<int> first(static_cast<std::size_t>(channels));
  std::iota(first.begin(), first.end(), 0);
  for (const std::vector<int>& group : joined)
    for (const int channel : group) {
      const int one = first[static_cast<std::size_t>(group.front())];
      const int other = first[static_cast<std::size_t>(channel)];
      for (int& f : first)
        if (f == std::max(one, other)) f = std::min(one, other);
    }
  return first;
}

}  // namespace

Regions::Regions(Index columns) : of_column_(static_cast<std::size_t>(columns), 0) {
  sort_columns(1);
}

Regions::Regions(const MatrixXd& acts, const std::vector<std::vector<int>>& joined) {
  const std::vector<int> first = first_channels(acts.rows(), joined);
  std::map<int, int> number;
  for (const int f : first) number.try_emplace(f, static_cast<int>(number.size()));
  for (Index column = 0; column < acts.cols(); ++column) {
    int region = kNowhere;
    for (Index c = 0; c < acts.rows(); ++c) {
      if (!(acts(c, column) > 0.0)) continue;
      const int here = number.at(first[static_cast<std::size_t>(c)]);
      region = region == kNowhere || region == here ? here : kEverywhere;
    }
    of_column_.push_back(region);
  }
  sort_columns(static_cast<int>(number.size()));
}

void Regions::sort_columns(int count) {
  columns_.resize(static_cast<std::size_t>(count));
  std::vector<Index> everywhere;
  for (std::size_t i = 0; i < of_column_.size(); ++i) {
    const int region = of_column_[i];
    all_.push_back(static_cast<Index>(i));
    place_.push_back(0);
    if (region == kNowhere) continue;
    auto& own = region == kEverywhere ? everywhere : columns_[static_cast<std::size_t>(region)];
    place_.back() = static_cast<Index>(own.size());
    own.push_back(static_cast<Index>(i));
  }
  everywhere_ = static_cast<Index>(everywhere.size());
  for (auto& own : columns_) {
    own_.push_back(static_cast<Index>(own.size()));
    own.insert(own.end(), everywhere.begin(), everywhere.end());
  }
}

int Regions::of(const std::vector<Index>& columns) const {
  if (columns.empty()) return kEverywhere;
  const int first = of(columns.front());
  for (const Index c : columns)
    if (of(c) != first) return kEverywhere;
  return first;
}

Index Regions::place(int region, Index column) const {
  if (region == kEverywhere) return column;
  return of(column) == kEverywhere ? own(region) + place(column) : place(column);
}

std::vector<Index> Regions::places(int region, const std::vector<Index>& columns) const {
  std::vector<Index> list;
  list.reserve(columns.size());
  for (const Index c : columns) list.push_back(place(region, c));
  return list;
}

RegionProducts::RegionProducts(Regions regions) : regions_(std::move(regions)) {
  for (int r = 0; r < regions_.count(); ++r)
    blocks_.push_back(MatrixXd::Zero(regions_.own(r), regions_.own(r)));
  blocks_.push_back(MatrixXd::Zero(regions_.own(Regions::kEverywhere), regions_.size()));
}

RegionProducts::RegionProducts(Regions regions, const Products& of) : regions_(std::move(regions)) {
  const auto halved = [](MatrixXd product) -> MatrixXd {
    return product.selfadjointView<Eigen::Lower>();
  };
  const std::vector<Index>& all = regions_.columns(Regions::kEverywhere);
  std::vector<Index> everywhere;
  for (const Index c : all)
    if (regions_.of(c) == Regions::kEverywhere) everywhere.push_back(c);
  for (int r = 0; r < regions_.count(); ++r) {
    std::vector<Index> own = regions_.columns(r);
    own.resize(static_cast<std::size_t>(regions_.own(r)));
    blocks_.push_back(halved(of(own, own)));
  }
  blocks_.push_back(of(everywhere, all));
  const MatrixXd among = halved(blocks_.back()(Eigen::all, everywhere));
  blocks_.back()(Eigen::all, everywhere) = among;
}

RegionProducts::RegionProducts(const MatrixXd& lower)
    : regions_(lower.cols()),
      blocks_{lower.selfadjointView<Eigen::Lower>(), MatrixXd(0, lower.cols())} {}

std::vector<RegionProducts::Located> RegionProducts::located(
    const std::vector<Index>& columns) const {
  std::vector<Located> list;
  list.reserve(columns.size());
  for (const Index c : columns) list.push_back({regions_.of(c), regions_.place(c), c});
  return list;
}

/// Where the product of two columns is kept; nothing: nowhere, it is zero.
const double* RegionProducts::find(const Located& row, const Located& column) const {
  if (!Regions::can_meet(row.region, column.region)) return nullptr;
  if (row.region == Regions::kEverywhere) return &blocks_.back()(row.place, column.column);
  if (column.region == Regions::kEverywhere) return &blocks_.back()(column.place, row.column);
  return &blocks_[static_cast<std::size_t>(row.region)](row.place, column.place);
}

double* RegionProducts::find(const Located& row, const Located& column) {
  return const_cast<double*>(std::as_const(*this).find(row, column));
}

double RegionProducts::operator()(Index row, Index column) const {
  const auto at = located({row, column});
  const double* product = find(at[0], at[1]);
  return product ? *product : 0.0;
}

MatrixXd RegionProducts::operator()(const std::vector<Index>& rows,
                                    const std::vector<Index>& columns) const {
  const std::vector<Located> down = located(rows), across = located(columns);
  MatrixXd part(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  for (std::size_t c = 0; c < across.size(); ++c) {
    double* to = part.col(static_cast<Index>(c)).data();
    for (const Located& row : down) {
      const double* product = find(row, across[c]);
      *to++ = product ? *product : 0.0;
    }
  }
  return part;
}

MatrixXd RegionProducts::dense() const {
  const std::vector<Index>& all = regions_.columns(Regions::kEverywhere);
  return (*this)(all, all);
}

void RegionProducts::set(Index row, Index column, double value) {
  const auto at = located({row, column});
  if (double* product = find(at[0], at[1])) *product = value;
  if (double* product = find(at[1], at[0])) *product = value;
}

void RegionProducts::add(const std::vector<Index>& at, const MatrixXd& lower) {
  const std::vector<Located> all = located(at);
  for (std::size_t c = 0; c < all.size(); ++c)
    for (std::size_t r = c; r < all.size(); ++r) {
      double* product = find(all[r], all[c]);
      if (!product) continue;
      *product += lower(static_cast<Index>(r), static_cast<Index>(c));
      *find(all[c], all[r]) = *product;
    }
}

RegionProducts& RegionProducts::operator+=(const RegionProducts& other) {
  const auto same_size = [](const MatrixXd& a, const MatrixXd& b) {
    return a.rows() == b.rows() && a.cols() == b.cols();
  };
  if (!std::equal(blocks_.begin(), blocks_.end(), other.blocks_.begin(), other.blocks_.end(),
                  same_size))
    throw std::invalid_argument("products of other columns do not add up");
  for (std::size_t i = 0; i < blocks_.size(); ++i) blocks_[i] += other.blocks_[i];
  return *this;
}

}  // namespace sinew::diagnosis
