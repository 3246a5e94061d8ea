// SPDX-License-Identifier: GPL-3.0-or-later
// How much room a plot's labels take.
#pragma once

#include <string>

namespace sinew::diagnosis {

/// A part of the drawing's plane, in its units.
struct PlotBounds {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// Width of one line of text, UTF-8, at a font size: no less than in any of the fonts that browsers
/// take for sans-serif.
double text_width(const std::string& text, double font_size);

/// `sheet` with all the room that the <text> elements of gnuplot's SVG need.
PlotBounds with_labels(const std::string& svg, PlotBounds sheet);

}  // namespace sinew::diagnosis
