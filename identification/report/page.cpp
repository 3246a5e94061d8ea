// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/report/numbers.h"
#include "symbolic/files/readable.h"

namespace sinew::diagnosis {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : readable(text)) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string escaped_name(const std::string& name) {
  std::string result;
  for (const char c : escaped(name))
    result += c == '_' || c == '/' ? std::string(1, c) + "<wbr>" : std::string(1, c);
  return result;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

Table::Table(std::vector<std::string> headings, std::string caption, bool narrow)
    : headings_(std::move(headings)), caption_(std::move(caption)), narrow_(narrow) {}

void Table::row(const std::vector<std::string>& cells) {
  rows_ += "<tr>";
  for (std::size_t i = 0; i < cells.size() && i < headings_.size(); ++i) {
    const bool number = headings_[i][0] == '#';
    const std::string label = escaped(headings_[i].substr(number ? 1 : 0));
    rows_ += fmt::format("<{0}{1} data-label=\"{2}\"><div>{3}</div></{0}>",
                         i == 0 ? "th scope=\"row\"" : "td", number ? " class=\"number\"" : "",
                         label, cells[i]);
  }
  rows_ += "</tr>\n";
}

std::string Table::html() const {
  std::string head;
  for (const std::string& heading : headings_) {
    const bool number = heading[0] == '#';
    head += fmt::format("<th scope=\"col\"{}>{}</th>", number ? " class=\"number\"" : "",
                        escaped(heading.substr(number ? 1 : 0)));
  }
  const std::string caption =
      caption_.empty() ? "" : "<caption>" + escaped(caption_) + "</caption>";
  return std::string(narrow_ ? "<table class=\"narrow\">" : "<table>") + caption + "<thead><tr>" +
         head + "</tr></thead>\n<tbody>" + rows_ + "</tbody></table>\n";
}

namespace {
double percent(double share) {
  return std::isfinite(share) ? 100.0 * std::clamp(share, 0.0, 1.0) : 0.0;
}
}  // namespace

std::string bar(double share, const std::string& role) {
  return fmt::format(
      "<span class=\"bar\" aria-hidden=\"true\"><span style=\"width:{:.1f}%;"
      "background:var(--{})\"></span></span>",
      percent(share), role);
}

std::string interval_bar(const Gain& gain) {
  const double low = percent(gain.low), high = percent(gain.high);
  return fmt::format(
      "<span class=\"bar interval\" aria-hidden=\"true\">"
      "<span class=\"band\" style=\"left:{:.1f}%;width:{:.1f}%\"></span>"
      "<span class=\"mark\" style=\"left:{:.1f}%\"></span></span>",
      low, std::max(0.5, high - low), percent(gain.share));
}

std::string section(const std::string& id, const std::string& heading, const std::string& content) {
  if (content.empty()) return "";
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n"
      "<h2 id=\"{0}-title\">{1}</h2>\n{2}</section>\n",
      id, escaped(heading), content);
}

std::string folded(const std::string& summary, const std::string& content, bool open) {
  return fmt::format("<details{}><summary>{}</summary>\n<div class=\"inside\">{}</div></details>\n",
                     open ? " open" : "", escaped(summary), content);
}

}  // namespace sinew::diagnosis
