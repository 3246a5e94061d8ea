// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace sinew::diagnosis {
namespace {

const std::string kUnknown = "–";
const std::string kSpace = "\u00a0";  // does not break

std::string with_minus(std::string text) {
  return !text.empty() && text[0] == '-' ? "−" + text.substr(1) : text;
}

std::string superscript(int exponent) {
  static const std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴",
                                                     "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(exponent))
    text += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
  return text;
}

/// Exponent of the value once it is rounded to `digits` significant digits.
int exponent_of(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  return std::stoi(text.substr(text.find('e') + 1));
}

struct Prefix {
  int exponent;
  const char* sign;
};
constexpr std::array<Prefix, 4> kSmaller = {{{0, ""}, {-3, "m"}, {-6, "µ"}, {-9, "n"}}};
constexpr std::array<Prefix, 3> kLarger = {{{0, ""}, {3, "k"}, {6, "M"}}};

/// The unit that a prefix would stand before.
std::string_view leading_unit(std::string_view unit) {
  return unit.substr(0, unit.find_first_of("*/^ "));
}

bool takes_prefix(std::string_view unit) {
  static constexpr std::array<std::string_view, 10> units = {"s", "m", "N",  "A",  "V",
                                                             "W", "J", "Pa", "Hz", "rad"};
  const std::string_view head = leading_unit(unit);
  const bool power = head.size() < unit.size() && unit[head.size()] == '^';
  return !power && std::find(units.begin(), units.end(), head) != units.end();
}

Prefix prefix_for(double scale, const std::string& unit) {
  const double size = std::abs(scale);
  if (!(size > 0.0) || !std::isfinite(size) || !takes_prefix(unit)) return kSmaller[0];
  if (size < 1e4)
    for (const Prefix& p : kSmaller)
      if (size * std::pow(10.0, -p.exponent) >= 0.0995) return p;
  // Kilometres and kiloseconds help nobody, and compound units do not grow prefixes.
  const bool grows = unit.size() <= 2 && unit != "m" && unit != "s";
  if (size >= 1e4 && grows) return size < 1e7 ? kLarger[1] : kLarger[2];
  return size < 1e4 ? kSmaller[3] : kSmaller[0];
}

std::string with_unit(const std::string& number, const char* prefix, const std::string& unit) {
  const std::string shown = shown_unit(unit);
  return shown.empty() ? number : number + kSpace + prefix + shown;
}

}  // namespace

std::string shown_number(double value, int digits) {
  if (std::isnan(value)) return kUnknown;
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  if (value == 0.0) return "0";
  const int exponent = exponent_of(value, digits);
  if (exponent >= -4 && exponent < 6)
    return with_minus(fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent)));
  const std::string mantissa = fmt::format("{:.{}e}", value, digits - 1);
  return with_minus(mantissa.substr(0, mantissa.find('e'))) + "×10" + superscript(exponent);
}

std::string shown_unit(const std::string& unit) {
  if (unit == "1") return "";
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit[i] == '*' || unit[i] == ' ') {
      text += "·";
    } else if (unit[i] == '^') {
      std::size_t end = i + 1;
      while (end < unit.size() && (unit[end] == '-' || (unit[end] >= '0' && unit[end] <= '9')))
        ++end;
      const std::string power = unit.substr(i + 1, end - i - 1);
      const bool number = power.find_first_of("0123456789") != std::string::npos;
      text += number ? superscript(std::stoi(power)) : "^" + power;
      i = end - 1;
    } else {
      text += unit[i];
    }
  }
  return text;
}

std::string shown_quantity(double value, const std::string& unit, int digits) {
  const Prefix prefix = prefix_for(value, unit);
  return with_unit(shown_number(value * std::pow(10.0, -prefix.exponent), digits), prefix.sign,
                   unit);
}

AxisUnit axis_unit(double largest, const std::string& unit) {
  const Prefix prefix = prefix_for(largest, unit);
  const double size = std::abs(largest) * std::pow(10.0, -prefix.exponent);
  const std::string shown = shown_unit(unit);
  if (prefix.exponent != 0) return {std::pow(10.0, -prefix.exponent), prefix.sign + shown};
  if (!std::isfinite(size) || size == 0.0 || (size >= 0.01 && size < 1e5)) return {1.0, shown};
  const int power = exponent_of(size, 3);
  return {std::pow(10.0, -power), "10" + superscript(power) + (shown.empty() ? "" : " " + shown)};
}

std::string shown_estimate(double value, double standard_error, const std::string& unit) {
  if (!(standard_error > 0.0) || !std::isfinite(standard_error) || !std::isfinite(value))
    return shown_quantity(value, unit, 4);
  const double scale = std::max(std::abs(value), standard_error);
  const Prefix prefix = prefix_for(scale, unit);
  int power = prefix.exponent;
  const int left = exponent_of(scale * std::pow(10.0, -power), 3);
  if (left < -3 || left > 5) power += left;
  const double shown = value * std::pow(10.0, -power);
  const double error = standard_error * std::pow(10.0, -power);
  const int decimals = std::clamp(1 - exponent_of(error, 2), 0, 9);
  std::string text = with_minus(fmt::format("{:.{}f}", shown, decimals)) + kSpace + "±" + kSpace +
                     fmt::format("{:.{}f}", error, decimals);
  if (power != prefix.exponent) text = "(" + text + ")×10" + superscript(power);
  return with_unit(text, prefix.sign, unit);
}

std::string shown_share(double share) {
  if (!std::isfinite(share)) return kUnknown;
  const double percent = 100.0 * share, size = std::abs(percent);
  if (percent == 0.0) return "0" + kSpace + "%";
  if (size < 0.005) return "0.00" + kSpace + "%";
  const int decimals = size < 0.995 ? 2 : size < 9.95 || (size > 99.0 && size < 100.0) ? 1 : 0;
  return with_minus(fmt::format("{:.{}f}", percent, decimals)) + kSpace + "%";
}

std::string shown_percent(double share) {
  return std::isfinite(share) ? shown_number(100.0 * share, 3) + kSpace + "%" : kUnknown;
}

std::string shown_interval(const Gain& gain) {
  if (!std::isfinite(gain.low) || !std::isfinite(gain.high)) return kUnknown;
  std::string low = shown_share(gain.low);
  low.resize(low.size() - kSpace.size() - 1);  // one percent sign is enough
  return low + kSpace + "to" + kSpace + shown_share(gain.high);
}

std::string shown_confidence(double confidence) {
  if (!std::isfinite(confidence)) return kUnknown;
  if (confidence > 0.99) return ">" + kSpace + "99" + kSpace + "%";
  return fmt::format("{:.0f}", std::floor(100.0 * std::max(0.0, confidence) + 1e-9)) + kSpace + "%";
}

std::string shown_duration(double seconds) {
  if (!std::isfinite(seconds)) return kUnknown;
  if (seconds >= 600.0) return shown_number(seconds / 60.0, 2) + kSpace + "min";
  return shown_quantity(seconds, "s", seconds < 10.0 ? 2 : 3);
}

}  // namespace sinew::diagnosis
