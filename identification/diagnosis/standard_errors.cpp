// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/standard_errors.h"

#include <algorithm>
#include <cmath>

#include "identification/diagnosis/clustered_errors.h"
#include "identification/regression/pseudo_inverse.h"
#include "identification/regression/refine.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const std::string& log_of(const Recording& recording) {
  return recording.log.empty() ? recording.name : recording.log;
}

/// Whitened derivative of a term's prediction with respect to one nonlinear parameter.
VectorXd sensitivity(const Design& design, const Term& term, Index parameter,
                     const VectorXd& coefficients, const Weights& weights, const Stack& stacked) {
  const BandColumns rate = shape_rate(design, term, parameter, coefficients);
  VectorXd result = VectorXd::Zero(stacked.y.size());
  for (std::size_t s = 0; s < weights.size(); ++s) {
    const Index rows = stacked.first_row[s + 1] - stacked.first_row[s];
    if (rows > 0 && rate[s].cols() > 0)
      result.segment(stacked.first_row[s], rows) = weights[s].cwiseProduct(rate[s].col(0));
  }
  return result;
}

/// Variance of the weighted noise in every stacked row.
VectorXd row_noise(const NoiseView& noise, const Stack& stacked) {
  VectorXd variance = VectorXd::Zero(stacked.y.size());
  for (std::size_t s = 0; s < noise.weights.size(); ++s) {
    const Index rows = stacked.first_row[s + 1] - stacked.first_row[s];
    if (rows > 0)
      variance.segment(stacked.first_row[s], rows) =
          noise.weights[s].cwiseAbs2().cwiseProduct(per_row(noise.noise[s].variance));
  }
  return variance;
}

/// What a nonlinear parameter's range says of it, where the logs say nothing: the reciprocal of the
/// variance of all values between its ends, the logarithms of which are alike likely where it is
/// logarithmic.
double precision_of_range(const NonlinearParameter& range, double value) {
  const double wide = range.width_at(value);
  return 12.0 / (wide * wide);
}

/// Normal matrix of the rows and that of their noise, both with what is known beforehand.
struct Normal {
  MatrixXd gram, spread;
};

/// Columns beside the stack's, all rows, and the precision that their parameters have without them.
struct Sensitivities {
  std::vector<VectorXd> columns;
  std::vector<double> precision;
};

Normal normal_of(const Stack& stacked, const Sensitivities& of_shapes, const VectorXd& variance) {
  const std::vector<VectorXd>& shapes = of_shapes.columns;
  const auto more = static_cast<Index>(shapes.size()), all = stacked.coefficients + more;
  Normal sum{MatrixXd::Zero(all, all), MatrixXd::Zero(all, all)};
  for (std::size_t s = 0; s < stacked.a.size(); ++s) {
    ActingRows rows = acting_rows(stacked, shapes, s);
    if (rows.at.empty()) continue;
    sum.gram(rows.at, rows.at) += rows.a.transpose() * rows.a;
    rows.a =
        variance.segment(stacked.first_row[s], rows.a.rows()).cwiseSqrt().asDiagonal() * rows.a;
    sum.spread(rows.at, rows.at) += rows.a.transpose() * rows.a;
  }
  VectorXd known(all);
  known.head(stacked.coefficients) = stacked.prior;
  known.tail(more) = VectorXd::Map(of_shapes.precision.data(), more);
  sum.gram.diagonal() += known;
  sum.spread.diagonal() += known;
  return sum;
}

}  // namespace

std::vector<std::vector<ParameterEstimate>> estimates(const Design& design, const Model& model,
                                                      const NoiseView& noise, NoiseErrors errors) {
  const Stack stacked = stack(model, noise.weights);
  const LinearFit fit = solve(stacked);
  const std::vector<Index> first = first_columns(model);
  Sensitivities sensitivities;
  std::vector<std::vector<ParameterEstimate>> result(model.terms.size());
  std::vector<std::vector<Index>> columns(model.terms.size());
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const Term& term = model.terms[t];
    const bool delay = term.candidate->kind == CandidateKind::delay;
    const auto layout = design.coefficients(*term.candidate);
    const Index wide = first[t + 1] - first[t];
    for (Index c = 0; c < wide; ++c) {
      const auto& place = layout[static_cast<std::size_t>(c)];
      if (place.recording >= static_cast<int>(design.problem().training.size())) continue;
      const LinearParameter& p = term.candidate->linear[static_cast<std::size_t>(place.parameter)];
      const double value = delay ? term.nonlinear(0) : fit.coefficients(first[t] + c);
      result[t].push_back(
          {p.name, p.unit, value, 0.0,
           place.recording < 0 ? std::string() : log_of(design.recording(place.recording))});
      columns[t].push_back(first[t] + c);
    }
    const auto shapes = static_cast<Index>(delay ? 0 : term.candidate->nonlinear.size());
    for (Index p = 0; p < shapes; ++p) {
      const NonlinearParameter& range = term.candidate->nonlinear[static_cast<std::size_t>(p)];
      if (!(range.high > range.low)) continue;
      sensitivities.columns.push_back(sensitivity(
          design, term, p, fit.coefficients.segment(first[t], wide), noise.weights, stacked));
      sensitivities.precision.push_back(precision_of_range(range, term.nonlinear(p)));
      result[t].push_back({range.name, range.unit, term.nonlinear(p), 0.0, {}});
      columns[t].push_back(stacked.coefficients + static_cast<Index>(sensitivities.columns.size()) -
                           1);
    }
  }
  const Normal normal = normal_of(stacked, sensitivities, row_noise(noise, stacked));
  const MatrixXd inverse = scaled_pseudo_inverse(normal.gram);
  VectorXd variance = (inverse * normal.spread * inverse).diagonal();
  if (errors == NoiseErrors::of_stretches_too)
    variance = variance.cwiseMax(
        covariance_by_stretches(design, stacked, sensitivities.columns, fit.residual, normal.gram)
            .diagonal());
  for (std::size_t t = 0; t < result.size(); ++t)
    for (std::size_t i = 0; i < result[t].size(); ++i)
      result[t][i].standard_error = std::sqrt(std::max(0.0, variance(columns[t][i])));
  return result;
}

}  // namespace sinew::diagnosis
