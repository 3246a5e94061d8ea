// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figures/figure.h"

#include <fmt/format.h>

namespace sinew {
namespace {

std::string csv_of(const Figure& figure) {
  std::string text = fmt::format("# Fig. {} of the source: {}. {}\npanel,series,x,y\n",
                                 figure.number, figure.title, figure.differs);
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series)
      for (std::size_t i = 0; i < series.x.size(); ++i)
        text += fmt::format("\"{}\",\"{}\",{},{}\n", panel.title, series.title, series.x[i],
                            series.y[i]);
  return text;
}

}  // namespace

FileSet figure_files(const Figure& figure) {
  return {{figure.file + ".csv", csv_of(figure)}, {figure.file + ".svg", svg_of(figure)}};
}

}  // namespace sinew
