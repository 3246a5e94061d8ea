// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/full_turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sinew {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi, quarter_turn = 0.25 * full_turn;
constexpr double jump_off = 0.01 * full_turn;

bool is_angle(const ChannelSpec& spec, ChannelRole role) {
  return spec.unit == "rad" && spec.role == role;
}

}  // namespace

double FullTurns::push(long row, double value) {
  if (!std::isfinite(value)) return value;
  if (count_ == 0) raw_low_ = raw_high_ = low_ = high_ = previous_ = value;
  double step = value - previous_;
  const double jump = step - step_;
  if (count_ > 1 && std::abs(std::abs(jump) - full_turn) < jump_off &&
      std::abs(step_) < quarter_turn) {
    const double turn = std::copysign(full_turn, jump);
    turns_ -= turn;
    step -= turn;
    if (jumps_++ == 0) first_row_ = row;
  } else {
    largest_step_ = std::max(largest_step_, std::abs(step));
  }
  ++count_;
  previous_ = value;
  step_ = step;
  raw_low_ = std::min(raw_low_, value);
  raw_high_ = std::max(raw_high_, value);
  low_ = std::min(low_, value + turns_);
  high_ = std::max(high_, value + turns_);
  return value + turns_;
}

bool FullTurns::is_wrapped() const {
  const double range = raw_high_ - raw_low_;
  return jumps_ > 0 && largest_step_ < quarter_turn && range > 0.9 * full_turn &&
         range < 1.02 * full_turn;
}

double FullTurns::shift_towards(double middle) const {
  return full_turn * std::round((middle - 0.5 * (low_ + high_)) / full_turn);
}

std::vector<bool> wrapped_channels(const std::vector<MappedColumn>& channels,
                                   const std::vector<FullTurns>& turns) {
  std::vector<bool> wrapped(channels.size(), false);
  const auto position_of = [&](std::size_t reference) {
    for (std::size_t c = 0; c < channels.size(); ++c)
      if (is_angle(channels[c].spec, ChannelRole::position) &&
          channels[c].spec.group == channels[reference].spec.group)
        return c;
    return reference;
  };
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const bool position = is_angle(channels[c].spec, ChannelRole::position);
    if (!position && !is_angle(channels[c].spec, ChannelRole::reference)) continue;
    // A command may step by a full turn and mean it.
    wrapped[c] = turns[c].is_wrapped() && (position || turns[position_of(c)].is_wrapped());
  }
  return wrapped;
}

}  // namespace sinew
