// SPDX-License-Identifier: GPL-3.0-or-later
// One panel of a figure as SVG.
#pragma once

#include <string>

#include "cli/figures/figure.h"

namespace sinew {

/// Where a panel stands on its sheet [pt].
struct PanelBox {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

/// Height of the key above the axes at this width [pt].
double key_height(const Panel& panel, double width);

/// Title, key, axes and curves; `key`: the height kept for the key, the same in all panels.
std::string drawn_panel(const Panel& panel, const PanelBox& box, double key);

/// Text as XML.
std::string xml_text(const std::string& text);

/// "1.5", "−20", "3·10⁻¹⁷": with a minus sign and without an exponent where it can be helped.
std::string tick_text(double value, double step);

/// Distance of ticks, 1, 2 or 5 times a power of ten, so that at most `most` fit between the ends.
double tick_step(double low, double high, int most);

}  // namespace sinew
