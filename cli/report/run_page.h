// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated run on one page: played back in the model's drawing.
#pragma once

#include "cli/report/model_report.h"
#include "cli/report/recorded_run.h"

namespace sinew {

/// From when to when a tendon was slack [s].
struct SlackSpan {
  std::string tendon;
  double from = 0.0, to = 0.0;
};

struct RunReport {
  ModelReport model;
  std::string what;  ///< file of the scenario or the log
  double duration = 0.0;
  RecordedRun run;
  RecordedBooks books;
  std::vector<std::string> powers;  ///< what the books' columns of work are called
  std::vector<SlackSpan> slack;
  bool knows_slack = false;                                ///< whether slack was looked for
  std::vector<std::pair<std::string, std::string>> facts;  ///< name and value, in words
};

std::string run_page(const RunReport& report);

}  // namespace sinew
