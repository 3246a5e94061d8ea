// SPDX-License-Identifier: GPL-3.0-or-later
// What held-out logs decide: which causes stand, and whether the model is extended.
#pragma once

#include <string>
#include <vector>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// Members of one name and place count once in their set, and causes that the same name and place
/// stand for best are one: the first of them, with the parameters of all.
/// What is named in another form is not ruled out.
void merge_members(Verdict& verdict);

/// Moves every cause that gains nothing on the held-out logs, and does not stand beside them, to
/// what is ruled out. The other causes keep the parameters that they were fitted with beside it.
/// Where it is plain in the training logs, or where the held-out logs leave much more over, the
/// logs disagree. Structure without a name that gains nothing there is not told.
void confirm_on_held_out(Verdict& verdict);

/// Adopted where there is a term, a held-out log, and a gain there whose interval lies above zero.
/// `functions`: what is emitted then.
void decide_adoption(bool any_term, bool held_out, const Gain& gain,
                     std::vector<std::string> functions, Extension& extension);

/// Takes an adoption back. `because` follows "is left as it is: ".
void withhold(const std::string& because, Extension& extension);

/// A first look is said to be one, in the headline, and adopts nothing.
void tell_first_look(Findings& findings);

/// What was changed and what was left out so that the model stays one that there can be: said
/// behind the reason; with no term left to adopt it is the reason.
void add_remarks(const std::vector<std::string>& changed, const std::vector<std::string>& refused,
                 bool any_term, Extension& extension);

}  // namespace sinew::diagnosis
