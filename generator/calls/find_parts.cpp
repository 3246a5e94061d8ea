// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/calls/find_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <map>
#include <optional>
#include <set>

#include "generator/calls/alike.h"
#include "generator/calls/part.h"
#include "generator/calls/part_cost.h"
#include "generator/calls/part_cut.h"
#include "generator/loops/unify.h"

namespace sinew {
namespace {

/// That a part is passed: what the boards have registers for.
constexpr std::size_t most_numbers = 6;

/// Instructions that a part must leave out of a function that calls it.
constexpr int least_of_caller = 12;

/// Elements that arrays of calls may have on the stack at once.
constexpr std::size_t most_at_once = 96;

/// A part, and the functions as they call it.
struct PartChoice {
  CallingFunction part;
  std::map<std::size_t, CallingFunction> callers;
  int saving = 0;  ///< instructions written
};

using PartCallers = std::map<std::size_t, std::vector<const PartInstance*>>;

class PartFinder {
 public:
  PartFinder(const std::vector<CallingFunction>& functions, const LoopLimits& limits)
      : functions_(functions),
        emitted_(functions.size()),
        limits_(limits),
        costs_(functions, limits.growth),
        planned_(functions.size(), -1) {}

  void run() {
    constexpr std::size_t most_parts = 12;
    while (functions_.size() - emitted_ < most_parts && add_part()) {
    }
  }

  std::vector<CallingFunction> emitted() const {
    return {functions_.begin(), functions_.begin() + static_cast<std::ptrdiff_t>(emitted_)};
  }

  /// Those that others call first.
  std::vector<CallingFunction> ordered_parts() const {
    std::vector<CallingFunction> ordered;
    std::set<std::string> done;
    for (std::size_t f = emitted_; f < functions_.size(); ++f) append(f, done, ordered);
    return ordered;
  }

 private:
  void append(std::size_t f, std::set<std::string>& done,
              std::vector<CallingFunction>& ordered) const {
    if (!done.insert(functions_[f].rest.name).second) return;
    for (const Call& call : functions_[f].calls)
      for (std::size_t g = emitted_; g < functions_.size(); ++g)
        if (functions_[g].rest.name == call.function) append(g, done, ordered);
    ordered.push_back(functions_[f]);
  }

  /// The one that leaves least to write.
  bool add_part() {
    all_ = all_alike(functions_, limits_.saving);
    std::vector<PartChoice> choices;
    for (const PartCandidate& candidate : part_candidates(all_))
      for (const double dearness : {1.0, 2.0})
        if (std::optional<PartChoice> choice = judged(candidate, dearness))
          choices.push_back(std::move(*choice));
    std::stable_sort(choices.begin(), choices.end(),
                     [](const PartChoice& a, const PartChoice& b) { return a.saving > b.saving; });
    for (PartChoice& choice : choices)
      if (saves_with_loops(choice)) {
        take(choice);
        return true;
      }
    return false;
  }

  void take(PartChoice& choice) {
    for (auto& [f, function] : choice.callers) {
      costs_.replace(f, function);
      functions_[f] = std::move(function);
    }
    costs_.add(choice.part);
    functions_.push_back(std::move(choice.part));
    planned_.push_back(-1);
  }

  /// Loops write once what repeats, and a part may leave less of it.
  bool saves_with_loops(const PartChoice& choice) {
    std::vector<std::pair<std::size_t, std::future<int>>> written;
    const auto start = [this](const CallingFunction& function) {
      return std::async(std::launch::async, [this, &function] { return planned_size(function); });
    };
    for (const auto& [f, function] : choice.callers) written.emplace_back(f, start(function));
    int saving = -planned_size(choice.part);
    std::map<std::size_t, int> now;
    for (auto& [f, size] : written) {
      if (planned_[f] < 0) planned_[f] = planned_size(functions_[f]);
      now[f] = size.get();
      saving += planned_[f] - now[f];
    }
    if (saving < limits_.saving) return false;
    for (const auto& [f, size] : now) planned_[f] = size;
    return true;
  }

  int planned_size(const CallingFunction& function) const {
    const Plan plan = plan_loops(function.rest, limits_beside(function.calls, limits_));
    return sinew::size_of(function.rest, plan).written + costs_.written_for_calls(function);
  }

  /// Leaves out the functions that the part is too dear for, until it is for none. `dearness`: of
  /// passing results; where that is dear a part gives fewer.
  std::optional<PartChoice> judged(const PartCandidate& candidate, double dearness) const {
    const Alike& alike = all_[candidate.alike];
    PartDraft draft{fmt::format("part_{}", functions_.size() - emitted_ + 1),
                    &functions_[alike.base.function],
                    alike.base.at,
                    {},
                    {},
                    {}};
    std::set<std::size_t> left_out;
    while (true) {
      draft.belongs = candidate.may;
      const PartCallers supporting = callers_of(alike, draft, left_out);
      draft.belongs = cut(alike, candidate.may, supporting, dearness);
      if (alike.weight(draft.belongs) < limits_.saving || numbers_of(draft).size() > most_numbers)
        return std::nullopt;
      const PartCallers callers = callers_of(alike, draft, left_out);
      if (count_of_calls(callers) < 2) return std::nullopt;
      complete(draft, callers);
      PartChoice choice = chosen(draft, callers);
      if (choice.callers.size() == callers.size())
        return choice.saving >= 2 * limits_.saving ? std::optional(choice) : std::nullopt;
      for (const auto& [f, instances] : callers)
        if (!choice.callers.count(f)) left_out.insert(f);
    }
  }

  static std::size_t count_of_calls(const PartCallers& callers) {
    std::size_t count = 0;
    for (const auto& [f, instances] : callers) count += instances.size();
    return count;
  }

  /// The instances that have most of the part, by function.
  PartCallers callers_of(const Alike& alike, const PartDraft& draft,
                         const std::set<std::size_t>& left_out) const {
    PartCallers callers;
    for (const PartInstance& instance : alike.instances)
      if (!left_out.count(instance.place.function) && can_call(alike, draft, instance))
        callers[instance.place.function].push_back(&instance);
    return callers;
  }

  bool can_call(const Alike& alike, const PartDraft& draft, const PartInstance& instance) const {
    constexpr double most = 0.5;
    if (alike.weight(draft.belongs, &instance) < most * alike.weight(draft.belongs)) return false;
    for (Value v : numbers_of(draft))
      if (instance.image[static_cast<std::size_t>(v)] == no_value) return false;
    const CallingFunction& caller = functions_[instance.place.function];
    const std::set<std::size_t> arrays = arrays_of_part(draft);
    return std::all_of(arrays.begin(), arrays.end(), [&](std::size_t array) {
      const auto own = caller.rest.inputs.begin();
      return std::any_of(
          own, own + static_cast<std::ptrdiff_t>(own_ports(caller)),
          [&](const Port& port) { return same_argument(port, draft.base->rest.inputs[array]); });
    });
  }

  std::vector<bool> cut(const Alike& alike, const std::vector<bool>& may,
                        const PartCallers& callers, double dearness) const {
    PartValues values{may, std::vector<bool>(may.size(), false), {}, {}};
    std::vector<int> count(may.size(), 0);
    for (const auto& [f, instances] : callers)
      for (const PartInstance* instance : instances) {
        const std::vector<bool> needed = needed_beside(*instance, may);
        for (std::size_t v = 0; v < may.size(); ++v) {
          if (instance->image[v] == no_value) continue;
          ++count[v];
          if (needed[static_cast<std::size_t>(instance->image[v])]) values.beside[v] = true;
        }
      }
    for (std::size_t v = 0; v < may.size(); ++v) {
      values.gain.push_back(alike.gains[v] * std::max(count[v] - 1, 0));
      values.cost.push_back(dearness * (2.0 + count[v]));  // stored once, and loaded
    }
    return cut_part(functions_[alike.base.function].rest, values);
  }

  /// By value of the instance's function: whether something that is none of the part's needs it.
  std::vector<bool> needed_beside(const PartInstance& instance,
                                  const std::vector<bool>& belongs) const {
    const Graph& graph = functions_[instance.place.function].rest;
    const std::vector<bool> members = members_of(graph, belongs, instance);
    std::vector<bool> needed(static_cast<std::size_t>(graph.size()), false);
    for (Value v : graph.results()) needed[static_cast<std::size_t>(v)] = true;
    for (Value v = 0; v < graph.size(); ++v)
      if (!members[static_cast<std::size_t>(v)])
        for (Value need : needs_of(graph, v)) needed[static_cast<std::size_t>(need)] = true;
    return needed;
  }

  /// Its results and the names of its numbers.
  void complete(PartDraft& draft, const PartCallers& callers) const {
    std::set<Value> results;
    for (const auto& [f, instances] : callers)
      for (const PartInstance* instance : instances) {
        const std::vector<bool> needed = needed_beside(*instance, draft.belongs);
        for (std::size_t v = 0; v < draft.belongs.size(); ++v)
          if (draft.belongs[v] && instance->image[v] != no_value &&
              needed[static_cast<std::size_t>(instance->image[v])])
            add_result(draft, static_cast<Value>(v), results);
      }
    draft.results.assign(results.begin(), results.end());
    std::set<std::string> taken{"part"};
    for (std::size_t array : arrays_of_part(draft))
      taken.insert(draft.base->rest.inputs[array].name);
    draft.names.clear();
    for (Value v : numbers_of(draft)) {
      const std::string stem = name_of_number(draft, v, callers);
      std::string name = stem;
      for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}_{}", stem, i);
      draft.names.push_back(name);
    }
  }

  /// A constant factor stays with the caller: what many places have with factors of their own, a
  /// loop writes once.
  static void add_result(const PartDraft& draft, Value v, std::set<Value>& results) {
    const Graph& graph = draft.base->rest;
    for (Value rest = v; rest != no_value; rest = scaled_operand(graph, graph[v])) v = rest;
    if (draft.belongs[static_cast<std::size_t>(v)]) results.insert(v);
  }

  /// The shortest that a caller has for it.
  std::string name_of_number(const PartDraft& draft, Value v, const PartCallers& callers) const {
    std::string name;
    for (const auto& [f, instances] : callers)
      for (const PartInstance* instance : instances) {
        const Graph& graph = functions_[f].rest;
        const Value there = instance->image[static_cast<std::size_t>(v)];
        const Port* port = graph[there].op == Op::input
                               ? &graph.inputs[graph.port_of_input(graph[there].index)]
                               : nullptr;
        const std::string label = port && port->by_value ? port->name : graph.label(there);
        if (!label.empty() && (name.empty() || label.size() < name.size())) name = label;
      }
    const bool is_angle = std::find(draft.at.begin(), draft.at.end(), v) != draft.at.end();
    return !name.empty() ? name : is_angle ? "angle" : "x";
  }

  /// With those callers that it is not too dear for.
  PartChoice chosen(const PartDraft& draft, const PartCallers& callers) const {
    PartChoice choice{made_part(draft), {}, 0};
    const PlanSize part = costs_.of(choice.part);
    const std::size_t elements = costs_.elements(choice.part);
    choice.saving = -part.written;
    if (choice.part.rest.outputs[0].size() == 0) return choice;
    for (const auto& [f, instances] : callers) {
      std::optional<CallingFunction> now = calling(functions_[f], draft, instances);
      if (!now || array_elements(now->calls) > limits_.arrays ||
          costs_.is_deep(f, costs_.elements(*now, elements), most_at_once))
        continue;
      const PlanSize size = costs_.of(*now, part.executed), before = costs_.of(f);
      const int saved = before.written - size.written, growth = size.executed - before.executed;
      if (saved < std::max(least_of_caller, growth) || costs_.is_dear(f, growth)) continue;
      choice.saving += saved;
      choice.callers.emplace(f, std::move(*now));
    }
    return choice;
  }

  std::vector<CallingFunction> functions_;  ///< the emitted ones, then the parts
  std::size_t emitted_;
  LoopLimits limits_;
  PartCosts costs_;
  std::vector<Alike> all_;
  std::vector<int> planned_;  ///< instructions written with loops; -1 where not known
};

}  // namespace

std::vector<CallingFunction> find_parts(std::vector<CallingFunction>& functions,
                                        const LoopLimits& limits) {
  PartFinder finder(functions, limits);
  finder.run();
  functions = finder.emitted();
  return finder.ordered_parts();
}

}  // namespace sinew
