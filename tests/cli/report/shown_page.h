// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of models and runs in a browser without a window: used, and looked at.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sinew::report {

struct ShownPage {
  std::string name, html;
  int width = 0;  ///< CSS pixels
  bool dark = false;
};

struct ShownPages {
  /// What was seen of each page, by its name: see the probe in shown_page.cpp.
  nlohmann::json seen;
  std::vector<std::string> complaints;  ///< lines of the console
};

/// Shows all pages at once, each in a frame, and uses it: moves a slider, turns the drawing by
/// pointer and by keys, presses every button. `calls`: {page: {function: [inputs, ...]}}, evaluated
/// by the page's own functions. Throws std::runtime_error where the browser does not answer.
ShownPages show(const std::vector<ShownPage>& pages, const nlohmann::json& calls = {});

}  // namespace sinew::report
