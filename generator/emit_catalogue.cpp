// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emit_catalogue.h"

#include <fmt/format.h>

#include "generator/emit_c.h"
#include "generator/literal.h"
#include "generator/wrap_lines.h"

namespace sinew {
namespace {

int total_size(const std::vector<Port>& ports) {
  int total = 0;
  for (const Port& port : ports) total += port.size();
  return total;
}

/// From one array to the arguments as the function takes them, and back.
std::string wrapper(const EmittedModel& model, const Graph& graph) {
  std::string arguments, statuses, results;
  const auto add = [&](const std::string& argument) {
    arguments += (arguments.empty() ? "" : ", ") + argument;
  };
  const char* type = model.target.type();
  int offset = 0;
  for (const Port& port : graph.inputs) {
    add(port.by_value ? fmt::format("x[{}]", offset) : fmt::format("x + {}", offset));
    offset += port.size();
  }
  offset = 0;
  for (const Port& port : graph.outputs) {
    if (port.states.empty()) {
      add(fmt::format("y + {}", offset));
    } else {
      statuses += fmt::format("    int {};\n", port.name);
      results += fmt::format("    y[{}] = ({}){};\n", offset, type, port.name);
      add("&" + port.name);
    }
    offset += port.size();
  }
  const std::string input = graph.inputs.empty()
                                ? "    (void)in;\n"
                                : fmt::format("    const {0} *x = (const {0} *)in;\n", type);
  return fmt::format(
      "static void call_{1}(const void *in, void *out)\n{{\n{4}    {0} *y = ({0} *)out;\n{5}    "
      "{2}_{1}({3});\n{6}}}\n",
      type, graph.name, model.name, arguments, input, statuses, results);
}

std::string bounds(const std::string& name, const Port& port, double Range::*end) {
  std::string values;
  for (const Range& range : port.ranges)
    values += fmt::format("{}{}", values.empty() ? "" : ", ", literal(range.*end, Target{}));
  return fmt::format("static const double {}[] = {{{}}};\n", name, values);
}

std::string ports(const Graph& graph, const std::vector<Port>& list, const char* direction) {
  if (list.empty()) return "";
  std::string text, rows;
  for (const Port& port : list) {
    const std::string stem = fmt::format("{}_{}", graph.name, port.name);
    std::string low = "0", high = "0";
    if (static_cast<int>(port.ranges.size()) == port.size()) {
      low = stem + "_low";
      high = stem + "_high";
      text += bounds(low, port, &Range::low) + bounds(high, port, &Range::high);
    }
    rows += fmt::format("    {{\"{}\", \"{}\", {}, {}, {}, {}}},\n", port.name, port.unit,
                        port.rows, port.cols, low, high);
  }
  return text + fmt::format("static const sinew_argument {}_{}[] = {{\n{}}};\n", graph.name,
                            direction, rows);
}

}  // namespace

std::string emit_catalogue_header(const EmittedModel& model) {
  std::string text = file_comment(
      model,
      fmt::format("Every function of the model {} behind one calling convention.", model.name));
  text += fmt::format(
      "#ifndef SINEW_{0}_CATALOGUE_H\n#define SINEW_{0}_CATALOGUE_H\n\n#include "
      "\"sinew_catalogue.h\"\n\n"
      "#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\nextern const sinew_catalogue "
      "{0}_catalogue;\n\n"
      "#ifdef __cplusplus\n}}\n#endif\n#endif\n",
      model.name);
  return wrap_lines(text);
}

std::string emit_catalogue(const EmittedModel& model) {
  std::string text = file_comment(
      model,
      fmt::format("Every function of the model {} behind one calling convention.", model.name));
  text += fmt::format("#include \"{0}_catalogue.h\"\n\n#include \"{0}.h\"\n", model.name);
  std::string rows;
  for (const Graph& graph : model.functions) {
    text += "\n" + wrapper(model, graph) + ports(graph, graph.inputs, "inputs") +
            ports(graph, graph.outputs, "outputs");
    rows +=
        fmt::format("    {{\"{}_{}\", {}, {}, {}, {}, {}, {}, call_{}}},\n", model.name, graph.name,
                    graph.inputs.size(), graph.outputs.size(), total_size(graph.inputs),
                    total_size(graph.outputs), graph.inputs.empty() ? "0" : graph.name + "_inputs",
                    graph.outputs.empty() ? "0" : graph.name + "_outputs", graph.name);
  }
  text += fmt::format("\nstatic const sinew_function functions[] = {{\n{}}};\n", rows);
  text += fmt::format(
      "\nconst sinew_catalogue {0}_catalogue = {{\"{0}\", \"{1}\", {2}, {3}, functions}};\n",
      model.name, model.hash, model.target.bytes(), model.functions.size());
  return wrap_lines(text);
}

}  // namespace sinew
