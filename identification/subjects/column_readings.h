// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a log's columns are what their names say: each way in which one may have been written
// otherwise is a hypothesis, and competes on one likelihood with what the machine itself may have
// wrong. rig_readings.h and driven_readings.h say what a log is worth, read in some way.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "identification/diagnosis/clustered_errors.h"
#include "identification/logs/data_faults.h"

namespace sinew::diagnosis {

/// One way in which a log may have been written.
struct ColumnReading {
  static constexpr int kClock = -1;  ///< in place of a column
  int column = 0;                    ///< channel of the log
  int other = -1;                    ///< exchanged with the first
  double factor = 1.0;               ///< what is written over what is meant
  std::string meaning;
  double odds = 1.0;  ///< against a slip that is often made
  bool all = false;   ///< all columns of this quantity alike
};

/// Odds of a factor that no unit has, and of two columns of unlike quantities that are exchanged,
/// against a slip that is often made.
inline constexpr double kRare = 0.2;

/// Every model is off by that share of what it says.
inline constexpr double kAnyway = 0.03;

/// Log likelihood of one measured quantity of which the model leaves over this share of its
/// variance, in so many stretches of time that each may be anything.
double evidence_of_share(double share, double stretches = kStretches);

/// The ways in which a column alone may be wrong: its sign, and units whose slips are known.
std::vector<ColumnReading> known_slips(const Log& log, int column);

/// Whether so much more log likelihood could make any of these readings likelier.
bool is_worth_reading(double gain, const std::vector<ColumnReading>& readings);

/// The likeliest of `others`, where it is likelier than the log as it is. `as_it_is`: log
/// likelihood of that; `evidence`: log likelihood of a reading, or anything below the second
/// argument where it cannot reach that.
std::optional<ColumnReading> likelier_reading(
    const std::vector<ColumnReading>& others, double as_it_is,
    const std::function<double(const ColumnReading&, double)>& evidence);

/// Severity::stop. `left_by`, `left_now`: share of the standard deviation of `what` that the model
/// leaves over, with that reading and as the log is.
void tell(const Log& log, const ColumnReading& reading, double left_by, double left_now,
          const std::string& what, FaultList& faults);

}  // namespace sinew::diagnosis
