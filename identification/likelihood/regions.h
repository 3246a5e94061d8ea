// SPDX-License-Identifier: GPL-3.0-or-later
// Which columns can meet: those that act on different channels, and share no noise, do not.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace sinew::diagnosis {

/// A region is a channel, or several whose columns meet; columns that act in more than one region
/// act everywhere. On an arm most columns are of one joint alone, and products between those of
/// different joints are zero, so that what is done region by region costs a fraction and is exact.
class Regions {
 public:
  static constexpr int kEverywhere = -1, kNowhere = -2;

  /// One region with all of them.
  explicit Regions(Eigen::Index columns = 0);
  /// `acts`: channels x columns, above zero where a column acts. `joined`: channels of one region.
  Regions(const Eigen::MatrixXd& acts, const std::vector<std::vector<int>>& joined);

  int count() const { return static_cast<int>(columns_.size()); }
  Eigen::Index size() const { return static_cast<Eigen::Index>(all_.size()); }
  int of(Eigen::Index column) const { return of_column_[static_cast<std::size_t>(column)]; }
  /// The region of all of these columns.
  int of(const std::vector<Eigen::Index>& columns) const;

  /// Columns of one region, or all; a region's own ones first, then those that act everywhere.
  const std::vector<Eigen::Index>& columns(int region) const {
    return region == kEverywhere ? all_ : columns_[static_cast<std::size_t>(region)];
  }
  /// How many are the region's own, or act everywhere.
  Eigen::Index own(int region) const {
    return region == kEverywhere ? everywhere_ : own_[static_cast<std::size_t>(region)];
  }

  /// Whether two columns can meet.
  bool meet(Eigen::Index column, Eigen::Index other) const {
    return can_meet(of(column), of(other));
  }
  /// Whether columns of these regions can.
  static bool can_meet(int region, int other) {
    return region != kNowhere && other != kNowhere &&
           (region == other || region == kEverywhere || other == kEverywhere);
  }
  /// Whether a region's columns have this one.
  bool has(int region, Eigen::Index column) const {
    return region == kEverywhere || of(column) == region || of(column) == kEverywhere;
  }
  /// Where it stands among them.
  Eigen::Index place(int region, Eigen::Index column) const;
  std::vector<Eigen::Index> places(int region, const std::vector<Eigen::Index>& columns) const;
  /// Where it stands among its region's own, or among those that act everywhere.
  Eigen::Index place(Eigen::Index column) const { return place_[static_cast<std::size_t>(column)]; }

 private:
  void sort_columns(int count);

  std::vector<int> of_column_;
  std::vector<Eigen::Index> place_;
  std::vector<std::vector<Eigen::Index>> columns_;
  std::vector<Eigen::Index> own_, all_;
  Eigen::Index everywhere_ = 0;
};

/// Products of columns with each other, of those alone that meet: a symmetric matrix.
class RegionProducts {
 public:
  RegionProducts() = default;
  /// Zeros.
  explicit RegionProducts(Regions regions);
  /// rows x columns: products of some columns with some others.
  using Products = std::function<Eigen::MatrixXd(const std::vector<Eigen::Index>& rows,
                                                 const std::vector<Eigen::Index>& columns)>;
  /// Asked for a region's at a time.
  RegionProducts(Regions regions, const Products& of);
  /// Of all columns, of which the lower half is read. They are one region.
  explicit RegionProducts(const Eigen::MatrixXd& lower);

  const Regions& regions() const { return regions_; }
  Eigen::Index size() const { return regions_.size(); }
  double operator()(Eigen::Index row, Eigen::Index column) const;
  Eigen::MatrixXd operator()(const std::vector<Eigen::Index>& rows,
                             const std::vector<Eigen::Index>& columns) const;
  Eigen::MatrixXd dense() const;

  void set(Eigen::Index row, Eigen::Index column, double value);
  /// `lower`: the lower half of the products of columns `at`, which ascend.
  void add(const std::vector<Eigen::Index>& at, const Eigen::MatrixXd& lower);
  /// Throws std::invalid_argument where the regions are others.
  RegionProducts& operator+=(const RegionProducts& other);

 private:
  /// A column: its region, its place there, and which one of all it is.
  struct Located {
    int region;
    Eigen::Index place, column;
  };
  std::vector<Located> located(const std::vector<Eigen::Index>& columns) const;
  const double* find(const Located& row, const Located& column) const;
  double* find(const Located& row, const Located& column);

  Regions regions_;
  /// Of every region its own columns' products, both halves; the last one of the columns that act
  /// everywhere with all.
  std::vector<Eigen::MatrixXd> blocks_;
};

}  // namespace sinew::diagnosis
