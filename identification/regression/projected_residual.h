// SPDX-License-Identifier: GPL-3.0-or-later
// What a model leaves over as a function of a few terms' nonlinear parameters, the linear
// coefficients eliminated (variable projection).
#pragma once

#include <optional>
#include <vector>

#include "identification/regression/partly_fixed_fit.h"

namespace sinew::diagnosis {

/// What does not depend on the nonlinear parameters is condensed once, by orthogonal
/// transformations of each segment's rows: where no moving term acts nothing but a triangle is left
/// of the segment, elsewhere the columns that stay are taken out of those that move. Norms of the
/// residual and its products with other residuals are those of the whitened rows.
class ProjectedResidual {
 public:
  /// `moving`: of each term whether its nonlinear parameters will change.
  ProjectedResidual(const Design& design, const Weights& weights, const Model& model,
                    const std::vector<bool>& moving);

  Eigen::Index rows() const { return condensed_.first_row.back(); }

  /// The condensed rows' residual; `nonlinear`: of every term, those that do not move as they were.
  Eigen::VectorXd operator()(const std::vector<Eigen::VectorXd>& nonlinear);

 private:
  /// A segment in which something moves.
  struct Touched {
    std::size_t segment = 0;
    Eigen::MatrixXd basis;  ///< orthonormal, of the columns that stay
    /// Entries of condensed_: the rows along the basis, then those across.
    std::size_t along = 0, across = 0;
    Eigen::Index fixed = 0;  ///< columns that stay
  };
  /// A moving term's columns in one segment, and where they stand among those that move there.
  struct Place {
    std::size_t touched = 0;
    Eigen::Index first = 0;
  };
  struct Columns {
    Eigen::VectorXd nonlinear;
    std::vector<Eigen::MatrixXd> along, across;  ///< one for each place
  };
  struct Moving {
    const Candidate* candidate = nullptr;
    std::vector<bool> segments;
    std::vector<Place> places;
    Columns now;
    std::vector<Columns> before;  ///< latest first
  };

  void condense(const Eigen::MatrixXd& a, const std::vector<Eigen::Index>& at,
                const Eigen::VectorXd& y);
  void touch(std::size_t segment, const Eigen::MatrixXd& a, const std::vector<Eigen::Index>& at,
             const Eigen::VectorXd& y, const std::vector<bool>& moves);
  void append(Eigen::MatrixXd a, std::vector<Eigen::Index> at, const Eigen::VectorXd& y);
  void find_places(const Model& model, const std::vector<bool>& moving);
  Columns columns_of(const Moving& term, const Eigen::VectorXd& nonlinear) const;
  void move(const Eigen::VectorXd& nonlinear, Moving& term);

  const Design& design_;
  const Weights& weights_;
  Stack condensed_;
  std::vector<Touched> touched_;
  std::vector<Moving> terms_;  ///< those that stay have no candidate
  std::optional<PartlyFixedFit> fit_;
};

}  // namespace sinew::diagnosis
