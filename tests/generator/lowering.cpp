// SPDX-License-Identifier: GPL-3.0-or-later
// Lowering: one form in every process, one form for both signs, and a clear word about what has
// none.
#include <catch2/catch.hpp>

#include <cmath>
#include <set>

#include "generator/cost.h"
#include "generator/dump.h"
#include "generator/evaluate.h"
#include "generator/lower.h"
#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

using namespace sinew;
using GiNaC::ex;
using GiNaC::symbol;

namespace {

const symbol x("x"), y("y"), z("z");

Function function_of(const ex& value) {
  Function function;
  function.name = "test";
  function.inputs = {{"q", 3, 1, {x, y, z}, "", "", {}}};
  function.outputs = {{"r", 1, 1, {value}, "", ""}};
  return function;
}

std::string form(const ex& value) {
  return dump_text(lower(function_of(value)));
}

/// What lowering says about an expression that it cannot lower.
std::string refusal(const Function& function) {
  try {
    lower(function);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

std::set<std::string> forms_in_processes(int count, const std::string& option) {
  std::set<std::string> forms;
  for (int i = 0; i < count; ++i) {
    std::string output;
    REQUIRE(reference::run_program({SINEW_LOWERING_KEY, option}, output) == 0);
    forms.insert(output);
  }
  return forms;
}

bool addresses_are_random() {
  return reference::read_text("/proc/sys/kernel/randomize_va_space")[0] != '0';
}

}  // namespace

TEST_CASE("nine GiNaC operations lower to one form in 30 processes") {
  if (!addresses_are_random()) test::skip("this kernel does not randomise addresses");
  const std::set<std::string> forms = forms_in_processes(30, "--lowered");
  CHECK(forms.size() == 1);
  const std::string& form = *forms.begin();
  for (const char* name : {"diff", "expand", "collect", "normal", "factor", "subs", "inverse",
                           "solve", "det", "reappearing"})
    CHECK(form.find(std::string("function ") + name) != std::string::npos);
}

TEST_CASE("control: GiNaC's own order does change from process to process") {
  if (!addresses_are_random()) return test::skip("this kernel does not randomise addresses");
  CHECK(forms_in_processes(30, "--ginac").size() > 1);
}

TEST_CASE("the first term of a sum is positive, whatever sign the derivation met first") {
  const auto body = [](const ex& value) {
    const std::string text = form(value);
    return text.substr(0, text.find("r[0]"));
  };
  CHECK(form(x - y) == form(-(y - x)));
  CHECK(form((x - y) * (y - z)) == form((y - x) * (z - y)));
  CHECK(form(sin(x - y)) == form(-sin(y - x)));
  CHECK(form(cos(x - y)) == form(cos(y - x)));
  CHECK(form(pow(y - x, 2)) == form(pow(x - y, 2)));
  CHECK(form(pow(y - x, 3)) == form(-pow(x - y, 3)));
  CHECK(form(1 / (y - x)) == form(-1 / (x - y)));
  CHECK(form(abs(y - x)) == form(abs(x - y)));
  // Both differences are one value; only the result's sign differs.
  CHECK(body(y - x).rfind(body(x - y), 0) == 0);
  CHECK(count_operations(lower(function_of((x - y) * (y - x) + cos(x - y)))).add == 2);
}

TEST_CASE("constants are the nearest doubles, exact or transcendental") {
  const auto value_of = [](const ex& value) {
    return evaluate<double>(lower(function_of(value)), {0, 0, 0})[0];
  };
  CHECK(value_of(GiNaC::numeric(1, 3)) == 1.0 / 3.0);
  CHECK(value_of(GiNaC::numeric(-1, 10)) == -0.1);
  CHECK(value_of(GiNaC::Pi) == 3.14159265358979323846);
  CHECK(value_of(GiNaC::numeric("1e22")) == 1e22);
  CHECK(value_of(0) == 0.0);
}

// Without it 1e43 stood in the C, which a model in float refused.
TEST_CASE("integers that cleared fractions leave in a denominator are taken out") {
  const ex large = GiNaC::pow(ex(10), 43);
  for (const ex& value : {large / (large * x + large * y / 2 + 3),
                          large * z / pow(large * x + 7, 2), 1 / (large * x + 3)}) {
    const Graph graph = lower(function_of(value));
    for (const Node& node : graph.nodes())
      if (node.op == Op::constant) CHECK(std::abs(node.constant) < 1e15);
    const double expected =
        GiNaC::ex_to<GiNaC::numeric>(
            value.subs(GiNaC::lst{x == ex(3) / 4, y == ex(1) / 4, z == ex(5) / 4}).evalf())
            .to_double();
    CHECK(evaluate(graph, std::vector<double>{0.75, 0.25, 1.25})[0] ==
          Approx(expected).epsilon(1e-14));
  }
}

TEST_CASE("what has no form in C is refused with function and expression") {
  const symbol stranger("stranger");
  const std::vector<std::pair<ex, std::string>> table{{GiNaC::tgamma(x), "tgamma(x)"},
                                                      {pow(x, y), "y"},
                                                      {pow(x, GiNaC::numeric(1, 3)), "1/3"},
                                                      {x + stranger, "stranger"},
                                                      {x * GiNaC::I, "complex"},
                                                      {x == y, "x==y"},
                                                      {GiNaC::wild(7), "$7"},
                                                      {GiNaC::matrix{{x, y}}, "[[x,y]]"}};
  for (const auto& [value, named] : table) {
    const std::string message = refusal(function_of(value));
    INFO(message);
    CHECK(message.find("function test") != std::string::npos);
    CHECK(message.find(named) != std::string::npos);
  }
}

TEST_CASE("arguments and results that do not fill their shape are refused") {
  Function few = function_of(x);
  few.inputs[0].rows = 4;
  CHECK(refusal(few).find("argument q has 3 symbols for 4x1") != std::string::npos);
  Function short_output = function_of(x);
  short_output.outputs[0].cols = 2;
  CHECK(refusal(short_output).find("result r has 1 values for 1x2") != std::string::npos);
}

TEST_CASE("a definition may use inputs and earlier definitions, not later ones") {
  const symbol first("first"), second("second");
  Function function = function_of(first + second);
  function.definitions = {{first, x * y}, {second, first + z}};
  CHECK(refusal(function) == "accepted");
  std::swap(function.definitions[0], function.definitions[1]);
  CHECK(refusal(function).find("first") != std::string::npos);
}
