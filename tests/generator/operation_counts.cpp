// SPDX-License-Identifier: GPL-3.0-or-later
// Operations counted on the graph are those that stand in the emitted C; dumps show every value.
#include <catch2/catch.hpp>

#include <regex>
#include <set>
#include <sstream>

#include "generator/assemble.h"
#include "generator/cost.h"
#include "generator/dump.h"
#include "generator/lower.h"
#include "generator/statements.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/tendons/functions.h"
#include "tests/generator/every_operation.h"
#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

using namespace sinew;

namespace {

int matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return static_cast<int>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator()));
}

std::string body_of(const Graph& graph) {
  std::string text;
  for (const std::string& line : statements(graph, straight_plan(graph), Target{}, array_names()))
    text += line + "\n";
  return text;
}

std::vector<Graph> samples() {
  std::vector<Function> functions =
      functions_of(read_mechanism(SINEW_SOURCE_DIR "/models/index"), emitted_cost);
  functions.push_back(every_operation());
  return assemble({"sample", "", "", {}}, functions, Target{}).functions;
}

bool dot_is_installed() {
  std::string output;
  try {
    return reference::run_program({"dot", "-V"}, output) == 0;
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// Mistakes of a dot text: edges between undeclared nodes, unbalanced braces or quotes.
std::vector<std::string> dot_mistakes(const std::string& dot) {
  static const std::regex node(R"(^\s*("[^"]*"|\w+) \[(?:[^"\]]|"[^"]*")*\];$)");
  static const std::regex edge(R"(^\s*("[^"]*"|\w+) -> ("[^"]*"|\w+);$)");
  std::set<std::string> declared;
  std::vector<std::string> mistakes, ends;
  std::istringstream lines(dot);
  std::string line;
  if (!std::getline(lines, line) || !std::regex_match(line, std::regex(R"(digraph \w+ \{)")))
    mistakes.push_back("opens with: " + line);
  bool closed = false;
  while (std::getline(lines, line)) {
    std::smatch match;
    if (closed) mistakes.push_back("after the end: " + line);
    if (line == "}")
      closed = true;
    else if (std::regex_match(line, match, node))
      declared.insert(match[1]);
    else if (std::regex_match(line, match, edge))
      ends.insert(ends.end(), {match[1], match[2]});
    else
      mistakes.push_back("not understood: " + line);
  }
  if (!closed) mistakes.push_back("not closed");
  for (const std::string& end : ends)
    if (!declared.count(end)) mistakes.push_back("undeclared: " + end);
  return mistakes;
}

}  // namespace

TEST_CASE("what is counted is what the C says") {
  for (const Graph& graph : samples()) {
    const std::string body = body_of(graph);
    const Cost cost = count_operations(graph);
    INFO(graph.name << "\n" << body);
    CHECK(matches(body, R"( \* )") == cost.multiply);
    CHECK(matches(body, R"( [-+] )") == cost.add);
    CHECK(matches(body, R"( / )") == cost.divide);
    CHECK(matches(body, R"(sinew_sqrt\()") == cost.square_root);
    CHECK(matches(body, R"(sinew_sincos\()") + 2 * matches(body, R"(sinew_sincos2\()") +
              4 * matches(body, R"(sinew_sincos4\()") ==
          cost.sincos);
  }
}

TEST_CASE("a dump as text has one line a value and the names of inputs and results") {
  for (const Graph& graph : samples()) {
    const std::string text = dump_text(graph);
    CHECK(text.rfind("function " + graph.name + "\n", 0) == 0);
    CHECK(matches(text, R"(%[0-9]+ = [a-z])") == graph.size());
    for (const Port& port : graph.outputs)
      CHECK(text.find(port.name + "[" + std::to_string(port.size() - 1) + "] = %") !=
            std::string::npos);
  }
}

TEST_CASE("a dump as dot is a graph") {
  const bool dot = dot_is_installed();
  if (!dot) test::skip("Graphviz's dot is not installed: only the test's own reading is done");
  for (const Graph& graph : samples()) {
    const std::string text = dump_dot(graph);
    INFO(graph.name);
    CHECK(dot_mistakes(text) == std::vector<std::string>{});
    if (!dot) continue;
    const reference::TemporaryFolder place;
    reference::write_text(place.path() / "graph.dot", text);
    std::string output;
    CHECK(reference::run_program(
              {"dot", "-Tplain", "-o", "/dev/null", (place.path() / "graph.dot").string()},
              output) == 0);
  }
}

TEST_CASE("planted: a dot text with a node or a brace too few is found") {
  const std::string text = dump_dot(lower(every_operation()));
  CHECK(dot_mistakes(text).empty());
  CHECK(!dot_mistakes(text.substr(0, text.size() - 2)).empty());
  const std::size_t node = text.find("  v3 ["), end = text.find('\n', node);
  std::string fewer = text;
  fewer.erase(node, end - node + 1);
  CHECK(!dot_mistakes(fewer).empty());
}
