// SPDX-License-Identifier: GPL-3.0-or-later
// Measured friction of guided tendons, as a table that a user brings (4.2).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sinew {

/// One measurement: the steady friction of a tendon drawn over a guide.
struct GuidingMeasurement {
  double tension = 0.0;   ///< N, on the pulling side
  double bending = 0.0;   ///< rad, in all
  double friction = 0.0;  ///< N, what the tension loses
};

/// Everything measured with one tendon on one kind of guide.
struct GuidingSeries {
  std::string tendon;   ///< material and diameter, in the table's words
  std::string guide;    ///< "pulley" or "sliding"
  std::string surface;  ///< material of the guide
  double radius = 0.0;  ///< m, of the bend
  std::vector<GuidingMeasurement> points;
};

/// CSV: columns `tendon`, `guide`, `surface` (words) and `radius [mm]`, `tension [N]`,
/// `bending [deg]`, `friction [N]` (any units of these kinds), in any order; lines that begin with
/// '#' are comments. Series in the order of their first row. Throws DescriptionError with every
/// mistake found, each with file, row and column: a column missing or twice, a unit missing or of
/// another kind, a cell that is no finite number, a negative one, a guide of another kind.
std::vector<GuidingSeries> read_guiding_table(const std::filesystem::path& file);

}  // namespace sinew
