// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/unify.h"

#include <algorithm>
#include <cmath>

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

bool is_addition(const Node& node) {
  return node.op == Op::add || node.op == Op::subtract;
}

/// The forms of an operation's operands, 0 where it has fewer.
template <class FormsOf>
std::array<std::uint64_t, 3> operand_forms(const Node& node, const FormsOf& forms) {
  std::array<std::uint64_t, 3> operands{};
  for (int i = 0; i < arity(node.op); ++i)
    operands[static_cast<std::size_t>(i)] = forms[static_cast<std::size_t>(node.operand(i))];
  return operands;
}

std::uint64_t mixed_with(std::uint64_t h, const Node& node,
                         const std::array<std::uint64_t, 3>& operands) {
  if (node.op == Op::power) h = mixed(h, static_cast<std::uint64_t>(node.index));
  for (int i = 0; i < arity(node.op); ++i) h = mixed(h, operands[static_cast<std::size_t>(i)]);
  return h;
}

/// `forms[v]`: of the operands.
template <class FormsOf>
std::uint64_t form_of(const Graph& graph, const Node& node, const FormsOf& forms) {
  if (const Value scaled = scaled_operand(graph, node); scaled != no_value)
    return forms[static_cast<std::size_t>(scaled)];
  std::array<std::uint64_t, 3> operands = operand_forms(node, forms);
  if (is_commutative(node.op) || is_addition(node))
    std::sort(operands.begin(), operands.begin() + arity(node.op));
  const Op op = is_addition(node) ? Op::add : node.op;
  return mixed_with(mixed(1, static_cast<std::uint64_t>(op) + 1), node, operands);
}

}  // namespace

Value scaled_operand(const Graph& graph, const Node& node) {
  if (node.op == Op::negate) return node.a;
  if (node.op != Op::multiply || graph.is_constant(node.a) == graph.is_constant(node.b))
    return no_value;
  return graph.is_constant(node.a) ? node.b : node.a;
}

Forms exact_forms_of(const Graph& graph, const KeptValues& kept) {
  Forms forms;
  for (Value v = 0; v < graph.size(); ++v) {
    const auto place = kept.find(v);
    if (place != kept.end()) {
      forms.push_back(mixed(3, static_cast<std::uint64_t>(place->second.array)));
      continue;
    }
    const Node& node = graph[v];
    std::array<std::uint64_t, 3> operands = operand_forms(node, forms);
    if (is_commutative(node.op)) std::sort(operands.begin(), operands.begin() + arity(node.op));
    forms.push_back(mixed_with(mixed(4, static_cast<std::uint64_t>(node.op) + 1), node, operands));
  }
  return forms;
}

Forms forms_of(const Graph& graph, const KeptValues& kept) {
  Forms forms;
  for (Value v = 0; v < graph.size(); ++v) {
    const auto place = kept.find(v);
    forms.push_back(place == kept.end()
                        ? form_of(graph, graph[v], forms)
                        : mixed(3, static_cast<std::uint64_t>(place->second.array)));
  }
  return forms;
}

void FormsGiven::give(const Graph& graph, Value leaf, Value last) {
  if (leaf > last) return;
  std::vector<bool> needs_it(static_cast<std::size_t>(last - leaf) + 1, false);
  changed_[static_cast<std::size_t>(leaf)] = mixed(2, 0);
  needs_it[0] = true;
  for (Value v = leaf + 1; v <= last; ++v) {
    const Node& node = graph[v];
    bool needs = false;
    for (int i = 0; i < arity(node.op); ++i) {
      const Value operand = node.operand(i);
      needs = needs || (operand >= leaf && needs_it[static_cast<std::size_t>(operand - leaf)]);
    }
    if (!needs) continue;
    needs_it[static_cast<std::size_t>(v - leaf)] = true;
    changed_[static_cast<std::size_t>(v)] = form_of(graph, node, *this);
  }
}

LoopBuilder::LoopBuilder(const Graph& graph, const Forms& forms, const KeptValues& kept,
                         const std::set<Value>& read, int count)
    : graph_(graph),
      kept_(kept),
      read_(read),
      forms_(static_cast<std::size_t>(count), FormsGiven(forms)) {
  loop.count = count;
  loop.body.name = graph.name;
  loop.body.inputs = {{"leaf", 0, 1, "", "", {}, {}}};
  loop.body.outputs = {{"result", 0, 1, "", "", {}, {}}};
}

void LoopBuilder::carry(Value first, const Column& column) {
  LoopLeaf before;
  before.kind = LoopLeaf::Kind::carried;
  before.result = static_cast<int>(loop.results.size());
  loop.results.push_back({0, {}, first, column.back(), {}});
  columns_.push_back(column);
  Column entry{first};
  entry.insert(entry.end(), column.begin(), column.end() - 1);
  known_[entry] = leaf(before);
  entries_.push_back(entry);
}

void LoopBuilder::store(const Column& column, int port, const std::vector<int>& elements) {
  loop.results.push_back({port, elements, no_value, no_value, {}});
  columns_.push_back(column);
}

void LoopBuilder::keep(const Column& column) {
  loop.results.push_back({0, {}, no_value, no_value, column});
  columns_.push_back(column);
}

void LoopBuilder::keep_only(const std::set<Column>& columns) {
  Port& results = loop.body.outputs[0];
  for (std::size_t k = loop.results.size(); k-- > 0;) {
    if (!loop.results[k].is_kept()) continue;  // what is carried comes first and stays in its place
    loop.results.erase(loop.results.begin() + static_cast<std::ptrdiff_t>(k));
    results.values.erase(results.values.begin() + static_cast<std::ptrdiff_t>(k));
  }
  for (const Column& column : columns) {
    keep(column);
    results.values.push_back(known_.at(column));
  }
  results.rows = static_cast<int>(results.values.size());
}

std::map<Value, Column> LoopBuilder::columns() const {
  std::map<Value, Column> all;
  for (const auto& [column, value] : known_)
    if (value != no_value && arity(loop.body[value].op) > 0) all[value] = column;
  return all;
}

/// What a pass is asked for is no later than its results.
void LoopBuilder::set_forms() {
  for (std::size_t pass = 0; pass < forms_.size(); ++pass) {
    Value last = no_value;
    for (const Column& column : columns_) last = std::max(last, column[pass]);
    for (const Column& entry : entries_) forms_[pass].give(graph_, entry[pass], last);
  }
}

bool LoopBuilder::build() {
  set_forms();
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
  const Value made = make(column);
  return known_[column] = made;
}

Value LoopBuilder::make(const Column& column) {
  const bool same =
      std::all_of(column.begin(), column.end(), [&](Value v) { return v == column[0]; });
  const auto all = [&](const auto& fits) {
    return std::all_of(column.begin(), column.end(), [&](Value v) { return fits(graph_[v]); });
  };
  if (same && graph_.is_constant(column[0])) return loop.body.constant(graph_[column[0]].constant);
  if (same) return leaf({LoopLeaf::Kind::shared, column[0]});
  if (all([](const Node& node) { return node.op == Op::constant; }))
    return constants(Scales(column.size(), 1.0), column);
  if (all([](const Node& node) { return node.op == Op::input; })) return unify_inputs(column);
  if (is_kept(column)) return leaf({LoopLeaf::Kind::kept, no_value, column});
  Column bases = column;
  const Scales scales = taken_out(bases);
  const bool one_base =
      std::all_of(bases.begin(), bases.end(), [&](Value v) { return v == bases[0]; });
  if (!one_base && is_choice(column)) return chosen(column);
  if (bases != column) return scaled(scales, unify(bases));
  const Op op = graph_[column[0]].op;
  if (all([&](const Node& node) { return node.op == op; }) ||
      all([](const Node& node) { return is_addition(node); }))
    return unify_operands(column);
  return no_value;
}

/// The factors of a column's values; `column` keeps what they multiply. A product with 1 or -1 has
/// no rounding.
LoopBuilder::Scales LoopBuilder::taken_out(Column& column) const {
  Scales scales;
  for (std::size_t pass = 0; pass < column.size(); ++pass) {
    double scale = 1.0;
    while (std::abs(scale) == 1.0 && !is_carried(pass, column[pass])) {
      const Node& node = graph_[column[pass]];
      const Value rest = scaled_operand(graph_, node);
      if (rest == no_value) break;
      scale *= node.op == Op::negate ? -1.0 : graph_[rest == node.a ? node.b : node.a].constant;
      column[pass] = rest;
    }
    scales.push_back(scale);
  }
  return scales;
}

bool LoopBuilder::is_kept(const Column& column) const {
  const auto first = kept_.find(column[0]);
  return first != kept_.end() && std::all_of(column.begin(), column.end(), [&](Value v) {
           const auto place = kept_.find(v);
           return place != kept_.end() && place->second.array == first->second.array;
         });
}

/// Whether passes share values, or others need them, too: each is computed once, then.
bool LoopBuilder::is_choice(const Column& column) const {
  const std::set<Value> distinct(column.begin(), column.end());
  return distinct.size() < column.size() ||
         std::all_of(distinct.begin(), distinct.end(), [&](Value v) { return read_.count(v) > 0; });
}

Value LoopBuilder::chosen(const Column& column) {
  LoopLeaf choice{LoopLeaf::Kind::chosen};
  for (Value v : column) {
    auto place = std::find(choice.choices.begin(), choice.choices.end(), v);
    if (place == choice.choices.end()) place = choice.choices.insert(choice.choices.end(), v);
    choice.places.push_back(static_cast<int>(place - choice.choices.begin()));
  }
  return leaf(choice);
}

Value LoopBuilder::scaled(const Scales& scales, Value base) {
  if (base == no_value) return no_value;
  const bool same =
      std::all_of(scales.begin(), scales.end(), [&](double s) { return s == scales[0]; });
  if (same && scales[0] == 1.0) return base;
  if (same && scales[0] == -1.0) return loop.body.make(Op::negate, base);
  const Value scale = same ? loop.body.constant(scales[0]) : leaf_of(scales);
  return loop.body.make(Op::multiply, scale, base);
}

Value LoopBuilder::leaf_of(const Scales& scales) {
  const auto found = tables_.find(scales);
  if (found != tables_.end()) return found->second;
  LoopLeaf table{LoopLeaf::Kind::constant};
  table.constants = scales;
  return tables_[scales] = leaf(table);
}

Value LoopBuilder::constants(Scales signs, const Column& column) {
  for (std::size_t pass = 0; pass < column.size(); ++pass)
    signs[pass] *= graph_[column[pass]].constant;
  return leaf_of(signs);
}

/// A term of a sum that has another sign in other passes: the sign becomes part of a constant
/// factor, where there is one.
LoopBuilder::Term LoopBuilder::unify_term(const Column& column, const Scales& signs) {
  const auto all = [&](double sign) {
    return std::all_of(signs.begin(), signs.end(), [&](double s) { return s == sign; });
  };
  if (all(1.0) || all(-1.0)) return {unify(column), signs[0] < 0.0};
  const auto key = std::make_pair(column, signs);
  if (const auto found = known_terms_.find(key); found != known_terms_.end()) return found->second;
  return known_terms_[key] = signed_value(column, signs);
}

/// A product takes the sign into a factor that has a constant factor itself; no_value where no
/// factor has.
LoopBuilder::Term LoopBuilder::signed_product(const Column& column, const Scales& signs) {
  const auto is_product = [&](Value v) {
    return graph_[v].op == Op::multiply && scaled_operand(graph_, graph_[v]) == no_value;
  };
  if (!std::all_of(column.begin(), column.end(), is_product)) return {};
  std::array<Column, 2> factors;
  for (std::size_t pass = 0; pass < column.size(); ++pass) {
    const Node& node = graph_[column[pass]];
    const bool swapped = is_swapped(pass, graph_[column[0]], node);
    factors[0].push_back(swapped ? node.b : node.a);
    factors[1].push_back(swapped ? node.a : node.b);
  }
  for (const std::size_t place : {0U, 1U}) {
    Column bases = factors[place];
    const Scales scales = taken_out(bases);
    if (std::any_of(scales.begin(), scales.end(), [](double s) { return std::abs(s) == 1.0; }))
      continue;
    const Term factor = unify_term(factors[place], signs);
    const Value other = unify(factors[1 - place]);
    if (factor.value == no_value || other == no_value) return {};
    return {loop.body.make(Op::multiply, factor.value, other), factor.negative};
  }
  return {};
}

/// One of two columns that differ in all signs is the other one, subtracted.
LoopBuilder::Term LoopBuilder::signed_value(const Column& column, Scales signs) {
  if (const Term product = signed_product(column, signs); product.value != no_value) return product;
  Column bases = column;
  const bool constant = std::all_of(column.begin(), column.end(),
                                    [&](Value v) { return graph_[v].op == Op::constant; });
  const Scales scales = constant ? Scales(column.size(), 1.0) : taken_out(bases);
  const double first = constant ? graph_[column[0]].constant : scales[0];
  const bool negative = first * signs[0] < 0.0;
  for (std::size_t pass = 0; pass < scales.size(); ++pass)
    signs[pass] *= negative ? -scales[pass] : scales[pass];
  return {constant ? constants(signs, column) : scaled(signs, unify(bases)), negative};
}

bool LoopBuilder::is_carried(std::size_t pass, Value v) const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Column& entry) { return entry[pass] == v; });
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
  if (!is_commutative(node.op) && !is_addition(node)) return false;
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
  std::array<Column, 3> operands;
  std::array<Scales, 3> signs;
  for (std::size_t pass = 0; pass < column.size(); ++pass) {
    const Node& node = graph_[column[pass]];
    if (node.index != model.index) return no_value;
    const bool swapped = is_swapped(pass, model, node);
    for (int i = 0; i < arity(model.op); ++i) {
      const int place = swapped && i < 2 ? 1 - i : i;
      operands[static_cast<std::size_t>(i)].push_back(node.operand(place));
      signs[static_cast<std::size_t>(i)].push_back(node.op == Op::subtract && place == 1 ? -1.0
                                                                                         : 1.0);
    }
  }
  const Value value = is_addition(model) ? make_sum(operands, signs) : make_node(model, operands);
  if (value != no_value) set_label(value, column);
  return value;
}

Value LoopBuilder::make_sum(const std::array<Column, 3>& operands,
                            const std::array<Scales, 3>& signs) {
  const Term a = unify_term(operands[0], signs[0]);  // first, whatever compiler it is
  const Term b = unify_term(operands[1], signs[1]);
  if (a.value == no_value || b.value == no_value) return no_value;
  if (a.negative && b.negative) {
    const Value minus_a = loop.body.make(Op::negate, a.value);
    return loop.body.make(Op::subtract, minus_a, b.value);
  }
  if (a.negative) return loop.body.make(Op::subtract, b.value, a.value);
  return loop.body.make(b.negative ? Op::subtract : Op::add, a.value, b.value);
}

Value LoopBuilder::make_node(const Node& model, const std::array<Column, 3>& operands) {
  Node made;
  made.op = model.op;
  made.index = model.index;
  for (int i = 0; i < arity(model.op); ++i) {
    made.operand(i) = unify(operands[static_cast<std::size_t>(i)]);
    if (made.operand(i) == no_value) return no_value;
  }
  return loop.body.add(made);
}

void LoopBuilder::set_label(Value made, const Column& column) {
  std::vector<std::string> labels;
  for (Value v : column) labels.push_back(graph_.label(v));
  loop.body.set_label(made, common_label(labels));
}

}  // namespace sinew
