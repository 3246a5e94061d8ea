// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the C of one robot, sinew's and SymPy's, with a number type that counts: what is executed is
// what is counted, the same way for both. Prints robot,quantity,maker,multiply,add,negate,divide,trig.
#include <cmath>
#include <cstddef>
#include <cstdio>

#include <math.h>
#include <stddef.h>

namespace {

struct Tally {
  int multiply = 0, add = 0, negate = 0, divide = 0, trigonometry = 0;
};
Tally tally;

struct Counted {
  double value = 0.0;
  Counted() = default;
  Counted(double v) : value(v) {}
};

Counted operator+(Counted a, Counted b) {
  ++tally.add;
  return a.value + b.value;
}
Counted operator-(Counted a, Counted b) {
  ++tally.add;
  return a.value - b.value;
}
Counted operator*(Counted a, Counted b) {
  ++tally.multiply;
  return a.value * b.value;
}
Counted operator/(Counted a, Counted b) {
  ++tally.divide;
  return a.value / b.value;
}
Counted operator-(Counted a) {
  ++tally.negate;
  return -a.value;
}
Counted sin(Counted a) {
  ++tally.trigonometry;
  return std::sin(a.value);
}
Counted cos(Counted a) {
  ++tally.trigonometry;
  return std::cos(a.value);
}
/// ccode's squares.
Counted pow(Counted a, Counted b) {
  for (int i = 1; i < static_cast<int>(b.value); ++i) ++tally.multiply;
  return std::pow(a.value, b.value);
}
void counted_sincos(Counted x, Counted* s, Counted* c) {
  ++tally.trigonometry;
  *s = std::sin(x.value);
  *c = std::cos(x.value);
}

}  // namespace

#define double Counted
#define restrict
#include "emitted_calls.c"
#include "sympy.c"
#undef double

namespace {

using Call = void (*)(const Counted*, const Counted*, const Counted*, Counted*);

void print(const char* robot, const char* quantity, const char* maker, Call call) {
  Counted q[SIZE], qd[SIZE], u[SIZE], out[SIZE * SIZE + SIZE];
  for (int i = 0; i < SIZE; ++i) {
    q[i] = 0.3 + 0.2 * i;
    qd[i] = 0.5 - 0.3 * i;
    u[i] = 1.0 - 0.7 * i;
  }
  tally = {};
  call(q, qd, u, out);
  std::printf("%s,%s,\"%s\",%d,%d,%d,%d,%d\n", robot, quantity, maker, tally.multiply, tally.add,
              tally.negate, tally.divide, tally.trigonometry);
}

}  // namespace

#define NAME_OF(x) #x
#define NAME(x) NAME_OF(x)

int main() {
  const char* robot = NAME(ROBOT);
  print(robot, "inverse_dynamics", "sinew", sinew_inverse_dynamics);
  print(robot, "bias", "sinew", sinew_bias);
  print(robot, "mass_matrix", "sinew", sinew_mass_matrix);
  print(robot, "both", "sinew", sinew_both);
  print(robot, "forward_dynamics", "sinew", sinew_forward_dynamics);
  print(robot, "inverse_dynamics", "SymPy, Newton-Euler", sympy_inverse_dynamics);
  print(robot, "bias", "SymPy, Newton-Euler", sympy_bias);
  print(robot, "mass_matrix", "SymPy, Newton-Euler", sympy_mass_matrix);
  (void)sinew_batch;
#ifdef LAGRANGE
  print(robot, "inverse_dynamics", "SymPy, Lagrange", sympy_lagrange_inverse_dynamics);
#endif
}
