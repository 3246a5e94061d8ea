// SPDX-License-Identifier: GPL-3.0-or-later
// The model with some hypotheses: how it fits, what else would gain beside them, and whether
// physics allows it.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <utility>
#include <vector>

#include "identification/likelihood/entries.h"

namespace sinew::diagnosis {

/// The hypotheses a model holds, one entry each.
struct Slots {
  std::vector<int> entries;
  std::vector<double> variances;  ///< prior variance of each one's coefficients, the most probable
  double log_posterior = 0.0;     ///< log odds against the model without any
};

/// An entry on top of a model.
struct EntryOdds {
  int entry = 0;
  double log_odds = 0.0;
};

/// Log odds of what is not to be taken.
inline constexpr double kNoOdds = -std::numeric_limits<double>::infinity();

class SlotModel {
 public:
  /// The model with some entries.
  struct Posterior {
    std::vector<Eigen::Index> columns;  ///< the entries'
    Eigen::VectorXd precision;          ///< prior precision of the model's coefficients
    Eigen::MatrixXd root;               ///< its transpose times it: their posterior covariance
    Eigen::MatrixXd inverse;            ///< their posterior covariance
    Eigen::VectorXd coefficients;
  };

  /// What the model with some entries leaves to a region's columns.
  struct Fit {
    Slots slots;
    int region = Regions::kEverywhere;
    std::vector<const Eigen::MatrixXd*> cross;  ///< of each slot, its products with the columns
    Eigen::MatrixXd inverse;                    ///< the coefficients' posterior covariance
    Eigen::VectorXd coefficients;
    Eigen::VectorXd target;  ///< products of the columns with what is left over
    Eigen::VectorXd grams;   ///< what is left of the Gram matrices of the region's entries, in turn
    int given_back = 0;      ///< slots that went since it was made from nothing
  };

  /// `banned`: hypotheses that are not to be taken.
  SlotModel(const Hypotheses& all, const SmallErrors& errors, const std::vector<bool>& banned);

  const std::vector<Entry>& entries() const { return entries_; }
  const Hypothesis& hypothesis_of(int entry) const;
  /// Where an entry acts; how many regions there are.
  int region_of(int entry) const { return regions_[static_cast<std::size_t>(entry)]; }
  int regions() const { return errors_.moments().regions().count(); }

  Fit fit(const Slots& slots, int region) const;
  /// The fit with one more slot, the last one, or with all but one, from that of the others or of
  /// all: far less work than from nothing.
  Fit fit_with(Fit f, int entry, double variance) const;
  Fit fit_without(Fit f, std::size_t slot) const;
  /// Of an entry on top of a model that is fitted in a region which has its columns.
  BayesFactor factor(int entry, const Fit& given) const;
  /// Of every entry whose columns the fit's region has, kNoOdds for the others and for other forms
  /// of what the slots hold.
  std::vector<double> log_odds(const Fit& f, bool names_alone) const;
  /// What they are at most, of those that can be above 0, the largest first: far less work.
  std::vector<EntryOdds> odds_at_most(const Fit& f, bool names_alone) const;
  /// Whether all coefficients are within their limits.
  bool is_possible(const Slots& slots) const;
  /// The same with one more entry of that prior variance, from the fit without it.
  bool stays_possible(const Fit& f, int entry, double variance) const;
  /// With the log posterior odds of the slots together against none.
  Slots weighed(Slots slots) const;
  /// Coefficients of a slot in the columns' own units, by coefficient of its first shape.
  Eigen::VectorXd coefficients(const Slots& slots, std::size_t slot) const;

 private:
  /// Entries that meet a region, where each one's matrix begins in Fit::grams, and where its
  /// columns stand among the region's.
  struct RegionEntries {
    std::vector<int> entries;
    std::vector<Eigen::Index> first;                ///< by entry; the length of all at the end
    std::vector<std::vector<Eigen::Index>> places;  ///< by entry; of others none
  };
  RegionEntries entries_meeting(int region) const;
  const RegionEntries& entries_in(int region) const {
    return region_entries_[static_cast<std::size_t>(region + 1)];
  }
  /// Whether an entry is one of those that meet a region.
  bool meets(int region, int entry) const { return !places(region, entry).empty(); }
  const std::vector<Eigen::Index>& places(int region, int entry) const {
    return entries_in(region).places[static_cast<std::size_t>(entry)];
  }
  Posterior posterior(const Slots& slots) const;
  /// Products of an entry's columns (rows) with a region's. A search asks for the same ones again
  /// and again.
  const Eigen::MatrixXd& products(int region, int entry) const;
  ConditionalMoments conditional(int entry, const Fit& given) const;
  ConditionalMoments elsewhere(int entry, const Eigen::MatrixXd& cross, const Fit& given) const;
  /// Products of the slots' coefficients, one row each, with an entry's columns.
  Eigen::MatrixXd cross_of(const Fit& f, int entry) const;
  /// `weights`, one column a coefficient of the slots, times their products with all columns.
  Eigen::MatrixXd combined(const Fit& f, const Eigen::MatrixXd& weights) const;
  /// Takes rows' rows off what is left of every entry's Gram matrix, or gives it back.
  void take(const Eigen::MatrixXd& rows, double sign, Fit& f) const;
  bool has_something_to_say(const ConditionalMoments& m, int entry) const;
  /// By entry, `odds` of those that log_odds() is about.
  template <class Odds>
  std::vector<double> of_entries(const Fit& f, bool names_alone, const Odds& odds) const;
  Eigen::VectorXd precisions(const Slots& slots) const;
  int cause_of(int entry) const {
    return causes_[static_cast<std::size_t>(entries_[static_cast<std::size_t>(entry)].hypothesis)];
  }
  bool is_possible(const std::vector<int>& entries, const Eigen::VectorXd& coefficients,
                   const Eigen::VectorXd& variances) const;
  bool is_possible(int entry, const Eigen::VectorXd& coefficients,
                   const Eigen::VectorXd& errors) const;

  const Hypotheses& all_;
  const SmallErrors& errors_;
  std::vector<Entry> entries_;
  std::vector<int> regions_;  ///< of every entry
  std::vector<int> causes_;   ///< of every hypothesis: one number for all forms of a cause
  std::vector<RegionEntries> region_entries_;  ///< everywhere, then the regions
  mutable std::shared_mutex guard_;
  /// By region and entry.
  mutable std::map<std::pair<int, int>, std::unique_ptr<Eigen::MatrixXd>> products_;
};

}  // namespace sinew::diagnosis
