// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/piecewise.h"

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

bool are_numbers(const ex& a, const ex& b) {
  return is_a<numeric>(a) && is_a<numeric>(b);
}

ex minimum_eval(const ex& a, const ex& b) {
  if (a.is_equal(b)) return a;
  if (are_numbers(a, b)) return ex_to<numeric>(a) <= ex_to<numeric>(b) ? a : b;
  return minimum(a, b).hold();
}

ex maximum_eval(const ex& a, const ex& b) {
  if (a.is_equal(b)) return a;
  if (are_numbers(a, b)) return ex_to<numeric>(a) >= ex_to<numeric>(b) ? a : b;
  return maximum(a, b).hold();
}

ex choose_eval(const ex& condition, const ex& a, const ex& b) {
  if (a.is_equal(b)) return a;
  if (is_a<numeric>(condition)) return ex_to<numeric>(condition).is_negative() ? b : a;
  return choose(condition, a, b).hold();
}

// Arguments arrive evaluated: what is still not a number then stays symbolic.
ex minimum_evalf(const ex& a, const ex& b) {
  return minimum_eval(a, b);
}
ex maximum_evalf(const ex& a, const ex& b) {
  return maximum_eval(a, b);
}
ex choose_evalf(const ex& condition, const ex& a, const ex& b) {
  return choose_eval(condition, a, b);
}

ex minimum_derivative(const ex& a, const ex& b, unsigned parameter) {
  return parameter == 0 ? choose(b - a, 1, 0) : choose(b - a, 0, 1);
}

ex maximum_derivative(const ex& a, const ex& b, unsigned parameter) {
  return parameter == 0 ? choose(a - b, 1, 0) : choose(a - b, 0, 1);
}

ex choose_derivative(const ex& condition, const ex&, const ex&, unsigned parameter) {
  if (parameter == 1) return choose(condition, 1, 0);
  if (parameter == 2) return choose(condition, 0, 1);
  return 0;
}

}  // namespace

// clang-format off
REGISTER_FUNCTION(minimum, eval_func(minimum_eval).evalf_func(minimum_evalf).derivative_func(minimum_derivative))
REGISTER_FUNCTION(maximum, eval_func(maximum_eval).evalf_func(maximum_evalf).derivative_func(maximum_derivative))
REGISTER_FUNCTION(choose, eval_func(choose_eval).evalf_func(choose_evalf).derivative_func(choose_derivative))
// clang-format on

GiNaC::ex clamped(const GiNaC::ex& value, const GiNaC::ex& low, const GiNaC::ex& high) {
  return minimum(maximum(value, low), high);
}

GiNaC::ex magnitude(const GiNaC::ex& value) {
  return maximum(value, -value);
}

}  // namespace sinew
