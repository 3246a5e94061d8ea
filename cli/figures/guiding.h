// SPDX-License-Identifier: GPL-3.0-or-later
// Designers' tables and plots of guiding friction (4.2, Fig. 4.10, 4.11).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/figures/figure.h"
#include "identification/experiments/guiding_fit.h"

namespace sinew {

struct FittedSeries {
  GuidingSeries series;
  GuidingFit fit;
};

/// Friction against bending angle, a panel a tendon, a curve a guide: measured points and the law
/// that fits. `tension`: N, which all curves are drawn for; points are scaled to it.
Figure figure_guiding_friction(const std::vector<FittedSeries>& all, double tension,
                               const std::string& origin);
/// Pulley against sliding surface: what is left of the tension behind either, by bending angle.
Figure figure_pulley_or_sliding(const std::vector<FittedSeries>& all, const std::string& origin);

/// Tension that the most measurements were made at [N].
double usual_tension(const std::vector<FittedSeries>& all);

/// The designers' files: friction_by_angle.csv (a row a series and angle), pulley_or_sliding.csv
/// (each pulley against each sliding surface of the same tendon), friction_by_angle.svg,
/// pulley_or_sliding.svg with their data.
FileSet guiding_tables(const std::vector<FittedSeries>& all);

}  // namespace sinew
