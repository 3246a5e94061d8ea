// SPDX-License-Identifier: GPL-3.0-or-later
// A sealed trial on a rig whose sensors a model predicts, from the plant to what was told of it.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "identification/diagnose_observed.h"
#include "tests/blind/truth/sealed_trial.h"

namespace sinew::blind {

struct Outcome {
  truth::Seal seal;
  diagnosis::Findings findings;
  std::map<std::string, std::string> words;  ///< what the program calls it -> what the seal does
  bool detected = false;                     ///< something is said to be wrong
  int false_names = 0;                       ///< sets without any hidden cause
  int members = 0;                           ///< of all sets together
  bool all_inside = false;                   ///< each hidden cause is in a set, no set is false
  bool all_right = false;                    ///< and is named first there
  std::string told() const;
  std::string hidden() const;
};

/// `rig`: the model under test from what is handed over.
Outcome diagnose_trial(const truth::TrialRequest& request,
                       const std::function<diagnosis::ObservedRig(const truth::Trial&)>& rig,
                       const std::map<std::string, std::string>& words);

/// SINEW_TRIALS, SINEW_SIZE (percent of the noise), SINEW_SEED, SINEW_FAMILY choose the run; a line
/// for each trial and the rates at the end.
void study(const std::function<Outcome(std::uint64_t seed, truth::Family, double size)>& trial);

}  // namespace sinew::blind
