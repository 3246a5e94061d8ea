// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of a wrist that has what its model has not.
#pragma once

#include <fmt/format.h>

#include <array>
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

/// The wrist of models/wrist moved over its range, with one value that its model has not.
class WristLog {
 public:
  /// `quantum`: steps [rad] that q73 is read in; 0: none.
  explicit WristLog(const std::vector<IdentifiedEffect>& hidden, double quantum = 0.0)
      : observation_(*observation_of(read_part(SINEW_SOURCE_DIR "/models/wrist"))),
        reading_(closed_observation(observation_, {hidden, {}})),
        sensors_{LooseSensor(hidden, "q71"), LooseSensor(hidden, "q73")},
        quantum_(quantum) {}

  std::string log(unsigned seed) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::string text = "time [s],q71 [rad],q73 [rad]";
    for (std::size_t i = 1; i <= kLogged; ++i) text += fmt::format(",theta_{} [rad]", i);
    std::array<LooseSensor, 2> sensors = sensors_;
    for (int k = 0; k < 1500; ++k) {
      const double t = 0.01 * k, phase = 0.7 * seed;
      const Moved a = along(reading_.inputs[0].ranges[0], 0.9, t, phase);
      const Moved b = along(reading_.inputs[1].ranges[0], 1.4, t, 2.0 * phase);
      const LooseSensor::Reading q71 = sensors[0].of(a.angle, a.speed),
                                 q73 = sensors[1].of(b.angle, b.speed);
      const std::vector<double> out =
          evaluate(reading_, {q71.value, q73.value, a.speed, b.speed, q71.side, q73.side});
      text += fmt::format("\n{:.3f},{:.8f},{:.8f}", t, q71.value, read(q73.value));
      for (std::size_t i = 0; i < kLogged; ++i)
        text += fmt::format(",{:.7f}", out[i] + 1e-4 * normal(random));
    }
    return text + "\n";
  }

 private:
  static constexpr std::size_t kLogged = 5;  // motors: a log need not have all
  struct Moved {
    double angle, speed;
  };
  static Moved along(const Range& range, double rate, double t, double phase) {
    const double reach = 0.35 * (range.high - range.low);
    return {0.5 * (range.low + range.high) + reach * std::sin(rate * t + phase),
            reach * rate * std::cos(rate * t + phase)};
  }
  double read(double angle) const {
    return quantum_ > 0.0 ? quantum_ * std::round(angle / quantum_) : angle;
  }

  Observation observation_;
  Function reading_;
  std::array<LooseSensor, 2> sensors_;
  double quantum_;
};

/// A copy of models/wrist beside two logs of the wrist as it really is.
inline Workplace wrist_that_has(const WristLog& wrist) {
  Workplace place;
  std::filesystem::copy(SINEW_SOURCE_DIR "/models/wrist", place.path("wrist"));
  for (const auto& [name, seed] : {std::pair{"a.csv", 1u}, {"b.csv", 2u}})
    std::ofstream(place.path(name)) << wrist.log(seed);
  return place;
}

}  // namespace sinew
