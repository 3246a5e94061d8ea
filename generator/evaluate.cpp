// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/evaluate.h"

#include <fmt/format.h>
#include <sinew_math.h>

#include <cmath>
#include <stdexcept>

namespace sinew {
namespace {

/// The runtime's functions for one scalar type.
template <class Real>
struct Runtime;

template <>
struct Runtime<double> {
  static double sine(double x) {
    double s, c;
    sinew_sincos(x, &s, &c);
    return s;
  }
  static double cosine(double x) {
    double s, c;
    sinew_sincos(x, &s, &c);
    return c;
  }
  static double square_root(double x) { return sinew_sqrt(x); }
  static double arctangent(double x) { return sinew_atan(x); }
  static double arctangent2(double y, double x) { return sinew_atan2(y, x); }
  static double arccosine(double x) { return sinew_acos(x); }
  static double arcsine(double x) { return sinew_asin(x); }
  static double exponential(double x) { return sinew_exp(x); }
  static double logarithm(double x) { return sinew_log(x); }
  static double hyperbolic_tangent(double x) { return sinew_tanh(x); }
  static double absolute(double x) { return sinew_abs(x); }
  static double minimum(double a, double b) { return sinew_min(a, b); }
  static double maximum(double a, double b) { return sinew_max(a, b); }
  static double choose(double a, double b, double c) { return sinew_choose(a, b, c); }
  static double fused(double a, double b, double c) { return std::fma(a, b, c); }
};

template <>
struct Runtime<float> {
  static float sine(float x) {
    float s, c;
    sinew_sincosf(x, &s, &c);
    return s;
  }
  static float cosine(float x) {
    float s, c;
    sinew_sincosf(x, &s, &c);
    return c;
  }
  static float square_root(float x) { return sinew_sqrtf(x); }
  static float arctangent(float x) { return sinew_atanf(x); }
  static float arctangent2(float y, float x) { return sinew_atan2f(y, x); }
  static float arccosine(float x) { return sinew_acosf(x); }
  static float arcsine(float x) { return sinew_asinf(x); }
  static float exponential(float x) { return sinew_expf(x); }
  static float logarithm(float x) { return sinew_logf(x); }
  static float hyperbolic_tangent(float x) { return sinew_tanhf(x); }
  static float absolute(float x) { return sinew_absf(x); }
  static float minimum(float a, float b) { return sinew_minf(a, b); }
  static float maximum(float a, float b) { return sinew_maxf(a, b); }
  static float choose(float a, float b, float c) { return sinew_choosef(a, b, c); }
  static float fused(float a, float b, float c) { return std::fma(a, b, c); }
};

template <>
struct Runtime<Exact> {
  static Exact sine(const Exact& x) { return sin(x); }
  static Exact cosine(const Exact& x) { return cos(x); }
  static Exact square_root(const Exact& x) { return x > 0 ? Exact(sqrt(x)) : Exact(0); }
  static Exact arctangent(const Exact& x) { return atan(x); }
  static Exact arctangent2(const Exact& y, const Exact& x) { return atan2(y, x); }
  static Exact arccosine(const Exact& x) { return acos(x); }
  static Exact arcsine(const Exact& x) { return asin(x); }
  static Exact exponential(const Exact& x) { return exp(x); }
  static Exact logarithm(const Exact& x) { return log(x); }
  static Exact hyperbolic_tangent(const Exact& x) { return tanh(x); }
  static Exact absolute(const Exact& x) { return abs(x); }
  static Exact minimum(const Exact& a, const Exact& b) { return a < b ? a : b; }
  static Exact maximum(const Exact& a, const Exact& b) { return a > b ? a : b; }
  static Exact choose(const Exact& a, const Exact& b, const Exact& c) { return a >= 0 ? b : c; }
  static Exact fused(const Exact& a, const Exact& b, const Exact& c) { return a * b + c; }
};

template <class Real>
Real integer_power(Real base, int exponent) {
  Real result = base;
  for (int i = 1; i < exponent; ++i) result = result * base;
  return result;
}

}  // namespace

template <class Real>
Real apply(const Node& node, const Real& a, const Real& b, const Real& c) {
  using F = Runtime<Real>;
  switch (node.op) {
    case Op::input:
      break;
    case Op::constant:
      return static_cast<Real>(node.constant);
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    case Op::divide:
      return a / b;
    case Op::negate:
      return -a;
    case Op::power:
      return integer_power<Real>(a, node.index);
    case Op::square_root:
      return F::square_root(a);
    case Op::sine:
      return F::sine(a);
    case Op::cosine:
      return F::cosine(a);
    case Op::arctangent:
      return F::arctangent(a);
    case Op::arctangent2:
      return F::arctangent2(a, b);
    case Op::arccosine:
      return F::arccosine(a);
    case Op::arcsine:
      return F::arcsine(a);
    case Op::exponential:
      return F::exponential(a);
    case Op::logarithm:
      return F::logarithm(a);
    case Op::hyperbolic_tangent:
      return F::hyperbolic_tangent(a);
    case Op::absolute:
      return F::absolute(a);
    case Op::minimum:
      return F::minimum(a, b);
    case Op::maximum:
      return F::maximum(a, b);
    case Op::choose:
      return F::choose(a, b, c);
    case Op::multiply_add:
      return F::fused(a, b, c);
    case Op::multiply_subtract:
      return F::fused(a, b, Real(-c));
    case Op::subtract_product:
      return F::fused(Real(-a), b, c);
  }
  throw std::logic_error("an input has no operation");
}

template <class Real>
std::vector<Real> evaluate(const Graph& graph, const std::vector<Real>& inputs) {
  if (static_cast<int>(inputs.size()) != graph.input_size())
    throw std::invalid_argument(fmt::format("function {}: {} inputs given, {} expected", graph.name,
                                            inputs.size(), graph.input_size()));
  std::vector<Real> values;
  values.reserve(static_cast<std::size_t>(graph.size()));
  const Real zero(0);
  for (const Node& node : graph.nodes()) {
    const auto at = [&](Value v) -> const Real& {
      return v == no_value ? zero : values[static_cast<std::size_t>(v)];
    };
    values.push_back(node.op == Op::input ? inputs[static_cast<std::size_t>(node.index)]
                                          : apply<Real>(node, at(node.a), at(node.b), at(node.c)));
  }
  std::vector<Real> results;
  for (Value v : graph.results()) results.push_back(values[static_cast<std::size_t>(v)]);
  return results;
}

template double apply(const Node&, const double&, const double&, const double&);
template float apply(const Node&, const float&, const float&, const float&);
template Exact apply(const Node&, const Exact&, const Exact&, const Exact&);
template std::vector<double> evaluate(const Graph&, const std::vector<double>&);
template std::vector<float> evaluate(const Graph&, const std::vector<float>&);
template std::vector<Exact> evaluate(const Graph&, const std::vector<Exact>&);

}  // namespace sinew
