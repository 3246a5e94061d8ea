// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the set of hypotheses with the largest posterior odds.
#pragma once

#include <optional>
#include <vector>

#include "identification/likelihood/entries.h"

namespace sinew::diagnosis {

/// The hypotheses a model holds, one entry each.
struct Slots {
  std::vector<int> entries;
  std::vector<double> variances;  ///< prior variance of each one's coefficients
  double log_posterior = 0.0;     ///< log odds against the model without any
};

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

  const std::vector<Entry>& entries() const { return entries_; }

  /// What the library's forms are off by, as a share of a found cause's size; kFormErrors[0] first.
  void set_form_error(double share) { form_error_ = share; }

  /// Grown from nothing by the best entry each, every slot exchanged for its best rival after every
  /// step.
  Slots find() const;
  /// The same from a slot's best rivals as other starts; the best of all.
  Slots from_rivals(const Slots& found) const;
  /// Every hypothesis in place of a slot, most probable first.
  std::vector<Rival> rivals(const Slots& slots, std::size_t slot) const;
  /// The smallest set of hypotheses that holds a slot's cause with kCredible; empty where nothing
  /// in its place is not ruled out by that.
  std::vector<Rival> credible(const Slots& slots, std::size_t slot) const;
  /// The same slots, each with the most probable name of its credible set, where there is one.
  Slots with_names(Slots slots) const;
  /// Every hypothesis on top of the slots.
  std::vector<Rival> on_top(const Slots& slots) const;
  /// Coefficients of a slot in the columns' own units, by coefficient of its first shape.
  Eigen::VectorXd coefficients(const Slots& slots, std::size_t slot) const;

 private:
  struct Fit;
  Fit fit(const std::vector<int>& entries) const;
  std::vector<double> log_odds(const std::vector<int>& given) const;
  BayesFactor factor(int entry, const Fit& given) const;
  double form_error(const Entry& e, const Fit& given, const ConditionalMoments& m,
                    double variance) const;
  Eigen::VectorXd precisions(const std::vector<int>& entries, Fit& f) const;
  bool is_possible(const std::vector<int>& entries) const;
  bool is_possible(int entry, const Eigen::VectorXd& coefficients,
                   const Eigen::VectorXd& errors) const;
  std::optional<int> best_possible(const std::vector<int>& given,
                                   const std::vector<double>& odds) const;
  std::vector<Rival> ranked(const std::vector<double>& odds) const;
  bool polish(std::vector<int>& entries) const;
  Slots grown(std::vector<int> entries) const;
  Slots weighed(const std::vector<int>& entries) const;

  const Hypotheses& all_;
  const SmallErrors& errors_;
  std::size_t most_;
  double form_error_;
  std::vector<Entry> entries_;
};

}  // namespace sinew::diagnosis
