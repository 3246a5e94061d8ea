// SPDX-License-Identifier: GPL-3.0-or-later
// What held-out logs say of what was found: nothing is fitted to them.
#pragma once

#include <optional>
#include <vector>

#include "identification/diagnosis/selection.h"
#include "identification/diagnosis/verdict.h"
#include "identification/likelihood/found_slots.h"

namespace sinew::diagnosis {

class HeldOutJudge {
 public:
  /// `found` stays where it is.
  HeldOutJudge(const Design& design, const Settings& settings, const FoundSlots& found)
      : design_(design), settings_(settings), found_(found) {}

  /// Names with what they gain, largest gain first. `of_slot`: as name_slots() gives them, in the
  /// order of the last terms of `adopted`. What held-out logs do not confirm gives its place to the
  /// next member of its set that they confirm, or leaves it unless it stands (confirmation.h), the
  /// least sure name first, and the others are judged anew: of two that say nearly the same neither
  /// is sure beside the other.
  std::vector<NamedCause> causes(const std::vector<NamedCause>& of_slot, Selection& adopted) const;

  /// Whether there is structure without a name, and none of it is told and confirmed by them. What
  /// is of one log they cannot refute.
  bool refutes_structure() const;

  /// What they say of structure without a name, in the order of its slots.
  void confirm_structure(std::vector<Dependence>& depends_on) const;

 private:
  /// The whitened error with a term and without it.
  Gain confirmed(const Model& whole, std::size_t term) const;
  bool is_told_structure(std::size_t slot) const;
  /// Of a slot without a name; none where they cannot say.
  std::optional<Gain> confirmed_structure(std::size_t slot) const;
  void measure(const Selection& selection, std::size_t term, NamedCause& cause) const;
  /// And what is left over in the training logs without it.
  void measure_unsure(std::size_t term, NamedCause& cause, Selection& adopted) const;
  std::optional<Model> with_member(const Model& whole, std::size_t term,
                                   const RankedCause& member) const;
  /// Whether another member of its set is confirmed in its place, and has taken it; the first is
  /// added to those that are gone, without a gain in training: the logs agree on another cause.
  bool gives_way(std::size_t term, NamedCause& cause, Selection& adopted,
                 std::vector<NamedCause>& gone) const;
  std::vector<NamedCause> withdrawn(std::vector<NamedCause>& list, Selection& adopted) const;

  const Design& design_;
  const Settings& settings_;
  const FoundSlots& found_;
};

}  // namespace sinew::diagnosis
