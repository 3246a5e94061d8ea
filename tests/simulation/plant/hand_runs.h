// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the complete hand from one derivation, which takes longer than the runs.
#pragma once

#include <functional>

#include "tests/simulation/scenario_run.h"

namespace sinew_tests {

/// A hand whose scenario changes from run to run; motors and losses are those of the first.
struct HandRuns {
  sinew::Plant plant;
  explicit HandRuns(const std::string& scenario) : plant(plant_of("hand", scenario)) {}

  Run changed(const std::function<void(sinew::Scenario&)>& change) const {
    sinew::Scenario scenario = plant.scenario();
    change(scenario);
    sinew::Plant own(scenario, plant.parts());
    return run(own);
  }
};

}  // namespace sinew_tests
