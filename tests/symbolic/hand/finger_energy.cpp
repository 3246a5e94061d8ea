// SPDX-License-Identifier: GPL-3.0-or-later
// Torque and stiffness of every finger against the energy stored in its tendons.
//
// Tendon i has the force law f(x) = f_i + k_i (x - x_i) about its present elongation; the motors
// are held, so x follows the path length and U(q) = sum ∫ f dx.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "fifth_catalogue.h"
#include "index_catalogue.h"
#include "middle_catalogue.h"
#include "ring_catalogue.h"
#include "tests/symbolic/hand/emitted_call.h"
#include "thumb_catalogue.h"
#include "thumb_table_5_2_catalogue.h"

using namespace sinew_tests;

namespace {

constexpr double step = 0.01;  // rad

struct State {
  const sinew_catalogue* finger;
  Values q, f, kt;

  std::size_t joints() const { return q.size(); }
  Values at(std::size_t j, double move_j, std::size_t k, double move_k) const {
    Values moved = q;
    moved[j] += move_j;
    moved[k] += move_k;
    return moved;
  }
  /// Stored energy [J] relative to the state.
  double energy(const Values& there) const {
    const Values h = call(*finger, "tendon_lengths", there),
                 h0 = call(*finger, "tendon_lengths", q);
    double sum = 0;
    for (std::size_t i = 0; i < h.size(); ++i) {
      const double x = h[i] - h0[i];
      sum += f[i] * x + kt[i] * x * x / 2;
    }
    return sum;
  }
};

State random_state(const sinew_catalogue& finger, std::mt19937& random) {
  const sinew_function* stiffness = find_function(finger, "joint_stiffness");
  REQUIRE(stiffness);
  State state{&finger, {}, {}, {}};
  Values* parts[3] = {&state.q, &state.f, &state.kt};
  for (int k = 0; k < 3; ++k) {
    const sinew_argument& input = stiffness->inputs[k];
    for (int i = 0; i < input.rows * input.cols; ++i)
      parts[k]->push_back(
          std::uniform_real_distribution<double>(input.low[i], input.high[i])(random));
  }
  return state;
}

/// Seventh-order difference weights: offsets 1..3 of a central first derivative.
constexpr double weight[3] = {3.0 / 4, -3.0 / 20, 1.0 / 60};

double slope(const State& s, std::size_t j) {
  double sum = 0;
  for (int n = 1; n <= 3; ++n)
    sum += weight[n - 1] * (s.energy(s.at(j, n * step, j, 0)) - s.energy(s.at(j, -n * step, j, 0)));
  return sum / step;
}

double curvature(const State& s, std::size_t j, std::size_t k) {
  double sum = 0;
  for (int n = 1; n <= 3; ++n)
    for (int m = 1; m <= 3; ++m) {
      const double u = n * step, v = m * step;
      sum += weight[n - 1] * weight[m - 1] *
             (s.energy(s.at(j, u, k, v)) - s.energy(s.at(j, u, k, -v)) -
              s.energy(s.at(j, -u, k, v)) + s.energy(s.at(j, -u, k, -v)));
    }
  return sum / (step * step);
}

struct Mismatch {
  double torque = 0, stiffness = 0, asymmetry = 0;
};

Mismatch mismatch(const State& s, const Values& tau, const Values& K) {
  const std::size_t n = s.joints();
  double largest_tau = 0, largest_K = 0;
  for (const double t : tau) largest_tau = std::max(largest_tau, std::abs(t));
  for (const double k : K) largest_K = std::max(largest_K, std::abs(k));
  Mismatch worst;
  for (std::size_t j = 0; j < n; ++j) {
    worst.torque = std::max(worst.torque, std::abs(tau[j] + slope(s, j)) / largest_tau);
    for (std::size_t k = 0; k < n; ++k) {
      worst.stiffness =
          std::max(worst.stiffness, std::abs(K[j * n + k] - curvature(s, j, k)) / largest_K);
      worst.asymmetry = std::max(worst.asymmetry, std::abs(K[j * n + k] - K[k * n + j]));
    }
  }
  return worst;
}

const sinew_catalogue* const fingers[] = {&index_catalogue, &middle_catalogue,
                                          &ring_catalogue,  &fifth_catalogue,
                                          &thumb_catalogue, &thumb_table_5_2_catalogue};

}  // namespace

TEST_CASE("torque is minus the energy's slope and stiffness its curvature", "[fingers]") {
  std::mt19937 random(5);
  for (const sinew_catalogue* finger : fingers)
    for (int trial = 0; trial < 5; ++trial) {
      const State s = random_state(*finger, random);
      const Values tau = call(*finger, "joint_torque", joined(s.q, s.f)),
                   K = call(*finger, "joint_stiffness", joined(joined(s.q, s.f), s.kt));
      const Mismatch worst = mismatch(s, tau, K);
      CAPTURE(finger->model, worst.torque, worst.stiffness);
      CHECK(worst.torque < 1e-8);
      CHECK(worst.stiffness < 1e-7);
      CHECK(worst.asymmetry == 0.0);
    }
}

TEST_CASE("a torque of the wrong sign and a stiffness without its geometric term show",
          "[fingers]") {
  std::mt19937 random(6);
  const State s = random_state(thumb_catalogue, random);
  Values tau = call(thumb_catalogue, "joint_torque", joined(s.q, s.f));
  const Values K = call(thumb_catalogue, "joint_stiffness", joined(joined(s.q, s.f), s.kt));
  for (double& t : tau) t = -t;
  CHECK(mismatch(s, tau, K).torque > 0.1);
  const Values without_forces =
      call(thumb_catalogue, "joint_stiffness", joined(joined(s.q, Values(8, 0.0)), s.kt));
  CHECK(mismatch(s, tau, without_forces).stiffness > 1e-4);
  Values skew = K;
  skew[1] += 1e-12;
  CHECK(mismatch(s, tau, skew).asymmetry > 0.0);
}

TEST_CASE("link positions follow from the lengths where the coupling is constant", "[fingers]") {
  std::mt19937 random(8);
  for (const sinew_catalogue* finger :
       {&index_catalogue, &middle_catalogue, &ring_catalogue, &fifth_catalogue}) {
    const State s = random_state(*finger, random);
    const Values q = call(*finger, "link_position", call(*finger, "tendon_lengths", s.q));
    for (std::size_t j = 0; j < s.joints(); ++j) CHECK(q[j] == Approx(s.q[j]).epsilon(1e-13));
  }
}
