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
#include "symbolic/expressions/piecewise.h"
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

/// `place(x, y, sum, status)`: which of three ranges x - y is in.
Function place_by_gap() {
  const GiNaC::symbol x("x"), y("y");
  Function function;
  function.name = "place";
  function.inputs = {{"x", 1, 1, {x}, "m", "", {{-1.0, 1.0}}},
                     {"y", 1, 1, {y}, "m", "", {{-1.0, 1.0}}}};
  const GiNaC::ex gap = x - y;
  const GiNaC::numeric half(1, 2);
  function.outputs = {{"sum", 1, 1, {x + y}, "m", ""},
                      {"status",
                       1,
                       1,
                       {choose(gap, choose(gap - half, 2, 1), 0)},
                       "1",
                       "",
                       {"below", "near", "far"}}};
  return function;
}

/// What knows the batch header and nothing else: whether the statuses are those by name, in as many
/// `int`s as there are states.
constexpr const char* status_user = R"(
int all_right(void);
int all_right(void) {
    enum { count = 37 };
    SCALAR x[count], y[count], sum[count];
    int status[2 * count], right = 1;
    for (int i = 0; i < count; ++i) {
        x[i] = (SCALAR)(7 * i % count) / (SCALAR)count;
        y[i] = (SCALAR)(11 * i % count) / (SCALAR)count;
        status[i] = status[count + i] = -1;
    }
    sample_place_batch(count, x, y, sum, status);
    for (int i = 0; i < count; ++i) {
        const SCALAR gap = x[i] - y[i];
        const int expected = gap < 0             ? SAMPLE_PLACE_BELOW
                             : 2 * gap < 1 ? SAMPLE_PLACE_NEAR
                                           : SAMPLE_PLACE_FAR;
        right = right && status[i] == expected && status[count + i] == -1;
    }
    return right;
}
)";

}  // namespace

TEST_CASE("a status over many states is an int that the batch header alone has the names of") {
  // Planted defects: a status of doubles, and a header without the names (it does not compile
  // then); every value one too high.
  for (const Scalar scalar : {Scalar::binary64, Scalar::binary32}) {
    const EmittedModel model =
        assemble({"sample", "A sample.", std::string(64, '0'), {}}, {place_by_gap()}, {scalar});
    const reference::TemporaryFolder place;
    const std::filesystem::path folder = place.path() / "sample";
    replace_folder(folder, emit_files(model));
    reference::write_text(place.path() / "user.c",
                          std::string("#include \"sample_batch.h\"\n") + status_user);
    const std::string file = (place.path() / "user.so").string();
    std::string output;
    const int status = run_program(
        {"cc", "-std=c11", "-O3", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off",
         "-fno-math-errno", "-shared", "-fPIC", std::string("-DSCALAR=") + model.target.type(),
         "-I", SINEW_SOURCE_DIR "/runtime", "-I", (folder / "host").string(), "-o", file,
         (place.path() / "user.c").string(), (folder / "host" / "sample_batch.c").string()},
        output);
    INFO(output);
    REQUIRE(status == 0);
    void* handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    REQUIRE(handle != nullptr);
    CHECK(reinterpret_cast<int (*)()>(::dlsym(handle, "all_right"))() == 1);
    ::dlclose(handle);
  }
}

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
