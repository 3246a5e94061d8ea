// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of the source, reproduced: its numbers as CSV, its drawing as SVG through gnuplot.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "generator/outputs/outputs.h"

namespace sinew {

constexpr double degree = std::numbers::pi / 180.0;  ///< rad

struct Series {
  std::string title;  ///< empty: no entry in the key
  std::vector<double> x, y;
  std::string style = "lines";  ///< gnuplot's
};

struct Panel {
  std::string title, x_label, y_label;
  std::vector<Series> series;
};

struct Figure {
  std::string file;           ///< stem of the file names
  std::string number;         ///< in the source
  std::string title;          ///< what it shows
  std::string differs;        ///< what differs from the source's figure, and why
  std::vector<Panel> panels;  ///< side by side
};

/// <file>.csv (a comment with number, title and difference, then panel, series, x, y) and
/// <file>.svg. Throws std::runtime_error where gnuplot fails.
FileSet figure_files(const Figure& figure);

/// index.html: all figures with their notes.
std::string index_page(const std::vector<Figure>& figures);

}  // namespace sinew
