// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/ended_early.h"

#include <exception>

namespace sinew::diagnosis {

std::string why_ended(const std::function<void()>& step) {
  try {
    step();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

void tell_ended_search(const std::string& why, Findings& findings) {
  findings.verdict.unexplained.none_of_the_known = true;
  findings.headline = "The search for causes ended without a result (" + why +
                      "); what the model leaves over is shown as it is.";
  findings.extension.adopted = false;
  findings.extension.reason = "the search for causes ended without a result: " + why;
}

}  // namespace sinew::diagnosis
