// SPDX-License-Identifier: GPL-3.0-or-later
// Plots as inline SVG, drawn by gnuplot (Debian's gnuplot-nox) as a process of its own.
#pragma once

#include <string>
#include <vector>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// One <svg> element for each plot, in their order, or an empty string where there is nothing to
/// draw or gnuplot is absent or fails. The elements carry no ids, no fonts and no fixed colours:
/// strokes are the page's custom properties --ink, --grid, --measured, --before, --after, --noise,
/// --extra-1 to --extra-3. `alternatives`: text for who cannot see the picture, one for each plot.
/// The same plots give the same bytes.
std::vector<std::string> svg_figures(const std::vector<Plot>& plots,
                                     const std::vector<std::string>& alternatives);

/// The name of the custom property a series is drawn in, without the dashes: "before" for "model
/// before". `position`: among the plot's series.
std::string series_role(const std::string& label, std::size_t position);

/// Whether a line is dashed: the model before, which mostly lies behind other curves, and backward
/// motion beside forward motion.
bool is_dashed(const std::string& label);

}  // namespace sinew::diagnosis
