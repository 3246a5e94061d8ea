// SPDX-License-Identifier: GPL-3.0-or-later
// gnuplot's SVG made fit for a page: without ids, fonts and definitions, in the page's colours,
// clouds of points as one path.
#pragma once

#include <string>

namespace sinew::diagnosis {

/// The colour by which gnuplot is told a role: "ink", "grid", "axis", "measured", "before",
/// "after", "noise", "extra-1" to "extra-3".
unsigned placeholder_colour(const std::string& role);

/// The <svg> element with a title for who cannot see it, as large as the drawing and all its
/// labels. Empty for text that is no whole SVG.
std::string svg_for_page(const std::string& gnuplot_svg, const std::string& alternative);

}  // namespace sinew::diagnosis
