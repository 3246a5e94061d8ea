// SPDX-License-Identifier: GPL-3.0-or-later
// Evidence for docs/source_errata.md: what the source prints, evaluated, beside what is emitted.
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "index_catalogue.h"
#include "ring_catalogue.h"
#include "tests/skip.h"
#include "tests/symbolic/hand/model_values.h"
#include "tests/symbolic/hand/palm_pose.h"
#include "thumb_catalogue.h"
#include "thumb_table_5_2_catalogue.h"

using namespace sinew_tests;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace {

Matrix coupling(const sinew_catalogue& finger, const Values& q) {
  const Values P = call(finger, "coupling_matrix", q);
  const auto n = static_cast<Eigen::Index>(q.size());
  return Eigen::Map<const Matrix>(P.data(), static_cast<Eigen::Index>(P.size()) / n, n);
}

/// Whether pulling tendons alone can balance the thumb's base: 0 within the convex hull of the four
/// rows of P, which are points of a plane: no gap of π or more between their directions.
bool balanced(const sinew_catalogue& thumb, double q10, double q11) {
  const Matrix P = coupling(thumb, {q10, q11, 0, 0});
  Values angles;
  for (Eigen::Index i = 0; i < 4; ++i) angles.push_back(std::atan2(P(i, 1), P(i, 0)));
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles[0] + 2 * std::numbers::pi);
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (angles[i] - angles[i - 1] >= std::numbers::pi) return false;
  return true;
}

/// The smallest angle [deg], in steps of one, at which balance is lost along any direction.
int balance_limit(const sinew_catalogue& thumb) {
  for (int size = 0; size < 90; ++size)
    for (int direction = 0; direction < 360; direction += 5)
      if (!balanced(thumb, size * degree * std::cos(direction * degree),
                    size * degree * std::sin(direction * degree)))
        return size;
  return 90;
}

}  // namespace

TEST_CASE("(5.13): P (P P^T)^-1 does not exist, (P^T P)^-1 P^T does", "[errata]") {
  const Eigen::MatrixXd P = coupling(index_catalogue, {0, 0, 0, 0});
  CHECK(Eigen::FullPivLU<Eigen::MatrixXd>(P * P.transpose()).rank() == 4);  // of 8
  CHECK(Eigen::FullPivLU<Eigen::MatrixXd>(P.transpose() * P).rank() == 4);  // of 4
}

namespace {

/// Root mean square error [rad] after 50 steps from (0, 0) over ±40 degrees. As printed, C_best
/// stays infinite, so that every step is taken and none halved.
double search_error(double first_step, bool as_printed) {
  double sum = 0;
  int count = 0;
  for (int i = -40; i <= 40; i += 8)
    for (int j = -40; j <= 40; j += 8, count += 2) {
      const double truth[2] = {i * degree, j * degree};
      Values h = call(thumb_catalogue, "tendon_lengths", {truth[0], truth[1], 0, 0});
      h.resize(4);
      Values search{0, 0, 0, 0, first_step, 1};
      for (int step = 0; step <= 50; ++step) {
        search = call(thumb_catalogue, "link_position_gradient_step", joined(h, search));
        if (as_printed) search[5] = 1e9;
      }
      sum += std::pow(search[0] - truth[0], 2) + std::pow(search[1] - truth[1], 2);
    }
  return std::sqrt(sum / count);
}

}  // namespace

TEST_CASE("Algorithm 1 as printed has no guard against too long a step", "[errata]") {
  for (const double first_step : {1200.0, 2400.0}) {
    const double printed = search_error(first_step, true),
                 corrected = search_error(first_step, false);
    CAPTURE(first_step, printed, corrected);
    CHECK(printed > 0.05);
    CHECK(corrected < 1e-3);
  }
  // With a step that is short enough both arrive.
  for (const double first_step : {300.0, 600.0}) CHECK(search_error(first_step, true) < 1e-6);
}

TEST_CASE("(5.16): the coupling ratio is r42/r43, not its inverse", "[errata]") {
  // A loop of constant length over both pulleys: r42 q42 = r43 q43. The drive tendons pass both.
  const double r42 = radius("ring", "h5", 0), r43 = radius("ring", "h5", 1);
  const Matrix P = coupling(ring_catalogue, {0, 0, 0});
  CHECK(P(4, 2) == Approx(r42 + r42 / r43 * r43).epsilon(1e-14));
  CHECK(std::abs(P(4, 2) - (r42 + r43 / r42 * r43)) > 0.1 * r42);  // as printed
  CHECK(std::abs(P(4, 2) - (r42 + r43)) > 0.1 * r42);              // (5.18) as printed
}

TEST_CASE("(5.21) is minus the derivative of (5.22)", "[errata]") {
  const double r12 = radius("thumb", "h4", 0), r13 = radius("thumb", "h6", 1);
  const Matrix P = coupling(thumb_catalogue, {0.1, 0.2, 0.3, 0.4});
  CHECK(P(4, 2) == r12);
  CHECK(P(6, 2) == -r12);
  CHECK(P(6, 3) == r13);
  CHECK(P(7, 3) == -r13);
}

TEST_CASE("Table 5.2's distal points lose the balance of pulling tendons", "[errata]") {
  const int as_printed = balance_limit(thumb_table_5_2_catalogue),
            by_default = balance_limit(thumb_catalogue);
  CAPTURE(as_printed, by_default);
  CHECK(as_printed >= 44);
  CHECK(as_printed <= 49);
  CHECK(by_default > as_printed);
}

TEST_CASE("(6.2): an arctangent of one argument puts C elsewhere for q73 < 0", "[errata]") {
  const double a = 0.050, b = 0.042, c = 0.036, r = std::sqrt(a * a + b * b + c * c);
  double worst = 0;
  for (double q73 = -60 * degree; q73 < 0; q73 += degree) {
    const double t_B = std::numbers::pi / 2 - q73;
    const double y = (r * r + b * b) * std::sin(t_B) - 2 * r * b,
                 x = (r * r - b * b) * std::cos(t_B);
    const double right = std::atan2(y, x), printed = std::atan(y / x);
    worst = std::max(worst, 2 * r * std::abs(std::sin((right - printed) / 2)));
    // Both satisfy the crossed loop's ratio, but only one keeps |BC| = b.
    const double B_x = r * std::cos(t_B), B_y = r * std::sin(t_B);
    const auto side = [&](double t) {
      return std::hypot(r * std::cos(t) - B_x, b + r * std::sin(t) - B_y);
    };
    CHECK(side(right) == Approx(b).epsilon(1e-12));
    CHECK(std::abs(side(printed) - b) > 1e-3);
  }
  CAPTURE(worst);
  CHECK(worst > 0.069);
}

TEST_CASE("the reference pose has both bar angles away from zero", "[errata]") {
  const Values q = bars(0, 0);
  const sinew::WristParameters& p = wrist_values();
  CHECK(q[0] == Approx(std::atan2(p.thickness, p.length)).epsilon(1e-13));
  CHECK(q[1] ==
        Approx(std::acos(p.width / std::hypot(p.length, p.width, p.thickness))).epsilon(1e-13));
  if (is_wrist_of_the_source()) {
    CHECK(q[0] / degree == Approx(35.75).margin(0.005));
    CHECK(q[1] / degree == Approx(55.72).margin(0.005));
  } else {
    sinew::test::skip("the model is not the source's wrist, whose angles these are");
  }
  CHECK(call(wrist_catalogue, "status", {q[0], 0.0})[0] == 1.0);  // q73 = 0 is singular
}

TEST_CASE("the base joint moves when the index finger flexes", "[errata]") {
  // Inertial coupling of base abduction and flexion: zero only without lateral offsets.
  const Values M = call(index_catalogue, "mass_matrix", {0.0, 0.1, 0.0, 0.0});
  double coupled = 0;
  for (std::size_t j = 1; j < 4; ++j) coupled = std::max(coupled, std::abs(M[j]));
  CHECK(coupled > 1e-9);
}
