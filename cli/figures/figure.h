// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of the source, reproduced: its numbers as CSV, its drawing as SVG, and both beside what
// the source prints.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "generator/outputs/outputs.h"

namespace sinew {

constexpr double degree = std::numbers::pi / 180.0;  ///< rad

enum class Look { line, dashed, thick, line_and_dots, dots, crosses, circles };

struct Series {
  std::string title;  ///< empty: no entry in the key
  std::vector<double> x, y;
  Look look = Look::line;
  int colour = -1;  ///< of the palette; below 0: the series' number among the panel's
};

struct Panel {
  std::string title, x_label, y_label;
  std::vector<Series> series;
  std::string note{};  ///< said within the axes, for instance that what is seen is rounding noise
};

/// A number that the source prints, or says in words, and the one found here.
struct ComparedNumber {
  std::string what, source, here;
};

struct Figure {
  std::string file;           ///< stem of the file names
  std::string number;         ///< in the source
  std::string title;          ///< what it shows
  std::string differs;        ///< what differs from the source's figure, and why
  std::vector<Panel> panels;  ///< side by side
  std::vector<ComparedNumber> numbers{};
};

/// The drawing, for paper: sizes in points, the key above the axes, white background.
std::string svg_of(const Figure& figure);

/// <file>.csv (a comment with number, title and difference, then panel, series, x, y) and
/// <file>.svg.
FileSet figure_files(const Figure& figure);

/// index.html: all figures on one page that needs nothing else, with the source's numbers beside
/// those found here.
std::string gallery_page(const std::vector<Figure>& figures);

}  // namespace sinew
