// SPDX-License-Identifier: GPL-3.0-or-later
// Slots that a search changes one by one, with their fits.
#pragma once

#include <map>
#include <utility>

#include "identification/likelihood/slot_model.h"

namespace sinew::diagnosis {

/// A fit that was asked for follows slots that are added.
class FittedSlots {
 public:
  FittedSlots(const SlotModel& model, Slots slots) : model_(model), slots_(std::move(slots)) {}

  const Slots& slots() const { return slots_; }

  const SlotModel::Fit& in(int region) {
    const auto known = fits_.find(region);
    if (known != fits_.end()) return known->second;
    return fits_.emplace(region, model_.fit(slots_, region)).first->second;
  }

  /// As the last slot.
  void add(int entry, double variance) {
    slots_.entries.push_back(entry);
    slots_.variances.push_back(variance);
    for (auto& [region, fit] : fits_) fit = model_.fit_with(std::move(fit), entry, variance);
  }

  /// The fits are made anew: columns that say nearly the same are told apart by differences that
  /// rounding would take away when one of them goes.
  void remove(std::size_t slot) {
    slots_.entries.erase(slots_.entries.begin() + static_cast<std::ptrdiff_t>(slot));
    slots_.variances.erase(slots_.variances.begin() + static_cast<std::ptrdiff_t>(slot));
    fits_.clear();
  }

 private:
  const SlotModel& model_;
  Slots slots_;
  std::map<int, SlotModel::Fit> fits_;
};

}  // namespace sinew::diagnosis
