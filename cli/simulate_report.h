// SPDX-License-Identifier: GPL-3.0-or-later
// A run gathered while it is integrated, for the page of `sinew simulate --report`.
#pragma once

#include <filesystem>
#include <string>

#include "cli/report/run_page.h"
#include "simulation/plant/simulate.h"

namespace sinew {

class RunRecorder {
 public:
  /// `what`: the file of the scenario or the log. Throws what reading the model throws.
  RunRecorder(const std::filesystem::path& model, const std::string& what, const Plant& plant);

  void add_row(const std::vector<double>& row) { report_.run.add(row); }
  void add_books(double time, double energy, const Powers& work) {
    report_.books.add(time, energy, {work.begin(), work.end()});
  }
  std::string html(const SimulationResult& result);

 private:
  void take_slack(const SimulationResult& result);

  RunReport report_;
};

}  // namespace sinew
