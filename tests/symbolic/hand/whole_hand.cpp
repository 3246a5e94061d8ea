// SPDX-License-Identifier: GPL-3.0-or-later
// The hand's emitted C against its parts: fingers, four-bar and wrist.
#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "fifth_catalogue.h"
#include "hand_catalogue.h"
#include "hmc_catalogue.h"
#include "index_catalogue.h"
#include "middle_catalogue.h"
#include "ring_catalogue.h"
#include "tests/symbolic/hand/model_values.h"
#include "tests/symbolic/hand/palm_pose.h"
#include "thumb_catalogue.h"

using namespace sinew_tests;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace {

constexpr std::size_t coordinates = 19, tendons = 38;

/// Where each member's coordinates and channels begin.
struct Member {
  const sinew_catalogue* model;
  std::size_t first, count, channel, tendons;
};

const Member members[] = {{&thumb_catalogue, 0, 4, 0, 8},   {&index_catalogue, 4, 4, 8, 8},
                          {&middle_catalogue, 8, 4, 16, 8}, {&ring_catalogue, 12, 3, 24, 6},
                          {&fifth_catalogue, 15, 3, 30, 6}, {&hmc_catalogue, 18, 1, 36, 2}};

struct State {
  Values q, wrist, f, kt;
};

State random_state(std::mt19937& random) {
  const sinew_function* stiffness = find_function(hand_catalogue, "joint_stiffness");
  REQUIRE(stiffness);
  State state;
  Values* parts[4] = {&state.q, &state.wrist, &state.f, &state.kt};
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < stiffness->inputs[k].rows; ++i)
      parts[k]->push_back(std::uniform_real_distribution<double>(
          stiffness->inputs[k].low[i], stiffness->inputs[k].high[i])(random));
  return state;
}

Matrix matrix(const Values& values, Eigen::Index rows) {
  return Eigen::Map<const Matrix>(values.data(), rows,
                                  static_cast<Eigen::Index>(values.size()) / rows);
}

Matrix stiffness_of(const State& s) {
  return matrix(
      call(hand_catalogue, "joint_stiffness", joined(joined(s.q, s.wrist), joined(s.f, s.kt))), 21);
}

/// K = -dtau/d(q, q_wrist) with tendon forces that follow their lengths: f + kt (h - h at s).
Matrix stiffness_by_differences(const State& s) {
  const Values h0 = call(hand_catalogue, "tendon_lengths", joined(s.q, s.wrist));
  const auto torque = [&](std::size_t j, double move) {
    Values at = joined(s.q, s.wrist);
    at[j] += move;
    const Values h = call(hand_catalogue, "tendon_lengths", at);
    Values f = s.f;
    for (std::size_t i = 0; i < tendons; ++i) f[i] += s.kt[i] * (h[i] - h0[i]);
    const Values tau = call(hand_catalogue, "joint_torque", joined(at, f));
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(tau.data(), 21));
  };
  const double step = 1e-3;
  Matrix K(21, 21);
  for (std::size_t j = 0; j < 21; ++j)
    K.col(Eigen::Index(j)) = -(45 * (torque(j, step) - torque(j, -step)) -
                               9 * (torque(j, 2 * step) - torque(j, -2 * step)) +
                               (torque(j, 3 * step) - torque(j, -3 * step))) /
                             (60 * step);
  return K;
}

}  // namespace

TEST_CASE("the hand's lengths are those of its parts and of the wrist", "[hand]") {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const State s = random_state(random);
    const Values h = call(hand_catalogue, "tendon_lengths", joined(s.q, s.wrist)),
                 wrist = call(wrist_catalogue, "tendon_lengths", s.wrist);
    for (const Member& member : members) {
      const Values own(s.q.begin() + std::ptrdiff_t(member.first),
                       s.q.begin() + std::ptrdiff_t(member.first + member.count));
      const Values part = call(*member.model, "tendon_lengths", own);
      REQUIRE(part.size() == member.tendons);
      for (std::size_t t = 0; t < member.tendons; ++t)
        CHECK(h[member.channel + t] == Approx(part[t] + wrist[member.channel + t]).epsilon(1e-15));
    }
  }
}

TEST_CASE("the hand's coupling matrix is the slope of its lengths", "[hand]") {
  std::mt19937 random(4);
  const State s = random_state(random);
  const Values P = call(hand_catalogue, "coupling_matrix", joined(s.q, s.wrist));
  REQUIRE(P.size() == tendons * (coordinates + 2));
  double worst = 0;
  for (std::size_t j = 0; j < 21; ++j) {
    const auto at = [&](double move) {
      Values q = joined(s.q, s.wrist);
      q[j] += move;
      return call(hand_catalogue, "tendon_lengths", q);
    };
    const double step = 1e-3;
    const Values a = at(step), b = at(-step), c = at(2 * step), d = at(-2 * step);
    for (std::size_t i = 0; i < tendons; ++i)
      worst = std::max(worst,
                       std::abs(P[21 * i + j] - (8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * step)));
  }
  CHECK(worst < 1e-12);
}

TEST_CASE("the hand's torque is -P^T f", "[hand]") {
  std::mt19937 random(9);
  const State s = random_state(random);
  const Matrix P = matrix(call(hand_catalogue, "coupling_matrix", joined(s.q, s.wrist)), 38);
  const Values tau = call(hand_catalogue, "joint_torque", joined(joined(s.q, s.wrist), s.f));
  const Eigen::VectorXd expected =
      -P.transpose() * Eigen::Map<const Eigen::VectorXd>(s.f.data(), 38);
  for (std::size_t j = 0; j < 21; ++j)
    CHECK(tau[j] == Approx(expected[Eigen::Index(j)]).epsilon(1e-13).margin(1e-15));
}

TEST_CASE("the hand's stiffness: symmetric, the torque's slope, wrist and fingers coupled",
          "[hand]") {
  std::mt19937 random(11);
  for (int trial = 0; trial < 3; ++trial) {
    const State s = random_state(random);
    Matrix K = stiffness_of(s);
    const Matrix expected = stiffness_by_differences(s);
    const double scale = K.cwiseAbs().maxCoeff();
    CHECK((K - K.transpose()).cwiseAbs().maxCoeff() == 0.0);
    CHECK((K - expected).cwiseAbs().maxCoeff() < 1e-9 * scale);
    CHECK(K.block(0, 19, 19, 2).cwiseAbs().maxCoeff() > 1e-3 * scale);
    // Without the coupling of wrist and fingers the comparison fails.
    K.block(0, 19, 19, 2).setZero();
    CHECK((K - expected).cwiseAbs().maxCoeff() > 1e-9 * scale);
  }
}

TEST_CASE("with the feedforward the fingers' share of the closure stands still", "[hand]") {
  std::mt19937 random(12);
  const State s = random_state(random);
  const Values reference = bars(0, 0), delta = call(hand_catalogue, "feedforward", s.wrist),
               h = call(hand_catalogue, "tendon_lengths", joined(s.q, s.wrist)),
               h0 = call(hand_catalogue, "tendon_lengths", joined(s.q, reference));
  for (std::size_t i = 0; i < tendons; ++i)
    CHECK(h[i] + wrist_values().motor_radius * delta[i] ==
          Approx(h0[i]).epsilon(1e-14).margin(1e-17));
}

TEST_CASE("fingertips in the forearm are those in the palm, moved by the wrist", "[hand]") {
  std::mt19937 random(13);
  const State s = random_state(random);
  const Values tips = call(hand_catalogue, "fingertips", joined(s.q, s.wrist));
  REQUIRE(tips.size() == 2 * 80);
  const Matrix wrist = matrix(call(wrist_catalogue, "pose", s.wrist), 4),
               palm = matrix(Values(tips.begin(), tips.begin() + 80), 20),
               forearm = matrix(Values(tips.begin() + 80, tips.end()), 20);
  for (Eigen::Index k = 0; k < 5; ++k) {
    const Matrix T = palm.block(4 * k, 0, 4, 4), R = T.block(0, 0, 3, 3);
    CHECK((wrist * T - forearm.block(4 * k, 0, 4, 4)).cwiseAbs().maxCoeff() < 1e-15);
    CHECK((R.transpose() * R - Matrix::Identity(3, 3)).cwiseAbs().maxCoeff() < 1e-14);
  }
  // The index finger's base is not turned in the palm: its tip is its own, moved.
  const Values q_index(s.q.begin() + 4, s.q.begin() + 8);
  const Values own = call(index_catalogue, "forward_kinematics", q_index);
  const sinew::Transform base = sinew::read_hand(model_folder("hand")).hand.fingers[1].base;
  REQUIRE(base.rotation == Eigen::Matrix3d::Identity());
  CHECK(palm(4, 3) == Approx(own[3] + base.translation.x()).epsilon(1e-14));
  CHECK(palm(5, 3) == Approx(own[7] + base.translation.y()).epsilon(1e-14));
  // The fifth finger rides on the coupler: it moves with the crank, the others do not.
  State moved = s;
  moved.q[18] += 0.1;
  const Values other = call(hand_catalogue, "fingertips", joined(moved.q, moved.wrist));
  for (std::size_t k = 0; k < 4; ++k) CHECK(other[16 * k + 3] == tips[16 * k + 3]);
  CHECK(std::abs(other[64 + 7] - tips[64 + 7]) > 1e-4);
}

TEST_CASE("gravity in the fingers' bases keeps its size and turns with the wrist", "[hand]") {
  std::mt19937 random(14);
  const State s = random_state(random);
  const Values g =
      call(hand_catalogue, "finger_gravity", joined(joined(s.q, s.wrist), {0, 0, -9.81}));
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(std::hypot(g[3 * k], g[3 * k + 1], g[3 * k + 2]) == Approx(9.81).epsilon(1e-14));
  const Values T = call(wrist_catalogue, "pose", s.wrist);
  for (std::size_t j = 0; j < 3; ++j) CHECK(g[3 + j] == Approx(-9.81 * T[8 + j]).epsilon(1e-13));
}
