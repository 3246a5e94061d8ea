// SPDX-License-Identifier: GPL-3.0-or-later
// Efforts of the past, for those that act or are logged late.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <deque>

namespace sinew {

enum class PastEffort { joint_torque, motor_torque, tendon_force };

class EffortHistory {
 public:
  using Efforts = std::array<Eigen::VectorXd, 3>;  ///< in the order of PastEffort

  /// `longest`: how long they are kept [s].
  void add(double time, Efforts efforts, double longest) {
    entries_.push_back({time, std::move(efforts)});
    while (entries_.size() > 2 && entries_[1].time < time - longest) entries_.pop_front();
  }

  /// By straight lines; before the first entry the first, after the last one `now`.
  Eigen::VectorXd at(PastEffort which, double time, const Eigen::VectorXd& now) const {
    const auto part = static_cast<std::size_t>(which);
    if (entries_.empty() || time > entries_.back().time) return now;
    const auto after = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& entry) { return entry.time >= time; });
    if (after == entries_.begin()) return after->efforts[part];
    const Entry& before = *std::prev(after);
    const double share = (time - before.time) / (after->time - before.time);
    return (1.0 - share) * before.efforts[part] + share * after->efforts[part];
  }

 private:
  struct Entry {
    double time;
    Efforts efforts;
  };
  std::deque<Entry> entries_;
};

}  // namespace sinew
