// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/loop_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/literal.h"

namespace sinew {
namespace {

constexpr std::size_t longest_line = 92;

class LoopTextMaker {
 public:
  LoopTextMaker(const Loop& loop, const Graph& graph, const Target& target,
                const LoopSurroundings& around)
      : loop_(loop), graph_(graph), target_(target), around_(around), index_(fresh("i")) {}

  LoopText run() {
    text_.head = fmt::format("for (int {0} = 0; {0} < {1}; ++{0}) {{", index_, loop_.count);
    for (const LoopResult& result : loop_.results) {
      text_.arrays.push_back(result.is_kept() ? fresh("kept") : "");
      text_.results.push_back(result_text(result));
    }
    const std::string constants = table_of_constants();
    for (const LoopLeaf& leaf : loop_.leaves) text_.leaves.push_back(leaf_text(leaf, constants));
    return std::move(text_);
  }

 private:
  std::string fresh(const std::string& prefix) const { return around_.fresh(prefix); }

  std::string result_text(const LoopResult& result) {
    if (result.is_carried()) return fresh("sum");
    if (result.is_kept()) return fmt::format("{}[{}]", text_.arrays.back(), index_);
    return element(graph_.outputs[static_cast<std::size_t>(result.port)].name, result.elements);
  }

  std::string leaf_text(const LoopLeaf& leaf, const std::string& constants) {
    switch (leaf.kind) {
      case LoopLeaf::Kind::shared:
        return "";
      case LoopLeaf::Kind::chosen:
        return choice(leaf);
      case LoopLeaf::Kind::kept:
        return kept(leaf);
      case LoopLeaf::Kind::constant:
        return columns_.size() == 1
                   ? fmt::format("{}[{}]", constants, index_)
                   : fmt::format("{}[{}][{}]", constants, index_, columns_.at(leaf.constants));
      case LoopLeaf::Kind::input:
        return input(leaf.inputs);
      case LoopLeaf::Kind::carried:
        break;
    }
    const std::string& variable = text_.results[static_cast<std::size_t>(leaf.result)];
    const auto carried = std::count_if(loop_.results.begin(), loop_.results.end(),
                                       [](const LoopResult& r) { return r.is_carried(); });
    if (carried == 1 && loop_.results.back().is_carried()) return variable;  // assigned last
    const std::string copy = fresh("before");
    text_.copies.push_back(fmt::format("const {} {} = {};", target_.type(), copy, variable));
    return copy;
  }

  /// One row a pass; equal columns stand once.
  std::string table_of_constants() {
    std::vector<const std::vector<double>*> order;
    for (const LoopLeaf& leaf : loop_.leaves)
      if (leaf.kind == LoopLeaf::Kind::constant &&
          columns_.emplace(leaf.constants, columns_.size()).second)
        order.push_back(&leaf.constants);
    if (order.empty()) return "";
    std::vector<std::string> rows;
    for (std::size_t pass = 0; pass < static_cast<std::size_t>(loop_.count); ++pass) {
      std::string row;
      for (const std::vector<double>* column : order)
        row += (row.empty() ? "" : ", ") + literal((*column)[pass], target_);
      rows.push_back(order.size() == 1 ? row : "{" + row + "}");
    }
    const std::string name = fresh("table");
    const std::string width = order.size() == 1 ? "" : fmt::format("[{}]", order.size());
    write_table(fmt::format("{} {}[{}]{}", target_.type(), name, loop_.count, width), rows);
    return name;
  }

  void write_table(const std::string& declaration, const std::vector<std::string>& entries) {
    write_array("static const " + declaration, entries);
  }

  void write_array(const std::string& declaration, const std::vector<std::string>& entries) {
    std::string line = declaration + " = {";
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::string entry = entries[i] + (i + 1 < entries.size() ? "," : "};");
      if (line.size() + entry.size() + 1 > longest_line) {
        text_.tables.push_back(line);
        line = "   ";
      }
      line += (line.back() == '{' ? "" : " ") + entry;
    }
    text_.tables.push_back(line);
  }

  /// The values in an array, and for each pass the place in it. They may be in an array already.
  std::string choice(const LoopLeaf& leaf) {
    const std::string array = around_.kept(leaf.choices[0]).first;
    std::vector<int> places;
    for (Value v : leaf.choices) {
      if (around_.kept(v).first != array || array.empty()) return new_choice(leaf);
      places.push_back(around_.kept(v).second);
    }
    std::vector<int> elements;
    for (int place : leaf.places) elements.push_back(places[static_cast<std::size_t>(place)]);
    return element(array, elements);
  }

  std::string new_choice(const LoopLeaf& leaf) {
    const std::string name = fresh("choice");
    std::vector<std::string> entries;
    for (Value v : leaf.choices) entries.push_back(around_.text(v));
    write_array(fmt::format("const {} {}[{}]", target_.type(), name, entries.size()), entries);
    return element(name, leaf.places);
  }

  std::string kept(const LoopLeaf& leaf) {
    std::vector<int> places;
    for (Value v : leaf.choices) places.push_back(around_.kept(v).second);
    return element(around_.kept(leaf.choices[0]).first, places);
  }

  std::string input(std::vector<int> elements) {
    for (const Port& port : graph_.inputs) {
      if (elements.front() < port.size()) return element(port.name, elements);
      for (int& each : elements) each -= port.size();
    }
    return "?";
  }

  /// name[3 * i + 5]; by a table where the elements are not evenly spaced.
  std::string element(const std::string& name, const std::vector<int>& elements) {
    const int first = elements[0], step = elements[1] - elements[0];
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (elements[i] != first + static_cast<int>(i) * step || step < 1)
        return fmt::format("{}[{}[{}]]", name, table_of_elements(elements), index_);
    const std::string scaled = step == 1 ? index_ : fmt::format("{} * {}", step, index_);
    return first == 0 ? fmt::format("{}[{}]", name, scaled)
                      : fmt::format("{}[{} + {}]", name, first, scaled);
  }

  std::string table_of_elements(const std::vector<int>& elements) {
    std::string& name = element_tables_[elements];
    if (!name.empty()) return name;
    name = fresh("element");
    std::vector<std::string> entries;
    for (int each : elements) entries.push_back(std::to_string(each));
    write_table(fmt::format("unsigned short {}[{}]", name, loop_.count), entries);
    return name;
  }

  const Loop& loop_;
  const Graph& graph_;
  const Target& target_;
  const LoopSurroundings& around_;
  std::string index_;
  LoopText text_;
  std::map<std::vector<double>, std::size_t> columns_;  ///< place in a row
  std::map<std::vector<int>, std::string> element_tables_;
};

}  // namespace

LoopText loop_text(const Loop& loop, const Graph& graph, const Target& target,
                   const LoopSurroundings& around) {
  return LoopTextMaker(loop, graph, target, around).run();
}

}  // namespace sinew
