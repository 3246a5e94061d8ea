// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/find_loops.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "generator/loops/constant_stores.h"
#include "generator/loops/kept_columns.h"
#include "generator/loops/runs.h"
#include "generator/loops/started_sums.h"
#include "generator/loops/sums.h"
#include "generator/loops/unify.h"

namespace sinew {
namespace {

/// What a loop gives: a column that is stored, carried where `first` is a value, or kept where it
/// has no elements.
struct LoopRoot {
  Column column;
  int port = 0;
  std::vector<int> elements = {};
  Value first = no_value;
  bool operator==(const LoopRoot&) const = default;
};

struct LoopCandidate {
  std::vector<LoopRoot> roots;
  int count = 0;
  int operations = 0;
  int written = 0;
  std::vector<std::vector<int>> places = {};  ///< of what passes choose from
  int saving() const { return (count - 1) * operations; }
};

/// Two passes cost more instructions than they save. Where passes choose, a compiler knows what the
/// first few choose and may leave the loop in its middle, which is no counted loop any more.
constexpr int fewest_passes = 3;
constexpr int fewest_passes_with_choice = 8;

/// Among loops that make a function longer in execution, what one saves is compared with what it
/// costs and this part of the whole.
constexpr double idle_growth = 0.02;

class Finder {
 public:
  /// `families`: also values that are no results and no terms of a sum.
  Finder(const Graph& graph, const LoopLimits& limits, bool families)
      : graph_(graph),
        limits_(limits),
        families_(families),
        live_(live_values(graph)),
        sums_(long_sums(graph)),
        best_(straight_plan(graph)),
        straight_(size_of(graph, best_)) {}

  /// The loop that saves most first, then what repeats beside it, until nothing saves enough.
  Plan run() {
    while (add_loop()) {
    }
    return best_;
  }

 private:
  std::uint64_t form(Value v) const { return keys_[static_cast<std::size_t>(v)]; }

  bool add_loop() {
    kept_ = kept_values();
    for (const Loop& loop : best_.loops)
      for (const LoopLeaf& leaf : loop.leaves)
        for (Value v : leaf.reads()) read_.insert(v);
    forms_ = forms_of(graph_, kept_);
    candidates_.clear();
    known_.clear();
    for (const bool exact : {true, false}) {
      exact_ = exact;
      keys_ = exact ? exact_forms_of(graph_, kept_) : forms_;
      for (std::size_t port = 0; port < graph_.outputs.size(); ++port)
        find_stores(static_cast<int>(port));
      for (const Sum& sum : sums_) find_steps(sum);
      if (families_) find_families();
    }
    leave_largest();
    merge();
    return choose();
  }

  KeptValues kept_values() const {
    KeptValues kept;
    int array = 0;
    for (const Loop& loop : best_.loops)
      for (const LoopResult& result : loop.results) {
        for (std::size_t pass = 0; pass < result.kept.size(); ++pass)
          kept[result.kept[pass]] = {array, static_cast<int>(pass)};
        ++array;
      }
    return kept;
  }

  std::optional<LoopBuilder> built(const std::vector<LoopRoot>& roots) const {
    LoopBuilder builder(graph_, forms_, kept_, read_,
                        static_cast<int>(roots.front().column.size()));
    for (const LoopRoot& root : roots)
      if (root.first != no_value) builder.carry(root.first, root.column);
    for (const LoopRoot& root : roots)
      if (!root.elements.empty())
        builder.store(root.column, root.port, root.elements);
      else if (root.first == no_value)
        builder.keep(root.column);
    if (!builder.build()) return std::nullopt;
    return builder;
  }

  /// What has one exact form has one form, too, and would be built twice.
  std::optional<LoopCandidate> candidate(const std::vector<LoopRoot>& roots) {
    const auto [known, is_new] = known_.try_emplace(key_of(roots));
    if (is_new) known->second = built_candidate(roots);
    return known->second;
  }

  static std::vector<int> key_of(const std::vector<LoopRoot>& roots) {
    std::vector<int> key;
    for (const LoopRoot& root : roots) {
      key.insert(key.end(), {root.port, root.first, static_cast<int>(root.column.size()),
                             static_cast<int>(root.elements.size())});
      key.insert(key.end(), root.column.begin(), root.column.end());
      key.insert(key.end(), root.elements.begin(), root.elements.end());
    }
    return key;
  }

  std::optional<LoopCandidate> built_candidate(const std::vector<LoopRoot>& roots) const {
    const std::optional<LoopBuilder> builder = built(roots);
    if (!builder || builder->loop.count < fewest_passes) return std::nullopt;
    LoopCandidate found{roots, builder->loop.count, operation_count(builder->loop.body),
                        size_of(builder->loop).written};
    for (const LoopLeaf& leaf : builder->loop.leaves)
      if (leaf.kind == LoopLeaf::Kind::chosen) found.places.push_back(leaf.places);
    if (!found.places.empty() && found.count < fewest_passes_with_choice) return std::nullopt;
    return found;
  }

  void keep(const std::optional<LoopCandidate>& found) {
    if (!found || found->saving() < limits_.saving) return;
    candidates_.push_back(*found);
    split(*found);
  }

  /// Loops of the passes that choose the same need no choice.
  void split(const LoopCandidate& found) {
    if (found.places.empty()) return;
    const std::vector<int>& places = found.places.front();
    for (int place = 0; place <= *std::max_element(places.begin(), places.end()); ++place) {
      std::vector<LoopRoot> roots;
      for (const LoopRoot& root : found.roots) {
        if (root.first != no_value) return;  // passes of a sum stay together
        LoopRoot part{{}, root.port};
        for (std::size_t pass = 0; pass < places.size(); ++pass) {
          if (places[pass] != place) continue;
          part.column.push_back(root.column[pass]);
          if (!root.elements.empty()) part.elements.push_back(root.elements[pass]);
        }
        roots.push_back(part);
      }
      if (!roots[0].column.empty()) keep(candidate(roots));
    }
  }

  /// Results in a row. Where several make a period any of them may come first.
  void find_stores(int port) {
    const std::vector<Value>& values = graph_.outputs[static_cast<std::size_t>(port)].values;
    std::vector<std::uint64_t> keys;
    for (std::size_t i = 0; i < values.size(); ++i)
      keys.push_back(is_free(port, i) ? form(values[i]) : i);
    std::map<std::uint64_t, LoopRoot> families;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!is_free(port, i) || arity(graph_[values[i]].op) == 0) continue;
      LoopRoot& root = families[form(values[i])];
      root.port = port;
      root.elements.push_back(static_cast<int>(i));
      root.column.push_back(values[i]);
    }
    for (const auto& [key, root] : families) keep(candidate({root}));
    for (const Repetition& run : runs_of(keys))
      keep(smallest_of(run, [&](int start, int count) {
        std::vector<LoopRoot> roots(static_cast<std::size_t>(run.period));
        for (int i = 0; i < run.period * count; ++i) {
          LoopRoot& root = roots[static_cast<std::size_t>(i % run.period)];
          root.port = port;
          root.elements.push_back(start + i);
          root.column.push_back(values[static_cast<std::size_t>(start + i)]);
        }
        return roots;
      }));
  }

  /// Whether no loop stores or keeps it yet.
  bool is_free(int port, std::size_t i) const {
    const Port& results = graph_.outputs[static_cast<std::size_t>(port)];
    return !best_.stored[static_cast<std::size_t>(port)][i] && !kept_.count(results.values[i]);
  }

  /// Any of a period's places may come first; that one is taken which leaves the smallest body.
  template <class Roots>
  std::optional<LoopCandidate> smallest_of(const Repetition& run, const Roots& roots) {
    std::optional<LoopCandidate> best;
    for (int phase = 0; phase < run.period; ++phase) {
      const int count = (run.length - phase) / run.period;
      const std::optional<LoopCandidate> now = candidate(roots(run.start + phase, count));
      if (now && (!best || now->operations < best->operations)) best = now;
    }
    return best;
  }

  /// A term computed from the sum so far, as an iteration's correction is, has the form it has
  /// where that sum is a leaf.
  std::uint64_t form_of_step(const Sum& sum, std::size_t i) const {
    const Value term = sum.terms[i], before = sum.partial[i - 1];
    FormsGiven forms(forms_);
    forms.give(graph_, before, term);
    return forms.needs_a_leaf(term)
               ? forms[static_cast<std::size_t>(term)]
               : form(term) * 2 + (exact_ && graph_[sum.partial[i]].op == Op::subtract);
  }

  /// Steps of a sum that repeat.
  void find_steps(const Sum& sum) {
    std::vector<std::uint64_t> keys;
    for (std::size_t i = 1; i < sum.terms.size(); ++i)
      keys.push_back(carried_.count(sum.partial[i]) ? i : form_of_step(sum, i));
    for (const Repetition& run : runs_of(keys))
      keep(smallest_of(run, [&](int start, int count) {
        LoopRoot root;
        root.first =
            sum.partial[static_cast<std::size_t>(start)];  // keys[i] leads to partial[i + 1]
        for (int k = 1; k <= count; ++k)
          root.column.push_back(sum.partial[static_cast<std::size_t>(start + k * run.period)]);
        return std::vector<LoopRoot>{root};
      }));
  }

  /// Values of one form, wherever they are used.
  void find_families() {
    const std::vector<bool> given = given_by(graph_, best_.loops);
    std::map<std::uint64_t, Column> families;
    for (const Step& step : best_.steps)
      if (step.value != no_value && arity(graph_[step.value].op) > 0 &&
          !given[static_cast<std::size_t>(step.value)] &&
          live_[static_cast<std::size_t>(step.value)] && !is_scaled(step.value))
        families[form(step.value)].push_back(step.value);
    for (auto& [key, column] : families) {
      std::sort(column.begin(), column.end());
      keep(candidate({{column, 0, {}, no_value}}));
    }
  }

  /// Whether it has the form of what a factor multiplies.
  bool is_scaled(Value v) const {
    for (int i = 0; i < arity(graph_[v].op); ++i)
      if (form(graph_[v].operand(i)) == form(v)) return true;
    return false;
  }

  void leave_largest() {
    constexpr std::size_t most = 40;
    std::stable_sort(
        candidates_.begin(), candidates_.end(),
        [](const LoopCandidate& a, const LoopCandidate& b) { return a.saving() > b.saving(); });
    if (candidates_.size() > most) candidates_.resize(most);
  }

  /// Loops of as many passes become one where their bodies have operations in common, and then
  /// where they are small.
  void merge() {
    constexpr int small = 40;  // larger bodies without a common operation crowd the registers
    merge(0);
    merge(small);
  }

  void merge(int small) {
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      for (std::size_t k = i + 1; k < candidates_.size();) {
        const std::optional<LoopCandidate> both = joined(candidates_[i], candidates_[k], small);
        if (both) {
          candidates_[i] = *both;
          candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(k));
        } else {
          ++k;
        }
      }
  }

  /// `small`: what bodies without a common operation may have together.
  std::optional<LoopCandidate> joined(const LoopCandidate& a, const LoopCandidate& b, int small) {
    if (a.count != b.count) return std::nullopt;
    std::vector<LoopRoot> roots = a.roots;
    for (const LoopRoot& root : b.roots)
      if (std::find(roots.begin(), roots.end(), root) == roots.end()) roots.push_back(root);
    if (roots.size() == a.roots.size()) return a;
    std::optional<LoopCandidate> both = candidate(roots);
    const int apart = a.operations + b.operations;
    if (both && both->written < a.written + b.written &&
        (both->operations < apart || apart < small))
      return both;
    return std::nullopt;
  }

  /// The candidate that leaves the fewest operations written.
  bool choose() {
    constexpr std::size_t most = 20;
    leave_largest();
    std::optional<Plan> best;
    const PlanSize before = size_of(graph_, best_);
    double highest = 0.0;
    for (std::size_t i = 0; i < std::min(most, candidates_.size()); ++i) {
      std::optional<Plan> plan = with(candidates_[i]);
      if (!plan) continue;
      const PlanSize now = size_of(graph_, *plan);
      const int saved = before.written - now.written;
      const double growth = std::max(now.executed - before.executed, 0);
      const double value = saved / (growth + idle_growth * straight_.executed);
      if (arrays_of(*plan) > limits_.arrays || saved < limits_.saving || value <= highest ||
          is_dear(now, straight_, limits_))
        continue;
      highest = value;
      best = std::move(plan);
    }
    if (!best) return false;
    best_ = std::move(*best);
    for (const LoopResult& result : best_.loops.back().results)
      if (result.is_carried()) carried_.insert(result.last);
    return true;
  }

  /// Elements of all arrays that the loops of a plan keep or choose from.
  static std::size_t arrays_of(const Plan& plan) {
    std::size_t elements = 0;
    for (const Loop& loop : plan.loops) {
      for (const LoopResult& result : loop.results) elements += result.kept.size();
      for (const LoopLeaf& leaf : loop.leaves)
        if (leaf.kind == LoopLeaf::Kind::chosen) elements += leaf.choices.size();
    }
    return elements;
  }

  std::optional<Plan> with(const LoopCandidate& each) const {
    std::optional<LoopBuilder> builder = built(each.roots);
    keep_needed(graph_, best_, *builder);
    std::vector<Loop> loops = best_.loops;
    loops.push_back(std::move(builder->loop));
    try {  // loops may need each other's results
      return plan_with(graph_, std::move(loops));
    } catch (const std::logic_error&) {
      return std::nullopt;
    }
  }

  const Graph& graph_;
  LoopLimits limits_;
  bool families_;
  std::vector<bool> live_;
  std::vector<Sum> sums_;
  Plan best_;
  PlanSize straight_;
  KeptValues kept_;       ///< by the loops of best_
  std::set<Value> read_;  ///< by the loops of best_
  std::set<Value> carried_;
  Forms forms_;
  Forms keys_;         ///< what is looked for among: forms, or exact forms
  bool exact_ = true;  ///< which of them
  std::vector<LoopCandidate> candidates_;
  std::map<std::vector<int>, std::optional<LoopCandidate>> known_;  ///< by their roots
};

}  // namespace

bool is_dear(const PlanSize& now, const PlanSize& before, const LoopLimits& limits) {
  return now.executed > before.executed * limits.growth;
}

LoopLimits loop_limits(const Target& target) {
  LoopLimits limits;
  if (target.optimise == Optimise::size) limits.growth = 2.0;
  return limits;
}

Plan plan_loops(const Graph& graph, const LoopLimits& limits) {
  Plan best = straight_plan(graph);
  for (const bool families : {false, true}) {
    Plan plan = Finder(graph, limits, families).run();
    if (size_of(graph, plan).written < size_of(graph, best).written) best = std::move(plan);
  }
  if (const std::vector<Loop> constants = loops_of_constants(graph, best); !constants.empty()) {
    std::vector<Loop> loops = best.loops;
    loops.insert(loops.end(), constants.begin(), constants.end());
    best = plan_with(graph, std::move(loops));
  }
  return with_fewest_waiting(graph, best);
}

PlannedGraph plan_graph(const Graph& graph, const LoopLimits& limits) {
  PlannedGraph plain{graph, plan_loops(graph, limits)};
  PlannedGraph started{with_started_sums(graph), {}};
  if (started.graph.size() == graph.size()) return plain;
  started.plan = plan_loops(started.graph, limits);
  const auto written = [](const PlannedGraph& each) {
    return size_of(each.graph, each.plan).written;
  };
  return written(started) < written(plain) ? started : plain;
}

}  // namespace sinew
