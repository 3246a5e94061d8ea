// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/unify.h"

#include <algorithm>

namespace sinew {
namespace {

std::uint64_t mixed(std::uint64_t h, std::uint64_t x) {
  h = (h ^ x) * 0x9e3779b97f4a7c15ULL;
  return h ^ (h >> 29);
}

/// "strand_3_x", "strand_4_x" -> "strand_x": the parts that all labels have; empty where they have
/// different numbers of parts.
std::string common_label(const std::vector<std::string>& labels) {
  const auto parts_of = [](const std::string& label) {
    std::vector<std::string> parts(1);
    for (char c : label)
      if (c == '_')
        parts.emplace_back();
      else
        parts.back() += c;
    return parts;
  };
  std::vector<std::string> common = parts_of(labels.front());
  for (const std::string& label : labels) {
    const std::vector<std::string> parts = parts_of(label);
    if (parts.size() != common.size()) return "";
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i] != common[i]) common[i].clear();
  }
  std::string text;
  for (const std::string& part : common)
    if (!part.empty()) text += (text.empty() ? "" : "_") + part;
  const bool is_name = !text.empty() && !(text[0] >= '0' && text[0] <= '9');
  return is_name ? text : "";
}

std::uint64_t form_of(const Node& node, const Forms& forms) {
  std::vector<std::uint64_t> operands;
  for (int i = 0; i < arity(node.op); ++i)
    operands.push_back(forms[static_cast<std::size_t>(node.operand(i))]);
  if (is_commutative(node.op)) std::sort(operands.begin(), operands.end());
  std::uint64_t h = mixed(1, static_cast<std::uint64_t>(node.op) + 1);
  if (node.op == Op::power) h = mixed(h, static_cast<std::uint64_t>(node.index));
  for (std::uint64_t operand : operands) h = mixed(h, operand);
  return h;
}

}  // namespace

Forms forms_of(const Graph& graph) {
  Forms forms;
  for (Value v = 0; v < graph.size(); ++v) forms.push_back(form_of(graph[v], forms));
  return forms;
}

Forms forms_given(const Graph& graph, Forms forms, Value leaf) {
  std::vector<bool> changed(forms.size(), false);
  forms[static_cast<std::size_t>(leaf)] = mixed(2, 0);
  changed[static_cast<std::size_t>(leaf)] = true;
  for (Value v = leaf + 1; v < graph.size(); ++v) {
    const Node& node = graph[v];
    for (int i = 0; i < arity(node.op); ++i)
      if (changed[static_cast<std::size_t>(node.operand(i))])
        changed[static_cast<std::size_t>(v)] = true;
    if (changed[static_cast<std::size_t>(v)])
      forms[static_cast<std::size_t>(v)] = form_of(node, forms);
  }
  return forms;
}

LoopBuilder::LoopBuilder(const Graph& graph, const Forms& forms, int count)
    : graph_(graph), forms_(static_cast<std::size_t>(count), forms) {
  loop.count = count;
  loop.body.name = graph.name;
  loop.body.inputs = {{"leaf", 0, 1, "", "", {}, {}}};
  loop.body.outputs = {{"result", 0, 1, "", "", {}, {}}};
}

void LoopBuilder::carry(Value first, const Column& column) {
  LoopLeaf before;
  before.kind = LoopLeaf::Kind::carried;
  before.result = static_cast<int>(loop.results.size());
  loop.results.push_back({0, {}, first, column.back()});
  columns_.push_back(column);
  Column entry{first};
  entry.insert(entry.end(), column.begin(), column.end() - 1);
  for (std::size_t pass = 0; pass < entry.size(); ++pass)
    forms_[pass] = forms_given(graph_, std::move(forms_[pass]), entry[pass]);
  known_[entry] = leaf(before);
}

void LoopBuilder::store(const Column& column, int port, const std::vector<int>& elements) {
  loop.results.push_back({port, elements, no_value, no_value});
  columns_.push_back(column);
}

bool LoopBuilder::build() {
  Port& results = loop.body.outputs[0];
  for (const Column& column : columns_) {
    const Value made = unify(column);
    if (made == no_value) return false;
    results.values.push_back(made);
  }
  results.rows = static_cast<int>(results.values.size());
  loop.body.inputs[0].rows = static_cast<int>(loop.leaves.size());
  return true;
}

Value LoopBuilder::leaf(LoopLeaf leaf) {
  loop.leaves.push_back(std::move(leaf));
  return loop.body.input(static_cast<int>(loop.leaves.size()) - 1);
}

Value LoopBuilder::unify(const Column& column) {
  const auto found = known_.find(column);
  if (found != known_.end()) return found->second;
  const bool same =
      std::all_of(column.begin(), column.end(), [&](Value v) { return v == column[0]; });
  const auto all = [&](Op op) {
    return std::all_of(column.begin(), column.end(), [&](Value v) { return graph_[v].op == op; });
  };
  Value made = no_value;
  if (same && graph_.is_constant(column[0])) {
    made = loop.body.constant(graph_[column[0]].constant);
  } else if (same) {
    made = leaf({LoopLeaf::Kind::shared, column[0]});
  } else if (all(Op::constant)) {
    LoopLeaf constants{LoopLeaf::Kind::constant};
    for (Value v : column) constants.constants.push_back(graph_[v].constant);
    made = leaf(constants);
  } else if (all(Op::input)) {
    made = unify_inputs(column);
  } else if (all(graph_[column[0]].op)) {
    made = unify_operands(column);
  }
  return known_[column] = made;
}

Value LoopBuilder::unify_inputs(const Column& column) {
  int first = 0;
  LoopLeaf inputs{LoopLeaf::Kind::input};
  for (Value v : column) inputs.inputs.push_back(graph_[v].index);
  for (const Port& port : graph_.inputs) {
    if (std::all_of(inputs.inputs.begin(), inputs.inputs.end(),
                    [&](int i) { return i >= first && i < first + port.size(); }))
      return leaf(inputs);
    first += port.size();
  }
  return no_value;
}

bool LoopBuilder::is_swapped(std::size_t pass, const Node& model, const Node& node) const {
  if (!is_commutative(node.op)) return false;
  const auto matches = [&](Value a, Value b) {
    const auto form = [this](std::size_t p, Value v) {
      return forms_[p][static_cast<std::size_t>(v)];
    };
    return form(pass, a) == form(0, model.a) && form(pass, b) == form(0, model.b);
  };
  if (!matches(node.b, node.a)) return false;
  return !matches(node.a, node.b) || node.b == model.a || node.a == model.b;
}

Value LoopBuilder::unify_operands(const Column& column) {
  const Node& model = graph_[column[0]];
  Node made;
  made.op = model.op;
  made.index = model.index;
  for (int i = 0; i < arity(model.op); ++i) {
    Column operands;
    for (std::size_t pass = 0; pass < column.size(); ++pass) {
      const Node& node = graph_[column[pass]];
      if (node.index != model.index) return no_value;
      const int place = is_swapped(pass, model, node) && i < 2 ? 1 - i : i;
      operands.push_back(node.operand(place));
    }
    made.operand(i) = unify(operands);
    if (made.operand(i) == no_value) return no_value;
  }
  const Value value = loop.body.add(made);
  set_label(value, column);
  return value;
}

void LoopBuilder::set_label(Value made, const Column& column) {
  std::vector<std::string> labels;
  for (Value v : column) labels.push_back(graph_.label(v));
  loop.body.set_label(made, common_label(labels));
}

}  // namespace sinew
