// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figures/figure.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <array>
#include <cstdio>
#include <stdexcept>

#include "generator/outputs/descriptor.h"

namespace sinew {
namespace {

/// In gnuplot's single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

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

std::string plot_of(const Panel& panel) {
  std::string text = fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n",
                                 quoted(panel.title), quoted(panel.x_label), quoted(panel.y_label));
  std::string data;
  text += "plot ";
  for (std::size_t k = 0; k < panel.series.size(); ++k) {
    const Series& series = panel.series[k];
    text += fmt::format("{}'-' with {} {}", k ? ", " : "", series.style,
                        series.title.empty() ? "notitle" : "title " + quoted(series.title));
    for (std::size_t i = 0; i < series.x.size(); ++i)
      data += fmt::format("{} {}\n", series.x[i], series.y[i]);
    data += "e\n";
  }
  return text + "\n" + data;
}

std::string script_of(const Figure& figure) {
  std::string text = fmt::format(
      "set terminal svg size {},420 noenhanced background 'white'\nset grid\n"
      "set key below\n"
      "set multiplot layout 1,{} title {}\n",
      figure.panels.size() > 1 ? 900 : 640, figure.panels.size(),
      quoted(fmt::format("{} (source: Fig. {})", figure.title, figure.number)));
  for (const Panel& panel : figure.panels) text += plot_of(panel);
  return text + "unset multiplot\n";
}

/// What gnuplot draws, taken from its standard output: writing a file it does not notice where that
/// ends for want of space. The script is a file in memory, which no disk can be too full for.
std::string drawn(const Figure& figure) {
  const std::string script = script_of(figure);
  const Descriptor memory(::memfd_create("gnuplot", 0));
  if (!memory.is_open()) fail_with_errno("the script of a figure", "cannot be kept");
  write_all(memory, script, "the script of a figure");
  std::FILE* gnuplot = ::popen(fmt::format("gnuplot /dev/fd/{}", memory.number()).c_str(), "r");
  if (!gnuplot) throw std::runtime_error("gnuplot cannot be started");
  std::string svg;
  std::array<char, 65536> block;
  for (std::size_t got; (got = std::fread(block.data(), 1, block.size(), gnuplot)) > 0;)
    svg.append(block.data(), got);
  if (::pclose(gnuplot) != 0 || svg.find("</svg>") == std::string::npos)
    throw std::runtime_error(figure.file + ".svg: gnuplot failed; expected Debian's gnuplot-nox");
  return svg;
}

}  // namespace

FileSet figure_files(const Figure& figure) {
  return {{figure.file + ".csv", csv_of(figure)}, {figure.file + ".svg", drawn(figure)}};
}

std::string index_page(const std::vector<Figure>& figures) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<title>Figures</title></head><body>\n<h1>Figures of the source, reproduced</h1>\n";
  for (const Figure& figure : figures)
    text += fmt::format(
        "<h2>Fig. {}: {}</h2>\n<p><img src=\"{}.svg\" alt=\"{}\"></p>\n<p>{} "
        "<a href=\"{}.csv\">CSV</a></p>\n",
        figure.number, escaped(figure.title), figure.file, escaped(figure.title),
        escaped(figure.differs), figure.file);
  return text + "</body></html>\n";
}

}  // namespace sinew
