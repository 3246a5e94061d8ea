// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/wrist.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "symbolic/expressions/evaluate_function.h"
#include "tests/symbolic/parts/differences.h"
#include "tests/symbolic/parts/hand_parameters.h"

using namespace sinew;
using namespace sinew_tests;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double a = 0.050, b = 0.042, c = 0.036;
const double r = std::sqrt(a * a + b * b + c * c);
const Vector3d A0(0, b / 2, c), B0(0, 0, 0), C0(0, b, 0);

/// Largest of the six errors of length [m] of points given as rows A, B, C.
double constraint_error(const std::vector<double>& rows) {
  const Vector3d A(rows[0], rows[1], rows[2]), B(rows[3], rows[4], rows[5]),
      C(rows[6], rows[7], rows[8]);
  const double side = std::hypot(b / 2, c);
  double worst = 0;
  for (const double error :
       {(A - A0).norm() - std::hypot(a, c), (B - B0).norm() - r, (C - C0).norm() - r,
        (A - B).norm() - side, (A - C).norm() - side, (B - C).norm() - b})
    worst = std::max(worst, std::abs(error));
  return worst;
}

/// The same points found numerically: B by turning the bar, then Newton on the five distances left
/// and on C lying in the bar plane, following the motion from the reference pose.
struct NumericWrist {
  Vector3d A{a, b / 2, 0}, C{a, 0, c};

  void follow(double q71, double q73) {
    const Vector3d e(std::cos(q71), 0, std::sin(q71)), n(-std::sin(q71), 0, std::cos(q71));
    const Vector3d B = r * (std::sin(q73) * e + std::cos(q73) * Vector3d::UnitY());
    for (int i = 0; i < 20; ++i) {
      Eigen::Matrix<double, 6, 1> error;
      Eigen::Matrix<double, 6, 6> slope = Eigen::Matrix<double, 6, 6>::Zero();
      const double side = b * b / 4 + c * c;
      error << (C - C0).squaredNorm() - r * r, (B - C).squaredNorm() - b * b, n.dot(C),
          (A - A0).squaredNorm() - a * a - c * c, (A - B).squaredNorm() - side,
          (A - C).squaredNorm() - side;
      slope.block<1, 3>(0, 3) = 2 * (C - C0).transpose();
      slope.block<1, 3>(1, 3) = 2 * (C - B).transpose();
      slope.block<1, 3>(2, 3) = n.transpose();
      slope.block<1, 3>(3, 0) = 2 * (A - A0).transpose();
      slope.block<1, 3>(4, 0) = 2 * (A - B).transpose();
      slope.block<1, 3>(5, 0) = 2 * (A - C).transpose();
      slope.block<1, 3>(5, 3) = -2 * (A - C).transpose();
      const Eigen::Matrix<double, 6, 1> step = slope.fullPivLu().solve(error);
      A -= step.head<3>();
      C -= step.tail<3>();
    }
  }
};

std::vector<double> bars(const Function& inverse, double flexion, double abduction) {
  std::vector<double> q = evaluate(inverse, {flexion * degree, abduction * degree});
  REQUIRE(q[2] < 1e-14);  // residual
  REQUIRE(q[3] == 0.0);   // status
  q.resize(2);
  return q;
}

/// R² of the best straight line through (x, y).
double straightness(const std::vector<double>& x, const std::vector<double>& y) {
  const Eigen::Map<const Eigen::VectorXd> u(x.data(), Eigen::Index(x.size())),
      v(y.data(), Eigen::Index(y.size()));
  const Eigen::VectorXd du = u.array() - u.mean(), dv = v.array() - v.mean();
  return std::pow(du.dot(dv), 2) / (du.squaredNorm() * dv.squaredNorm());
}

}  // namespace

TEST_CASE("reference pose of the wrist", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const double q71 = reference_q71(p), q73 = reference_q73(p);
  CHECK(q71 / degree == Approx(35.75).margin(0.005));
  CHECK(q73 / degree == Approx(55.72).margin(0.005));
  const std::vector<double> T = evaluate(wrist_pose(p), {q71, q73});
  const std::vector<double> expected{1, 0, 0, a, 0, 1, 0, b / 2, 0, 0, 1, c / 2, 0, 0, 0, 1};
  for (std::size_t i = 0; i < 16; ++i) CHECK(T[i] == Approx(expected[i]).margin(2e-16));
  for (const double angle : evaluate(wrist_palm_angles(p), {q71, q73}))
    CHECK(std::abs(angle) < 3e-16);
  CHECK(evaluate(wrist_status(p), {q71, q73})[0] == 0.0);
  const auto distance = evaluate(wrist_singularity(p), {q71, q73});
  CHECK(distance[0] == Approx(q73));
  CHECK(distance[1] == Approx(90 * degree).margin(1e-7));
}

TEST_CASE("six distances hold to rounding over the palm's range", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const Function points = wrist_points(p), inverse = wrist_bar_angles(p),
                 angles = wrist_palm_angles(p);
  const std::vector<Range> ranges = bar_ranges(p);
  double worst = 0, worst_angle = 0;
  for (int flexion = -30; flexion <= 30; ++flexion)
    for (int abduction = -20; abduction <= 20; ++abduction) {
      const std::vector<double> q = bars(inverse, flexion, abduction);
      worst = std::max(worst, constraint_error(evaluate(points, q)));
      const std::vector<double> palm = evaluate(angles, q);
      worst_angle = std::max({worst_angle, std::abs(palm[0] - flexion * degree),
                              std::abs(palm[1] - abduction * degree)});
      for (std::size_t j = 0; j < 2; ++j) CHECK((q[j] >= ranges[j].low && q[j] <= ranges[j].high));
    }
  INFO("distances " << worst << " m, palm angles after the inverse map " << worst_angle << " rad");
  CHECK(worst <= 1e-15);
  CHECK(worst_angle <= 2e-15);
  // The check sees a femtometre's hundredfold.
  std::vector<double> moved = evaluate(points, bars(inverse, 10, 10));
  moved[0] += 1e-13;
  CHECK(constraint_error(moved) > 1e-15);
}

TEST_CASE("closed form equals a numeric solution of the constraints", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const Function points = wrist_points(p), inverse = wrist_bar_angles(p);
  for (const double flexion : {-30.0, -12.0, 0.0, 17.0, 30.0})
    for (const double abduction : {-20.0, -7.0, 0.0, 20.0}) {
      NumericWrist numeric;
      const std::vector<double> q = bars(inverse, flexion, abduction);
      for (int i = 1; i <= 20; ++i)
        numeric.follow(reference_q71(p) + (q[0] - reference_q71(p)) * i / 20,
                       reference_q73(p) + (q[1] - reference_q73(p)) * i / 20);
      const std::vector<double> rows = evaluate(points, q);
      CHECK((numeric.A - Vector3d(rows[0], rows[1], rows[2])).norm() < 1e-14);
      CHECK((numeric.C - Vector3d(rows[6], rows[7], rows[8])).norm() < 1e-14);
    }
}

TEST_CASE("palm frame is orthonormal and built on A, B, C", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const std::vector<double> q{0.75, 1.1};
  const auto T = evaluate(wrist_pose(p), q), rows = evaluate(wrist_points(p), q);
  Matrix3d R;
  R << T[0], T[1], T[2], T[4], T[5], T[6], T[8], T[9], T[10];
  CHECK((R.transpose() * R - Matrix3d::Identity()).norm() < 1e-15);
  CHECK(R.determinant() == Approx(1.0).epsilon(1e-15));
  const Vector3d A(rows[0], rows[1], rows[2]), B(rows[3], rows[4], rows[5]),
      C(rows[6], rows[7], rows[8]), M = (B + C) / 2;
  CHECK((R.col(1) - (B - C).normalized()).norm() < 1e-15);
  CHECK((R.col(2) - (M - A).normalized()).norm() < 1e-15);
  CHECK((Vector3d(T[3], T[7], T[11]) - (A + M) / 2).norm() < 1e-16);
}

TEST_CASE("palm flexes at twice the bar rate near the reference", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const auto rate = difference(wrist_palm_angles(p), {reference_q71(p), reference_q73(p)}, 0);
  CHECK(rate[0] == Approx(2.0).epsilon(1e-12));
}

TEST_CASE("wrist couples little in flexion and linearly in abduction", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const Function lengths = wrist_tendon_lengths(p), inverse = wrist_bar_angles(p);
  const auto neutral = evaluate(lengths, bars(inverse, 0, 0));
  double flexion_coupling = 0;
  for (const double flexion : {-30.0, 30.0}) {
    const auto h = evaluate(lengths, bars(inverse, flexion, 0));
    for (std::size_t i = 0; i < 38; ++i)
      flexion_coupling = std::max(flexion_coupling, std::abs(h[i] - neutral[i]));
  }
  CHECK(flexion_coupling == Approx(0.74e-3).margin(0.01e-3));
  CHECK(flexion_coupling <= 0.75e-3);
  for (const double abduction : {-20.0, 20.0})
    for (const std::size_t layer : {0u, 19u}) {
      const auto h = evaluate(lengths, bars(inverse, 0, abduction));
      std::vector<double> change, distance;
      for (std::size_t i = layer; i < layer + 19; ++i) {
        change.push_back(h[i] - neutral[i]);
        distance.push_back(p.palm_points[i].y());
      }
      CHECK(straightness(distance, change) >= 0.99);
      change[0] = change[18];  // a swapped tendon shows
      CHECK(straightness(distance, change) < 0.99);
    }
}

TEST_CASE("tendon lengths, Jacobian and Hessian against 50 digits", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const Function lengths = wrist_tendon_lengths(p), jacobian = wrist_tendon_jacobian(p),
                 hessian = wrist_tendon_hessian(p);
  for (const std::vector<double>& q :
       {std::vector<double>{0.4, 0.8}, {0.624, 0.9725}, {0.88, 1.25}, {0.37, 1.27}}) {
    const auto h = evaluate(lengths, q), P = evaluate(jacobian, q), H = evaluate(hessian, q);
    const std::vector<GiNaC::numeric> exact{binary_fraction(q[0]), binary_fraction(q[1])};
    const auto h50 = evaluate_precisely(lengths, exact), P50 = evaluate_precisely(jacobian, exact),
               H50 = evaluate_precisely(hessian, exact);
    double error_h = 0, error_P = 0, error_H = 0, scale_P = 0, scale_H = 0;
    for (std::size_t i = 0; i < h.size(); ++i)
      error_h = std::max(error_h, std::abs((h50[i] - binary_fraction(h[i])).to_double()));
    for (std::size_t i = 0; i < P.size(); ++i) {
      error_P = std::max(error_P, std::abs((P50[i] - binary_fraction(P[i])).to_double()));
      scale_P = std::max(scale_P, std::abs(P[i]));
    }
    for (std::size_t i = 0; i < H.size(); ++i) {
      error_H = std::max(error_H, std::abs((H50[i] - binary_fraction(H[i])).to_double()));
      scale_H = std::max(scale_H, std::abs(H[i]));
    }
    CHECK(error_h <= 1e-14);
    CHECK(error_P <= 1e-12 * scale_P);
    CHECK(error_H <= 1e-12 * scale_H);
    for (std::size_t j = 0; j < 2; ++j) {
      const auto slope = difference(lengths, q, j), curvature = difference(jacobian, q, j);
      for (std::size_t i = 0; i < 38; ++i) {
        CHECK(P50[2 * i + j].to_double() == Approx(slope[i]).epsilon(1e-13).margin(1e-17));
        for (std::size_t k = 0; k < 2; ++k)
          CHECK(H50[4 * i + 2 * j + k].to_double() ==
                Approx(curvature[2 * i + k]).epsilon(1e-13).margin(1e-16));
      }
    }
  }
}

TEST_CASE("feedforward takes up what the wrist changes", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const std::vector<double> q{0.8, 1.1}, rate{0.7, -0.4};
  const auto h = evaluate(wrist_tendon_lengths(p), q),
             h0 = evaluate(wrist_tendon_lengths(p), {reference_q71(p), reference_q73(p)}),
             delta = evaluate(wrist_feedforward(p), q),
             deltas = evaluate(wrist_feedforward_rate(p), {q[0], q[1], rate[0], rate[1]}),
             by_q71 = difference(wrist_feedforward(p), q, 0),
             by_q73 = difference(wrist_feedforward(p), q, 1);
  for (std::size_t i = 0; i < 38; ++i) {
    CHECK(p.motor_radius * delta[i] + h[i] == Approx(h0[i]).epsilon(1e-15));
    CHECK(deltas[i] == Approx(by_q71[i] * rate[0] + by_q73[i] * rate[1]).epsilon(1e-12));
  }
}

TEST_CASE("wrist torque and stiffness follow from the stored energy", "[wrist]") {
  const WristParameters p = wrist_parameters();
  std::mt19937 random(7);
  std::vector<double> q{0.7, 1.05}, f, k;
  for (int i = 0; i < 38; ++i) {
    f.push_back(std::uniform_real_distribution<double>(1, 90)(random));
    k.push_back(std::uniform_real_distribution<double>(3e3, 4e4)(random));
  }
  std::vector<double> with_forces = q;
  with_forces.insert(with_forces.end(), f.begin(), f.end());
  const auto tau = evaluate(wrist_joint_torque(p), with_forces);
  const auto P = evaluate(wrist_tendon_jacobian(p), q);
  double tau0 = 0;
  for (std::size_t i = 0; i < 38; ++i) tau0 -= P[2 * i] * f[i];
  CHECK(tau[0] == Approx(tau0).epsilon(1e-13));
  // K = -dtau/dq: at constant force from the torque itself, plus P^T k P from the force law.
  std::vector<double> everything = with_forces;
  everything.insert(everything.end(), k.begin(), k.end());
  const auto K = evaluate(wrist_joint_stiffness(p), everything);
  CHECK(K[1] == K[2]);
  for (std::size_t j = 0; j < 2; ++j) {
    const auto slope = difference(wrist_joint_torque(p), with_forces, j);
    for (std::size_t i = 0; i < 2; ++i) {
      double expected = -slope[i];
      for (std::size_t t = 0; t < 38; ++t) expected += P[2 * t + i] * k[t] * P[2 * t + j];
      CHECK(K[2 * i + j] == Approx(expected).epsilon(1e-12));
    }
  }
  const Function coupled = wrist_finger_stiffness(p, "finger_stiffness", {3, 20}, 2);
  const auto K_wf = evaluate(coupled, {q[0], q[1], 1e4, 2e4, 0.006, 0.001, -0.004, 0.005});
  CHECK(K_wf[0] == Approx(P[6] * 1e4 * 0.006 + P[40] * 2e4 * -0.004).margin(1e-14));
  CHECK(K_wf[3] == Approx(P[7] * 1e4 * 0.001 + P[41] * 2e4 * 0.005).margin(1e-14));
}

TEST_CASE("bending angles are those of the strands against both x axes", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const std::vector<double> q{0.8, 1.1};
  const auto angles = evaluate(wrist_bending_angles(p), q), T = evaluate(wrist_pose(p), q);
  Eigen::Matrix4d pose = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(T.data());
  for (std::size_t i = 0; i < 38; ++i) {
    const Vector3d strand = (pose * p.palm_points[i].homogeneous()).head<3>() - p.forearm_points[i];
    const double expected = std::acos(strand.normalized().x()) +
                            std::acos(strand.normalized().dot(pose.col(0).head<3>()));
    CHECK(angles[i] == Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("wrist stays defined at and beyond its singular poses", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const Function pose = wrist_pose(p), hessian = wrist_tendon_hessian(p), status = wrist_status(p),
                 singularity = wrist_singularity(p), points = wrist_points(p);
  // The dead centre by bisection along q71.
  double regular = reference_q71(p), singular = -1.0;
  const double q73 = 0.7;
  REQUIRE(evaluate(status, {singular, q73})[0] == 1.0);
  for (int i = 0; i < 60; ++i) {
    const double middle = (regular + singular) / 2;
    (evaluate(status, {middle, q73})[0] == 0.0 ? regular : singular) = middle;
  }
  INFO("dead centre at q71 = " << singular / degree << " deg");
  CHECK(evaluate(singularity, {singular, q73})[1] < 1e-5);
  for (const double centre : {singular, 0.0})
    for (int ulps = -1000; ulps <= 1000; ulps += 50) {
      const double moved = centre + ulps * (centre == 0.0 ? 1e-17 : 4.4e-16);
      const std::vector<double> q =
          centre == 0.0 ? std::vector<double>{0.6, moved} : std::vector<double>{moved, q73};
      const double s = evaluate(status, q)[0];
      CHECK((s == 0.0 || s == 1.0));
      CHECK(all_finite(evaluate(pose, q)));
      CHECK(all_finite(evaluate(hessian, q)));
      CHECK(all_finite(evaluate(singularity, q)));
    }
  CHECK(evaluate(status, {0.6, 0.0})[0] == 1.0);
  CHECK(evaluate(status, {0.6, -0.1})[0] == 1.0);
  // Up to the margin the links keep their lengths.
  CHECK(constraint_error(evaluate(points, {regular, q73})) < 1e-15);
}

TEST_CASE("wrist functions are finite for any input", "[wrist]") {
  const WristParameters p = wrist_parameters();
  const std::vector<Function> functions{wrist_pose(p), wrist_palm_angles(p), wrist_bar_angles(p),
                                        wrist_tendon_jacobian(p), wrist_singularity(p)};
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(-8, 8);
  for (int i = 0; i < 300; ++i) {
    const std::vector<double> q{anywhere(random), anywhere(random)};
    for (const Function& function : functions) CHECK(all_finite(evaluate(function, q)));
  }
  CHECK(evaluate(wrist_bar_angles(p), {2.5, 0.1})[3] == 1.0);
  CHECK(evaluate(wrist_bar_angles(p), {0.1, -4.0})[3] == 1.0);
}
