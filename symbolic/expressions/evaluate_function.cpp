// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/evaluate_function.h"

#include <cln/cln.h>

#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "symbolic/expressions/working_digits.h"

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

/// What differs between the two number types.
struct DoubleArithmetic {
  using Number = double;
  static double from(const numeric& n) {
    return cln::double_approx(cln::the<cln::cl_R>(n.to_cl_N()));
  }
  static double power(double base, const numeric& n) {
    if (n.is_equal(numeric(1, 2))) return std::sqrt(base);
    if (n.is_equal(numeric(-1, 2))) return 1.0 / std::sqrt(base);
    if (n.is_equal(numeric(-1))) return 1.0 / base;
    return std::pow(base, from(n));
  }
  static bool is_negative(double x) { return x < 0.0; }
};

struct PreciseArithmetic {
  using Number = numeric;
  static numeric from(const numeric& n) { return ex_to<numeric>(n.evalf()); }
  static numeric power(const numeric& base, const numeric& n) {
    if (base.is_zero() && n.is_positive()) return base;
    return GiNaC::pow(base, n);
  }
  static bool is_negative(const numeric& x) { return x.is_negative(); }
};

[[noreturn]] void fail(const Function& function, const std::string& what, const ex& value) {
  std::ostringstream text;
  text << "function " << function.name << ": " << what << " " << value;
  throw std::invalid_argument(text.str());
}

template <typename Arithmetic>
class Evaluator {
 public:
  using Number = typename Arithmetic::Number;

  Evaluator(const Function& function, const std::vector<numeric>& inputs) : function_(function) {
    std::size_t next = 0;
    for (const Argument& argument : function.inputs)
      for (const GiNaC::symbol& symbol : argument.symbols) {
        if (next == inputs.size()) fail(function, "no value for", symbol);
        values_[symbol] = Arithmetic::from(inputs[next++]);
      }
    if (next != inputs.size())
      fail(function, "more values than inputs:", numeric(int(inputs.size())));
  }

  std::vector<Number> run() {
    for (const Definition& definition : function_.definitions)
      values_[definition.symbol] = value_of(definition.value);
    std::vector<Number> results;
    for (const Output& output : function_.outputs)
      for (const ex& value : output.values) results.push_back(value_of(value));
    return results;
  }

 private:
  Number value_of(const ex& e) {
    if (is_a<numeric>(e)) return Arithmetic::from(ex_to<numeric>(e));
    if (is_a<GiNaC::constant>(e)) return Arithmetic::from(ex_to<numeric>(e.evalf()));
    if (is_a<GiNaC::symbol>(e)) return value_of_symbol(e);
    if (is_a<GiNaC::power>(e)) {
      if (!is_a<numeric>(e.op(1))) fail(function_, "exponent is not a number:", e);
      return Arithmetic::power(value_of(e.op(0)), ex_to<numeric>(e.op(1)));
    }
    if (is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e)) return fold(e);
    if (is_a<GiNaC::function>(e)) return call(e);
    fail(function_, "no value for", e);
  }

  Number value_of_symbol(const ex& e) {
    const auto found = values_.find(e);
    if (found == values_.end()) fail(function_, "neither input nor earlier definition:", e);
    return found->second;
  }

  Number fold(const ex& e) {
    Number result = value_of(e.op(0));
    for (std::size_t i = 1; i < e.nops(); ++i) {
      const Number next = value_of(e.op(i));
      result = is_a<GiNaC::add>(e) ? Number(result + next) : Number(result * next);
    }
    return result;
  }

  Number call(const ex& e) {
    using namespace std;    // NOLINT: one text for double and numeric
    using namespace GiNaC;  // NOLINT
    const string name = ex_to<GiNaC::function>(e).get_name();
    vector<Number> a;
    for (size_t i = 0; i < e.nops(); ++i) a.push_back(value_of(e.op(i)));
    if (name == "sin") return sin(a[0]);
    if (name == "cos") return cos(a[0]);
    if (name == "atan") return atan(a[0]);
    if (name == "atan2") return atan2_of(a[0], a[1]);
    if (name == "acos") return acos(a[0]);
    if (name == "asin") return asin(a[0]);
    if (name == "exp") return exp(a[0]);
    if (name == "log") return log(a[0]);
    if (name == "tanh") return tanh(a[0]);
    if (name == "abs") return abs(a[0]);
    if (name == "minimum") return a[0] <= a[1] ? a[0] : a[1];
    if (name == "maximum") return a[0] >= a[1] ? a[0] : a[1];
    if (name == "choose") return Arithmetic::is_negative(a[0]) ? a[2] : a[1];
    fail(function_, "function without a value:", e);
  }

  static double atan2_of(double y, double x) { return std::atan2(y, x); }
  static numeric atan2_of(const numeric& y, const numeric& x) { return GiNaC::atan(y, x); }

  const Function& function_;
  std::map<ex, Number, GiNaC::ex_is_less> values_;
};

}  // namespace

std::vector<double> evaluate(const Function& function, const std::vector<double>& inputs) {
  std::vector<numeric> exact;
  for (const double input : inputs) exact.push_back(binary_fraction(input));
  return Evaluator<DoubleArithmetic>(function, exact).run();
}

std::vector<numeric> evaluate_precisely(const Function& function,
                                        const std::vector<numeric>& inputs, int digits) {
  const WorkingDigits scope(digits);
  return Evaluator<PreciseArithmetic>(function, inputs).run();
}

std::vector<double> rounded_values(const Function& function, const std::vector<double>& inputs) {
  std::vector<numeric> exact;
  for (const double input : inputs) exact.push_back(binary_fraction(input));
  std::vector<double> values;
  for (const numeric& value : evaluate_precisely(function, exact))
    values.push_back(value.to_double());
  return values;
}

numeric binary_fraction(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("input is not a finite number");
  return numeric(cln::cl_N(cln::rational(cln::cl_DF(value))));
}

}  // namespace sinew
