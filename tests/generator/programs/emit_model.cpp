// SPDX-License-Identifier: GPL-3.0-or-later
// emit_model <model folder> <output folder>: what `sinew generate` writes, under the locale that
// the environment asks for. Says on the standard output how this locale writes one half. Needs
// nothing but symbolic/ and generator/, so that a second compiler builds it quickly.
#include <clocale>
#include <cstdio>
#include <exception>
#include <locale>
#include <random>

#include "generator/assemble.h"
#include "generator/rewrite.h"
#include "generator/write.h"
#include "symbolic/functions.h"
#include "symbolic/read_mechanism.h"

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

void emit(const char* model_folder, const char* output_folder) {
  const Mechanism mechanism = read_mechanism(model_folder);
  EmittedModel model = assemble({mechanism.name, mechanism.description, std::string(64, '0'), {}},
                                functions_of(mechanism, emitted_cost), Target{});
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
