// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/literal.h"
#include "generator/local_names.h"
#include "generator/loops/loop_text.h"
#include "generator/runtime_calls.h"

namespace sinew {
namespace {

constexpr std::size_t longest_expression = 72;
/// Of a named step that is used once: its name would take a line and say little more.
constexpr std::size_t longest_in_place = 40;

/// How tightly an expression binds in C.
enum Binding { binds_sum = 1, binds_product = 2, binds_unary = 3, binds_atom = 4 };

struct Text {
  std::string text;
  Binding binding = binds_atom;
};

class Writer {
 public:
  Writer(const Graph& graph, const Plan& plan, const Target& target, const ArrayNames& names,
         LocalNames& local_names)
      : graph_(graph),
        plan_(plan),
        target_(target),
        names_(names),
        texts_(static_cast<std::size_t>(graph.size())),
        local_names_(local_names) {}

  std::vector<std::string> run() {
    const bool early = names_.side_by_side && !names_.stores_last && stores_early(graph_);
    Stores stores = early ? stores_by_value() : Stores{};
    for (at_ = 0; at_ < plan_.steps.size(); ++at_) {
      const Step& step = plan_.steps[at_];
      if (step.loop >= 0) {
        write_loop(plan_.loops[static_cast<std::size_t>(step.loop)]);
        continue;
      }
      if (step.call >= 0) {
        write_call(graph_.inputs[static_cast<std::size_t>(step.call)]);
        continue;
      }
      write(step.value);
      for (const Element& element : stores.after[step.value]) store(element);
    }
    for (const Element& element : early ? stores.last : elements()) store(element);
    return std::move(lines_);
  }

 private:
  /// An element of a result.
  struct Element {
    const Port* port;
    int index;
    Value value() const { return port->values[static_cast<std::size_t>(index)]; }
  };

  /// Those that no loop stores.
  std::vector<Element> elements() const {
    std::vector<Element> all;
    for (std::size_t p = 0; p < graph_.outputs.size(); ++p)
      for (int i = 0; i < graph_.outputs[p].size(); ++i)
        if (!plan_.stored[p][static_cast<std::size_t>(i)]) all.push_back({&graph_.outputs[p], i});
    return all;
  }

  /// Which results are stored when.
  struct Stores {
    std::map<Value, std::vector<Element>> after;  ///< after the statement of a value
    std::vector<Element> last;
  };

  /// Elements that need no computation follow the one before them: compilers make a loop of too
  /// many zeros in a row.
  Stores stores_by_value() const {
    Stores stores;
    Value before = no_value;
    for (const Element& element : elements()) {
      const Node& node = graph_[element.value()];
      const bool is_computed = node.op != Op::input && node.op != Op::constant;
      if (is_computed) {
        before = element.value();
        stores.after[before].push_back(element);
      } else if (before != no_value) {
        stores.after[std::max(before, element.value())].push_back(element);
      } else {
        stores.last.push_back(element);
      }
    }
    return stores;
  }

  void store(const Element& element) {
    write(element.value());  // a constant may stand later
    const bool is_status = names_.int_statuses && !element.port->states.empty();
    const std::string value = is_status ? "(int)" + in_parentheses(element.value(), binds_atom)
                                        : text(element.value()).text;
    lines_.push_back(fmt::format("{} = {};", names_.element(*element.port, element.index), value));
  }

  Text& text(Value v) { return texts_[static_cast<std::size_t>(v)]; }

  void write(Value v) {
    if (!text(v).text.empty()) return;
    const Node& node = graph_[v];
    if (is_sincos(node)) return write_sincos();
    Text expression = form(node);
    if (node.op != Op::input && node.op != Op::constant && deserves_name(v, expression)) {
      const std::string name = fresh_name(v, "t");
      lines_.push_back(fmt::format("const {} {} = {};", target_.type(), name, expression.text));
      expression = {name, binds_atom};
    }
    text(v) = expression;
  }

  bool deserves_name(Value v, const Text& expression) const {
    const int uses = plan_.uses[static_cast<std::size_t>(v)];
    const std::size_t longest = graph_.label(v).empty() ? longest_expression : longest_in_place;
    return uses > 1 || expression.text.size() > longest;
  }

  /// The first of a group of neighbouring sines and cosines, the step being written, writes the
  /// call for all of them: the runtime evaluates four or two angles side by side, with the bits of
  /// as many single calls.
  void write_sincos() {
    std::vector<Value> angles;
    for (std::size_t i = at_; i < plan_.steps.size(); ++i) {
      const Value w = plan_.steps[i].value;
      if (w == no_value || !is_sincos(graph_[w])) break;
      const Value angle = graph_[w].a;
      if (text(angle).text.empty()) break;  // sin(sin(x)): one of the group's own results
      if (text(w).text.empty() && std::find(angles.begin(), angles.end(), angle) == angles.end())
        angles.push_back(angle);
    }
    while (!angles.empty()) {
      const std::size_t count = !names_.side_by_side                   ? 1
                                : angles.size() >= 4 && !names_.shared ? 4
                                : angles.size() >= 2                   ? 2
                                                                       : 1;
      const std::vector<Value> group(angles.begin(),
                                     angles.begin() + static_cast<std::ptrdiff_t>(count));
      if (names_.shared)
        write_shared_sincos(group);
      else if (count == 1)
        write_one_sincos(group[0]);
      else
        write_sincos_group(group);
      angles.erase(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(count));
    }
  }

  static bool is_sincos(const Node& node) { return node.op == Op::sine || node.op == Op::cosine; }

  struct Pair {
    std::string s, c;
  };

  /// Names for sine and cosine of an angle; both get one, used or not.
  Pair name_pair(Value angle) {
    Value sine = no_value, cosine = no_value;
    for (Value w = angle + 1; w < graph_.size(); ++w) {
      if (graph_[w].a != angle) continue;
      if (graph_[w].op == Op::sine) sine = w;
      if (graph_[w].op == Op::cosine) cosine = w;
    }
    const Pair pair{sine == no_value ? fresh_name("s") : fresh_name(sine, "s"),
                    cosine == no_value ? fresh_name("c") : fresh_name(cosine, "c")};
    if (sine != no_value) text(sine) = {pair.s, binds_atom};
    if (cosine != no_value) text(cosine) = {pair.c, binds_atom};
    return pair;
  }

  bool is_used(Value angle, Op op) const {
    for (Value w = angle + 1; w < graph_.size(); ++w)
      if (graph_[w].a == angle && graph_[w].op == op && plan_.uses[static_cast<std::size_t>(w)] > 0)
        return true;
    return false;
  }

  void write_one_sincos(Value angle) {
    const Pair pair = name_pair(angle);
    lines_.push_back(fmt::format("{} {}, {};", target_.type(), pair.s, pair.c));
    lines_.push_back(fmt::format("{}({}, &{}, &{});", function_name(Op::sine, "sinew_sincos"),
                                 text(angle).text, pair.s, pair.c));
  }

  void write_sincos_group(const std::vector<Value>& angles) {
    std::string list;
    for (Value angle : angles) list += (list.empty() ? "" : ", ") + text(angle).text;
    const std::string in = fresh_name("angle"), sine = fresh_name("sine"),
                      cosine = fresh_name("cosine");
    const std::size_t n = angles.size();
    lines_.push_back(fmt::format("const {} {}[{}] = {{{}}};", target_.type(), in, n, list));
    lines_.push_back(fmt::format("{} {}[{}], {}[{}];", target_.type(), sine, n, cosine, n));
    lines_.push_back(
        fmt::format("sinew_sincos{}{}({}, {}, {});", n, target_.suffix(), in, sine, cosine));
    name_results(angles, sine, cosine);
  }

  void name_results(const std::vector<Value>& angles, const std::string& sine,
                    const std::string& cosine) {
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const bool s = is_used(angles[i], Op::sine), c = is_used(angles[i], Op::cosine);
      const Pair pair = name_pair(angles[i]);
      if (s)
        lines_.push_back(fmt::format("const {} {} = {}[{}];", target_.type(), pair.s, sine, i));
      if (c)
        lines_.push_back(fmt::format("const {} {} = {}[{}];", target_.type(), pair.c, cosine, i));
    }
  }

  void write_shared_sincos(const std::vector<Value>& angles) {
    std::string list;
    for (Value angle : angles) list += (list.empty() ? "" : ", ") + text(angle).text;
    const std::string sines = fresh_name("sines");
    lines_.push_back(fmt::format("const {} {} = {}({});", shared_sincos_type(angles.size()), sines,
                                 shared_sincos_name(angles.size(), target_), list));
    name_results(angles, sines + ".s", sines + ".c");
  }

  std::string fresh_name(Value v, const std::string& prefix) {
    const std::string& label = graph_.label(v);
    return label.empty() ? fresh_name(prefix) : local_names_.labelled(label);
  }

  std::string fresh_name(const std::string& prefix) { return local_names_.numbered(prefix); }

  Text form(const Node& node) {
    switch (node.op) {
      case Op::input:
        return {input_text(node.index), binds_atom};
      case Op::constant:
        return {literal(node.constant, target_), node.constant < 0 ? binds_unary : binds_atom};
      case Op::add:
        return infix(node, " + ", binds_sum);
      case Op::subtract:
        return infix(node, " - ", binds_sum);
      case Op::multiply:
        return infix(node, " * ", binds_product);
      case Op::divide:
        return infix(node, " / ", binds_product);
      case Op::negate:
        return {"-" + in_parentheses(node.a, binds_atom), binds_unary};
      case Op::power:
        return repeated_product(node);
      case Op::multiply_add:
        return fused(node, "", "");
      case Op::multiply_subtract:
        return fused(node, "", "-");
      case Op::subtract_product:
        return fused(node, "-", "");
      default:
        return call(node);
    }
  }

  Text infix(const Node& node, const char* sign, Binding binding) {
    return {in_parentheses(node.a, binding) + sign +
                in_parentheses(node.b, static_cast<Binding>(binding + 1)),
            binding};
  }

  Text repeated_product(const Node& node) {
    std::string product = in_parentheses(node.a, binds_product);
    for (int i = 1; i < node.index; ++i) product += " * " + in_parentheses(node.a, binds_unary);
    return {product, binds_product};
  }

  /// Signs are free: they become part of the instruction.
  Text fused(const Node& node, const char* sign_of_product, const char* sign_of_rest) {
    const auto with_sign = [this](const std::string& sign, Value v) {
      return sign.empty() ? text(v).text : sign + in_parentheses(v, binds_atom);
    };
    return {
        fmt::format("sinew_fma{}({}, {}, {})", target_.suffix(), with_sign(sign_of_product, node.a),
                    text(node.b).text, with_sign(sign_of_rest, node.c)),
        binds_atom};
  }

  /// The runtime's function, or the one copy of it in the file.
  std::string function_name(Op op, const std::string& function) const {
    const std::string shared = shared_name(op, target_);
    return names_.shared && !shared.empty() ? shared : function + target_.suffix();
  }

  Text call(const Node& node) {
    std::string arguments;
    for (int i = 0; i < arity(node.op); ++i)
      arguments += (i > 0 ? ", " : "") + text(node.operand(i)).text;
    return {fmt::format("{}({})", function_name(node.op, runtime_function(node.op)), arguments),
            binds_atom};
  }

  std::string in_parentheses(Value v, Binding least) {
    const Text& t = text(v);
    return t.binding >= least ? t.text : "(" + t.text + ")";
  }

  std::string input_text(int index) const {
    for (const Port& port : graph_.inputs) {
      if (index < port.size()) return names_.element(port, index);
      index -= port.size();
    }
    return "?";
  }

  void write_call(const Port& port) {
    std::vector<std::string> passed;
    for (Value v : port.values) passed.push_back(text(v).text);
    for (const std::string& line : names_.call(port, passed)) lines_.push_back(line);
  }

  /// A block of its own. What is carried is read before anything is assigned.
  void write_loop(const Loop& loop) {
    const LoopText text = loop_text(
        loop, graph_, target_,
        {[this](const std::string& prefix) { return fresh_name(prefix); },
         [this](Value v) { return this->text(v).text; }, [this](Value v) { return kept_[v]; }});
    for (const std::string& line : text.tables) lines_.push_back(line);
    for (std::size_t k = 0; k < loop.results.size(); ++k) {
      const LoopResult& result = loop.results[k];
      if (result.is_kept()) keep(result.kept, text.arrays[k]);
      if (!result.is_carried()) continue;
      lines_.push_back(fmt::format("{} {} = {};", target_.type(), text.results[k],
                                   this->text(result.first).text));
      this->text(result.last) = {text.results[k], binds_atom};
    }
    lines_.push_back(text.head);
    for (const std::string& line : text.copies) lines_.push_back("    " + line);
    for (const std::string& line : body_of(loop, text)) lines_.push_back("    " + line);
    lines_.push_back("}");
  }

  void keep(const std::vector<Value>& values, const std::string& array) {
    lines_.push_back(fmt::format("{} {}[{}];", target_.type(), array, values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      text(values[i]) = {fmt::format("{}[{}]", array, i), binds_atom};
      kept_[values[i]] = {array, static_cast<int>(i)};
    }
  }

  std::vector<std::string> body_of(const Loop& loop, const LoopText& text) {
    ArrayNames names = names_;
    names.stores_last = true;
    names.element = [&](const Port& port, int k) {
      const auto i = static_cast<std::size_t>(k);
      if (port.name == "result") return text.results[i];
      const LoopLeaf& leaf = loop.leaves[i];
      return leaf.kind == LoopLeaf::Kind::shared ? this->text(leaf.value).text : text.leaves[i];
    };
    const Plan plan = straight_plan(loop.body);
    return Writer(loop.body, plan, target_, names, local_names_).run();
  }

  const Graph& graph_;
  const Plan& plan_;
  const Target& target_;
  const ArrayNames& names_;
  std::vector<Text> texts_;
  LocalNames& local_names_;
  std::vector<std::string> lines_;
  std::map<Value, std::pair<std::string, int>> kept_;  ///< by loops: array and place
  std::size_t at_ = 0;                                 ///< the step being written
};

}  // namespace

ArrayNames array_names() {
  ArrayNames names{[](const Port& port, int element) {
    if (port.by_value) return port.name;
    return port.states.empty() ? fmt::format("{}[{}]", port.name, element) : "*" + port.name;
  }};
  names.int_statuses = true;
  return names;
}

bool stores_early(const Graph& graph) {
  constexpr std::size_t most_results = 16;  // registers of a vector machine
  return graph.results().size() > most_results;
}

bool reads_port(const Graph& graph, const std::string& name) {
  int first = 0;
  for (const Port& port : graph.inputs) {
    if (port.name == name) {
      for (const Node& node : graph.nodes())
        if (node.op == Op::input && node.index >= first && node.index < first + port.size())
          return true;
      return false;
    }
    first += port.size();
  }
  return false;
}

std::vector<std::string> statements(const Graph& graph, const Plan& plan, const Target& target,
                                    const ArrayNames& names) {
  LocalNames local_names(graph, target);
  return Writer(graph, plan, target, names, local_names).run();
}

}  // namespace sinew
