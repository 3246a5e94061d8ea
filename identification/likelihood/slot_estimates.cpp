// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_estimates.h"

#include <algorithm>
#include <cmath>

#include "identification/regression/pseudo_inverse.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A slot's coefficients in their own units, and their covariance.
struct SlotFit {
  const Entry* entry = nullptr;
  VectorXd coefficients;
  MatrixXd covariance;
};

const Entry& entry_of(const FoundSlots& found, std::size_t slot) {
  return found.search->entries()[static_cast<std::size_t>(found.slots.entries[slot])];
}

std::vector<SlotFit> fitted_slots(const FoundSlots& found, const std::vector<std::size_t>& slots) {
  std::vector<Index> columns;
  for (const std::size_t slot : slots) {
    const auto& own = entry_of(found, slot).columns;
    columns.insert(columns.end(), own.begin(), own.end());
  }
  const VectorXd scale = found.moments.scale(columns);
  const MatrixXd inverse = scaled_pseudo_inverse(found.errors->gram(columns, columns));
  const VectorXd all = scale.cwiseProduct(inverse * VectorXd(found.errors->target()(columns)));
  const MatrixXd covariance = scale.asDiagonal() * inverse * scale.asDiagonal();
  std::vector<SlotFit> fits;
  Index first = 0;
  for (const std::size_t slot : slots) {
    const Entry& entry = entry_of(found, slot);
    const auto wide = static_cast<Index>(entry.columns.size());
    fits.push_back({&entry, all.segment(first, wide), covariance.block(first, first, wide, wide)});
    first += wide;
  }
  return fits;
}

double standard_deviation(double variance) {
  return std::sqrt(std::max(0.0, variance));
}

std::vector<ParameterEstimate> of_one_shape(const FoundSlots& found, const SlotFit& fit) {
  const Entry& entry = *fit.entry;
  const Candidate& source = *found.all.list[static_cast<std::size_t>(entry.hypothesis)].source;
  std::vector<ParameterEstimate> list;
  for (std::size_t c = 0; c < entry.columns.size(); ++c) {
    const auto column = static_cast<std::size_t>(entry.columns[c]);
    const LinearParameter& p =
        source.linear[static_cast<std::size_t>(found.moments.coefficient[column])];
    const auto at = static_cast<Index>(c);
    list.push_back(
        {p.name, p.unit, fit.coefficients(at), standard_deviation(fit.covariance(at, at)), {}});
  }
  if (source.kind == CandidateKind::delay) return list;
  const Shape& shape = found.all.shapes[static_cast<std::size_t>(entry.shapes.front())];
  for (Index k = 0; k < shape.nonlinear.size(); ++k) {
    const NonlinearParameter& range = source.nonlinear[static_cast<std::size_t>(k)];
    const double value = shape.nonlinear(k);
    list.push_back({range.name, range.unit, value, range.step_at(value) / std::sqrt(12.0), {}});
  }
  return list;
}

/// Both have one coefficient (Shape::neighbours).
std::vector<ParameterEstimate> between_two_shapes(const FoundSlots& found, const SlotFit& fit) {
  const Entry& entry = *fit.entry;
  const Candidate& source = *found.all.list[static_cast<std::size_t>(entry.hypothesis)].source;
  const LinearParameter& p = source.linear.front();
  const VectorXd& b = fit.coefficients;
  std::vector<ParameterEstimate> list{
      {p.name, p.unit, b.sum(), standard_deviation(fit.covariance.sum()), {}}};
  const double whole = std::max(b.cwiseAbs().sum(), 1e-300), share = std::abs(b(1)) / whole;
  // Both act the same way, or there is no such entry.
  const Eigen::Vector2d slope(-share / whole, (1.0 - share) / whole);
  const double share_error = standard_deviation(slope.dot(fit.covariance * slope));
  const auto shape = [&](std::size_t i) {
    return found.all.shapes[static_cast<std::size_t>(entry.shapes[i])].nonlinear;
  };
  const VectorXd value = shape_between(source.nonlinear, shape(0), shape(1), share);
  for (Index k = 0; k < value.size(); ++k) {
    const NonlinearParameter& range = source.nonlinear[static_cast<std::size_t>(k)];
    const double first = shape(0)(k), second = shape(1)(k);
    const double reach = range.logarithmic ? value(k) * std::log(second / first) : second - first;
    list.push_back({range.name,
                    range.unit,
                    value(k),
                    std::abs(reach) * std::min(share_error, 1.0 / std::sqrt(12.0)),
                    {}});
  }
  return list;
}

}  // namespace

VectorXd shape_between(const std::vector<NonlinearParameter>& ranges, const VectorXd& first,
                       const VectorXd& second, double share) {
  VectorXd between = first;
  for (Index k = 0; k < between.size(); ++k) {
    const bool logarithmic = ranges[static_cast<std::size_t>(k)].logarithmic;
    between(k) = logarithmic ? first(k) * std::pow(second(k) / first(k), share)
                             : (1.0 - share) * first(k) + share * second(k);
  }
  return between;
}

std::vector<std::vector<ParameterEstimate>> slot_estimates(const FoundSlots& found,
                                                           const std::vector<std::size_t>& slots) {
  std::vector<std::vector<ParameterEstimate>> list;
  if (slots.empty()) return list;
  for (const SlotFit& fit : fitted_slots(found, slots))
    list.push_back(fit.entry->shapes.size() > 1 ? between_two_shapes(found, fit)
                                                : of_one_shape(found, fit));
  return list;
}

}  // namespace sinew::diagnosis
