// SPDX-License-Identifier: GPL-3.0-or-later
// The simulators themselves: mechanics, sizes as asked for, nothing given away.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "tests/blind/truth/finger_body.h"
#include "tests/blind/truth/sealed_trial.h"
#include "tests/blind/truth/signals.h"
#include "tests/skip.h"

using namespace sinew::truth;

namespace {

double rms(const std::vector<double>& x) {
  double sum = 0.0;
  for (const double v : x) sum += v * v;
  return std::sqrt(sum / static_cast<double>(x.size()));
}

std::unique_ptr<Plant> draw_kind(const std::string& kind, std::uint64_t seed) {
  if (kind == "drive") return draw_drive(Draw(seed));
  if (kind == "lever") return draw_lever(Draw(seed));
  if (kind == "finger") return draw_finger(Draw(seed));
  return draw_wrist(Draw(seed));
}

}  // namespace

TEST_CASE("the links' forces agree with their energies") {
  Draw draw(3);
  FingerBody body;
  body.payload = 0.03;
  for (int trial = 0; trial < 20; ++trial) {
    Vector4 q, qd, qdd;
    for (long j = 0; j < 4; ++j) {
      q(j) = draw.uniform(-1.0, 1.5);
      qd(j) = draw.uniform(-5.0, 5.0);
      qdd(j) = draw.uniform(-50.0, 50.0);
    }
    const Vector4 zero = Vector4::Zero();
    FingerBody free = body;
    free.gravity = 0.0;
    const Vector4 by_mass = free.mass_matrix(q) * qdd;
    CHECK((free.torque(q, zero, qdd) - by_mass).norm() < 1.0e-12 * (1.0 + by_mass.norm()));
    // Power of the velocity terms is half the rate of the mass matrix.
    const double h = 1.0e-6;
    const Matrix4 rate = (free.mass_matrix(q + h * qd) - free.mass_matrix(q - h * qd)) / (2.0 * h);
    const double power = qd.dot(free.torque(q, qd, zero));
    CHECK(power == Approx(0.5 * qd.dot(rate * qd)).epsilon(1.0e-6).margin(1.0e-12));
  }
}

TEST_CASE("measurement noise has the size it says and a colour") {
  for (int seed = 1; seed <= 20; ++seed) {
    Noise noise{Draw(static_cast<std::uint64_t>(seed))};
    std::vector<double> x(200000);
    for (double& v : x) v = noise.next();
    CHECK(rms(x) == Approx(1.0).epsilon(0.08));
    double together = 0.0;
    for (size_t k = 1; k < x.size(); ++k) together += x[k] * x[k - 1];
    CHECK(together / static_cast<double>(x.size()) > 0.02);
  }
}

TEST_CASE("with nothing hidden the model leaves next to nothing over") {
  for (const char* kind : {"drive", "lever", "finger", "wrist"})
    for (std::uint64_t seed = 1; seed <= (std::string(kind) == "finger" ? 3u : 12u); ++seed) {
      const auto plant = draw_kind(kind, seed);
      double largest = 0.0;
      for (const auto& channel : plant->left_over(plant->simulate({}, 0), {}))
        largest = std::max(largest, rms(channel));
      CAPTURE(kind, seed, plant->nominal());
      CHECK(largest < 0.15);
    }
}

TEST_CASE("MuJoCo's drive and ours leave the same over") {
  if (!draw_mujoco_drive(Draw(1)))
    return sinew::test::skip("MuJoCo is not installed (libmujoco-dev)");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto plant = draw_mujoco_drive(Draw(seed));
    CAPTURE(seed, plant->nominal());
    CHECK(rms(plant->left_over(plant->simulate({}, 0), {})[0]) < 0.15);
    TrialRequest request;
    request.seed = seed;
    request.plant = "mujoco_drive";
    request.size = 1.0;
    const SealedTrial trial(request);
    REQUIRE(trial.seal().hidden.size() == 1);
    CHECK(trial.seal().hidden[0].size == Approx(1.0).epsilon(0.2));
  }
}

TEST_CASE("what is hidden has the size that was asked for") {
  for (const char* kind : {"drive", "lever", "wrist"})
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
      TrialRequest request;
      request.seed = seed;
      request.plant = kind;
      request.size = seed % 2 == 0 ? 0.3 : 1.0;
      const SealedTrial trial(request);
      REQUIRE(trial.seal().hidden.size() == 1);
      CHECK(trial.seal().hidden[0].size == Approx(request.size).epsilon(0.2));
    }
}

TEST_CASE("a seed draws the same trial again, and another seed another") {
  TrialRequest request;
  request.seed = 11;
  request.family = Family::two;
  const SealedTrial first(request), again(request);
  CHECK(first.open().train == again.open().train);
  CHECK(seal_text(first.seal()) == seal_text(again.seal()));
  CHECK(first.seal().hidden.size() == 2);
  request.seed = 12;
  CHECK(SealedTrial(request).open().train != first.open().train);
}

TEST_CASE("what is handed over does not name what is hidden") {
  std::set<std::string> causes;
  for (const char* kind : {"drive", "lever", "finger", "wrist"})
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const auto plant = draw_kind(kind, seed);
      for (const Cause& cause : plant->causes()) causes.insert(cause.name);
    }
  CHECK(causes.size() >= 24);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    TrialRequest request;
    request.seed = seed;
    const SealedTrial trial(request);
    const std::string header = trial.open().train.substr(0, trial.open().train.find('\n'));
    for (const std::string& cause : causes) {
      if (cause == "inertia" || cause == "load") continue;  // a nominal value of every drive
      CHECK(header.find(cause) == std::string::npos);
      CHECK(trial.open().nominal.find(cause) == std::string::npos);
    }
    // Columns and nominal values are those of a trial with nothing hidden.
    TrialRequest nothing = request;
    nothing.family = Family::nothing;
    const SealedTrial empty(nothing);
    CHECK(empty.open().nominal == trial.open().nominal);
    CHECK(empty.open().train.substr(0, header.size()) == header);
  }
}

TEST_CASE("an inseparable pair looks the same, and differs in the follow-up") {
  int tried = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    TrialRequest request;
    request.seed = seed;
    request.family = Family::inseparable;
    request.size = 1.0;
    const SealedTrial trial(request);
    REQUIRE(trial.seal().admissible.size() == 2);
    REQUIRE(trial.seal().hidden.size() == 1);
    CHECK(trial.follow_up() != trial.open().train);
    ++tried;
  }
  CHECK(tried == 12);
}
