// SPDX-License-Identifier: GPL-3.0-or-later
// Slots that a search changes one by one, with their fits.
#pragma once

#include <map>
#include <utility>
#include <variant>
#include <vector>

#include "identification/likelihood/slot_model.h"

namespace sinew::diagnosis {

/// A region's fit follows what has changed when it is asked for.
class FittedSlots {
 public:
  FittedSlots(const SlotModel& model, Slots slots) : model_(model), slots_(std::move(slots)) {}
  /// Slots that are fitted already in one region.
  FittedSlots(const SlotModel& model, SlotModel::Fit fit) : model_(model), slots_(fit.slots) {
    const int region = fit.region;
    fits_[region] = {std::move(fit), true, 0};
  }

  const Slots& slots() const { return slots_; }

  const SlotModel::Fit& in(int region) {
    Kept& kept = fits_[region];
    if (is_followed(kept))
      follow(kept);
    else
      kept.fit = model_.fit(slots_, region);
    kept.made = true;
    kept.changes = changes_.size();
    return kept.fit;
  }

  /// As the last slot.
  void add(int entry, double variance) {
    slots_.entries.push_back(entry);
    slots_.variances.push_back(variance);
    changes_.emplace_back(Added{entry, variance});
  }

  /// `left`: a fit without the slot.
  void remove(std::size_t slot, SlotModel::Fit left) {
    slots_.entries.erase(slots_.entries.begin() + static_cast<std::ptrdiff_t>(slot));
    slots_.variances.erase(slots_.variances.begin() + static_cast<std::ptrdiff_t>(slot));
    changes_.emplace_back(Removed{slot});
    const int region = left.region;
    fits_[region] = {std::move(left), true, changes_.size()};
  }

 private:
  struct Added {
    int entry;
    double variance;
  };
  struct Removed {
    std::size_t slot;
  };
  struct Kept {
    SlotModel::Fit fit;
    bool made = false;
    std::size_t changes = 0;  ///< that the fit knows
  };

  /// More changes than that are more work than a fit from nothing (about 1 ms each against 4 to 12
  /// on an arm of six joints).
  static constexpr std::size_t kMostChanges = 8;
  /// Columns that say nearly the same are told apart by differences of which every slot that goes
  /// takes some digits: of two that are a thousandth apart, 400 exchanges without a limit leave
  /// 1e-9 of a column wrong, 2e-10 with this one. What is below 1e-5 has nothing to say
  /// (SlotModel).
  static constexpr int kMostGivenBack = 8;

  bool is_followed(const Kept& kept) const {
    return kept.made && changes_.size() - kept.changes <= kMostChanges &&
           kept.fit.given_back < kMostGivenBack;
  }

  void follow(Kept& kept) const {
    for (std::size_t i = kept.changes; i < changes_.size(); ++i) {
      if (const auto* added = std::get_if<Added>(&changes_[i]))
        kept.fit = model_.fit_with(std::move(kept.fit), added->entry, added->variance);
      else
        kept.fit = model_.fit_without(std::move(kept.fit), std::get<Removed>(changes_[i]).slot);
    }
  }

  const SlotModel& model_;
  Slots slots_;
  std::vector<std::variant<Added, Removed>> changes_;
  std::map<int, Kept> fits_;
};

}  // namespace sinew::diagnosis
