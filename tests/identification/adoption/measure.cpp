// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "identification/adoption/measure.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;
using diagnosis::MeasuredChannel;
using Eigen::VectorXd;

/// What is measured is `size` times a motion and noise of one; the model lacks `missing` of it.
MeasuredChannel channel(int index, double size, double missing, std::uint64_t seed) {
  reference::RandomNumbers random(seed);
  MeasuredChannel m;
  m.channel = index;
  m.held_out = true;
  const VectorXd motion = VectorXd::LinSpaced(1200, 0.0, 60.0).array().sin();
  VectorXd noise(motion.size());
  for (double& value : noise) value = random.uniform(-1.7, 1.7);
  m.measured = size * motion + noise;
  m.before = (size - missing) * motion;
  m.after = size * motion;
  return m;
}

}  // namespace

TEST_CASE("a joint that measures noise does not hide what was gained at another one") {
  // Planted defect: with each joint in shares of what is measured there, the gain of both is
  // 0.0011.
  const std::vector<MeasuredChannel> both = {channel(0, 300.0, 10.0, 1), channel(1, 0.0, 0.0, 2)};
  const diagnosis::Gain shoulder = diagnosis::measured_gain(both, 0, true, 12, 1);
  CHECK(shoulder.share > 0.97);
  const diagnosis::Gain all = diagnosis::measured_gain(both, -1, true, 12, 1);
  CHECK(all.share > 0.95);
  CHECK(all.low > 0.9);
}
