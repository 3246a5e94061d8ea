// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "generator/outputs/scratch_folder.h"
#include "identification/report/svg.h"
#include "identification/report/thinning.h"

namespace sinew::diagnosis {
namespace {

namespace fs = std::filesystem;

/// Stands for a role in gnuplot's output; svg.h puts the page's colour in its place.
std::string colour_of(const std::string& role) {
  return fmt::format("#{:06x}", placeholder_colour(role));
}

/// In gnuplot's single quotes, on one line.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? "''" : c == '\n' || c == '\r' ? " " : std::string(1, c);
  return result + "'";
}

std::string data_of(const Series& series) {
  std::string text;
  for (std::size_t i = 0; i < series.x.size(); ++i)
    text += std::isfinite(series.y[i]) ? fmt::format("{:.7g} {:.7g}\n", series.x[i], series.y[i])
                                       : std::string("\n");
  return text;
}

std::string style_of(const Series& series, const std::string& role) {
  if (series.points) return "with dots lc rgb '" + colour_of(role) + "'";
  const char* dash = is_dashed(series.label) ? "(10,6)" : role == "noise" ? "(2,4)" : "1";
  const char* width = role == "measured" ? "2.2" : "1.4";
  return fmt::format("with lines lw {} dt {} lc rgb '{}'", width, dash, colour_of(role));
}

bool has_value(const Series& series) {
  return std::any_of(series.y.begin(), series.y.end(), [](double y) { return std::isfinite(y); });
}

/// Clouds first, so that lines lie on top.
std::vector<std::pair<Series, std::string>> drawable(const Plot& plot, std::size_t most) {
  std::vector<std::pair<Series, std::string>> result;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const Series thin = thinned(plot.series[k], plot.logarithmic, most);
    if (has_value(thin)) result.emplace_back(thin, series_role(thin.label, k));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.first.points && !b.first.points; });
  return result;
}

std::string axes_of(const Plot& plot) {
  const std::string logarithmic =
      "set logscale xy 10\nset format xy '@%T'\nset xtics 10\nset ytics 10\nset mxtics 1\nset "
      "mytics 1\n";
  return fmt::format(
      "reset\nset encoding utf8\nset minussign\nunset key\n"
      "set border 3 lc rgb '{0}' lw 0.8\nset tics nomirror out scale 0.5 textcolor rgb '{1}'\n"
      "set xtics offset 0,0.4\n"
      "set grid lc rgb '{2}' lt 1 lw 0.6\nset xzeroaxis lc rgb '{0}' lt 1 lw 0.8\n"
      "set lmargin at screen 0.125\nset rmargin at screen 0.955\n"
      "set tmargin at screen 0.885\nset bmargin at screen 0.165\n"
      "set xlabel {3} textcolor rgb '{1}' offset 0,0.9\n"
      "set label 1 {4} at screen 0.012,0.955 left front textcolor rgb '{1}'\n{5}",
      colour_of("axis"), colour_of("ink"), colour_of("grid"), quoted(plot.x_label),
      quoted(plot.y_label), plot.logarithmic ? logarithmic : "");
}

/// Samples a series may have so that the whole page stays below about 2 MB.
std::size_t samples_for(const std::vector<Plot>& plots) {
  std::size_t series = 1;
  for (const Plot& plot : plots) series += plot.series.size();
  return std::clamp<std::size_t>(60000 / series, 150, 700);
}

std::string script_of(const Plot& plot, const fs::path& output, std::size_t most) {
  const auto series = drawable(plot, most);
  if (series.empty()) return "";
  std::string blocks, commands;
  for (std::size_t k = 0; k < series.size(); ++k) {
    blocks += fmt::format("$series{} << END\n{}END\n", k, data_of(series[k].first));
    commands += fmt::format("{}$series{} using 1:2 {} notitle", k ? ", " : "plot ", k,
                            style_of(series[k].first, series[k].second));
  }
  return blocks + "set terminal svg size 460,300 noenhanced background 'white' font ',13'\n" +
         axes_of(plot) + "set output " + quoted(output.string()) + "\n" + commands +
         "\nunset output\n";
}

std::string whole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Throws std::runtime_error where it is cut short: gnuplot does not notice a full disk.
std::string whole_drawing(const fs::path& file) {
  std::string svg = whole(file);
  if (!svg.empty() && svg.find("</svg>") == std::string::npos)
    throw std::runtime_error(file.string() + ": cannot be written; expected room for a drawing");
  return svg;
}

/// For the shell.
std::string shell_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

/// Settings of the user and of the machine are left out: -d.
void run_gnuplot(const fs::path& script) {
  const std::string command = "gnuplot -d " + shell_quoted(script.string()) + " 2>/dev/null";
  if (std::FILE* process = ::popen(command.c_str(), "r")) ::pclose(process);
}

}  // namespace

bool is_dashed(const std::string& label) {
  const auto has = [&](const char* word) { return label.find(word) != std::string::npos; };
  return has("backward") || (has("model") && has("before"));
}

std::string series_role(const std::string& label, std::size_t position) {
  const auto has = [&](const char* word) { return label.find(word) != std::string::npos; };
  if (has("noise")) return "noise";
  if (has("before")) return "before";
  if (has("after")) return "after";
  if (has("measured")) return "measured";
  return fmt::format("extra-{}", position % 3 + 1);
}

std::vector<std::string> svg_figures(const std::vector<Plot>& plots,
                                     const std::vector<std::string>& alternatives) {
  std::vector<std::string> figures(plots.size());
  if (plots.empty()) return figures;
  const ScratchFolder scratch;
  const auto output = [&](std::size_t k) { return scratch.path() / fmt::format("{}.svg", k); };
  std::ofstream script(scratch.path() / "figures.gp", std::ios::binary);
  for (std::size_t k = 0; k < plots.size(); ++k)
    script << script_of(plots[k], output(k), samples_for(plots));
  script.close();
  if (!script) throw std::runtime_error(scratch.path().string() + ": cannot be written");
  run_gnuplot(scratch.path() / "figures.gp");
  for (std::size_t k = 0; k < plots.size(); ++k)
    figures[k] =
        svg_for_page(whole_drawing(output(k)), k < alternatives.size() ? alternatives[k] : "");
  return figures;
}

}  // namespace sinew::diagnosis
