// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <sstream>
#include <string_view>

#include "identification/report/page.h"
#include "identification/report/plot_bounds.h"

namespace sinew::diagnosis {
namespace {

constexpr std::array<const char*, 10> kRoles = {"ink",   "grid",  "axis",    "measured", "before",
                                                "after", "noise", "extra-1", "extra-2",  "extra-3"};

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// All ways in which gnuplot writes a colour: of lines, of text, of backgrounds.
void put_colours(std::string& text) {
  for (std::size_t k = 0; k < kRoles.size(); ++k) {
    const unsigned colour = placeholder_colour(kRoles[k]);
    const std::string page = fmt::format("var(--{})", kRoles[k]);
    replace_all(
        text, fmt::format("rgb({:3}, {:3}, {:3})", colour >> 16, colour >> 8 & 255U, colour & 255U),
        page);
    replace_all(text, fmt::format("rgb({},{},{})", colour >> 16, colour >> 8 & 255U, colour & 255U),
                page);
    replace_all(text, fmt::format("#{:06X}", colour), page);
  }
  replace_all(text, "'black'", "'currentColor'");
  replace_all(text, "\"black\"", "\"currentColor\"");
}

std::string attribute(const std::string& line, const std::string& name) {
  const std::size_t at = line.find(" " + name + "='");
  if (at == std::string::npos) return "";
  const std::size_t begin = at + name.size() + 3;
  return line.substr(begin, line.find('\'', begin) - begin);
}

/// A path's data with one decimal and without what goes without saying: a tenth of a unit is less
/// than a pixel.
std::string short_path(const std::string& data) {
  std::string result;
  std::size_t decimals = 0;
  bool fraction = false;
  for (const char c : data) {
    const bool digit = c >= '0' && c <= '9';
    if (c == '.') fraction = true, decimals = 0;
    if (!digit && c != '.') fraction = false;
    if (digit && fraction && ++decimals > 1) continue;
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == 'L';
    if (!blank)
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  return result;
}

/// Runs of gnuplot's dots (a line each) as one path of round dots.
std::string with_clouds(const std::string& text) {
  std::istringstream lines(text);
  std::string line, result, path, colour;
  const auto flush = [&] {
    if (!path.empty())
      result += fmt::format("<path class=\"cloud\" stroke=\"{}\" d=\"{}\"/>\n", colour, path);
    path.clear();
  };
  while (std::getline(lines, line)) {
    if (line.find("#gpDot") == std::string::npos) {
      if (line.find_first_not_of(" \t") == std::string::npos) continue;
      flush();
      result += line + "\n";
      continue;
    }
    const std::string now = attribute(line, "color");
    if (now != colour) flush();
    colour = now;
    path += short_path("M" + attribute(line, "x") + " " + attribute(line, "y") + "h0");
  }
  flush();
  return result;
}

std::string with_short_paths(const std::string& text) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = text.find(" d='"); at != std::string::npos; at = text.find(" d='", done)) {
    const std::size_t end = text.find('\'', at + 4);
    if (end == std::string::npos) break;
    result += text.substr(done, at + 4 - done) + short_path(text.substr(at + 4, end - at - 4));
    done = end;
  }
  return result + text.substr(done);
}

/// "@-3" of a logarithmic axis: small powers as numbers, others with a raised exponent.
std::string with_powers(const std::string& text) {
  static const std::regex power(">\\s*@(-|−)?0*([0-9]+)<");
  std::string result;
  auto rest = text.cbegin();
  for (std::sregex_iterator it(text.begin(), text.end(), power), end; it != end; ++it) {
    result.append(rest, (*it)[0].first);
    rest = (*it)[0].second;
    const bool negative = (*it)[1].matched;
    const int exponent = std::stoi((*it)[2]);
    if (exponent <= 3)
      result += ">" +
                (negative && exponent
                     ? "0." + std::string(static_cast<std::size_t>(exponent - 1), '0') + "1"
                     : "1" + std::string(static_cast<std::size_t>(exponent), '0')) +
                "<";
    else
      result += fmt::format(">10<tspan dy=\"-5\" font-size=\"10\">{}{}</tspan><",
                            negative ? "−" : "", exponent);
  }
  return result.append(rest, text.cend());
}

std::string without(const std::string& text, const char* pattern) {
  return std::regex_replace(text, std::regex(pattern), "");
}

}  // namespace

unsigned placeholder_colour(const std::string& role) {
  const auto* at = std::find(kRoles.begin(), kRoles.end(), role);
  return 0x010200U + static_cast<unsigned>(at - kRoles.begin());
}

std::string svg_for_page(const std::string& gnuplot_svg, const std::string& alternative) {
  const std::size_t definitions = gnuplot_svg.find("</defs>");
  const std::size_t last = gnuplot_svg.rfind("</svg>");
  if (definitions == std::string::npos || last == std::string::npos) return "";
  std::string body = gnuplot_svg.substr(definitions + 7, last - definitions - 7);
  put_colours(body);
  body = with_powers(with_clouds(with_short_paths(body)));
  // Every group states its defaults again, and each series has an id and a title.
  body = without(body, " id=\"[^\"]*\"");
  body = without(body, "<title>[^<]*</title>");
  body = without(body, " font-family=\"[^\"]*\"");
  body = without(body, "<g [^>]*>\\s*</g>\\s*");
  replace_all(body, " stroke-linecap=\"butt\" stroke-linejoin=\"miter\"", "");
  replace_all(body, " color=\"currentColor\"", "");
  // Said once, for the whole picture.
  replace_all(body, " fill=\"none\" stroke=\"currentColor\"", "");
  replace_all(body, " stroke-width=\"1.00\"", "");
  replace_all(body, "\t", "");
  // One group more than the body opens was opened before the definitions.
  const std::size_t canvas = body.rfind("</g>");
  if (canvas != std::string::npos) body.erase(canvas, 4);
  const PlotBounds view = with_labels(body, {0.0, 0.0, 460.0, 300.0});
  return fmt::format("<svg viewBox=\"{:.0f} {:.0f} {:.0f} {:.0f}\" role=\"img\"><title>",
                     std::floor(view.left), std::floor(view.top),
                     std::ceil(view.right) - std::floor(view.left),
                     std::ceil(view.bottom) - std::floor(view.top)) +
         escaped(alternative) + "</title><g fill=\"none\" stroke=\"currentColor\">" + body +
         "</g></svg>";
}

}  // namespace sinew::diagnosis
