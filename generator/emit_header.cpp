// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emit_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "generator/cost.h"
#include "generator/emit_c.h"
#include "generator/wrap_lines.h"

namespace sinew {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string shape(const Port& port) {
  return port.cols > 1 ? fmt::format("{}x{}", port.rows, port.cols) : fmt::format("{}", port.rows);
}

std::string range_text(const Port& port) {
  if (port.ranges.empty()) return "";
  const auto same = [&](const Range& r) {
    return r.low == port.ranges[0].low && r.high == port.ranges[0].high;
  };
  const std::size_t shown =
      std::all_of(port.ranges.begin(), port.ranges.end(), same) ? 1 : port.ranges.size();
  std::string text;
  for (std::size_t i = 0; i < shown && i < 8; ++i)
    text += fmt::format("{}{:.4g}..{:.4g}", i ? ", " : "", port.ranges[i].low, port.ranges[i].high);
  return fmt::format("; made for {}{}", text, shown > 8 ? ", ..." : "");
}

std::string operations_text(const Cost& c) {
  std::string text = fmt::format("{} multiplications, {} additions", c.multiply, c.add);
  if (c.divide) text += fmt::format(", {} divisions", c.divide);
  if (c.square_root) text += fmt::format(", {} square roots", c.square_root);
  if (c.sincos) text += fmt::format(", {} sincos", c.sincos);
  if (c.other) text += fmt::format(", {} other functions", c.other);
  return text;
}

/// What a function's statuses say, for the caller to compare with.
std::string state_names(const EmittedModel& model, const Graph& graph) {
  std::string text;
  for (const Port& port : graph.outputs) {
    std::string names;
    for (std::size_t i = 0; i < port.states.size(); ++i)
      names += fmt::format("{}{} = {}", i ? ", " : "",
                           upper(model.name + "_" + graph.name + "_" + port.states[i]), i);
    if (!names.empty()) text += "enum { " + names + " };\n";
  }
  return text;
}

std::string prototype(const EmittedModel& model, const Graph& graph) {
  std::string text =
      fmt::format("\n/* {}{}{}\n", graph.doc, graph.equation.empty() ? "" : " ", graph.equation);
  for (const Port& port : graph.inputs)
    text +=
        fmt::format(" *   in  {:<8} {:>6} {}{}{}\n", port.name, shape(port),
                    port.unit.empty() ? "" : "[" + port.unit + "] ", port.doc, range_text(port));
  for (const Port& port : graph.outputs)
    text += fmt::format(" *   out {:<8} {:>6} {}{}\n", port.name, shape(port),
                        port.unit.empty() ? "" : "[" + port.unit + "] ", port.doc);
  text += fmt::format(" * {}. */\n", operations_text(count_operations(graph)));
  return text + signature(model, graph) + ";\n" + state_names(model, graph);
}

}  // namespace

std::string emit_header(const EmittedModel& model) {
  const std::string guard = fmt::format("SINEW_{}_H", upper(model.name));
  std::string text = file_comment(model, model.description);
  text += fmt::format("#ifndef {0}\n#define {0}\n\n", guard);
  const bool numbered = std::any_of(model.functions.begin(), model.functions.end(),
                                    [](const Graph& graph) { return !graph.equation.empty(); });
  text += "/* SI units; matrices row-major. Results are finite for every finite input.";
  if (numbered) text += "\n * Numbers such as (5.2) are those of equations in the model's source.";
  text += " */\n";
  if (!model.notes.empty()) {
    text += "\n/*";
    for (const std::string& note : model.notes) text += " " + note + "\n *";
    text += "/\n";
  }
  text +=
      "\n#ifndef SINEW_AT_LEAST\n#ifdef __cplusplus\n#define SINEW_AT_LEAST(n) n\n#else\n"
      "#define SINEW_AT_LEAST(n) static n\n#endif\n#endif\n"
      "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n";
  for (const Graph& graph : model.functions) text += prototype(model, graph);
  text += "\n#ifdef __cplusplus\n}\n#endif\n#endif\n";
  return wrap_lines(text);
}

}  // namespace sinew
