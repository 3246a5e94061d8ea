// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a model's page, each empty where there is nothing to say.
#pragma once

#include <string>

#include "cli/report/model_report.h"
#include "cli/report/sampled_facts.h"

namespace sinew {

std::string workspace_section(const ModelReport& report, const std::optional<Reach>& reach);
std::string along_section(const ModelReport& report);
std::string closure_section(const ModelReport& report, const std::optional<Closure>& closure);
std::string function_section(const ModelReport& report, const std::vector<std::string>& left_out);
std::string change_section(const ModelReport& report);
std::string equation_section(const ModelReport& report);
std::string table_section(const ModelReport& report);
std::string missing_section(const ModelReport& report);

}  // namespace sinew
