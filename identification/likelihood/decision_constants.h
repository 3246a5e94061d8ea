// SPDX-License-Identifier: GPL-3.0-or-later
// Every number that the search decides by, with what it is chosen by. None belongs to one cause.
#pragma once

namespace sinew::diagnosis {

/// Prior odds of a named cause: the nulls' largest log odds stay below 0 in 99 %.
inline constexpr double kPriorOdds = 1e-5;

/// Odds of structure without a name, as a share of a named cause's: names that were wrongly left
/// out against structure that was wrongly named, at equal cost.
inline constexpr double kUnnamedOdds = 0.3;

/// Odds of a cause that is unlikely by itself, as a share of another one's: named only where no
/// other explains as much (a link that is not as drawn, where a rotor or a payload may be). No
/// command calibrates it yet.
inline constexpr double kUnlikelyOdds = 2.5e-3;

/// Sizes of a cause, as shares of the rms of what was measured: from what is worth telling to what
/// a model's own values can be off by.
inline constexpr double kSmallestSize = 0.004, kLargestSize = 0.5;

/// Cosines of the noise's log spectrum: the most with which the bins of fresh nulls stay white.
inline constexpr int kCosines = 6;

/// A bin counts as no more than this many times the spectrum: a hum is no noise.
inline constexpr double kClipped = 9.0;

/// What a tenfold share of small errors has to gain in log likelihood: between nulls, in which
/// cheap errors hide weak delays, and measured drives, in which dear ones invent names.
inline constexpr double kPriceOfDecade = 20.0;

/// Share of its size by which the form of what was found is off: the laws of one name differ by
/// about that much (tests/blind/truth/axis.cpp). Of 0.03, 0.1 and 0.2 the one with the fewest wrong
/// names on 132 trials of development's seeds (tests/blind/study/run_study.py); larger ones were
/// not tried.
inline constexpr double kFormError = 0.2;

/// Posterior probability of a set that cannot be told apart: a definition.
inline constexpr double kCredible = 0.95;

}  // namespace sinew::diagnosis
