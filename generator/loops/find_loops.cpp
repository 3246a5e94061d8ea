// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/find_loops.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "generator/loops/runs.h"
#include "generator/loops/unify.h"

namespace sinew {
namespace {

/// What a loop gives: a column that is stored, or carried where `first` is a value.
struct LoopRoot {
  Column column;
  int port = 0;
  std::vector<int> elements = {};
  Value first = no_value;
};

struct LoopCandidate {
  std::vector<LoopRoot> roots;
  Loop loop;
  int operations() const { return operation_count(loop.body); }
  int saving() const { return (loop.count - 1) * operations(); }
};

/// A long sum: value 0 is its first term, value i the sum up to term i.
struct Sum {
  std::vector<Value> partial;
  std::vector<Value> terms;  ///< term i leads from value i - 1 to i; the first is not used
};

/// Values that a result needs.
std::vector<bool> live_values(const Graph& graph) {
  std::vector<bool> live(static_cast<std::size_t>(graph.size()), false);
  for (Value v : graph.results()) live[static_cast<std::size_t>(v)] = true;
  for (Value v = graph.size() - 1; v >= 0; --v)
    for (int i = 0; live[static_cast<std::size_t>(v)] && i < arity(graph[v].op); ++i)
      live[static_cast<std::size_t>(graph[v].operand(i))] = true;
  return live;
}

class Finder {
 public:
  Finder(const Graph& graph, int saving)
      : graph_(graph), saving_(saving), forms_(forms_of(graph)), live_(live_values(graph)) {}

  Plan run() {
    for (std::size_t port = 0; port < graph_.outputs.size(); ++port)
      find_stores(static_cast<int>(port));
    for (const Sum& sum : sums()) find_steps(sum);
    merge();
    return choose();
  }

 private:
  std::uint64_t form(Value v) const { return forms_[static_cast<std::size_t>(v)]; }

  std::optional<LoopCandidate> candidate(const std::vector<LoopRoot>& roots) const {
    LoopBuilder builder(graph_, forms_, static_cast<int>(roots.front().column.size()));
    for (const LoopRoot& root : roots)
      if (root.first != no_value)
        builder.carry(root.first, root.column);
      else
        builder.store(root.column, root.port, root.elements);
    if (!builder.build()) return std::nullopt;
    return LoopCandidate{roots, std::move(builder.loop)};
  }

  void keep(const std::optional<LoopCandidate>& found) {
    if (found && found->saving() >= saving_) candidates_.push_back(*found);
  }

  void find_stores(int port) {
    const std::vector<Value>& values = graph_.outputs[static_cast<std::size_t>(port)].values;
    std::vector<std::uint64_t> keys;
    for (Value v : values) keys.push_back(form(v));
    for (const Repetition& run : runs_of(keys)) {
      std::vector<LoopRoot> roots(static_cast<std::size_t>(run.period));
      for (int i = 0; i < run.period * run.count; ++i) {
        LoopRoot& root = roots[static_cast<std::size_t>(i % run.period)];
        root.port = port;
        root.elements.push_back(run.start + i);
        root.column.push_back(values[static_cast<std::size_t>(run.start + i)]);
      }
      keep(candidate(roots));
    }
  }

  /// Sums of which no other is a part, with all their terms in the order of addition.
  std::vector<Sum> sums() const {
    const auto is_sum = [this](Value v) {
      return graph_[v].op == Op::add || graph_[v].op == Op::subtract;
    };
    std::vector<int> length(static_cast<std::size_t>(graph_.size()), 0);
    const auto length_of = [&](Value v) -> int& { return length[static_cast<std::size_t>(v)]; };
    const auto rest_of = [&](const Node& node) {  // the operand that is the sum so far
      const bool b = node.op == Op::add && length_of(node.b) > length_of(node.a);
      return b ? node.b : node.a;
    };
    for (Value v = 0; v < graph_.size(); ++v)
      if (is_sum(v) && live_[static_cast<std::size_t>(v)])
        length_of(v) = 1 + length_of(rest_of(graph_[v]));
    std::vector<Sum> all;
    std::vector<bool> part(static_cast<std::size_t>(graph_.size()), false);
    for (Value v = graph_.size() - 1; v >= 0; --v) {
      if (part[static_cast<std::size_t>(v)] || length_of(v) < 3) continue;
      Sum sum;
      Value at = v;
      for (; is_sum(at); at = rest_of(graph_[at])) {
        part[static_cast<std::size_t>(at)] = true;
        const Node& node = graph_[at];
        sum.partial.push_back(at);
        sum.terms.push_back(rest_of(node) == node.a ? node.b : node.a);
      }
      sum.partial.push_back(at);
      sum.terms.push_back(at);
      std::reverse(sum.partial.begin(), sum.partial.end());
      std::reverse(sum.terms.begin(), sum.terms.end());
      all.push_back(std::move(sum));
    }
    return all;
  }

  bool depends(Value v, Value on, std::set<Value>& seen) const {
    if (v <= on || !seen.insert(v).second) return v == on;
    for (int i = 0; i < arity(graph_[v].op); ++i)
      if (depends(graph_[v].operand(i), on, seen)) return true;
    return false;
  }

  /// A term computed from the sum so far, as an iteration's correction is, has the form it has
  /// where that sum is a leaf.
  std::uint64_t form_of_step(const Sum& sum, std::size_t i) const {
    const Value term = sum.terms[i], before = sum.partial[i - 1];
    std::set<Value> seen;
    const std::uint64_t own =
        depends(term, before, seen)
            ? forms_given(graph_, forms_, before)[static_cast<std::size_t>(term)]
            : form(term);
    return own * 2 + (graph_[sum.partial[i]].op == Op::subtract);
  }

  /// Steps of a sum that repeat. Where several make a period any of them may come first; that one
  /// is taken which leaves the smallest body.
  void find_steps(const Sum& sum) {
    std::vector<std::uint64_t> keys;
    for (std::size_t i = 1; i < sum.terms.size(); ++i) keys.push_back(form_of_step(sum, i));
    for (const Repetition& run : runs_of(keys)) {
      std::optional<LoopCandidate> best;
      for (int phase = 0; phase < run.period; ++phase) {
        const int count = phase == 0 ? run.count : (run.count * run.period - phase) / run.period;
        LoopRoot root;
        // keys[i] belongs to the step that ends in partial[i + 1]
        root.first = sum.partial[static_cast<std::size_t>(run.start + phase)];
        for (int k = 1; k <= count; ++k)
          root.column.push_back(
              sum.partial[static_cast<std::size_t>(run.start + phase + k * run.period)]);
        const std::optional<LoopCandidate> now = candidate({root});
        if (now && (!best || now->operations() < best->operations())) best = now;
      }
      keep(best);
    }
  }

  /// Loops of as many passes become one where their bodies have operations in common.
  void merge() {
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      for (std::size_t k = i + 1; k < candidates_.size();) {
        const std::optional<LoopCandidate> both = joined(candidates_[i], candidates_[k]);
        if (both) {
          candidates_[i] = *both;
          candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(k));
        } else {
          ++k;
        }
      }
  }

  std::optional<LoopCandidate> joined(const LoopCandidate& a, const LoopCandidate& b) const {
    if (a.loop.count != b.loop.count) return std::nullopt;
    std::vector<LoopRoot> roots = a.roots;
    roots.insert(roots.end(), b.roots.begin(), b.roots.end());
    std::optional<LoopCandidate> both = candidate(roots);
    if (both && both->operations() < a.operations() + b.operations()) return both;
    return std::nullopt;
  }

  /// The loops that save most first; each must save enough beside those taken before it.
  Plan choose() {
    std::stable_sort(
        candidates_.begin(), candidates_.end(),
        [](const LoopCandidate& a, const LoopCandidate& b) { return a.saving() > b.saving(); });
    Plan best = straight_plan(graph_);
    const PlanSize straight = size_of(graph_, best);
    for (const LoopCandidate& each : candidates_) {
      std::vector<Loop> loops = best.loops;
      loops.push_back(each.loop);
      std::optional<Plan> plan = try_plan(loops);
      if (!plan) continue;
      const PlanSize before = size_of(graph_, best), now = size_of(graph_, *plan);
      if (before.written - now.written < saving_ ||
          now.executed > largest_growth * straight.executed)
        continue;
      best = std::move(*plan);
    }
    return best;
  }

  std::optional<Plan> try_plan(const std::vector<Loop>& loops) const {
    try {
      return plan_with(graph_, loops);
    } catch (const std::logic_error&) {  // they need each other's results
      return std::nullopt;
    }
  }

  const Graph& graph_;
  int saving_;
  Forms forms_;
  std::vector<bool> live_;
  std::vector<LoopCandidate> candidates_;
};

}  // namespace

Plan plan_loops(const Graph& graph, int saving) {
  return Finder(graph, saving).run();
}

}  // namespace sinew
