// SPDX-License-Identifier: GPL-3.0-or-later
// The wrist's emitted C against the derivation evaluated with 50 digits.
#include <algorithm>
#include <cmath>

#include "generator/evaluate.h"
#include "generator/lower.h"
#include "symbolic/parts/part.h"
#include "tests/symbolic/hand/palm_pose.h"

using namespace sinew;
using namespace sinew_tests;

namespace {

WristParameters wrist_parameters() {
  const Part part = read_part(std::string(SINEW_SOURCE_DIR) + "/models/wrist");
  return std::get<WristParameters>(part.parameters);
}

struct Comparison {
  double error = 0;  ///< largest difference
  double scale = 0;  ///< largest magnitude
};

Comparison compare(const Graph& graph, const Values& emitted, const Values& q) {
  const std::vector<Exact> exact = evaluate<Exact>(graph, {Exact(q[0]), Exact(q[1])});
  REQUIRE(exact.size() == emitted.size());
  Comparison result;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double error = static_cast<double>(abs(exact[i] - Exact(emitted[i])));
    // NaN must not pass as small.
    result.error = error <= result.error ? result.error : error;
    result.scale = std::max(result.scale, std::abs(static_cast<double>(exact[i])));
  }
  return result;
}

}  // namespace

TEST_CASE("lengths, Jacobian and Hessian of the wrist's tendons against 50 digits", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const Graph lengths = lower(wrist_tendon_lengths(p)), jacobian = lower(wrist_tendon_jacobian(p)),
              hessian = lower(wrist_tendon_hessian(p));
  Comparison h, P, H;
  const auto worse = [](Comparison a, const Comparison& b) {
    return Comparison{std::max(a.error, b.error), std::max(a.scale, b.scale)};
  };
  for (int flexion = -30; flexion <= 30; flexion += 15)
    for (int abduction = -20; abduction <= 20; abduction += 10) {
      const Values q = bars(flexion, abduction);
      h = worse(h, compare(lengths, call(wrist_catalogue, "tendon_lengths", q), q));
      P = worse(P, compare(jacobian, call(wrist_catalogue, "tendon_jacobian", q), q));
      H = worse(H, compare(hessian, call(wrist_catalogue, "tendon_hessian", q), q));
    }
  CAPTURE(h.error, P.error / P.scale, H.error / H.scale);
  CHECK(h.error <= 1e-14);
  CHECK(P.error <= 1e-12 * P.scale);
  CHECK(H.error <= 1e-12 * H.scale);
  // A digit lost in the thirteenth place shows.
  const Values q = bars(12, 5);
  Values spoilt = call(wrist_catalogue, "tendon_lengths", q);
  spoilt[7] += 2e-14;
  CHECK(compare(lengths, spoilt, q).error > 1e-14);
  Values slopes = call(wrist_catalogue, "tendon_jacobian", q);
  slopes[40] *= 1 + 1e-8;
  CHECK(compare(jacobian, slopes, q).error > 1e-12 * P.scale);
}
