// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/batch.h"

#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>

namespace sinew::benchmarks {

Batch load_batch(const Subject& subject, const std::string& argument) {
  const std::size_t comma = argument.find(',');
  if (comma == std::string::npos)
    throw std::runtime_error(argument + ": expected <instruction set>,<shared object>");
  void* library = ::dlopen(argument.substr(comma + 1).c_str(), RTLD_NOW | RTLD_LOCAL);
  void* symbol = library == nullptr ? nullptr : ::dlsym(library, "sinew_batch");
  if (symbol == nullptr) throw std::runtime_error(::dlerror());
  return {subject.name, argument.substr(0, comma), reinterpret_cast<batch_call*>(symbol),
          coordinate_count(subject.mechanism)};
}

std::vector<double> batch_inputs(int n) {
  const std::vector<State> states = random_states(n, batch_states);
  std::vector<double> inputs;
  for (std::size_t k = 0; k < states[0].size(); ++k)
    for (const State& state : states) inputs.push_back(state[k]);
  return inputs;
}

double worst_error(const Subject& subject, const Batch& batch) {
  const int n = batch.n;
  const std::vector<double> in = batch_inputs(n);
  std::vector<double> out(static_cast<std::size_t>(n * batch_states));
  const double* q = in.data();
  batch.call(batch_states, q, q + n * batch_states, q + 2 * n * batch_states, out.data());
  std::size_t next = 0;
  const Contestant one{"batch", Quantity::inverse_dynamics,
                       [&](const double*, const double*, const double*, double* tau) {
                         for (int k = 0; k < n; ++k)
                           tau[k] = out[static_cast<std::size_t>(k * batch_states) + next];
                         ++next;
                       }};
  return worst_error(subject, one, random_states(n, batch_states));
}

}  // namespace sinew::benchmarks
