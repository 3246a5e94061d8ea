// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the set of hypotheses with the largest posterior odds.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "identification/likelihood/fitted_slots.h"

namespace sinew::diagnosis {

/// A hypothesis in place of a slot's.
struct Rival {
  int hypothesis = 0;
  int entry = 0;             ///< its best
  double log_odds = 0.0;     ///< all its entries together, against nothing in that place
  double probability = 0.0;  ///< among all rivals and nothing
};

class SlotSearch {
 public:
  /// `most`: slots at most. `banned`: hypotheses that are not to be taken.
  SlotSearch(const Hypotheses& all, const SmallErrors& errors, int most,
             const std::vector<bool>& banned);

  const std::vector<Entry>& entries() const { return model_.entries(); }

  /// Whether structure without a name is left out; at first it is not.
  void set_names_alone(bool alone) { names_alone_ = alone; }

  /// Whether all slots have a physical name.
  bool are_named(const Slots& slots) const;

  /// Grown from nothing, and from all values of the model's own, by the best entry each, every slot
  /// exchanged for its best rival after every step; the better one. From nothing alone, a form of
  /// friction that stands for a level and a slope is never given back for the two.
  Slots find() const;
  /// The same from slots that another search has found: entries stand in the same order whatever
  /// the small errors are.
  Slots find(Slots from) const;
  /// The same from a slot's best rivals as other starts; the best of all.
  Slots from_rivals(const Slots& found) const;
  /// Every hypothesis in place of a slot, most probable first.
  std::vector<Rival> rivals(const Slots& slots, std::size_t slot) const;
  /// The smallest set of hypotheses that holds a slot's cause with kCredible; empty where nothing
  /// in its place is not ruled out by that.
  std::vector<Rival> credible(const Slots& slots, std::size_t slot) const;
  /// Log posterior odds that the forms of the slots' laws may lack against structure without a
  /// name, which follows any form.
  double may_lack(const Slots& slots) const;
  /// The same slots, each with the most probable name of its credible set, where there is one.
  Slots with_names(Slots slots) const;
  /// Every hypothesis on top of the slots, with a name or not.
  std::vector<Rival> on_top(const Slots& slots) const;
  /// Coefficients of a slot in the columns' own units, by coefficient of its first shape.
  Eigen::VectorXd coefficients(const Slots& slots, std::size_t slot) const {
    return model_.coefficients(slots, slot);
  }

 private:
  double log_prior(int entry) const { return entries()[static_cast<std::size_t>(entry)].log_prior; }
  struct Sized {
    int entry;
    double variance;
  };
  std::optional<Sized> best(const SlotModel::Fit& f) const;
  std::vector<Rival> rivals(const SlotModel::Fit& f) const;
  bool is_as_good(const Rival& rival, const Rival& best) const;
  std::vector<Rival> ranked(const std::vector<double>& odds) const;
  std::optional<Rival> name_of(const std::vector<Rival>& set) const;
  bool polish(FittedSlots& fitted, int region) const;
  /// `known`: an end of the search; slots that arrive there need no further look.
  void settle(FittedSlots& fitted, int region, const Slots* known = nullptr) const;
  /// With every value of the model's own that has one parameter, of a region or of all.
  Slots with_own_values(Slots slots, std::optional<int> region) const;
  Slots grown(FittedSlots& fitted, int region, const Slots* known = nullptr) const;
  /// Another search's: a rival in a slot's place, beside the others.
  struct Start {
    std::shared_ptr<const SlotModel::Fit> others;
    Sized rival;
  };
  std::vector<Start> other_starts(const Slots& found, int region) const;
  FittedSlots own_values_instead(const Slots& found, int region) const;
  Slots from_rivals(const Slots& found, int region) const;

  const Hypotheses& all_;
  std::size_t most_;
  bool names_alone_ = false;
  SlotModel model_;
};

}  // namespace sinew::diagnosis
