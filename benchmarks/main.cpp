// SPDX-License-Identifier: GPL-3.0-or-later
// Times, or counts under callgrind, the dynamics of robots by sinew and its peers.
//
//   peers check|time|count --robot <urdf>,<gx>,<gy>,<gz>,<so> [--batch <instructions>,<so>]...
//                          [--robot ...] [Google Benchmark's options]
//
// Every contestant is first compared with Newton-Euler in long double; one that is wrong ends the
// program with status 1, before anything is timed. `check` prints the errors as CSV. `count` is to
// be run under valgrind --tool=callgrind --collect-atstart=no: it dumps one profile a contestant.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <valgrind/callgrind.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "benchmarks/batch.h"
#include "benchmarks/subjects.h"

namespace sinew::benchmarks {
namespace {

constexpr int states_timed = 128;
/// Far below any modelling mistake, far above the rounding of forward dynamics of an arm.
constexpr double wrong = 1e-9;

struct Arena {
  std::vector<Subject> subjects;
  std::vector<Batch> batches;
};

Arena read_arena(int argc, char** argv) {
  Arena arena;
  for (int i = 2; i + 1 < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--robot") arena.subjects.push_back(read_subject(argv[++i]));
    if (option == "--batch") {
      if (arena.subjects.empty()) throw std::runtime_error("--batch: expected a --robot before it");
      arena.batches.push_back(load_batch(arena.subjects.back(), argv[++i]));
    }
  }
  return arena;
}

std::string label(const Subject& subject, const Contestant& contestant) {
  return fmt::format("{}/{}/{}", subject.name, name_of(contestant.quantity), contestant.maker);
}

std::string label(const Batch& batch) {
  return fmt::format("{}/batch/{}", batch.robot, batch.instructions);
}

bool report(const std::string& what, double error) {
  fmt::print("\"{}\",{:.1e}\n", what, error);
  if (error <= wrong) return true;
  fmt::print(stderr, "{}: wrong by {:.1e} of the largest entry, allowed {:.0e}\n", what, error,
             wrong);
  return false;
}

bool all_are_right(const Arena& arena) {
  bool right = true;
  for (const Subject& subject : arena.subjects) {
    const auto states = random_states(coordinate_count(subject.mechanism), states_timed);
    for (const Contestant& each : subject.contestants)
      right = report(label(subject, each), worst_error(subject, each, states)) && right;
    for (const Batch& batch : arena.batches)
      if (batch.robot == subject.name)
        right = report(label(batch), worst_error(subject, batch)) && right;
  }
  return right;
}

/// Calls the contestant once at each state.
void run_through(const Contestant& contestant, const std::vector<State>& states, double* out) {
  const std::size_t n = states[0].size() / 3;
  for (const State& state : states) {
    const double* q = state.data();
    contestant.call(q, q + n, q + 2 * n, out);
    benchmark::DoNotOptimize(out);
    benchmark::ClobberMemory();
  }
}

/// The cost of the loop itself, and the trigonometry of the C library on n angles: what figures
/// from elsewhere are scaled by.
std::vector<Contestant> calibration(int n) {
  return {{"empty call", Quantity::inverse_dynamics,
           [](const double*, const double*, const double*, double*) {}},
          {"sincos of libm", Quantity::inverse_dynamics,
           [n](const double* q, const double*, const double*, double* out) {
             double sum = 0.0;
             for (int i = 0; i < n; ++i) {
               double s, c;
               ::sincos(q[i], &s, &c);
               sum += s + c;
             }
             out[0] = sum;
           }}};
}

template <class Each>
void for_each_contestant(Arena& arena, const Each& each) {
  for (Subject& subject : arena.subjects) {
    const int n = coordinate_count(subject.mechanism);
    for (const Contestant& contestant : calibration(n)) each(subject, contestant, n);
    for (const Contestant& contestant : subject.contestants) each(subject, contestant, n);
  }
}

void register_all(Arena& arena) {
  for_each_contestant(arena, [](const Subject& subject, const Contestant& contestant, int n) {
    benchmark::RegisterBenchmark(label(subject, contestant).c_str(),
                                 [contestant, n](benchmark::State& state) {
                                   const auto states = random_states(n, states_timed);
                                   std::vector<double> out(static_cast<std::size_t>(n * n + n));
                                   for (auto _ : state) run_through(contestant, states, out.data());
                                   state.SetItemsProcessed(state.iterations() * states_timed);
                                 });
  });
  for (const Batch& batch : arena.batches)
    benchmark::RegisterBenchmark(label(batch).c_str(), [batch](benchmark::State& state) {
      const std::vector<double> in = batch_inputs(batch.n);
      std::vector<double> out(static_cast<std::size_t>(batch.n * batch_states));
      const double* q = in.data();
      for (auto _ : state) {
        batch.call(batch_states, q, q + batch.n * batch_states, q + 2 * batch.n * batch_states,
                   out.data());
        benchmark::ClobberMemory();
      }
      state.SetItemsProcessed(state.iterations() * batch_states);
    });
}

/// One profile a contestant, named by its label, of one call at each of the states.
void count_instructions(Arena& arena) {
  for_each_contestant(arena, [](const Subject& subject, const Contestant& contestant, int n) {
    const auto states = random_states(n, states_timed);
    std::vector<double> out(static_cast<std::size_t>(n * n + n));
    run_through(contestant, states, out.data());
    CALLGRIND_ZERO_STATS;
    CALLGRIND_TOGGLE_COLLECT;
    run_through(contestant, states, out.data());
    CALLGRIND_TOGGLE_COLLECT;
    const std::string name = label(subject, contestant);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
  });
}

}  // namespace
}  // namespace sinew::benchmarks

int main(int argc, char** argv) {
  using namespace sinew::benchmarks;
  const std::string mode = argc > 1 ? argv[1] : "";
  try {
    if (mode != "check" && mode != "time" && mode != "count")
      throw std::runtime_error("peers: expected check, time or count as the first word");
    Arena arena = read_arena(argc, argv);
    if (mode == "count") {
      count_instructions(arena);
      return 0;
    }
    if (!all_are_right(arena)) return 1;
    if (mode == "check") return 0;
    register_all(arena);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
