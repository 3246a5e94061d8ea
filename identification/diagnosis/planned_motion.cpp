// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/planned_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// A joint's reference in the making: strokes with speeds that rise and fall smoothly.
class Path {
 public:
  Path(const MotionRange& range, double step) : range_(range), step_(step), place_(middle()) {
    load_ = 0.5 * range.load;
  }

  double middle() const { return 0.5 * (range_.low + range_.high); }
  double half() const { return 0.5 * (range_.high - range_.low); }
  /// Half of what it goes through in about four seconds: an axis that turned on and on need not go
  /// all the way back.
  double near() const { return std::min(half(), 2.0 * range_.speed); }

  void rest(double seconds) {
    for (Index k = std::lround(seconds / step_); k > 0; --k) write(place_);
  }

  /// Another known load, while the joint rests.
  void take_load(double load) {
    const double from = load_;
    const Index n = std::max<Index>(1, std::lround(0.5 / step_));
    for (Index k = 1; k <= n; ++k) {
      load_ = from + (load - from) * static_cast<double>(k) / static_cast<double>(n);
      write(place_);
    }
  }

  void stroke(double to, double speed) {
    const double way = to - place_, from = place_;
    if (way == 0.0) return;
    // Of a smooth step 3 u^2 - 2 u^3 the slope is 1.5 at most.
    double ramp = std::max(1.5 * speed / range_.acceleration, 4.0 * step_);
    if (std::abs(way) < speed * ramp) {
      speed = std::min(speed, std::sqrt(std::abs(way) * range_.acceleration / 1.5));
      ramp = std::abs(way) / speed;
    }
    const double length = std::abs(way) / speed + ramp;
    const Index n = static_cast<Index>(std::ceil(length / step_));
    for (Index k = 1; k <= n; ++k) {
      const double t = std::min(length, static_cast<double>(k) * step_);
      write(from + std::copysign(passed(t, length, ramp, speed), way));
    }
    place_ = to;
  }

  /// About the present place.
  void oscillate(double seconds, const std::vector<std::array<double, 2>>& amplitude_and_hertz) {
    const double about = place_;
    const Index n = std::lround(seconds / step_);
    for (Index k = 1; k <= n; ++k) {
      const double t = static_cast<double>(k) * step_;
      double sum = 0.0;
      for (const auto& [amplitude, hertz] : amplitude_and_hertz)
        sum += amplitude * std::sin(kTurn * hertz * t);
      write(about + faded(t, seconds, amplitude_and_hertz.front()[1]) * sum);
    }
    write(about);
  }

  /// From slow to fast at small amplitude.
  void sweep(double seconds, double lowest, double highest) {
    const double about = place_;
    const Index n = std::lround(seconds / step_);
    double phase = 0.0;
    for (Index k = 1; k <= n; ++k) {
      const double t = static_cast<double>(k) * step_;
      const double hertz = lowest * std::pow(highest / lowest, t / seconds);
      phase += kTurn * hertz * step_;
      write(about + faded(t, seconds, lowest) * 0.6 * reach(hertz) * std::sin(phase));
    }
    write(about);
  }

  /// About the largest amplitude of a sine. Without kinks, since a sweep goes over all frequencies.
  double reach(double hertz) const {
    const double w = kTurn * hertz;
    const double wide = 1.0 / half(), fast = w / range_.speed, hard = w * w / range_.acceleration;
    return 1.0 / std::sqrt(wide * wide + fast * fast + hard * hard);
  }

  const MotionRange& range() const { return range_; }
  const std::vector<double>& position() const { return position_; }
  const std::vector<double>& load() const { return loads_; }

 private:
  /// In and out over a turn of the slowest sine, so that this asks for no more than the sines do.
  static double faded(double t, double seconds, double slowest) {
    const double over = std::min(std::max(1.0, 1.0 / slowest), 0.25 * seconds);
    const double edge = std::clamp(std::min(t, seconds - t) / over, 0.0, 1.0);
    return edge * edge * (3.0 - 2.0 * edge);
  }

  static double passed(double t, double length, double ramp, double speed) {
    // Integral of the smooth step 3 u^2 - 2 u^3.
    const auto rising = [&](double u) { return speed * ramp * (u * u * u - 0.5 * u * u * u * u); };
    const double whole = speed * (length - ramp);
    if (t < ramp) return rising(t / ramp);
    if (t > length - ramp) return whole - rising((length - t) / ramp);
    return speed * (0.5 * ramp + (t - ramp));
  }

  void write(double position) {
    position_.push_back(position);
    loads_.push_back(load_);
  }

  MotionRange range_;
  double step_, place_, load_ = 0.0;
  std::vector<double> position_, loads_;
};

/// As long as a speed lasts for two seconds, or from end to end.
void speeds(Path& path) {
  for (const double share : {0.04, 0.08, 0.15, 0.3, 0.55, 0.9}) {
    const double speed = share * path.range().speed;
    const double way = std::min(0.9 * path.half(), speed);
    path.stroke(path.middle() - way, speed);
    path.stroke(path.middle() + way, speed);
    path.stroke(path.middle() - way, speed);
  }
  path.stroke(path.middle(), 0.5 * path.range().speed);
}

void slow_range(Path& path) {
  const double fast = path.range().speed;
  const double slow = std::clamp(path.half() / 6.0, 0.02 * fast, 0.4 * fast);
  const double way = std::min(path.half(), 8.0 * slow);
  for (int i = 0; i < 2; ++i) {
    path.stroke(path.middle() - way, slow);
    path.stroke(path.middle() + way, slow);
  }
}

void strokes(Path& path, double seconds_about) {
  const double speed = 0.4 * path.range().speed;
  const double way = std::min(0.9 * path.half(), 1.5 * speed);
  const double each = 2.0 * way / speed + 1.5 * speed / path.range().acceleration;
  const int pairs = std::clamp(static_cast<int>(seconds_about / (2.0 * each)), 1, 50);
  for (int i = 0; i < pairs; ++i) {
    path.stroke(path.middle() + way, speed);
    path.stroke(path.middle() - way, speed);
  }
}

void under_loads(Path& path, void (*draw)(Path&)) {
  for (const double share : {0.0, 0.5, 1.0}) {
    path.take_load(share * path.range().load);
    draw(path);
  }
}

void loads(Path& path) {
  under_loads(path, [](Path& p) { strokes(p, 8.0); });
}

void reversals(Path& path) {
  for (const double place : {-0.8, -0.4, 0.0, 0.4, 0.8}) {
    path.stroke(path.middle() + place * path.near(), 0.5 * path.range().speed);
    path.rest(0.3);
    const double hertz = 5.0;
    path.oscillate(3.5, {{std::min(0.15 * path.half(), 0.7 * path.reach(hertz)), hertz}});
  }
}

void sines(Path& path, double first) {
  std::vector<std::array<double, 2>> all;
  for (const double ratio : {1.0, 2.3, 5.1, 11.7})
    all.push_back({0.25 * path.reach(first * ratio), first * ratio});
  path.oscillate(24.0, all);
}

/// For what no single one of them settles.
void everything(Path& path) {
  if (path.range().load != 0.0)
    under_loads(path, speeds);
  else
    speeds(path);
  reversals(path);
  path.stroke(path.middle(), 0.5 * path.range().speed);
  path.sweep(24.0, 0.3, 10.0);
}

/// Others rest.
PlannedMotion alone(const std::string& name, const std::vector<MotionRange>& joints,
                    std::size_t joint, double step, void (*draw)(Path&)) {
  Path path(joints[joint], step);
  path.rest(0.5);
  draw(path);
  path.rest(0.5);
  PlannedMotion motion{name, step, {}, {}};
  const auto n = static_cast<Index>(path.position().size());
  motion.position.resize(n, static_cast<Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j)
    motion.position.col(static_cast<Index>(j)).setConstant(0.5 * (joints[j].low + joints[j].high));
  motion.position.col(static_cast<Index>(joint)) =
      Eigen::Map<const VectorXd>(path.position().data(), n);
  if (joints[joint].load != 0.0) motion.load = Eigen::Map<const VectorXd>(path.load().data(), n);
  return motion;
}

PlannedMotion together(const std::vector<MotionRange>& joints, double step) {
  PlannedMotion motion{"all joints at once, each at several frequencies", step, {}, {}};
  for (std::size_t j = 0; j < joints.size(); ++j) {
    Path path(joints[j], step);
    sines(path, 0.11 * (1.0 + 0.37 * static_cast<double>(j)));
    const auto n = static_cast<Index>(path.position().size());
    if (j == 0) motion.position.resize(n, static_cast<Index>(joints.size()));
    motion.position.col(static_cast<Index>(j)) =
        Eigen::Map<const VectorXd>(path.position().data(), n);
  }
  return motion;
}

}  // namespace

std::vector<PlannedMotion> planned_motions(const std::vector<MotionRange>& joints,
                                           std::size_t joint, double step) {
  std::vector<PlannedMotion> motions;
  const auto add = [&](const char* name, void (*draw)(Path&)) {
    motions.push_back(alone(name, joints, joint, step, draw));
  };
  add("constant speeds from slow to fast, both ways", speeds);
  add("slow motion over the whole range, both ways", slow_range);
  add("small fast reversals about several positions", reversals);
  add("a sweep of frequencies from slow to fast", [](Path& p) { p.sweep(24.0, 0.3, 10.0); });
  add("several frequencies at once", [](Path& p) { sines(p, 0.11); });
  add("the same strokes for a minute", [](Path& p) { strokes(p, 60.0); });
  if (joints[joint].load != 0.0) add("the same strokes under three known loads", loads);
  if (joints.size() > 1) motions.push_back(together(joints, step));
  add(joints[joint].load != 0.0
          ? "constant speeds from slow to fast under three known loads, small fast reversals, and "
            "a "
            "sweep of frequencies"
          : "constant speeds from slow to fast, small fast reversals, and a sweep of frequencies",
      everything);
  return motions;
}

}  // namespace sinew::diagnosis
