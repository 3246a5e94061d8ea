// SPDX-License-Identifier: GPL-3.0-or-later
// Bending angles of tendons against angles taken by hand from routing and pose.
#include "symbolic/tendons/tendon_bending.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/model/read_mechanism.h"

using namespace sinew;

namespace {

Mechanism model(const std::string& name) {
  return read_mechanism(std::string(SINEW_SOURCE_DIR) + "/models/" + name);
}

double between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The thumb's metacarpal: Rz(q10) Rx(90 deg) Rz(q11) Rx(-90 deg).
Eigen::Matrix3d metacarpal(double q10, double q11) {
  const double quarter = std::numbers::pi / 2;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  return (Eigen::AngleAxisd(q10, z) * Eigen::AngleAxisd(quarter, x) * Eigen::AngleAxisd(q11, z) *
          Eigen::AngleAxisd(-quarter, x))
      .toRotationMatrix();
}

/// Lean of tendon A's stretch at its two ends.
double lean(double q10, double q11) {
  const Eigen::Vector3d start(0.002, 0.03, -0.025), end(0.047, 0.006, -0.005);
  const Eigen::Matrix3d R = metacarpal(q10, q11);
  const Eigen::Vector3d now = R * end - start, rest = end - start;
  return between(now, rest) + between(R.transpose() * now, rest);
}

}  // namespace

TEST_CASE("over pulleys a tendon bends by the joints' angles", "[tendon_bending]") {
  const Function bending = tendon_bending_angles(model("index"));
  const auto angles = evaluate(bending, {0.1, -0.7, 0.9, -0.2});
  const double expected[] = {0.8, 0.8, 0.8, 0.8, 0.9, 0.9, 1.1, 1.1};
  REQUIRE(angles.size() == 8);
  for (std::size_t i = 0; i < 8; ++i) CHECK(angles[i] == Approx(expected[i]).epsilon(1e-15));
  for (const double angle : evaluate(bending, {0, 0, 0, 0})) CHECK(angle == 0.0);
}

TEST_CASE("a joint that follows another bends the tendon too", "[tendon_bending]") {
  const auto angles = evaluate(tendon_bending_angles(model("ring")), {0.1, -0.7, 0.9});
  REQUIRE(angles.size() == 6);
  CHECK(angles[0] == Approx(0.8).epsilon(1e-15));
  // rho = r42/r43; the drive tendons run over both.
  CHECK(angles[4] == Approx(0.9 * (1.0 + 0.0055 / 0.0045)).epsilon(1e-12));
}

TEST_CASE("a straight stretch bends at its ends as it leans", "[tendon_bending]") {
  const Function bending = tendon_bending_angles(model("thumb"));
  for (const double q10 : {-0.5, 0.0, 0.3})
    for (const double q11 : {-0.4, 0.0, 0.6}) {
      CAPTURE(q10, q11);
      const auto angles = evaluate(bending, {q10, q11, 0.4, -0.3});
      REQUIRE(angles.size() == 8);
      CHECK(angles[0] == Approx(lean(q10, q11)).epsilon(1e-9).margin(1e-12));
      CHECK(angles[4] == Approx(0.4).epsilon(1e-15));
      CHECK(angles[6] == Approx(0.7).epsilon(1e-15));
    }
}

TEST_CASE("a tendon over a joint that is not there is refused", "[tendon_bending]") {
  Mechanism finger = model("index");
  finger.tendons[0].pulleys[0].joint = "q99";
  CHECK_THROWS_AS(tendon_bending_angles(finger), std::invalid_argument);
}
