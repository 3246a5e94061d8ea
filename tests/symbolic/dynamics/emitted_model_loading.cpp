// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison itself, on a planar arm of two links written by hand from the textbook: right C
// passes, and each planted mistake is seen. No generator is involved.
#include <catch2/catch.hpp>

#include "tests/symbolic/dynamics/deviation.h"
#include "tests/symbolic/dynamics/mechanics_checks.h"

namespace sinew::reference {
namespace {

/// Two links of 0.3 m and 0.2 m about z, gravity along -y; see the C below.
Mechanism planar_arm() {
  Mechanism arm;
  arm.name = "arm";
  arm.gravity = {0.0, -9.81, 0.0};
  arm.bodies.push_back(
      {"upper", "", 2.0, {0.15, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 0.02, {}});
  arm.bodies.push_back({"lower", "", 1.0, {0.1, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 0.01, {}});
  arm.joints.resize(2);
  arm.joints[0].name = "shoulder";
  arm.joints[1].name = "elbow";
  arm.joints[1].parent = 0;
  arm.joints[1].origin.translation = {0.3, 0.0, 0.0};
  return arm;
}

const char* const kArm = R"(
#include <math.h>
#include "sinew_catalogue.h"
/* a + b cos(q1) and so on; constants of the two links */
enum { n = 2 };
static const double a = 2.0*0.15*0.15 + 0.02 + 1.0*(0.3*0.3 + 0.1*0.1) + 0.01;
static const double b = 2*0.3*0.1, d = 0.1*0.1 + 0.01;
static void mass(const double *q, double *m) {
  m[0] = a + b*cos(q[1]); m[1] = m[2] = d + 0.5*b*cos(q[1]); m[3] = d;
}
static void coriolis(const double *q, const double *v, double *c) {
  const double s = 0.5*b*sin(q[1]);
  c[0] = -s*v[1]; c[1] = -s*(v[0] + v[1]); c[2] = s*v[0]; c[3] = 0;
}
static void weight(const double *q, double *g) {
  g[1] = 9.81*0.1*cos(q[0] + q[1]); g[0] = 9.81*(2.0*0.15 + 0.3)*cos(q[0]) + g[1];
}
static void bias(const double *q, const double *v, double *h) {
  double c[4]; coriolis(q, v, c); weight(q, h);
  h[0] += c[0]*v[0] + c[1]*v[1]; h[1] += c[2]*v[0] + c[3]*v[1];
}
static void f_mass(const void *x, void *y) { mass(x, y); }
static void f_coriolis(const void *x, void *y) { coriolis(x, (const double *)x + n, y); }
static void f_gravity(const void *x, void *y) { weight(x, y); }
static void f_bias(const void *x, void *y) { bias(x, (const double *)x + n, y); }
static void f_inverse(const void *in, void *out) {
  const double *x = in; double *y = out, m[4]; mass(x, m); bias(x, x + 2, y);
  y[0] += m[0]*x[4] + m[1]*x[5]; y[1] += m[2]*x[4] + m[3]*x[5];
}
static void f_forward(const void *in, void *out) {
  const double *x = in; double *y = out, m[4], h[2]; mass(x, m); bias(x, x + 2, h);
  const double r0 = x[4] - h[0], r1 = x[5] - h[1], det = m[0]*m[3] - m[1]*m[2];
  y[0] = (m[3]*r0 - m[1]*r1)/det; y[1] = (m[0]*r1 - m[2]*r0)/det;
}
static const sinew_argument vector[] = {{"v", "", 2, 1, 0, 0}, {"v", "", 2, 1, 0, 0}, {"v", "", 2, 1, 0, 0}};
static const sinew_argument matrix[] = {{"m", "", 2, 2, 0, 0}};
static const sinew_function functions[] = {
  {"arm_mass_matrix", 1, 1, 2, 4, vector, matrix, f_mass},
  {"arm_coriolis_matrix", 2, 1, 4, 4, vector, matrix, f_coriolis},
  {"arm_gravity", 1, 1, 2, 2, vector, vector, f_gravity},
  {"arm_bias", 2, 1, 4, 2, vector, vector, f_bias},
  {"arm_inverse_dynamics", 3, 1, 6, 2, vector, vector, f_inverse},
  {"arm_forward_dynamics", 3, 1, 6, 2, vector, vector, f_forward}};
const sinew_catalogue arm_catalogue = {"arm", "", 8, 6, functions};
)";

/// The arm's C with one text replaced by another, compiled and loaded.
EmittedModel arm_with(const std::string& from = "", const std::string& to = "") {
  std::string text = kArm;
  if (!from.empty()) {
    REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), from.size(), to);
  }
  const TemporaryFolder folder;
  write_text(folder.path() / "arm_catalogue.c", text);
  return EmittedModel(folder.path());
}

const Deviation& of(const std::vector<Deviation>& deviations, const std::string& function) {
  for (const Deviation& each : deviations)
    if (each.function == function) return each;
  throw std::out_of_range(function);
}

bool all_hold(const std::vector<LawCheck>& checks) {
  for (const LawCheck& check : checks)
    if (!check.holds()) return false;
  return true;
}

const ComparisonSize kSmall{200, 50, 1};

TEST_CASE("right C agrees with the reference and obeys mechanics") {
  const EmittedModel arm = arm_with();
  CHECK(arm.model() == "arm");
  const auto deviations = compare(arm, planar_arm(), kSmall);
  INFO(describe(deviations));
  for (const Deviation& each : deviations) {
    CHECK(each.relative < 1e-12);
    CHECK(each.units < 16);
  }
  const auto states = sample_states(planar_arm(), 50, 3);
  const auto laws = rigid_body_laws(arm, states);
  INFO(describe(laws));
  CHECK(all_hold(laws));
  CHECK(energy_law(arm, planar_arm(), states.back(), 0.5).holds());
}

TEST_CASE("a Coriolis term with the wrong sign is seen") {
  const EmittedModel arm = arm_with("c[2] = s*v[0]", "c[2] = -s*v[0]");
  const auto deviations = compare(arm, planar_arm(), kSmall);
  CHECK(of(deviations, "coriolis_matrix").units > 16);
  CHECK(of(deviations, "bias").relative > 1e-12);
  CHECK(of(deviations, "mass_matrix").units < 16);
  const auto states = sample_states(planar_arm(), 50, 3);
  const auto laws = rigid_body_laws(arm, states);
  REQUIRE(laws[2].law == "Mdot - 2C is skew-symmetric");
  CHECK_FALSE(laws[2].holds());
  CHECK_FALSE(energy_law(arm, planar_arm(), states.back(), 0.5).holds());
}

TEST_CASE("a Coriolis matrix that is not Christoffel's but gives the right torque is seen") {
  const EmittedModel arm =
      arm_with("c[0] = -s*v[1]; c[1] = -s*(v[0] + v[1])", "c[0] = 0; c[1] = -s*(2*v[0] + v[1])");
  const auto deviations = compare(arm, planar_arm(), kSmall);
  CHECK(of(deviations, "bias").units < 16);
  CHECK(of(deviations, "coriolis_matrix").units > 16);
  CHECK_FALSE(all_hold(rigid_body_laws(arm, sample_states(planar_arm(), 20, 3))));
}

TEST_CASE("an inertia that is off by 1e-9 of itself is seen") {
  Mechanism changed = planar_arm();
  changed.bodies[1].inertia *= 1.0 + 1e-9;
  const auto deviations = compare(arm_with(), changed, kSmall);
  CHECK(of(deviations, "mass_matrix").relative > 1e-12);
  CHECK(of(deviations, "inverse_dynamics").units > 16);
  CHECK(of(deviations, "gravity").units < 16);
}

TEST_CASE("a result that is not a number, unwritten or missing is seen") {
  const EmittedModel unwritten = arm_with("m[3] = d;", "");
  CHECK_FALSE(of(compare(unwritten, planar_arm(), kSmall), "mass_matrix").units < 16);
  CHECK_FALSE(all_hold(rigid_body_laws(unwritten, sample_states(planar_arm(), 5, 3))));
  const EmittedModel missing = arm_with("arm_gravity", "arm_levity");
  CHECK_FALSE(of(compare(missing, planar_arm(), kSmall), "gravity").relative < 1);
  CHECK_THROWS_AS(missing.call("gravity", {0.0, 0.0}), std::out_of_range);
  CHECK_THROWS_AS(missing.call("mass_matrix", {0.0}), std::invalid_argument);
}

TEST_CASE("C that does not compile is reported with the compiler's words") {
  CHECK_THROWS_WITH(arm_with("static void mass", "static voyd mass"),
                    Catch::Matchers::Contains("voyd"));
}

}  // namespace
}  // namespace sinew::reference
