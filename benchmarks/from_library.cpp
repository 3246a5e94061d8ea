// SPDX-License-Identifier: GPL-3.0-or-later
#include <dlfcn.h>

#include <stdexcept>

#include "benchmarks/calls.h"
#include "benchmarks/contestant.h"

namespace sinew::benchmarks {

const char* name_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::inverse_dynamics:
      return "inverse_dynamics";
    case Quantity::bias:
      return "bias";
    case Quantity::mass_matrix:
      return "mass_matrix";
    case Quantity::both:
      return "both";
    case Quantity::forward_dynamics:
      return "forward_dynamics";
  }
  return "";
}

std::vector<Contestant> from_library(const std::string& maker, const std::string& file,
                                     const std::string& prefix) {
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error(::dlerror());
  std::vector<Contestant> found;
  for (const Quantity quantity : {Quantity::inverse_dynamics, Quantity::bias, Quantity::mass_matrix,
                                  Quantity::both, Quantity::forward_dynamics})
    if (void* symbol = ::dlsym(library, (prefix + name_of(quantity)).c_str()))
      found.push_back({maker, quantity, reinterpret_cast<dynamics_call*>(symbol)});
  return found;
}

}  // namespace sinew::benchmarks
