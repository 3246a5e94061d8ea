// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figures/draw_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sinew {
namespace {

constexpr double font = 8.0, line_width = 1.0, label_left = 44.0, label_below = 30.0;  // pt
/// Told apart by people who cannot tell red from green, and on grey paper by their dashes.
constexpr std::array palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                             "#000000", "#e69f00", "#56b4e9"};
constexpr std::array dashes{"", "5 2.5", "1.5 2", "6 2 1.5 2"};
/// A double's last place at the sizes of hands: below, curves are rounding.
constexpr double rounding_size = 1e-13;

double letters(const std::string& text) {
  return static_cast<double>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

double text_width(const std::string& text) {
  return 0.55 * font * letters(text);
}

struct Ends {
  double low = 1e300, high = -1e300;
  void take(const std::vector<double>& values) {
    for (const double value : values)
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
  void open(double share) {
    if (high < low) low = 0.0, high = 1.0;
    if (high == low) low -= 1.0, high += 1.0;
    const double air = share * (high - low);
    low -= air, high += air;
  }
};

struct Pen {
  std::string colour, dash;
};

Pen pen_of(const Panel& panel, std::size_t k) {
  const Series& series = panel.series[k];
  std::size_t number = 0;
  for (std::size_t i = 0; i < k; ++i) number += !panel.series[i].title.empty();
  // Curves without a name are of one kind.
  if (series.title.empty() && series.colour < 0) return {palette[0], ""};
  if (series.colour >= 0) number = static_cast<std::size_t>(series.colour);
  return {palette[number % palette.size()], series.look == Look::dashed
                                                ? dashes[1]
                                                : dashes[number / palette.size() % dashes.size()]};
}

std::string text_at(double x, double y, const std::string& text, const char* anchor,
                    const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, xml_text(text));
}

class PanelWriter {
 public:
  PanelWriter(const Panel& panel, const PanelBox& box, double key)
      : panel_(panel),
        box_(box),
        left_(box.left + label_left),
        right_(box.left + box.width - 6.0),
        top_(box.top + 16.0 + key),
        bottom_(box.top + box.height - label_below) {
    for (const Series& series : panel.series) {
      x_.take(series.x);
      y_.take(series.y);
    }
    noise_ = std::max(std::abs(y_.low), std::abs(y_.high)) < rounding_size && y_.high > y_.low;
    x_.open(0.0);
    y_.open(0.05);
    if (noise_ || !panel.note.empty()) y_.high += 0.12 * (y_.high - y_.low);  // room for the note
  }

  std::string run() {
    text_ += text_at(left_, box_.top + 9.0, panel_.title, "start", " font-weight=\"bold\"");
    key();
    axes();
    for (std::size_t k = 0; k < panel_.series.size(); ++k) curve(k);
    if (noise_ || !panel_.note.empty())
      text_ += text_at(right_ - 3.0, top_ + font + 2.0,
                       panel_.note.empty() ? "rounding noise" : panel_.note, "end",
                       " font-style=\"italic\" stroke=\"#ffffff\" stroke-width=\"3\" "
                       "paint-order=\"stroke\"");
    return std::move(text_);
  }

 private:
  double at_x(double x) const {
    return left_ + (x - x_.low) / (x_.high - x_.low) * (right_ - left_);
  }
  double at_y(double y) const {
    return bottom_ - (y - y_.low) / (y_.high - y_.low) * (bottom_ - top_);
  }

  void axes() {
    const double step_y = tick_step(y_.low, y_.high, 6), step_x = tick_step(x_.low, x_.high, 6);
    for (double k = std::ceil(y_.low / step_y); k * step_y <= y_.high; ++k) {
      const double y = at_y(k * step_y);
      text_ +=
          fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#{}\" stroke-width=\"0.5\"/>\n",
                      left_, y, right_, k == 0.0 ? "888888" : "dddddd");
      text_ += text_at(left_ - 4.0, y + 0.35 * font, tick_text(k * step_y, step_y), "end");
    }
    for (double k = std::ceil(x_.low / step_x - 1e-9); k * step_x <= x_.high + 1e-9 * step_x; ++k) {
      const double x = at_x(k * step_x);
      text_ += fmt::format(
          "<path d=\"M{:.1f} {:.1f}v3\" stroke=\"#000000\" stroke-width=\"0.6\"/>\n", x, bottom_);
      text_ += text_at(x, bottom_ + 4.0 + font, tick_text(k * step_x, step_x), "middle");
    }
    text_ += fmt::format(
        "<path d=\"M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}\" stroke=\"#000000\" stroke-width=\"0.8\" "
        "fill=\"none\"/>\n",
        left_, top_, bottom_, right_);
    text_ +=
        text_at(0.5 * (left_ + right_), box_.top + box_.height - 5.0, panel_.x_label, "middle");
    text_ += fmt::format(
        "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" "
        "text-anchor=\"middle\">{}</text>\n",
        box_.left + font, 0.5 * (top_ + bottom_), xml_text(panel_.y_label));
  }

  void key() {
    double x = left_, y = box_.top + 20.0;
    for (std::size_t k = 0; k < panel_.series.size(); ++k) {
      const Series& series = panel_.series[k];
      if (series.title.empty()) continue;
      const double width = 22.0 + text_width(series.title) + 10.0;
      if (x > left_ && x + width > right_ + 6.0) x = left_, y += font + 4.0;
      const Pen pen = pen_of(panel_, k);
      if (is_line(series.look))
        text_ += stroke(fmt::format("M{:.1f} {:.1f}h16", x, y - 0.35 * font), pen, series.look);
      if (series.look != Look::line && series.look != Look::dashed && series.look != Look::thick)
        text_ += marks({{x + 8.0, y - 0.35 * font}}, pen, series.look);
      text_ += text_at(x + 20.0, y, series.title, "start");
      x += width;
    }
  }

  static bool is_line(Look look) {
    return look == Look::line || look == Look::dashed || look == Look::thick ||
           look == Look::line_and_dots;
  }

  static std::string stroke(const std::string& path, const Pen& pen, Look look) {
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
        "stroke-linejoin=\"round\"{}/>\n",
        path, pen.colour, look == Look::thick ? 1.8 * line_width : line_width,
        pen.dash.empty() ? "" : " stroke-dasharray=\"" + pen.dash + "\"");
  }

  static std::string marks(const std::vector<std::pair<double, double>>& points, const Pen& pen,
                           Look look) {
    std::string path;
    for (const auto& [x, y] : points)
      path += look == Look::crosses ? fmt::format("M{:.1f} {:.1f}l4 4m0 -4l-4 4", x - 2, y - 2)
              : look == Look::circles
                  ? fmt::format("M{:.1f} {:.1f}a2 2 0 1 0 4 0a2 2 0 1 0 -4 0", x - 2, y)
                  : fmt::format("M{:.1f} {:.1f}h0", x, y);
    const bool dots = look == Look::dots || look == Look::line_and_dots;
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
        "stroke-linecap=\"round\"/>\n",
        path, pen.colour,
        look == Look::dots ? "1.3"
        : dots             ? "2.2"
                           : "0.8");
  }

  void curve(std::size_t k) {
    const Series& series = panel_.series[k];
    const Pen pen = pen_of(panel_, k);
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < series.x.size(); ++i)
      if (std::isfinite(series.y[i])) points.emplace_back(at_x(series.x[i]), at_y(series.y[i]));
    if (is_line(series.look)) text_ += stroke(path_of(points), pen, series.look);
    if (series.look != Look::line && series.look != Look::dashed && series.look != Look::thick)
      text_ += marks(points, pen, series.look);
  }

  /// Of points in the same fifth of a point's width the first, the ends and the last: what can be
  /// seen stays.
  static std::string path_of(const std::vector<std::pair<double, double>>& points) {
    std::string path;
    const auto put = [&](std::size_t i) {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", points[i].first,
                          points[i].second);
    };
    for (std::size_t i = 0; i < points.size();) {
      std::size_t end = i, low = i, high = i;
      while (end < points.size() && std::abs(points[end].first - points[i].first) < 0.2) {
        if (points[end].second < points[low].second) low = end;
        if (points[end].second > points[high].second) high = end;
        ++end;
      }
      std::array<std::size_t, 4> kept{i, std::min(low, high), std::max(low, high), end - 1};
      for (std::size_t n = 0; n < kept.size(); ++n)
        if (n == 0 || kept[n] != kept[n - 1]) put(kept[n]);
      i = end;
    }
    return path;
  }

  const Panel& panel_;
  const PanelBox& box_;
  double left_, right_, top_, bottom_;
  Ends x_, y_;
  bool noise_ = false;
  std::string text_;
};

}  // namespace

std::string xml_text(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

double tick_step(double low, double high, int most) {
  const double raw = (high - low) / most, power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= 0.999 * raw) return factor * power;
  return 10.0 * power;
}

std::string tick_text(double value, double step) {
  if (std::abs(value) < 1e-9 * step) return "0";
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::string text, power;
  if (decimals > 4 || std::abs(value) >= 1e6) {
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    text = fmt::format("{:.3g}", value / std::pow(10.0, exponent));
    power = "·10";
    for (const char c : std::to_string(exponent)) {
      constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
      power += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
    }
  } else {
    text = fmt::format("{:.{}f}", value, decimals);
  }
  if (text.front() == '-') text.replace(0, 1, "−");
  return text + power;
}

double key_height(const Panel& panel, double width) {
  double x = 0.0;
  int rows = 0;
  for (const Series& series : panel.series) {
    if (series.title.empty()) continue;
    const double entry = 22.0 + text_width(series.title) + 10.0;
    if (rows == 0) rows = 1;
    if (x > 0.0 && x + entry > width - label_left) x = 0.0, ++rows;
    x += entry;
  }
  return rows * (font + 4.0);
}

std::string drawn_panel(const Panel& panel, const PanelBox& box, double key) {
  return PanelWriter(panel, box, key).run();
}

}  // namespace sinew
