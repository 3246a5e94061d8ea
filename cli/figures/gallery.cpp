// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "cli/figures/figure.h"
#include "identification/report/page.h"

namespace sinew {
namespace {

using diagnosis::escaped;

constexpr const char* gallery_style =
    ".sheet { background: #ffffff; border: 1px solid var(--rule); border-radius: 10px; padding: "
    "0.8rem; }\n.sheet svg { display: block; width: 100%; height: auto; max-width: 60rem; margin: "
    "0 auto; }\n";

std::string numbers_of(const Figure& figure) {
  if (figure.numbers.empty()) return "";
  diagnosis::Table table({"", "The source", "Here"});
  for (const ComparedNumber& each : figure.numbers)
    table.row({escaped(each.what), escaped(each.source), escaped(each.here)});
  return table.html();
}

std::string part_of(const Figure& figure) {
  return diagnosis::section(
      figure.file, fmt::format("Fig. {}: {}", figure.number, figure.title),
      "<div class=\"sheet\">" + svg_of(figure) + "</div>\n" + numbers_of(figure) + "<p>" +
          escaped(figure.differs) + "</p>\n" +
          fmt::format("<p class=\"small\"><a href=\"{0}.svg\">{0}.svg</a>, <a "
                      "href=\"{0}.csv\">{0}.csv</a></p>\n",
                      figure.file));
}

}  // namespace

std::string gallery_page(const std::vector<Figure>& figures) {
  std::string items, parts;
  for (const Figure& figure : figures) {
    items += fmt::format("<li><a href=\"#{}\">Fig. {}</a></li>\n", figure.file, figure.number);
    parts += part_of(figure);
  }
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'\">\n<title>The source's figures, computed again</title>\n<style>" +
         diagnosis::page_style() + gallery_style + "</style>\n</head>\n<body>\n<main>\n" +
         fmt::format(
             "<p class=\"kicker\">{} figures by the emitted C</p>\n"
             "<h1>The source’s figures, computed again: its numbers beside ours</h1>\n"
             "<p>Figure and equation numbers are the source’s. Under each figure stand the "
             "numbers that the source prints beside those found here, and what differs.</p>"
             "\n<nav aria-label=\"Figures\"><ul class=\"toc\">\n{}</ul></nav>\n",
             figures.size(), items) +
         parts + "<footer><p>Written by sinew figures.</p></footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace sinew
