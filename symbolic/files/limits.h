// SPDX-License-Identifier: GPL-3.0-or-later
// How large what is read may be, so that no input keeps the program busy for ever or takes the
// machine's memory. No robot and no log comes near; docs/model_files.md, docs/logs.md and
// docs/simulation.md show the same numbers.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sinew::limits {

// Descriptions: TOML, tables of mass properties, URDF.
constexpr std::uintmax_t description_bytes = std::uintmax_t{4} << 20;
constexpr std::size_t entries =
    1000;                           ///< [[body]], [[joint]], ...; rows of a table; links of a URDF
constexpr int moving_joints = 100;  ///< of one mechanism: the derivation's time grows with them
constexpr int toml_nesting = 32;    ///< parts of a dotted key; brackets inside brackets
constexpr int xml_nesting = 200;    ///< elements inside elements

// Logs, which are read in one passage and never held whole, and tables of commands, which are.
constexpr std::uintmax_t log_bytes = std::uintmax_t{100} << 30;
constexpr std::size_t log_line_bytes = std::size_t{16} << 20;
constexpr std::size_t log_columns = 10000;
constexpr std::uintmax_t command_table_bytes = std::uintmax_t{64} << 20;

// Sums of logs (docs/fleets.md): of an arm of seven joints a few thousand columns, a hundred MB.
constexpr std::uintmax_t sums_bytes = std::uintmax_t{2} << 30;
constexpr std::size_t sums_columns = 20000;

// Scenarios.
constexpr double run_seconds = 86400.0;    ///< duration
constexpr double run_rows = 1e8;           ///< duration times output rate
constexpr double run_steps = 1e9;          ///< duration over the step of a fixed-step integrator
constexpr double sine_periods = 1e6;       ///< of one command within the run
constexpr long watched_steps = 100000;     ///< so many steps of CVODE ...
constexpr double watched_progress = 1e-3;  ///< s, ... get at least this far

// Messages.
constexpr std::size_t shown_mistakes = 100;     ///< of one run; the others are counted
constexpr std::size_t shown_names = 30;         ///< of a list in a message; the others are counted
constexpr std::size_t shown_characters = 1000;  ///< of one part of a message, its middle left out
constexpr std::size_t shown_line = 4000;        ///< characters of any line of a message

}  // namespace sinew::limits
