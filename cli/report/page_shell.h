// SPDX-License-Identifier: GPL-3.0-or-later
// What pages of models and of runs have in common: the document, its data, its program.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/report/model_report.h"
#include "generator/graph.h"

namespace sinew {

/// Files of cli/report/page, compiled in (cmake/sinew_embed.cmake).
extern const char* const page_program;
extern const char* const page_sheet;

/// A whole HTML document: the first screen, the program, and the rest of the page behind it, so
/// that the drawing stands before the rest is read. `data` is what the program reads; the functions
/// of `graphs` are there under their names. The policy names the hash of the one script: no other
/// one runs, and nothing is asked for.
std::string document(const std::string& title, const std::string& first, const std::string& rest,
                     const nlohmann::ordered_json& data, const std::vector<Graph>& graphs);

/// Functions that the page computes with: the model's own and those of its drawing, but those too
/// long for a page, whose names go to `left_out`.
std::vector<Graph> functions_of_page(const ModelReport& report, std::vector<std::string>& left_out);

/// What the drawing and the sliders need.
nlohmann::ordered_json data_of(const ModelReport& report, const std::vector<Graph>& graphs);

/// The drawing with its buttons; `controls`: HTML beside it.
std::string stage(const ModelReport& report, const std::string& controls);

/// "1 joint", "2 joints".
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// Three significant digits with the page's minus sign.
std::string shown(double value);

}  // namespace sinew
