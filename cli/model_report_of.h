// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/models/model_folder.h"
#include "cli/report/model_report.h"

namespace sinew {

/// The drawing of a model and what is known of its tendons; `emitted`: its functions. Changes,
/// boards and equations are left open.
ModelReport model_report_of(const ModelFolder& folder, const EmittedModel& emitted);

}  // namespace sinew
