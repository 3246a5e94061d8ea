// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/subjects.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <random>
#include <sstream>
#include <stdexcept>

#include "symbolic/model/read_urdf.h"
#include "tests/reference/newton_euler.h"

namespace sinew::benchmarks {
namespace {

using reference::NewtonEuler;
using Exact = NewtonEuler<long double>;

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

double number(const std::string& word) {
  double value = 0.0;
  const auto end = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end.ptr != word.data() + word.size()) throw std::runtime_error(word + ": expected a number");
  return value;
}

Exact::Vector slice(const State& state, int part) {
  const auto n = static_cast<Eigen::Index>(state.size() / 3);
  return Eigen::Map<const Eigen::VectorXd>(state.data() + part * n, n).cast<long double>();
}

std::vector<long double> row_major(const Exact::Matrix& m) {
  std::vector<long double> values;
  for (Eigen::Index r = 0; r < m.rows(); ++r)
    for (Eigen::Index c = 0; c < m.cols(); ++c) values.push_back(m(r, c));
  return values;
}

std::vector<long double> expected(const Exact& dynamics, Quantity quantity, const State& state) {
  const Exact::Vector q = slice(state, 0), qd = slice(state, 1), u = slice(state, 2);
  switch (quantity) {
    case Quantity::inverse_dynamics:
      return row_major(dynamics.inverse_dynamics(q, qd, u));
    case Quantity::bias:
      return row_major(dynamics.bias(q, qd));
    case Quantity::mass_matrix:
      return row_major(dynamics.mass_matrix(q));
    case Quantity::forward_dynamics:
      return row_major(dynamics.forward_dynamics(q, qd, u));
    case Quantity::both: {
      std::vector<long double> all = row_major(dynamics.mass_matrix(q));
      for (long double value : row_major(dynamics.bias(q, qd))) all.push_back(value);
      return all;
    }
  }
  return {};
}

}  // namespace

int result_size(Quantity quantity, int n) {
  return quantity == Quantity::mass_matrix ? n * n : quantity == Quantity::both ? n * n + n : n;
}

Subject read_subject(const std::string& argument) {
  const std::vector<std::string> words = split(argument);
  if (words.size() != 5)
    throw std::runtime_error(argument + ": expected <urdf>,<gx>,<gy>,<gz>,<shared object>");
  Subject subject;
  subject.mechanism =
      read_urdf(words[0], Eigen::Vector3d(number(words[1]), number(words[2]), number(words[3])));
  subject.name = subject.mechanism.name;
  subject.library = words[4];
  const auto join = [&](std::vector<Contestant> more) {
    std::move(more.begin(), more.end(), std::back_inserter(subject.contestants));
  };
  join(from_library("sinew", subject.library, "sinew_"));
  join(from_library("SymPy, Newton-Euler", subject.library, "sympy_"));
  join(from_library("SymPy, Lagrange", subject.library, "sympy_lagrange_"));
  join(from_mujoco(subject.mechanism));
  join(from_kdl(subject.mechanism));
  return subject;
}

std::vector<State> random_states(int n, int count) {
  std::mt19937_64 random(20);
  std::vector<State> states;
  for (int i = 0; i < count; ++i) {
    State state;
    for (const double range : {M_PI, 3.0, 10.0})
      for (int k = 0; k < n; ++k)
        state.push_back(range * (0x1p-52 * static_cast<double>(random() >> 11) - 1.0));
    states.push_back(state);
  }
  return states;
}

double worst_error(const Subject& subject, const Contestant& contestant,
                   const std::vector<State>& states) {
  const Exact dynamics(subject.mechanism);
  const int n = dynamics.size();
  double worst = 0.0;
  for (const State& state : states) {
    const std::vector<long double> exact = expected(dynamics, contestant.quantity, state);
    std::vector<double> given(exact.size(), std::nan(""));
    contestant.call(state.data(), state.data() + n, state.data() + 2 * n, given.data());
    long double scale = 0.0L;
    for (long double value : exact) scale = std::max(scale, std::fabs(value));
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double error =
          static_cast<double>(std::fabs(static_cast<long double>(given[i]) - exact[i]) / scale);
      if (!(error <= worst)) worst = error;  // NaN wins
    }
  }
  return worst;
}

}  // namespace sinew::benchmarks
