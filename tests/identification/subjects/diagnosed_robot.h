// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism's logs diagnosed as `sinew diagnose` does it.
#pragma once

#include <string>
#include <vector>

#include "identification/adoption/diagnose.h"
#include "identification/report/findings.h"
#include "symbolic/model/mechanism.h"

namespace sinew::test {

/// A carriage on a rail without weight: kg, N·s/m, N.
Mechanism slide(double mass, double damping, double friction);

/// `train`, `holdout`: CSV text with q_<joint>, tau_<joint>.
diagnosis::Diagnosis whole_diagnosis(const Mechanism& nominal, const std::string& train,
                                     const std::string& holdout);

/// A log as CSV text.
struct LogText {
  std::string name, text;
  bool held_out = false;
};

/// `conditions`: texts of --condition.
diagnosis::Diagnosis diagnosis_of(const Mechanism& nominal, const std::vector<LogText>& logs,
                                  const std::vector<std::string>& conditions = {});
diagnosis::Findings diagnosed(const Mechanism& nominal, const std::string& train,
                              const std::string& holdout);

}  // namespace sinew::test
