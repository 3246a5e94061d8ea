// SPDX-License-Identifier: GPL-3.0-or-later
// Few samples a second: friction that sticks and breaks loose within a sample is no other cause.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>

#include "tests/identification/subjects/diagnosed_robot.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;

constexpr double kMass = 20.0, kViscous = 60.0, kCoulomb = 30.0;

struct Reference {
  double position = 0.0, velocity = 0.0, acceleration = 0.0;
};

/// Strokes of trapezoidal speed there and back, with rests between.
class Strokes {
 public:
  Strokes(reference::RandomNumbers& random, double way) : random_(random), way_(way) {}

  Reference at(double t) {
    if (t >= until_) {
      from_ = goal_;
      goal_ = way_ * random_.uniform(-1.0, 1.0);
      start_ = t;
      lasts_ = random_.uniform(0.5, 1.1);
      until_ = t + lasts_ + random_.uniform(0.0, 0.3);
    }
    const double u = std::min(1.0, (t - start_) / lasts_), gone = goal_ - from_;
    const double top = 1.0 / (1.0 - kRamp), rise = top / kRamp, left = 1.0 - u;
    if (u >= 1.0) return {goal_, 0.0, 0.0};
    if (u < kRamp) return made(0.5 * rise * u * u, rise * u, rise, gone);
    if (left < kRamp) return made(1.0 - 0.5 * rise * left * left, rise * left, -rise, gone);
    return made(top * (u - 0.5 * kRamp), top, 0.0, gone);
  }

 private:
  static constexpr double kRamp = 0.25;
  Reference made(double x, double v, double a, double gone) const {
    return {from_ + gone * x, gone * v / lasts_, gone * a / (lasts_ * lasts_)};
  }
  reference::RandomNumbers& random_;
  double way_, from_ = 0.0, goal_ = 0.0, start_ = 0.0, lasts_ = 1.0, until_ = 0.0;
};

/// Coulomb friction that holds exactly, a controller without delay, samples without averaging.
std::string log_of(double step, std::uint64_t seed, double seconds) {
  reference::RandomNumbers random(seed);
  const double way = random.uniform(0.2, 0.5), inner = 1e-4, stiff = 20000.0, damping = 900.0;
  double x = 0.0, v = 0.0, slow = 0.0;
  Strokes strokes(random, way);
  std::string text = "time [s],q_x [m],tau_x [N]\n";
  const auto every = std::lround(step / inner);
  for (long k = 0; inner * double(k) < seconds; ++k) {
    const double t = inner * double(k);
    const Reference r = strokes.at(t);
    const double force = stiff * (r.position - x) + damping * (r.velocity - v) +
                         kMass * r.acceleration +
                         0.8 * (kViscous * r.velocity + kCoulomb * std::tanh(r.velocity / 0.01));
    if (k % every == 0) {
      slow = 0.9 * slow + random.uniform(-0.3, 0.3);
      fmt::format_to(std::back_inserter(text), "{:.4f},{:.8f},{:.6f}\n", t,
                     x + 2e-7 * random.uniform(-1.0, 1.0),
                     force + slow + random.uniform(-0.8, 0.8));
    }
    const double free = v + inner * (force - kViscous * v) / kMass;
    const double held = inner * kCoulomb / kMass;
    v = std::abs(free) <= held ? 0.0 : free - std::copysign(held, free);
    x += inner * v;
  }
  return text;
}

}  // namespace

TEST_CASE("friction that sticks in slow logs is no elasticity, delay or backlash",
          "[slow][thorough]") {
  // Planted defect: with everything compared up to 60 Hz, where the smoothed motion ends at 25 or
  // at 10 (set_bands()), all nine get gear elasticity or backlash. Where a joint at rest holds no
  // more than what is usual there, two of nine get an unlogged force.
  for (const double step : {0.004, 0.008, 0.01})
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const diagnosis::Findings found =
          test::diagnosed(test::slide(kMass, kViscous, kCoulomb), log_of(step, seed, 30.0),
                          log_of(step, seed + 1000, 30.0));
      INFO(found.headline << " at " << step << " s, seed " << seed << ", error "
                          << found.verdict.relative_error_before);
      CHECK(found.verdict.nothing_beyond_noise());
    }
}
