// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "cli/figures/draw_panel.h"

namespace sinew {
namespace {

constexpr double lone_panel = 340.0, sheet = 510.0, gap = 14.0, axes_height = 190.0;  // pt

}  // namespace

std::string svg_of(const Figure& figure) {
  const auto count = static_cast<double>(figure.panels.size());
  const double width = figure.panels.size() > 1 ? sheet : lone_panel;
  const double each = count > 0 ? (width - (count - 1.0) * gap) / count : width;
  double key = 0.0;
  for (const Panel& panel : figure.panels) key = std::max(key, key_height(panel, each));
  const double height = axes_height + 16.0 + key;
  std::string panels;
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    panels += drawn_panel(figure.panels[i],
                          {static_cast<double>(i) * (each + gap), 0.0, each, height}, key);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}pt\" height=\"{1:g}pt\" "
             "viewBox=\"0 0 {0:g} {1:g}\" role=\"img\" font-family=\"Helvetica, Arial, 'Liberation "
             "Sans', sans-serif\" font-size=\"8\">\n<title>",
             width, height) +
         xml_text(fmt::format("{} (source: Fig. {})", figure.title, figure.number)) +
         fmt::format("</title>\n<path d=\"M0 0H{:g}V{:g}H0Z\" fill=\"#ffffff\"/>\n", width,
                     height) +
         panels + "</svg>\n";
}

}  // namespace sinew
