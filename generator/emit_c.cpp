// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emit_c.h"

#include <fmt/format.h>

#include "generator/cost.h"
#include "generator/statements.h"

namespace sinew {
namespace {

/// Text from a model file, for inside a comment: it may neither end the comment nor open another,
/// and stays on one line.
std::string comment_text(const std::string& text) {
  std::string safe;
  for (char c : text) {
    const bool closes =
        !safe.empty() && ((safe.back() == '*' && c == '/') || (safe.back() == '/' && c == '*'));
    if (closes) safe += ' ';
    safe += static_cast<unsigned char>(c) < ' ' || c == '\\' ? ' ' : c;
  }
  return safe;
}

}  // namespace

std::string file_comment(const EmittedModel& model, const std::string& what) {
  return fmt::format(
      "/* SPDX-License-Identifier: BSD-2-Clause\n"
      " *\n"
      " * {}\n"
      " *\n"
      " * Made by: sinew generate models/{}\n"
      " * Model:   sha256 {}\n"
      " * Do not edit: change the model and generate again.\n"
      " */\n",
      comment_text(what), model.name, model.hash);
}

std::string signature(const EmittedModel& model, const Graph& graph) {
  std::string arguments;
  for (const Port& port : graph.inputs)
    arguments += fmt::format("{}const {} {}[SINEW_AT_LEAST({})]", arguments.empty() ? "" : ", ",
                             model.target.type(), port.name, port.size());
  for (const Port& port : graph.outputs)
    arguments += fmt::format("{}{} {}[SINEW_AT_LEAST({})]", arguments.empty() ? "" : ", ",
                             model.target.type(), port.name, port.size());
  return fmt::format("void {}_{}({})", model.name, graph.name, arguments);
}

std::string emit_function(const EmittedModel& model, const Graph& graph) {
  const ArrayNames names = array_names(graph);
  std::string text = signature(model, graph) + "\n{\n";
  for (const Port& port : graph.inputs)
    if (!reads_port(graph, port.name)) text += fmt::format("    (void){};\n", port.name);
  for (const std::string& line : statements(graph, model.target, names))
    text += "    " + line + "\n";
  return text + "}\n";
}

std::string emit_c(const EmittedModel& model) {
  std::string text = file_comment(model, model.description);
  text += fmt::format("#include \"{}.h\"\n\n#include \"sinew_math.h\"\n", model.name);
  for (const Graph& graph : model.functions) text += "\n" + emit_function(model, graph);
  return text;
}

}  // namespace sinew
