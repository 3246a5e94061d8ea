// SPDX-License-Identifier: GPL-3.0-or-later
// Operations of every emitted function of the committed models and the benchmarks' robots.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace sinew {

/// The kinds that are counted, in the order of the table's columns and by the manifest's names.
inline constexpr std::array<const char*, 7> operation_kinds = {
    "multiply", "add", "negate", "divide", "sqrt", "sincos", "other"};
using OperationCounts = std::array<int, operation_kinds.size()>;

/// Model and function -> counts.
using OperationTable = std::map<std::array<std::string, 2>, OperationCounts>;

/// Derived: of the committed models as their manifests say, which the test of `sinew check` holds
/// against the derivation; of the robots by importing and generating them here.
OperationTable derived_operations();

/// The committed table: CSV text with a header row. Throws std::runtime_error with the line where
/// it cannot be read.
OperationTable parse_operations(const std::string& csv);
std::string csv_text(const OperationTable& table);

/// A line for each function whose counts differ, more before fewer; empty where all are the same.
std::vector<std::string> changes(const OperationTable& accepted, const OperationTable& derived);

}  // namespace sinew
