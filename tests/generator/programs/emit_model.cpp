// SPDX-License-Identifier: GPL-3.0-or-later
// emit_model <model folder> <output folder>: what `sinew generate` writes of a mechanism, a part or
// a hand, and what a part's sensors read, under the locale that the environment asks for. Says on
// the standard output how this locale writes one half. Needs nothing but symbolic/ and generator/,
// so that a second compiler builds it quickly.
#include <clocale>
#include <cstdio>
#include <exception>
#include <locale>
#include <random>

#include "generator/assemble.h"
#include "generator/rewrite.h"
#include "generator/write.h"
#include "symbolic/tendons/functions.h"
#include "symbolic/hand/hand.h"
#include "symbolic/extension/part_observation.h"
#include "symbolic/hand/read_hand.h"
#include "symbolic/model/read_mechanism.h"

using namespace sinew;

namespace {

#ifdef SINEW_PLANT_RANDOM_ORDER
/// Planted defect: operands of sums and products in an order that differs from run to run. The
/// values stay the same to the last bit.
Graph disturbed(const Graph& graph) {
  std::random_device chance;
  return rewrite(graph, [&chance](Graph& to, const Node& node) {
    if (is_commutative(node.op) && chance() % 2) return to.make(node.op, node.b, node.a);
    return to.add(node);
  });
}
#else
Graph disturbed(const Graph& graph) {
  return graph;
}
#endif

std::vector<Function> functions_of_part(const Part& part) {
  std::vector<Function> functions = functions_of(part);
  if (const std::optional<Observation> observation = observation_of(part))
    functions.push_back(closed_observation(*observation, {}));
  return functions;
}

std::vector<Function> functions_of_folder(const std::filesystem::path& folder) {
  if (is_hand_folder(folder)) return hand_functions(read_hand(folder).hand);
  if (is_part_folder(folder)) return functions_of_part(read_part(folder));
  return functions_of(read_mechanism(folder), emitted_cost);
}

void emit(const std::filesystem::path& folder, const char* output_folder) {
  EmittedModel model = assemble({folder.filename().string(), "", std::string(64, '0'), {}},
                                functions_of_folder(folder), Target{});
  for (Graph& graph : model.functions) graph = disturbed(graph);
  replace_folder(output_folder, emit_files(model));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3 || !std::setlocale(LC_ALL, "")) return 2;
  std::locale::global(std::locale(""));
  std::printf("%.1f\n", 0.5);
  emit(argv[1], argv[2]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
