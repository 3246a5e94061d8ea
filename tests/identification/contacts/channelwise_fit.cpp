// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/contacts/channelwise_fit.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Index kRows = 400;

double value(Index row, Index column) {
  return std::sin(0.37 * static_cast<double>(row * (column + 1)) + static_cast<double>(column));
}

/// Two logs of two channels: three columns of the first channel, the third of which is the second
/// one times two, two of the second channel, two that both share, and one that is nowhere.
Stack two_channels() {
  Stack s;
  s.coefficients = 8;
  s.prior = VectorXd::Zero(8);
  s.prior(5) = 3.0;
  const std::vector<std::vector<Index>> at{{0, 1, 2, 5, 6}, {3, 4, 5, 6}};
  s.first_row = {0};
  for (int segment = 0; segment < 4; ++segment) {
    s.at.push_back(at[static_cast<std::size_t>(segment % 2)]);
    MatrixXd a(kRows, static_cast<Index>(s.at.back().size()));
    for (Index r = 0; r < kRows; ++r)
      for (Index c = 0; c < a.cols(); ++c)
        a(r, c) = value(r + kRows * segment, s.at.back()[static_cast<std::size_t>(c)]);
    if (segment % 2 == 0) a.col(2) = 2.0 * a.col(1);
    s.a.push_back(a);
    s.first_row.push_back(s.first_row.back() + kRows);
  }
  s.y = VectorXd::NullaryExpr(s.first_row.back(),
                              [](Index r) { return value(r, 20) + 0.3 * value(r, 5); });
  return s;
}

VectorXd said(const Stack& s, const VectorXd& coefficients) {
  return s.dense() * coefficients;
}

}  // namespace

TEST_CASE("a fit by channels says what the whole one does") {
  // Planted defects, each seen to fail: shared columns not freed of what a channel's own take, a
  // prior left out.
  const std::vector<int> channel{0, 1, 0, 1};
  Stack s = two_channels();
  const LinearFit fit = solve(s);
  const ChannelwiseFit channelwise(s, channel);
  const VectorXd whole = fit.coefficients, by_parts = channelwise.coefficients();
  CHECK((said(s, whole) - said(s, by_parts)).norm() < 1e-9 * s.y.norm());
  CHECK(by_parts(7) == 0.0);
  for (const Index row : {Index{3}, kRows + 3}) {
    const VectorXd x = s.dense().row(row).transpose();
    CHECK(channelwise.variance(x) == Approx(x.dot(fit.covariance * x)).epsilon(1e-9));
  }
  // What both share is in the second channel one of its own columns, and in the first one nothing.
  for (const std::size_t k : {0U, 1U, 2U, 3U}) {
    const Index shared = k % 2 == 0 ? 4 : 3;
    s.a[k].col(shared) = k % 2 == 0 ? VectorXd(VectorXd::Zero(kRows)) : VectorXd(s.a[k].col(1));
  }
  CHECK(
      (said(s, solve(s).coefficients) - said(s, ChannelwiseFit(s, channel).coefficients())).norm() <
      1e-9 * s.y.norm());
}
