// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/plot_bounds.h"

#include <algorithm>
#include <regex>
#include <string_view>

namespace sinew::diagnosis {
namespace {

/// Of the font size, as in DejaVu Sans and Verdana, the widest of the usual fonts.
double width_of_letter(unsigned char first_byte) {
  constexpr std::string_view narrow = " .,:;'|!()[]ijlftrI/", wide = "mwMW%@";
  const char c = static_cast<char>(first_byte);
  if (first_byte >= 0x80) return 0.84;  // a minus sign; no sign of a unit is wider
  if (narrow.find(c) != std::string_view::npos) return 0.42;
  if (wide.find(c) != std::string_view::npos) return 1.0;
  return c >= 'A' && c <= 'Z' ? 0.79 : 0.64;
}

/// As it is seen: entities are one letter, tags none.
std::string seen_text(const std::string& markup) {
  static const std::regex tag("<[^>]*>"), entity("&[a-z#0-9]+;"), edge("^\\s+|\\s+$");
  return std::regex_replace(std::regex_replace(std::regex_replace(markup, tag, ""), entity, "M"),
                            edge, "");
}

}  // namespace

double text_width(const std::string& text, double font_size) {
  double width = 0.0;
  for (const char c : text)
    if ((c & 0xC0) != 0x80) width += width_of_letter(static_cast<unsigned char>(c));
  return width * font_size;
}

PlotBounds with_labels(const std::string& svg, PlotBounds sheet) {
  static const std::regex label(
      "<g transform=\"translate\\(([-0-9.]+),([-0-9.]+)\\)\"[^>]*font-size=\"([0-9.]+)\"[^>]*"
      "text-anchor=\"([a-z]+)\"[^>]*>\\s*<text[^>]*>(.*)</text>");
  constexpr double kAir = 2.0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), label), end; it != end; ++it) {
    const std::smatch& found = *it;
    const double x = std::stod(found[1]), y = std::stod(found[2]), size = std::stod(found[3]);
    const double width = text_width(seen_text(found[5]), size);
    const double before = found[4] == "end" ? width : found[4] == "middle" ? width / 2.0 : 0.0;
    sheet.left = std::min(sheet.left, x - before - kAir);
    sheet.right = std::max(sheet.right, x - before + width + kAir);
    sheet.top = std::min(sheet.top, y - size - kAir);
    sheet.bottom = std::max(sheet.bottom, y + 0.3 * size + kAir);
  }
  return sheet;
}

}  // namespace sinew::diagnosis
