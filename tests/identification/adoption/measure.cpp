// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

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
  const diagnosis::Gain shoulder = diagnosis::measured_gain(both, 0, 1);
  CHECK(shoulder.share > 0.97);
  const diagnosis::Gain all = diagnosis::measured_gain(both, -1, 1);
  CHECK(all.share > 0.95);
  CHECK(all.low > 0.9);
}

TEST_CASE("errors and gain of a channel are of the same samples") {
  // Planted defect: standstill counted in error_sums(): the error before is 28.4, the gain 0.67
  // where the two errors give 0.998.
  MeasuredChannel m = channel(0, 3.0, 2.0, 3);
  m.counts = VectorXd::Ones(m.measured.size());
  m.counts.head(400).setZero();
  m.before.head(400).array() += 40.0;
  diagnosis::ChannelFinding finding;
  diagnosis::add_error("force", {m}, 0, 1, finding);
  const diagnosis::DomainError& error = finding.domains.front();
  const double ratio = error.after / error.before;
  CHECK(error.gain.share == Approx(1.0 - ratio * ratio));
  CHECK(error.before < 3.0);
  CHECK(finding.unexplained_before ==
        Approx(std::pow(error.before / finding.standard_deviation, 2)));
}

TEST_CASE("what is unexplained is a share, and of a small error nothing") {
  // Planted defects: without the bound the first is 24.2; without nothing_to_explain() the second
  // is 1, all of a variance that is nothing beside what is measured.
  MeasuredChannel wrong = channel(0, 1.0, 0.0, 4);
  wrong.before = wrong.measured - 5.0 * channel(0, 1.0, 0.0, 5).measured;
  diagnosis::ChannelFinding finding;
  diagnosis::add_error("force", {wrong}, 0, 1, finding);
  CHECK(finding.unexplained_before == 1.0);
  CHECK_FALSE(finding.nothing_to_explain());

  MeasuredChannel still = channel(0, 0.0, 0.0, 6);
  still.measured = 10.0 + 0.006 * still.measured.array();
  still.before = still.after = VectorXd::Constant(still.measured.size(), 10.003);
  diagnosis::ChannelFinding held;
  diagnosis::add_error("force", {still}, 0, 1, held);
  CHECK(held.domains.front().before < 0.01);
  CHECK(held.nothing_to_explain());
  CHECK(held.unexplained_before == 0.0);
  // Nor is an error below the step in which the log writes the channel.
  diagnosis::ChannelFinding coarse;
  coarse.quantum = 100.0;  // rounding to it makes an error of 29
  diagnosis::add_error("force", {wrong}, 0, 1, coarse);
  CHECK(coarse.nothing_to_explain());
}

TEST_CASE("a verdict takes errors and gains from what was measured") {
  // Planted defect: without the last line of tell_measured() the lone cause keeps the search's
  // gain.
  const std::vector<MeasuredChannel> one = {channel(0, 30.0, 10.0, 7)};
  diagnosis::Verdict verdict;
  verdict.causes.resize(1);
  verdict.causes.front().held_out = verdict.held_out = {0.5, 0.4, 0.6};
  diagnosis::Verdict corrected = verdict;
  diagnosis::tell_measured(one, false, true, 1, verdict);
  diagnosis::ChannelFinding finding;
  diagnosis::add_error("force", one, 0, 1, finding);
  const diagnosis::DomainError& error = finding.domains.front();
  CHECK(verdict.held_out.share == error.gain.share);
  CHECK(verdict.held_out.low == error.gain.low);
  CHECK(verdict.causes.front().held_out.share == error.gain.share);
  CHECK(verdict.relative_error_before == Approx(error.before / finding.standard_deviation));
  CHECK(verdict.relative_error_after == Approx(error.after / finding.standard_deviation));
  // Where the extension does not hold the cause its gain stays the search's.
  diagnosis::tell_measured(one, false, false, 1, corrected);
  CHECK(corrected.causes.front().held_out.share == 0.5);
}

TEST_CASE("what makes one channel surely worse is seen, whatever another one gains") {
  // Planted defect, seen to fail: the gain of all channels asked, which was all that a lever's or a
  // wrist's adoption went by.
  const MeasuredChannel better = channel(0, 30.0, 10.0, 7);
  MeasuredChannel worse = channel(1, 30.0, 0.0, 8);
  worse.after = 0.9 * worse.after;
  worse.step = 0.05;
  CHECK(diagnosis::measured_gain({better, worse}, -1, 1).low > 0.0);
  CHECK(diagnosis::harmed_channel({better, worse}, 2, diagnosis::Settings()) == 1);
  worse.held_out = false;
  CHECK_FALSE(diagnosis::harmed_channel({better, worse}, 2, diagnosis::Settings()));
  MeasuredChannel same = channel(1, 30.0, 0.0, 8);
  same.step = 0.05;
  CHECK_FALSE(diagnosis::harmed_channel({better, same}, 2, diagnosis::Settings()));
}
