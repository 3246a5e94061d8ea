// SPDX-License-Identifier: GPL-3.0-or-later
// Ripples that show in an effort's spectrum over a shaft's angle and not in the band that all else
// is compared in.
#pragma once

#include <vector>

#include "identification/diagnosis/verdict.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// Causes for the subject's lines (DrivenSubject::shaft_lines) that the verdict does not name: with
/// their amplitude in every training log, of what splines leave over of the efforts as logged. The
/// line has to be material and to gain in what it was not fitted to, held-out logs that turn the
/// shaft once or, without any, blocks of theirs. They have no term (kNoTerm): the model stays as it
/// is, since the band that judges it holds too little of them.
std::vector<NamedCause> lines_beside(const DrivenSubject& subject, const Verdict& verdict,
                                     const Settings& settings);

}  // namespace sinew::diagnosis
