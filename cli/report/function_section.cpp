// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cli/report/page_sections.h"
#include "cli/report/page_shell.h"
#include "generator/cost.h"
#include "generator/error_bound.h"
#include "generator/reference.h"
#include "identification/report/page.h"

namespace sinew {
namespace {

using diagnosis::escaped;

constexpr int states_of_errors = 4;

std::string error_text(double error) {
  if (error == 0.0) return "0";
  if (!std::isfinite(error)) return "none";
  const int exponent = static_cast<int>(std::floor(std::log10(error)));
  return fmt::format("{:.1f}·10<sup>{}{}</sup>", error / std::pow(10.0, exponent),
                     exponent < 0 ? "−" : "", std::abs(exponent));
}

std::string others_of(const Cost& cost) {
  std::string text;
  const auto add = [&](int count, const char* name) {
    if (count > 0) text += (text.empty() ? "" : ", ") + fmt::format("{} {}", count, name);
  };
  add(cost.divide, "÷");
  add(cost.square_root, "√");
  add(cost.sincos, cost.sincos == 1 ? "sin and cos pair" : "sin and cos pairs");
  add(cost.other, "other");
  add(cost.negate, cost.negate == 1 ? "sign" : "signs");
  return text.empty() ? "–" : text;
}

/// "361 / – / 402" in the order of the boards.
std::string on_boards(const ModelReport& report, const std::vector<std::string>& boards,
                      const std::string& function, std::optional<long> BoardCost::*which) {
  std::string text;
  for (const std::string& board : boards) {
    std::string count = "–";
    for (const BoardCost& cost : report.boards)
      if (cost.board == board && cost.function == function && cost.*which)
        count = std::to_string(*(cost.*which));
    text += (text.empty() ? "" : " / ") + count;
  }
  return text;
}

std::vector<std::string> boards_of(const ModelReport& report) {
  std::vector<std::string> boards;
  for (const BoardCost& cost : report.boards)
    if (std::find(boards.begin(), boards.end(), cost.board) == boards.end())
      boards.push_back(cost.board);
  return boards;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string table_of(const ModelReport& report, const std::vector<std::string>& boards) {
  std::vector<std::string> headings{"Function", "Gives", "#× and +", "Beside them"};
  if (!boards.empty()) {
    headings.push_back("#Instructions");
    headings.push_back("#Bytes");
  }
  headings.insert(headings.end(), {"#Error bound", "#Error seen"});
  diagnosis::Table table(headings);
  for (const Graph& graph : report.emitted.functions) {
    const std::string name = report.emitted.name + "_" + graph.name;
    const Cost cost = count_operations(graph);
    std::vector<std::vector<double>> states = spread_inputs(graph, states_of_errors);
    states.push_back(reference_inputs(graph));
    const RelativeErrors errors = relative_errors(graph, states);
    std::vector<std::string> cells{
        "<code>" + diagnosis::escaped_name(name) + "</code>",
        escaped(graph.doc + (graph.equation.empty() ? "" : " " + graph.equation)),
        std::to_string(cost.operations()), others_of(cost)};
    if (!boards.empty()) {
      cells.push_back(on_boards(report, boards, name, &BoardCost::instructions));
      cells.push_back(on_boards(report, boards, name, &BoardCost::bytes));
    }
    cells.push_back(error_text(errors.bound));
    cells.push_back(error_text(errors.observed));
    table.row(cells);
  }
  return "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Table of functions\">" +
         table.html() + "</div>\n";
}

}  // namespace

std::string function_section(const ModelReport& report, const std::vector<std::string>& left_out) {
  const std::vector<std::string> boards = boards_of(report);
  std::string text =
      "<p>What is emitted as C: multiplications and additions of one call, and what else it "
      "computes. Error: of the rounding of the whole call, relative to the largest entry of the "
      "result, over five states; the bound by running error analysis (to first order), what was "
      "seen "
      "by computing again with 50 digits.</p>\n";
  text += boards.empty()
              ? "<p class=\"small soft\">Instructions and bytes on the boards are not in a table "
                "here: <code>scripts/accept_budget " +
                    escaped(report.emitted.name) + "</code> counts them.</p>\n"
              : "<p>Instructions of one call, counted in emulation, and bytes of its code, on " +
                    escaped(joined(boards)) + " in this order; from <code>" +
                    diagnosis::escaped_name(report.boards_from) + "</code>.</p>\n";
  text += table_of(report, boards);
  if (!left_out.empty())
    text += "<p class=\"small soft\">Too long to be computed on this page: " +
            escaped(joined(left_out)) + ".</p>\n";
  text += diagnosis::folded("Try a function", "\x01");
  const std::string explorer =
      "<div class=\"choose\"><label for=\"try-function\">Function</label><select "
      "id=\"try-function\"></select></div>\n<div id=\"try-inputs\"></div>\n<h4>Results</h4>\n<div "
      "id=\"try-results\" aria-live=\"polite\"></div>\n";
  text.replace(text.find('\x01'), 1, explorer);
  text += "<p class=\"small soft\" id=\"agreement\"></p>\n";
  return diagnosis::section("functions", "Functions", text);
}

}  // namespace sinew
