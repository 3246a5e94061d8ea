// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figures/figure.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace sinew {
namespace {

namespace fs = std::filesystem;

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

std::string script_of(const fs::path& svg, const Figure& figure) {
  std::string text = fmt::format(
      "set terminal svg size {},420 noenhanced background 'white'\nset output {}\nset grid\n"
      "set key below\n"
      "set multiplot layout 1,{} title {}\n",
      figure.panels.size() > 1 ? 900 : 640, quoted(svg.string()), figure.panels.size(),
      quoted(fmt::format("{} (source: Fig. {})", figure.title, figure.number)));
  for (const Panel& panel : figure.panels) text += plot_of(panel);
  return text + "unset multiplot\n";
}

}  // namespace

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

void write_figure(const fs::path& folder, const Figure& figure) {
  write_text(folder / (figure.file + ".csv"), csv_of(figure));
  const fs::path svg = folder / (figure.file + ".svg");
  const std::string script = script_of(svg, figure);
  std::FILE* gnuplot = ::popen("gnuplot", "w");
  if (!gnuplot) throw std::runtime_error("gnuplot cannot be started");
  const bool whole = std::fwrite(script.data(), 1, script.size(), gnuplot) == script.size();
  if (::pclose(gnuplot) != 0 || !whole || !fs::exists(svg))
    throw std::runtime_error(svg.string() + ": gnuplot failed; expected Debian's gnuplot-nox");
}

void write_index(const fs::path& folder, const std::vector<Figure>& figures) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<title>Figures</title></head><body>\n<h1>Figures of the source, reproduced</h1>\n";
  for (const Figure& figure : figures)
    text += fmt::format(
        "<h2>Fig. {}: {}</h2>\n<p><img src=\"{}.svg\" alt=\"{}\"></p>\n<p>{} "
        "<a href=\"{}.csv\">CSV</a></p>\n",
        figure.number, escaped(figure.title), figure.file, escaped(figure.title),
        escaped(figure.differs), figure.file);
  write_text(folder / "index.html", text + "</body></html>\n");
}

}  // namespace sinew
