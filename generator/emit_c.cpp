// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emit_c.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

#include "generator/calls/find_calls.h"
#include "generator/calls/find_parts.h"
#include "generator/calls/places.h"
#include "generator/cost.h"
#include "generator/loops/find_loops.h"
#include "generator/runtime_calls.h"
#include "generator/statements.h"
#include "generator/wrap_lines.h"

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

/// Options of the command that made the files, where they are not the usual ones.
std::string options_text(const Target& target) {
  return std::string(target.scalar == Scalar::binary32 ? " --scalar float" : "") +
         (target.fused ? " --fma" : "") +
         (target.optimise == Optimise::size ? " --optimise size" : "");
}

int count_of(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

/// The copies of long runtime functions that `functions` calls. One that is called once may become
/// part of its caller.
std::string shared_definitions(const EmittedModel& model, const std::string& functions) {
  std::string text;
  bool not_inline = functions.find("SINEW_NOT_INLINE") != std::string::npos;
  for (const SharedFunction& each : shared_functions(model.functions, model.target)) {
    const int calls = count_of(functions, each.name + "(");
    not_inline = not_inline || calls > 1;
    if (calls > 0 && !each.type.empty()) text += "\n" + each.type;
    if (calls > 0) text += (calls > 1 ? "\nSINEW_NOT_INLINE " : "\n") + each.definition;
  }
  const std::string macro =
      "\n#ifdef __GNUC__\n#define SINEW_NOT_INLINE __attribute__((noinline))\n#else\n"
      "#define SINEW_NOT_INLINE\n#endif\n";
  return (not_inline ? macro : "") + text;
}

}  // namespace

std::string file_comment(const EmittedModel& model, const std::string& what) {
  return fmt::format(
      "/* SPDX-License-Identifier: BSD-2-Clause\n"
      " *\n"
      " * {}\n"
      " *\n"
      " * Made by: sinew generate models/{}{}\n"
      " * Model:   sha256 {}\n"
      " * Do not edit: change the model and generate again.\n"
      " */\n",
      comment_text(what), model.name, options_text(model.target), model.hash);
}

std::string runtime_includes(const Target& target) {
  if (!target.fused) return "#include \"sinew_math.h\"\n";
  return fmt::format(
      "#include \"sinew_fused.h\"\n\n"
      "#ifndef SINEW_FUSED_{}\n"
      "#error \"made with --fma: the processor must have fused multiply-add in {} (x86-64: "
      "-mfma)\"\n"
      "#endif\n",
      target.scalar == Scalar::binary64 ? "DOUBLE" : "FLOAT", target.type());
}

std::string signature(const EmittedModel& model, const Graph& graph) {
  std::string arguments;
  const auto add = [&](const std::string& argument) {
    arguments += (arguments.empty() ? "" : ", ") + argument;
  };
  const char* type = model.target.type();
  for (const Port& port : graph.inputs)
    add(port.by_value
            ? fmt::format("{} {}", type, port.name)
            : fmt::format("const {} {}[SINEW_AT_LEAST({})]", type, port.name, port.size()));
  for (const Port& port : graph.outputs)
    add(port.states.empty() ? fmt::format("{} {}[SINEW_AT_LEAST({})]", type, port.name, port.size())
                            : fmt::format("int *{}", port.name));
  return fmt::format("void {}_{}({})", model.name, graph.name, arguments);
}

namespace {

bool passes_port(const CallingFunction& function, const std::string& name) {
  return std::any_of(function.calls.begin(), function.calls.end(), [&](const Call& call) {
    return std::find(call.arguments.begin(), call.arguments.end(), name) != call.arguments.end();
  });
}

/// The arrays that the calls fill, and the calls.
std::string calls_text(const EmittedModel& model, const CallingFunction& function) {
  std::string text;
  for (const Call& call : function.calls) {
    std::string arguments;
    for (const std::string& name : call.arguments)
      arguments += (arguments.empty() ? "" : ", ") + name;
    const auto is_passed_numbers = [&](const Port& port) {
      return port.name == call.results[0].name && !port.values.empty();
    };
    if (std::any_of(function.rest.inputs.begin(), function.rest.inputs.end(), is_passed_numbers))
      continue;  // stands where they are known
    for (const Port& array : call.results) {
      if (!call.gives_results)
        text += fmt::format("    {} {}[{}];\n", model.target.type(), array.name, array.size());
      arguments += (arguments.empty() ? "" : ", ") + array.name;
    }
    text += fmt::format("    {}_{}({});\n", model.name, call.function, arguments);
  }
  return text;
}

/// The call of a part at numbers that the function computes.
std::vector<std::string> part_call(const EmittedModel& model, const CallingFunction& function,
                                   const Port& array, const std::vector<std::string>& passed) {
  const auto call =
      std::find_if(function.calls.begin(), function.calls.end(),
                   [&](const Call& each) { return each.results[0].name == array.name; });
  std::vector<std::string> arguments = call->arguments;
  arguments.insert(arguments.end(), passed.begin(), passed.end());
  arguments.push_back(array.name);
  return {fmt::format("{} {}[{}];", model.target.type(), array.name, array.size()),
          fmt::format("{}_{}({});", model.name, call->function, fmt::join(arguments, ", "))};
}

/// Definition of one function. `graph`: as the header has it.
std::string emit_function(const EmittedModel& model, const Graph& graph,
                          const CallingFunction& function) {
  ArrayNames names = array_names();
  if (model.target.optimise == Optimise::size) names.side_by_side = false;
  names.shared = true;
  names.call = [&](const Port& array, const std::vector<std::string>& passed) {
    return part_call(model, function, array, passed);
  };
  std::string text = signature(model, graph) + "\n{\n";
  for (const Port& port : graph.inputs)
    if (!reads_port(function.rest, port.name) && !passes_port(function, port.name))
      text += fmt::format("    (void){};\n", port.name);
  text += calls_text(model, function);
  const PlannedGraph planned =
      plan_graph(function.rest, limits_beside(function.calls, loop_limits(model.target)));
  for (const std::string& line : statements(planned.graph, planned.plan, model.target, names))
    text += "    " + line + "\n";
  return wrap_lines(text + "}\n");
}

/// The signature of a part: no header has it, and none of its arguments is left unread.
std::string emit_part(const EmittedModel& model, const CallingFunction& part) {
  Graph graph = part.rest;
  graph.inputs.resize(own_ports(part));
  return "SINEW_NOT_INLINE static " + emit_function(model, graph, part);
}

/// Of every function, side by side; the parts first.
std::vector<std::string> emit_functions(const EmittedModel& model) {
  // Also where size counts: what a call executes for a few of its results is never worth it, and a
  // function that calls another for much has less alike with others.
  std::vector<CallingFunction> functions = find_calls(model.functions, LoopLimits{});
  const std::vector<CallingFunction> parts = find_parts(functions, loop_limits(model.target));
  std::vector<std::string> texts(parts.size() + model.functions.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < texts.size(); i = next++)
      texts[i] = i < parts.size() ? emit_part(model, parts[i])
                                  : emit_function(model, model.functions[i - parts.size()],
                                                  functions[i - parts.size()]);
  };
  std::vector<std::future<void>> workers;
  for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k)
    workers.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& worker : workers) worker.get();
  if (!parts.empty())
    texts[0] = "/* Parts: what several functions compute alike, or one at several places. */\n\n" +
               texts[0];
  return texts;
}

}  // namespace

std::string emit_c(const EmittedModel& model) {
  std::string functions;
  for (const std::string& text : emit_functions(model)) functions += "\n" + text;
  return wrap_lines(
      file_comment(model, model.description) + fmt::format("#include \"{}.h\"\n\n", model.name) +
      runtime_includes(model.target) + shared_definitions(model, functions) + functions);
}

}  // namespace sinew
