// SPDX-License-Identifier: GPL-3.0-or-later
// The batch form of every function of a model gives the bits of the single function.
#include <dlfcn.h>

#include <bit>
#include <catch2/catch.hpp>

#include "generator/assemble.h"
#include "generator/cost.h"
#include "generator/emit_batch.h"
#include "generator/evaluate.h"
#include "generator/write.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/tendons/functions.h"
#include "tests/generator/every_operation.h"
#include "tests/reference/temporary_folder.h"

using namespace sinew;
using reference::run_program;

namespace {

constexpr int count = 37;  // no multiple of any vector's length

using Numbers = std::vector<double>;

std::vector<Function> sample_functions() {
  std::vector<Function> functions =
      functions_of(read_mechanism(SINEW_SOURCE_DIR "/models/index"), emitted_cost);
  functions.push_back(every_operation());
  return functions;
}

EmittedModel model_without(const std::vector<std::string>& passes,
                           const std::vector<Function>& functions) {
  return assemble({"sample", "A sample.", std::string(64, '0'), {}}, functions, {}, passes);
}

/// The batch file of a model, compiled with vectorised loops and loaded.
class Library {
 public:
  explicit Library(const EmittedModel& model) {
    replace_folder(place_.path() / "sample", emit_files(model));
    const std::string file = (place_.path() / "batch.so").string();
    std::string output;
    const int status =
        run_program({"cc", "-std=c11", "-O3", "-fno-tree-slp-vectorize", "-ffp-contract=off",
                     "-fno-math-errno", "-shared", "-fPIC", "-I", SINEW_SOURCE_DIR "/runtime", "-o",
                     file, (place_.path() / "sample" / "host" / "sample_batch.c").string()},
                    output);
    if (status != 0) throw std::runtime_error(output);
    handle_ = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) throw std::runtime_error(::dlerror());
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { ::dlclose(handle_); }

  void call(const std::string& function, const std::vector<double*>& a) const {
    void* symbol = ::dlsym(handle_, ("sample_" + function + "_batch").c_str());
    if (symbol == nullptr) throw std::runtime_error(function + ": has no batch form");
    using P = double*;
    if (a.size() == 2) return reinterpret_cast<void (*)(int, P, P)>(symbol)(count, a[0], a[1]);
    if (a.size() == 3)
      return reinterpret_cast<void (*)(int, P, P, P)>(symbol)(count, a[0], a[1], a[2]);
    if (a.size() == 4)
      return reinterpret_cast<void (*)(int, P, P, P, P)>(symbol)(count, a[0], a[1], a[2], a[3]);
    throw std::runtime_error(function + ": this test calls functions of two to four arrays");
  }

 private:
  reference::TemporaryFolder place_;
  void* handle_ = nullptr;
};

/// Results of the batch form that are not the bits of the interpreter, which are those of the
/// single function (see "values stay the same after every pass").
int differing(const Graph& graph, const Library& library) {
  const auto states = states_of(graph, count, 11);
  std::vector<Numbers> arrays;
  std::size_t first = 0;
  for (const Port& port : graph.inputs) {
    arrays.emplace_back();
    for (std::size_t k = 0; k < static_cast<std::size_t>(port.size()); ++k)
      for (const Numbers& state : states) arrays.back().push_back(state[first + k]);
    first += static_cast<std::size_t>(port.size());
  }
  for (const Port& port : graph.outputs)
    arrays.emplace_back(static_cast<std::size_t>(port.size() * count), -1.0);
  std::vector<double*> pointers;
  for (Numbers& array : arrays) pointers.push_back(array.data());
  library.call(graph.name, pointers);
  int found = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Numbers expected = evaluate<double>(graph, states[i]);
    std::size_t next = 0;
    for (std::size_t p = graph.inputs.size(); p < arrays.size(); ++p)
      for (std::size_t k = 0; k * count < arrays[p].size(); ++k)
        found += std::bit_cast<std::uint64_t>(arrays[p][k * count + i]) !=
                 std::bit_cast<std::uint64_t>(expected[next++]);
  }
  return found;
}

}  // namespace

TEST_CASE("the batch form of every function has the bits of the single function",
          "[slow][thorough]") {
  const std::vector<Function> functions = sample_functions();
  const EmittedModel model = model_without({}, functions);
  const Library library(model);
  for (const Graph& graph : model.functions) {
    INFO(graph.name);
    REQUIRE(count_operations(graph).operations() <= longest_batch_function);
    CHECK(differing(graph, library) == 0);
  }
  // Planted: the single functions were made without a pass that changes roundings.
  int found = 0;
  for (const Graph& graph : model_without({"factor_sums"}, functions).functions) {
    if (found > 0) break;
    found += differing(graph, library);
  }
  CHECK(found > 0);
}
