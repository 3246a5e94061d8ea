// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/calibration_polynomial.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sinew {
namespace {

constexpr int folds = 5;
constexpr double as_good = 1.05;

Eigen::MatrixXd powers(const Eigen::ArrayXd& u, int degree) {
  Eigen::MatrixXd columns(u.size(), degree + 1);
  columns.col(0).setOnes();
  for (int k = 1; k <= degree; ++k) columns.col(k) = columns.col(k - 1).array() * u;
  return columns;
}

/// Rms error on the fold that a fit to the others did not see. Neighbours in u go to different
/// folds, so that no fold asks for more than interpolation.
double validation_error(const std::vector<Eigen::Index>& order, const Eigen::MatrixXd& columns,
                        const Eigen::VectorXd& value) {
  double squares = 0.0;
  for (int fold = 0; fold < folds; ++fold) {
    std::vector<Eigen::Index> seen, unseen;
    for (std::size_t i = 0; i < order.size(); ++i)
      (static_cast<int>(i % folds) == fold ? unseen : seen).push_back(order[i]);
    const Eigen::MatrixXd known = columns(seen, Eigen::all);
    const Eigen::VectorXd c = known.householderQr().solve(Eigen::VectorXd(value(seen)));
    squares += (columns(unseen, Eigen::all) * c - value(unseen)).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(value.size()));
}

}  // namespace

double CalibrationPolynomial::at(double u) const {
  double sum = 0.0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * u + coefficients[k];
  return sum;
}

double CalibrationPolynomial::slope(double u) const {
  double sum = 0.0;
  for (std::size_t k = coefficients.size(); k-- > 1;)
    sum = sum * u + static_cast<double>(k) * coefficients[k];
  return sum;
}

CalibrationPolynomial fit_polynomial(const Eigen::ArrayXd& u, const Eigen::ArrayXd& value,
                                     int highest) {
  if (u.size() < 3 * (highest + 1))
    throw std::invalid_argument(fmt::format("{} calibration points for degree {}; expected {}",
                                            u.size(), highest, 3 * (highest + 1)));
  std::vector<Eigen::Index> order(static_cast<std::size_t>(u.size()));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Eigen::Index>(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return u(a) < u(b); });
  CalibrationPolynomial p;
  for (int degree = 1; degree <= highest; ++degree)
    p.validation_rms.push_back(validation_error(order, powers(u, degree), value.matrix()));
  const double best = *std::min_element(p.validation_rms.begin(), p.validation_rms.end());
  int degree = 1;
  while (p.validation_rms[static_cast<std::size_t>(degree - 1)] > as_good * best) ++degree;
  const Eigen::MatrixXd columns = powers(u, degree);
  const Eigen::VectorXd c = columns.householderQr().solve(value.matrix());
  p.coefficients.assign(c.data(), c.data() + c.size());
  const Eigen::ArrayXd error = (columns * c).array() - value;
  p.largest_error = error.abs().maxCoeff();
  p.rms = std::sqrt(error.square().mean());
  return p;
}

}  // namespace sinew
