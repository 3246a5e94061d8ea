// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of a lever on its calibration rig that has what its model has not.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/extension/part_observation.h"
#include "symbolic/parts/part.h"
#include "tests/cli/loose_sensor.h"
#include "tests/cli/program.h"

namespace sinew {

/// The lever of models/lever drawn to and fro by its tendon, with one value that its model has not.
class Calibration {
 public:
  explicit Calibration(const IdentifiedEffect& hidden)
      : observation_(*observation_of(read_part(SINEW_SOURCE_DIR "/models/lever"))),
        reading_(closed_observation(observation_, {{hidden}, {}})),
        sensor_({hidden}, "sensor") {}

  std::string log(unsigned seed, bool with_elongation) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::string text = with_elongation ? "time [s],count [1],force [N],elongation [mm]\n"
                                       : "time [s],count [1],force [N]\n";
    std::vector<double> memory{0.0, 0.0};
    LooseSensor sensor = sensor_;
    for (int k = 0; k < 3000; ++k) {
      const double t = 0.01 * k, phase = 0.4 * seed;
      const double rate =
          1350.0 * std::cos(0.9 * t + phase) + 690.0 * std::cos(2.3 * t + 2.0 * phase);
      const LooseSensor::Reading read = sensor.of(
          2040.0 + 1500.0 * std::sin(0.9 * t + phase) + 300.0 * std::sin(2.3 * t + 2.0 * phase),
          rate);
      const double count = std::round(read.value);
      const std::vector<double> out =
          evaluate(reading_, {count, rate, rate, read.side, 0.0, 0.01, memory[0], memory[1]});
      memory = {out[2], out[3]};
      text += fmt::format("{:.2f},{:.0f},{:.4f}", t, count, out[0] + 0.05 * normal(random));
      if (with_elongation) text += fmt::format(",{:.5f}", 1e3 * out[1] + 0.005 * normal(random));
      text += "\n";
    }
    return text;
  }

 private:
  Observation observation_;
  Function reading_;
  LooseSensor sensor_;
};

/// A copy of models/lever beside two logs of the lever as it really is.
inline Workplace lever_that_has(const IdentifiedEffect& hidden, bool with_elongation) {
  Workplace place;
  std::filesystem::copy(SINEW_SOURCE_DIR "/models/lever", place.path("lever"));
  const Calibration calibration(hidden);
  for (const auto& [name, seed] : {std::pair{"a.csv", 1u}, {"b.csv", 2u}})
    std::ofstream(place.path(name)) << calibration.log(seed, with_elongation);
  return place;
}

}  // namespace sinew
