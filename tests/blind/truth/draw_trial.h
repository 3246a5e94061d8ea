// SPDX-License-Identifier: GPL-3.0-or-later
// A seed draws a plant, a cause, its place and its dose; the folder gets the model and the logs,
// and the seal comes back as text, to be kept where the program cannot see it.
#pragma once

#include <filesystem>
#include <string>

#include "tests/blind/truth/trial_plant.h"

namespace sinew::trials {

struct TrialRequest {
  std::uint64_t seed = 1;
  std::string plant = "drive";  ///< or joint, arm, finger, hand, lever, wrist, mujoco_drive, ...
  std::string family = "one";   ///< or null, two, outside, pair, fault, drives
  double size = 1.0;            ///< in units of the noise
  std::string cause;     ///< this one instead of a drawn one; the plant is one that offers it
  int logs = 1;          ///< for training, 1 to 3: train.csv, train2.csv, train3.csv
  double heavier = 1.0;  ///< the lone joint's inertia, for the gate that compares two plants
};

/// Writes model, channels and logs into the folder; of an unreachable trial nothing. Returns the
/// seal, JSON. Throws std::invalid_argument for an unknown plant or family, std::runtime_error
/// where a file cannot be written or this build has no MuJoCo.
std::string draw_trial(const TrialRequest& request, const std::filesystem::path& folder);

/// Plays a planned motion, as `sinew diagnose` writes it, on the trial's plant, and writes the log.
/// Throws std::invalid_argument for a file that is none.
void play_motion(const TrialRequest& request, const std::filesystem::path& motion,
                 const std::filesystem::path& out);

std::unique_ptr<TrialPlant> draw_plant(const TrialRequest& request, truth::Draw draw,
                                       const Pairing* pairing = nullptr);

}  // namespace sinew::trials
