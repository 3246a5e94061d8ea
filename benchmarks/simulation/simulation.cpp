// SPDX-License-Identifier: GPL-3.0-or-later
// How much faster than real time a finger and the complete hand simulate at 3 kHz output on one
// core. `real_time_factor` is simulated time over processor time, `best_factor` that of the fastest
// run: what others on the machine take from its caches and its core's other half is least in it.
// Rows are handed over. Where the name says so they are written as CSV, by another thread: there
// the time is the wall's. `error_rad`: how far joints are at most from a run at 1e-10.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <vector>

#include "simulation/plant/simulate.h"
#include "simulation/plant/write_rows.h"

namespace {

namespace fs = std::filesystem;

const fs::path source = SINEW_SOURCE_DIR;

/// Deriving and compiling a model takes longer than simulating it.
const sinew::Plant& finger() {
  static const sinew::Plant plant = sinew::build_plant(
      source / "models/index", source / "benchmarks/simulation/finger.toml", source / "runtime");
  return plant;
}

const sinew::Plant& hand() {
  static const sinew::Plant plant =
      sinew::build_plant(source / "models/hand", source / "models/hand/scenarios/wrist_motion.toml",
                         source / "runtime");
  return plant;
}

using Change = std::function<void(sinew::Scenario&)>;

void as_it_is(sinew::Scenario&) {}

void coarsely(sinew::Scenario& scenario) {
  scenario.relative_tolerance = 1e-4;
  scenario.absolute_tolerance = 1e-6;
}

void in_fixed_steps(sinew::Scenario& scenario) {
  scenario.integrator = sinew::Integrator::fixed_step;
  scenario.step = 1.0 / 3000.0;
}

using Rows = std::vector<std::vector<double>>;

/// Joint angles of a run, one row an output.
Rows joints(const sinew::Plant& model, const sinew::Scenario& scenario) {
  sinew::Plant plant(scenario, model.parts());
  const auto count = static_cast<std::ptrdiff_t>(plant.coordinates());
  Rows rows;
  sinew::simulate(plant, [&](const std::vector<double>& row) {
    rows.emplace_back(row.begin() + 1, row.begin() + 1 + count);
  });
  return rows;
}

/// How far joints are at most from where far smaller tolerances take them [rad].
double largest_error(const sinew::Plant& model, const sinew::Scenario& scenario) {
  sinew::Scenario fine = model.scenario();
  fine.relative_tolerance = 1e-10;
  fine.absolute_tolerance = 1e-12;
  const Rows found = joints(model, scenario), wanted = joints(model, fine);
  double largest = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = 0; j < found[i].size(); ++j)
      largest = std::max(largest, std::abs(found[i][j] - wanted[i][j]));
  return largest;
}

/// Processor time of this thread, or the wall's [s].
double seconds(bool of_wall) {
  timespec now{};
  ::clock_gettime(of_wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// `written`: rows go to a CSV file, which vanishes.
void simulate(benchmark::State& state, const sinew::Plant& model, const Change& change,
              bool written) {
  sinew::Scenario scenario = model.scenario();
  change(scenario);
  const fs::path file = fs::temp_directory_path() / "simulation_benchmark.csv";
  long steps = 0;
  double least = 1e300;
  for (auto _ : state) {
    const double start = seconds(written);
    sinew::Plant plant(scenario, model.parts());
    if (written) {
      sinew::RowWriter out(file, sinew::output_columns(plant));
      steps += sinew::simulate(plant, [&](const auto& row) { out.write(row); }).count.steps;
      out.finish();
    } else {
      double last = 0.0;
      steps += sinew::simulate(plant, [&](const auto& row) { last = row.back(); }).count.steps;
      benchmark::DoNotOptimize(last);
    }
    least = std::min(least, seconds(written) - start);
  }
  fs::remove(file);
  const double simulated = scenario.duration * static_cast<double>(state.iterations());
  state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
  if (!written) state.counters["error_rad"] = largest_error(model, scenario);
  state.counters["best_factor"] = scenario.duration / least;
  state.counters["steps_a_second"] = static_cast<double>(steps) / simulated;
}

}  // namespace

int main(int count, char** words) {
  const struct {
    const char* name;
    const sinew::Plant& (*model)();
    Change change;
    bool written;
  } cases[] = {{"finger/cvode", finger, as_it_is, false},
               {"finger/cvode/csv", finger, as_it_is, true},
               {"finger/cvode/1e-4", finger, coarsely, false},
               {"finger/fixed_step", finger, in_fixed_steps, false},
               {"hand/cvode", hand, as_it_is, false},
               {"hand/cvode/csv", hand, as_it_is, true},
               {"hand/cvode/1e-4", hand, coarsely, false},
               {"hand/fixed_step", hand, in_fixed_steps, false}};
  for (const auto& each : cases) {
    auto* registered = benchmark::RegisterBenchmark(each.name, [each](benchmark::State& state) {
                         simulate(state, each.model(), each.change, each.written);
                       })->Unit(benchmark::kMillisecond);
    if (each.written) registered->UseRealTime();
  }
  benchmark::Initialize(&count, words);
  if (benchmark::ReportUnrecognizedArguments(count, words)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
