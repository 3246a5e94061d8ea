// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emit_batch.h"

#include <fmt/format.h>

#include <algorithm>

#include "generator/cost.h"
#include "generator/emit_c.h"
#include "generator/statements.h"
#include "generator/wrap_lines.h"

namespace sinew {
namespace {

bool has_batch_form(const Graph& graph) {
  return count_operations(graph).operations() <= longest_batch_function;
}

bool is_status(const Port& port) {
  return !port.states.empty();
}

bool has_status(const EmittedModel& model) {
  return std::any_of(model.functions.begin(), model.functions.end(), [](const Graph& graph) {
    return has_batch_form(graph) &&
           std::any_of(graph.outputs.begin(), graph.outputs.end(), is_status);
  });
}

std::string batch_signature(const EmittedModel& model, const Graph& graph) {
  std::string text = fmt::format("void {}_{}_batch(int count", model.name, graph.name);
  for (const Port& port : graph.inputs)
    text += fmt::format(", const {} *SINEW_RESTRICT {}", model.target.type(), port.name);
  for (const Port& port : graph.outputs)
    text += fmt::format(", {} *SINEW_RESTRICT {}", is_status(port) ? "int" : model.target.type(),
                        port.name);
  return text + ")";
}

std::string batch_function(const EmittedModel& model, const Graph& graph) {
  ArrayNames names{[](const Port& port, int element) {
                     return element == 0 ? fmt::format("{}[state]", port.name)
                                         : fmt::format("{}[{} * n + state]", port.name, element);
                   },
                   false};
  names.int_statuses = true;
  std::string text = batch_signature(model, graph) + "\n{\n    const size_t n = (size_t)count;\n";
  for (const Port& port : graph.inputs)
    if (!reads_port(graph, port.name)) text += fmt::format("    (void){};\n", port.name);
  text += "    SINEW_STATES_ARE_INDEPENDENT\n    for (size_t state = 0; state < n; ++state) {\n";
  for (const std::string& line : statements(graph, straight_plan(graph), model.target, names))
    text += "        " + line + "\n";
  return text + "    }\n}\n";
}

std::string what(const EmittedModel& model) {
  return fmt::format(
      "For a host with vector instructions: the functions of the model {} over many states; "
      "element k of state i is at [k * count + i].",
      model.name);
}

}  // namespace

std::string emit_batch_header(const EmittedModel& model) {
  std::string text = file_comment(model, what(model));
  text += fmt::format(
      "#ifndef SINEW_{0}_BATCH_H\n#define SINEW_{0}_BATCH_H\n\n#ifndef SINEW_RESTRICT\n#ifdef "
      "__cplusplus\n"
      "#define SINEW_RESTRICT\n#else\n#define SINEW_RESTRICT restrict\n#endif\n#endif\n\n",
      model.name);
  if (has_status(model))
    text += fmt::format("#include \"../{}.h\" /* what the values of a status are called */\n\n",
                        model.name);
  text += "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n";
  for (const Graph& graph : model.functions)
    if (has_batch_form(graph)) text += batch_signature(model, graph) + ";\n";
  return wrap_lines(text + "\n#ifdef __cplusplus\n}\n#endif\n#endif\n");
}

std::string emit_batch(const EmittedModel& model) {
  std::string text = file_comment(model, what(model));
  text += fmt::format(
      "#include \"{0}_batch.h\"\n\n#include <stddef.h>\n\n{1}\n"
      "#if defined(__GNUC__) && !defined(__clang__)\n#define SINEW_STATES_ARE_INDEPENDENT "
      "_Pragma(\"GCC ivdep\")\n"
      "#else\n#define SINEW_STATES_ARE_INDEPENDENT\n#endif\n",
      model.name, runtime_includes(model.target));
  for (const Graph& graph : model.functions)
    if (has_batch_form(graph)) text += "\n" + batch_function(model, graph);
  return wrap_lines(text);
}

}  // namespace sinew
