// SPDX-License-Identifier: GPL-3.0-or-later
// The worked example at the head of every pass's file: operations before and after.
#include <catch2/catch.hpp>

#include <bit>
#include <cstdint>

#include "generator/cost.h"
#include "generator/dump.h"
#include "generator/evaluate.h"
#include "generator/passes/passes.h"
#include "generator/passes/pipeline.h"

using namespace sinew;

namespace {

/// Builds graphs of scalar inputs a, b, c, d, e and results r[0], r[1], ...
struct Example {
  Graph graph;
  Value a, b, c, d, e;

  Example() {
    graph.name = "example";
    for (const char* name : {"a", "b", "c", "d", "e"})
      graph.inputs.push_back({name, 1, 1, "", "", {{-1.0, 1.0}}, {}});
    a = graph.input(0);
    b = graph.input(1);
    c = graph.input(2);
    d = graph.input(3);
    e = graph.input(4);
  }
  Value make(Op op, Value x, Value y = no_value) { return graph.make(op, x, y); }
  Value number(double value) { return graph.constant(value); }
  const Graph& returning(const std::vector<Value>& results) {
    graph.outputs = {{"r", static_cast<int>(results.size()), 1, "", "", {}, results}};
    return graph;
  }
};

int count_of(const Graph& graph, Op op) {
  int count = 0;
  for (const Node& node : graph.nodes()) count += node.op == op;
  return count;
}

/// Tells -0 from 0.
std::vector<std::uint64_t> bits(const std::vector<double>& numbers) {
  std::vector<std::uint64_t> all;
  for (const double number : numbers) all.push_back(std::bit_cast<std::uint64_t>(number));
  return all;
}

std::vector<Op> order_of(const Graph& graph) {
  std::vector<Op> order;
  for (const Node& node : graph.nodes())
    if (node.op != Op::input) order.push_back(node.op);
  return order;
}

}  // namespace

TEST_CASE("example: share") {
  Example x;
  // Equal operations on equal operands are one value from the start.
  const Value product = x.make(Op::multiply, x.a, x.b);
  CHECK(x.make(Op::multiply, x.b, x.a) == product);
  // a - b, b - a -> d = a - b, -d
  const Graph& before =
      x.returning({x.make(Op::subtract, x.a, x.b), x.make(Op::subtract, x.b, x.a)});
  const Graph after = share(before);
  CHECK(count_operations(before).add == 2);
  CHECK(count_operations(after).add == 1);
  CHECK(count_operations(after).negate == 1);
}

TEST_CASE("example: fold_constants") {
  Example x;
  const Graph& before = x.returning(
      {x.make(Op::multiply, x.number(2), x.number(3)), x.make(Op::add, x.a, x.number(0)),
       x.make(Op::multiply, x.b, x.number(1)), x.make(Op::multiply, x.c, x.number(0)),
       x.make(Op::divide, x.number(0), x.d), x.make(Op::negate, x.make(Op::negate, x.e))});
  CHECK(count_operations(before).weight() > 0);
  const Graph after = remove_dead(fold_constants(before));
  CHECK(count_operations(after).weight() == 0.0);
  CHECK(after.is_constant(after.outputs[0].values[0], 6.0));
  CHECK(after.input_name(after[after.outputs[0].values[1]].index) == "a[0]");
  CHECK(after.input_name(after[after.outputs[0].values[2]].index) == "b[0]");
  CHECK(after.is_constant(after.outputs[0].values[3], 0.0));
  CHECK(after.is_constant(after.outputs[0].values[4], 0.0));
  CHECK(after.input_name(after[after.outputs[0].values[5]].index) == "e[0]");
}

TEST_CASE("example: fold_constants leaves what has no finite value") {
  Example x;
  const Graph& before = x.returning({x.make(Op::divide, x.number(1), x.number(0))});
  CHECK(count_operations(fold_constants(before)).divide == 1);
}

TEST_CASE("example: expand_powers") {
  Example x;
  Node power;
  power.op = Op::power;
  power.a = x.a;
  power.index = 6;
  const Graph& before = x.returning({x.graph.add(power)});
  CHECK(count_operations(before).multiply == 5);
  const Graph after = expand_powers(before);
  CHECK(count_operations(after).multiply == 3);
  CHECK(count_of(after, Op::power) == 0);
}

TEST_CASE("example: pair_sincos") {
  Example x;
  const Graph& before =
      x.returning({x.make(Op::sine, x.a), x.make(Op::cosine, x.make(Op::negate, x.a))});
  CHECK(count_operations(before).sincos == 2);
  const Graph after = remove_dead(pair_sincos(before));
  CHECK(count_operations(after).sincos == 1);
  CHECK(count_operations(after).negate == 0);
}

TEST_CASE("example: pair_sincos of opposite differences") {
  Example x;
  const Graph& before = x.returning({x.make(Op::sine, x.make(Op::subtract, x.b, x.a)),
                                     x.make(Op::cosine, x.make(Op::subtract, x.a, x.b))});
  CHECK(count_operations(before).sincos == 2);
  CHECK(count_operations(before).add == 2);
  const Graph after = remove_dead(pair_sincos(share(before)));
  CHECK(count_operations(after).sincos == 1);
  CHECK(count_operations(after).add == 1);
}

TEST_CASE("example: contract_trigonometry") {
  Example x;
  const Value s = x.make(Op::sine, x.a), c = x.make(Op::cosine, x.a);
  const Value squares = x.make(Op::add, x.make(Op::multiply, s, s), x.make(Op::multiply, c, c));
  const Graph alone = x.returning({squares});
  CHECK(count_operations(alone).operations() == 3);
  const Graph one = contract_trigonometry(alone);
  CHECK(one.is_constant(one.outputs[0].values[0], 1.0));

  Example y;  // cos^2 - b + sin^2, with the squares apart
  const Value sine = y.make(Op::sine, y.a), cosine = y.make(Op::cosine, y.a);
  const Graph& longer =
      y.returning({y.make(Op::add, y.make(Op::subtract, y.make(Op::multiply, cosine, cosine), y.b),
                          y.make(Op::multiply, sine, sine))});
  const Graph after = contract_trigonometry(longer);
  CHECK(count_operations(after).operations() == 1);
  CHECK(count_operations(after).sincos == 0);
}

TEST_CASE("example: contract_trigonometry leaves other angles and other signs") {
  Example x;
  const auto square = [&x](Op op, Value angle) {
    const Value v = x.make(op, angle);
    return x.make(Op::multiply, v, v);
  };
  const Graph& before =
      x.returning({x.make(Op::add, square(Op::sine, x.a), square(Op::cosine, x.b)),
                   x.make(Op::subtract, square(Op::cosine, x.a), square(Op::sine, x.a))});
  CHECK(dump_text(contract_trigonometry(before)) == dump_text(remove_dead(before)));
}

TEST_CASE("example: move_signs") {
  Example x;
  const Value u = x.make(Op::multiply, x.make(Op::negate, x.a), x.b);
  const Graph& before = x.returning({x.make(Op::add, x.c, u)});
  CHECK(count_operations(before).negate == 1);
  const Graph after = remove_dead(move_signs(before));
  CHECK(count_operations(after).negate == 0);
  CHECK(count_of(after, Op::subtract) == 1);
}

TEST_CASE("example: combine_constants") {
  Example x;
  const Graph product = x.returning({x.make(Op::multiply, x.make(Op::multiply, x.number(2), x.a),
                                            x.make(Op::multiply, x.number(3), x.b))});
  CHECK(count_operations(product).multiply == 3);
  const Graph combined = remove_dead(combine_constants(product));
  CHECK(count_operations(combined).multiply == 2);
  CHECK(evaluate<double>(combined, {5, 7, 0, 0, 0})[0] == 210.0);

  Example y;
  const Graph sum = y.returning(
      {y.make(Op::add, y.make(Op::add, y.a, y.number(2)), y.make(Op::subtract, y.b, y.number(3)))});
  CHECK(count_operations(sum).add == 3);
  const Graph shorter = remove_dead(combine_constants(sum));
  CHECK(count_operations(shorter).add == 2);
  CHECK(evaluate<double>(shorter, {5, 7, 0, 0, 0})[0] == 11.0);
}

TEST_CASE("example: factor_sums") {
  Example x;
  const auto times_a = [&x](Value v) { return x.make(Op::multiply, x.a, v); };
  const Value sum = x.make(Op::subtract, x.make(Op::add, times_a(x.b), times_a(x.c)), times_a(x.d));
  const Graph& before = x.returning({x.make(Op::add, sum, x.e)});
  CHECK(count_operations(before).multiply == 3);
  const Graph after = factor_sums(before);
  CHECK(count_operations(after).multiply == 1);
  CHECK(count_operations(after).add == count_operations(before).add);
}

TEST_CASE("example: share_reciprocals") {
  Example x;
  const Graph before = x.returning({x.make(Op::divide, x.a, x.d), x.make(Op::divide, x.b, x.d)});
  CHECK(count_operations(before).divide == 2);
  CHECK(count_operations(share_reciprocals(before)).divide == 1);
  CHECK(count_operations(share_reciprocals(before)).multiply == 2);
  const Graph& single = x.returning({x.make(Op::divide, x.c, x.e)});
  CHECK(count_operations(share_reciprocals(remove_dead(single))).multiply == 0);
}

TEST_CASE("example: distribute_constants") {
  Example x;
  // 3 * (2*a - 5*b + 1) -> 6*a - 15*b + 3
  const Value two_a = x.make(Op::multiply, x.number(2), x.a);
  const Value five_b = x.make(Op::multiply, x.number(5), x.b);
  const Value sum = x.make(Op::add, x.make(Op::subtract, two_a, five_b), x.number(1));
  const Graph before = x.returning({x.make(Op::multiply, x.number(3), sum)});
  CHECK(count_operations(before).multiply == 3);
  CHECK(count_operations(distribute_constants(before)).multiply == 2);
  CHECK(evaluate<double>(distribute_constants(before), {7, 2, 0, 0, 0}) == std::vector<double>{15});
  // a term without a constant would cost one: nothing happens
  const Value plain = x.make(Op::add, two_a, x.c);
  const Graph& kept = x.returning({x.make(Op::multiply, x.number(3), plain)});
  CHECK(count_operations(distribute_constants(kept)).multiply == 2);
}

TEST_CASE("example: reduce_strength") {
  Example x;
  const Value quarter = x.make(Op::divide, x.a, x.number(4));
  const Value twice = x.make(Op::multiply, x.number(2), x.b);
  const Value nested = x.make(Op::divide, x.c, x.make(Op::divide, x.d, x.e));
  const Graph& before = x.returning({quarter, twice, nested});
  CHECK(count_operations(before).divide == 3);
  const Graph after = remove_dead(reduce_strength(before));
  CHECK(count_operations(after).divide == 1);
  CHECK(count_of(after, Op::add) == 1);
  CHECK(evaluate<double>(after, {1, 3, 6, 2, 4}) == std::vector<double>{0.25, 6, 12});
}

// Seen to fail with in_magnitude() taking any maximum, and with magnitudes replaced everywhere.
TEST_CASE("example: reduce_strength of magnitudes under an exponential") {
  Example x;
  const auto decay_of = [&x](Value y, Value z) {
    return x.make(Op::exponential, x.make(Op::negate, x.make(Op::maximum, y, z)));
  };
  const Value minus_a = x.make(Op::negate, x.a), minus_b = x.make(Op::negate, x.b);
  const Graph& before =
      x.returning({decay_of(x.a, minus_a), decay_of(minus_b, x.b), decay_of(x.a, minus_b),
                   x.make(Op::exponential, x.make(Op::maximum, x.c, x.make(Op::negate, x.c))),
                   x.make(Op::maximum, x.d, x.make(Op::negate, x.d))});
  const Graph after = remove_dead(reduce_strength(before));
  CHECK(count_of(after, Op::absolute) == 2);
  CHECK(count_of(after, Op::maximum) == 3);
  for (const double number : {0.0, -0.0, 2.0, -2.0, 1e-320, 800.0})
    CHECK(bits(evaluate<double>(after, {number, number, number, number, 1})) ==
          bits(evaluate<double>(before, {number, number, number, number, 1})));
}

TEST_CASE("example: remove_dead") {
  Example x;
  x.make(Op::multiply, x.a, x.b);
  const Graph& before = x.returning({x.make(Op::add, x.a, x.b)});
  CHECK(count_operations(before).multiply == 1);
  CHECK(count_operations(remove_dead(before)).multiply == 0);
  CHECK(count_operations(remove_dead(before)).add == 1);
}

TEST_CASE("example: schedule") {
  Example x;
  const Value t = x.make(Op::multiply, x.make(Op::sine, x.a), x.b);
  const Graph& before = x.returning({x.make(Op::add, t, x.make(Op::sine, x.d))});
  CHECK(order_of(before) == std::vector<Op>{Op::sine, Op::multiply, Op::sine, Op::add});
  CHECK(order_of(schedule(before)) == std::vector<Op>{Op::sine, Op::sine, Op::multiply, Op::add});
}

TEST_CASE("a pass that is left out is left out; an unknown one is named with those that are") {
  Example x;
  Node power;
  power.op = Op::power;
  power.a = x.a;
  power.index = 6;
  const Graph& before = x.returning({x.graph.add(power)});
  CHECK(count_of(optimise(before), Op::power) == 0);
  CHECK(count_of(optimise(before, {"expand_powers"}), Op::power) == 1);
  try {
    optimise(before, {"fold"});
    FAIL("an unknown pass was accepted");
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    CHECK(message.find("'fold'") != std::string::npos);
    for (const Pass& pass : pipeline()) CHECK(message.find(pass.name) != std::string::npos);
  }
}
