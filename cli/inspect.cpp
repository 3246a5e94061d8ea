// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/equations.h"
#include "cli/models/model_folder.h"
#include "cli/models/reduced_models.h"
#include "cli/models/target_options.h"
#include "cli/terminal/terminal.h"
#include "generator/cost.h"
#include "generator/dump.h"
#include "generator/lower.h"
#include "generator/passes/pipeline.h"
#include "generator/runtime_calls.h"
#include "symbolic/dynamics/dynamics_functions.h"
#include "symbolic/dynamics/lagrangian.h"

namespace sinew {
namespace {

struct InspectOptions {
  std::string folder, function, after;
  TargetOptions target;
  bool passes = false, methods = false, reduced = false, runtime_parameters = false;
  bool dot = false, json = false, equations = false;
  std::string format = "latex";
};

nlohmann::ordered_json cost_json(const Cost& c, const Target& target) {
  nlohmann::ordered_json row{
      {"multiply", c.multiply}, {"add", c.add},       {"multiply_add", c.operations()},
      {"negate", c.negate},     {"divide", c.divide}, {"sqrt", c.square_root},
      {"sincos", c.sincos},     {"other", c.other}};
  if (target.fused) row["fused"] = c.fused;
  return row;
}

void print_cost_heading(const Target& target) {
  tell("{:<24} {:>7} {:>6} {:>6} {:>6} {:>6} {:>6} {:>7} {:>6}{}{}\n", "function", "mul+add", "mul",
       "add", "neg", "div", "sqrt", "sincos", "other", target.fused ? "  fused" : "",
       target.optimise == Optimise::size ? "  copies" : "");
}

void print_cost(const std::string& function, const Graph& graph, const Target& target) {
  const Cost c = count_operations(graph);
  tell("{:<24} {:>7} {:>6} {:>6} {:>6} {:>6} {:>6} {:>7} {:>6}", function, c.operations(),
       c.multiply, c.add, c.negate, c.divide, c.square_root, c.sincos, c.other);
  if (target.fused) tell(" {:>6}", c.fused);
  if (target.optimise == Optimise::size) tell(" {:>7}", shared_functions({graph}, target).size());
  tell("\n");
}

void print_costs(const std::vector<Function>& functions, const Target& target, bool json) {
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  if (!json) print_cost_heading(target);
  for (const Function& function : functions) {
    const Graph graph = optimise(lower(function), {}, target);
    if (!json) {
      print_cost(function.name, graph, target);
      continue;
    }
    const Cost cost = count_operations(graph);
    nlohmann::ordered_json row = cost_json(cost, target);
    if (target.optimise == Optimise::size) row["copies"] = shared_functions({graph}, target).size();
    row["function"] = function.name;
    report.push_back(row);
  }
  if (json) tell_json(report);
}

/// For every pass: operations of all functions with that pass left out, less those with all. A
/// fused multiplication and addition counts as one.
void print_pass_gains(const std::vector<Function>& functions, const Target& target, bool json) {
  std::vector<Graph> graphs;
  for (const Function& function : functions) graphs.push_back(lower(function));
  const auto total = [&](const std::vector<std::string>& without) {
    int sum = 0;
    for (const Graph& graph : graphs) {
      const Cost cost = count_operations(optimise(graph, without, target));
      sum += cost.operations() - cost.fused;
    }
    return sum;
  };
  const int all = total({});
  nlohmann::ordered_json report{{"multiply_add", all}, {"gains", nlohmann::ordered_json::array()}};
  if (!json)
    tell("{:<24} {:>18}\nall passes on: {} multiplications and additions in {} functions\n",
         "pass left out", "mul+add more", all, functions.size());
  std::set<std::string> seen;
  for (const Pass& pass : pipeline(target)) {
    if (!seen.insert(pass.name).second) continue;
    const int more = total({pass.name}) - all;
    if (json)
      report["gains"].push_back({{"pass", pass.name}, {"multiply_add", more}});
    else
      tell("{:<24} {:>18}\n", pass.name, more);
  }
  if (json) tell_json(report);
}

const Mechanism& mechanism_of(const ModelFolder& folder) {
  const Mechanism* mechanism = std::get_if<Mechanism>(&folder.model);
  if (mechanism) return *mechanism;
  throw std::runtime_error(folder.identity.name +
                           " has no dynamics; expected a model with mechanism.toml");
}

/// Error against operations saved.
void print_reduced(const ModelFolder& folder, bool json) {
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  if (!json)
    tell("{:<34} {:<17} {:>7} {:>7} {:>9} {:>9}\n", "left out", "function", "mul+add", "left",
         "rms error", "largest");
  for (const ReducedModel& r : reduced_models(mechanism_of(folder))) {
    if (json)
      report.push_back({{"left_out", r.left_out},
                        {"function", r.function},
                        {"multiply_add", r.operations},
                        {"multiply_add_left", r.reduced_operations},
                        {"rms_error", r.rms_error},
                        {"largest_error", r.largest_error}});
    else
      tell("{:<34} {:<17} {:>7} {:>7} {:>7.2f} % {:>7.1f} %\n", r.left_out, r.function,
           r.operations, r.reduced_operations, 100.0 * r.rms_error, 100.0 * r.largest_error);
  }
  if (json)
    tell_json(report);
  else
    tell(
        "Errors at the worst joint, of the whole torque's rms there; rates and accelerations up to "
        "a "
        "quarter of the model's largest.\n");
}

/// Inverse dynamics by every method of derivation; for coupled joints those of 5.3.2.
std::vector<Function> by_every_method(const ModelFolder& folder) {
  const Mechanism* mechanism = &mechanism_of(folder);
  std::vector<Function> methods{inverse_dynamics_function(*mechanism, emitted_cost),
                                textbook_inverse_dynamics(*mechanism)};
  methods[0].name = "recursive (emitted)";
  methods[1].name = "L differentiated";
  if (mechanism->couplings.empty() && mechanism->four_bars.empty()) return methods;
  methods.push_back(projected_inverse_dynamics(*mechanism));
  methods[1].name = "couplings in L";
  methods[2].name = "all joints, projected";
  return methods;
}

void run_cost(const InspectOptions& o) {
  const Target target = o.target.target();
  if (o.reduced) return print_reduced(open_model_folder(o.folder), o.json);
  if (o.methods) return print_costs(by_every_method(open_model_folder(o.folder)), target, o.json);
  const std::vector<Function> functions =
      derive_functions(open_model_folder(o.folder), o.runtime_parameters);
  if (o.passes)
    print_pass_gains(functions, target, o.json);
  else
    print_costs(functions, target, o.json);
}

/// Names of the stages that --after takes, for this target.
std::string stages(const Target& target) {
  std::string names = "lower";
  std::set<std::string> seen;
  for (const Pass& pass : pipeline(target))
    if (seen.insert(pass.name).second) names += ", " + pass.name;
  return names;
}

Graph graph_after(const Function& function, const std::string& after, const Target& target) {
  Graph graph = lower(function);
  if (after == "lower") return graph;
  for (const Pass& pass : pipeline(target)) {
    graph = pass.run(graph);
    if (pass.name == after) return graph;
  }
  if (after.empty()) return graph;
  const bool elsewhere = after == "fuse";  // the one pass that not every target has
  throw std::invalid_argument(fmt::format(
      "--after {}: expected {}", after, elsewhere ? "--fma with it" : "one of " + stages(target)));
}

void run_dump(const InspectOptions& o) {
  const Target target = o.target.target();
  const ModelFolder folder = open_model_folder(o.folder);
  if (o.equations) return tell("{}", equations_of(folder, o.format));
  const std::vector<Function> functions = derive_functions(folder, o.runtime_parameters);
  std::string names;
  for (const Function& function : functions) {
    names += (names.empty() ? "" : ", ") + function.name;
    if (function.name != o.function) continue;
    const Graph graph = graph_after(function, o.after, target);
    tell("{}", o.dot ? dump_dot(graph) : dump_text(graph));
    return;
  }
  const Mechanism* mechanism = std::get_if<Mechanism>(&folder.model);
  throw std::invalid_argument(
      fmt::format("--function {}: expected one of {}{}", o.function, names,
                  mechanism && is_massless(*mechanism) ? "; " + why_no_dynamics(*mechanism) : ""));
}

}  // namespace

void add_cost_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("cost", "Count the operations of every function");
  auto options = std::make_shared<InspectOptions>();
  command->add_option("model", options->folder, "Model folder")->required();
  command->add_flag("--runtime-parameters", options->runtime_parameters,
                    "Counts with masses and gravity as arguments");
  add_target_options(*command, options->target);
  command->add_flag("--passes", options->passes, "What each optimisation pass brings");
  command->add_flag("--methods", options->methods,
                    "Inverse dynamics by every method of derivation (5.3.2)");
  command->add_flag(
      "--reduced", options->reduced,
      "What leaving out gravity, Coriolis or the change of the coupling saves and costs");
  command->add_flag("--json", options->json, "Report for machines");
  command->callback([options] { run_cost(*options); });
}

void add_dump_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("dump", "Print an intermediate form of a function");
  auto options = std::make_shared<InspectOptions>();
  command->add_option("model", options->folder, "Model folder")->required();
  CLI::Option_group* what = command->add_option_group("what is printed");
  what->add_option("--function", options->function,
                   "Function without the model's prefix, for instance bias");
  CLI::Option* equations = what->add_flag(
      "--equations", options->equations,
      "The model's equations for people: symbols kept, with the source's numbers and a table");
  what->require_option(1);
  command->add_option("--format", options->format, "Of the equations: latex, mathml or text")
      ->capture_default_str()
      ->needs(equations);
  command->add_option("--after", options->after,
                      "Last pass to run, or 'lower' (default: all passes)");
  add_target_options(*command, options->target);
  command->add_flag("--runtime-parameters", options->runtime_parameters,
                    "Masses and gravity as arguments");
  command->add_flag("--dot", options->dot, "As a graph for Graphviz");
  command->callback([options] { run_dump(*options); });
}

}  // namespace sinew
