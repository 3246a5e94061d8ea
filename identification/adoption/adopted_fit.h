// SPDX-License-Identifier: GPL-3.0-or-later
// The joint fit that a model is extended by: without what is impossible in it, and without what
// does harm at a joint.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/diagnosis/explanation.h"

namespace sinew::diagnosis {

/// A fit whose causes may be fewer than those named; the rest is fitted again without the others.
struct AdoptedFit {
  Selection selection;
  std::vector<std::string> refused;  ///< a sentence for each cause that was left out
};

/// Of a verdict's causes, the one that this candidate's term stands for; -1: none.
int cause_of(const Verdict& verdict, int candidate);

/// The fit that the verdict's gains stand for, without causes that it puts beyond their limits or
/// of which it leaves no finite standard error: what was possible when a cause was named may have
/// become impossible beside the others. Without bodies, too, that no cause tells: another one's
/// mass would be what only both together have.
AdoptedFit possible_fit(const Design& design, const Explanation& explanation);

/// Leaves out the cause without which the fit predicts this channel of the held-out logs best.
/// False where every cause that acts there is of use to it.
bool leave_out_harmful(const Design& design, const Settings& settings, int channel,
                       const std::string& channel_name, AdoptedFit& fit);

}  // namespace sinew::diagnosis
