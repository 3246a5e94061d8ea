// SPDX-License-Identifier: GPL-3.0-or-later
// A sealed trial, from the plant's logs to what was told of them, and rates over many.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "identification/adoption/diagnose.h"
#include "identification/adoption/diagnose_observed.h"
#include "tests/blind/truth/sealed_trial.h"

namespace sinew::blind {

/// What the program calls a cause -> what the seal does.
using Words = std::function<std::string(const std::string& name, const std::string& place)>;
Words by_table(std::map<std::string, std::string> table);

struct Outcome {
  truth::Seal seal;
  diagnosis::Findings findings;
  Words words;
  bool detected = false;    ///< something is said to be wrong
  int false_names = 0;      ///< sets without any hidden cause
  int members = 0;          ///< of all sets together
  bool all_inside = false;  ///< each hidden cause is in a set, no set is false
  bool all_right = false;   ///< and is named first there
  /// Whether this one cause is hidden, within a fifth of the size: a seed's trial changes with the
  /// simulators, so a test of one seed says first what it takes the seed to hide.
  bool hides(const std::string& name, const std::string& place, double size) const;
  bool is_settled() const;  ///< each hidden cause alone in its set, and nothing else
  std::string told() const;
  std::string hidden() const;
  std::string missed() const;  ///< why what is hidden was ruled out
};

/// Opens the seal after the verdict.
Outcome judged(truth::Seal seal, diagnosis::Findings findings, const Words& words);

/// Diagnoses the trial's logs as driven joints; `request` has the model and its channels.
Outcome diagnose_driven(
    const truth::TrialRequest& trial,
    const std::function<diagnosis::DiagnoseRequest(const truth::Trial&)>& request,
    const Words& words);

/// The same, and where the hidden cause is told in a set with others, once more with a log of the
/// motion that the program asked for: `before`, and what was told then.
struct Settled {
  Outcome before;
  std::optional<Outcome> after;  ///< none: no set, or no motion asked for
};
Settled settle_driven(const truth::TrialRequest& trial,
                      const std::function<diagnosis::DiagnoseRequest(const truth::Trial&)>& request,
                      const Words& words);

/// Diagnoses the trial's logs as a rig's; `rig`: the model under test from what is handed over.
Outcome diagnose_rig(const truth::TrialRequest& trial,
                     const std::function<diagnosis::ObservedRig(const truth::Trial&)>& rig,
                     const Words& words);

using Trials = std::function<Outcome(const truth::TrialRequest&)>;

/// How many of a row of trials came out how.
struct Rates {
  int trials = 0, detected = 0, all_inside = 0, all_right = 0, false_names = 0;
  int trials_with_false_name = 0, none_of_the_known = 0, sets = 0, members = 0, adopted = 0;
  void add(const Outcome& outcome);
  std::string text() const;
};

/// Trials with the seeds first, first + 1, ... Throws std::runtime_error where a seal does not hold
/// as many causes as its family says.
Rates run(const Trials& diagnose, truth::TrialRequest request, int count,
          const std::function<void(std::uint64_t seed, const Outcome&)>& each = {});

}  // namespace sinew::blind
