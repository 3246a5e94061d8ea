// SPDX-License-Identifier: GPL-3.0-or-later
// A seed draws what is hidden, where, how much, and everything around it. The two logs are handed
// over; what was hidden is looked at only after the verdict.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tests/blind/truth/plant.h"

namespace sinew::truth {

enum class Family { nothing, one, two, three, outside, inseparable, data_fault };

struct TrialRequest {
  std::uint64_t seed = 1;
  std::string plant = "drive";  ///< "drive", "mujoco_drive", "lever", "finger", "wrist", or "any"
  Family family = Family::one;
  double size = 0.0;  ///< in units of the noise; 0: drawn from 0.1, 0.2, 0.3, 0.5, 1
};

struct HiddenCause {
  std::string name, place, unit;
  double value = 0.0;
  double size = 0.0;  ///< rms of what it leaves over, in units of the noise, as simulated
};

/// What was hidden.
struct Seal {
  Family family = Family::nothing;
  std::vector<HiddenCause> hidden;
  /// Inseparable pairs: all the names that explain the log equally.
  std::vector<std::string> admissible;
  /// Data faults: the finding expected, its channel, and the line of the file (0: anywhere).
  std::string fault, channel;
  long row = 0;
};

/// What is handed over.
struct Trial {
  std::string plant;           ///< kind of plant
  std::string nominal;         ///< JSON object: nominal values of the model under test
  std::string train, holdout;  ///< CSV text
};

/// A drawn trial. Nothing about the seal can be read from `open`.
class SealedTrial {
 public:
  explicit SealedTrial(const TrialRequest& request);
  const Trial& open() const { return trial_; }
  /// After the verdict.
  const Seal& seal() const { return seal_; }
  /// A further log with the same causes, from the experiment that would separate an inseparable
  /// pair (varied speeds, varied load, both directions); for others a fresh motion.
  std::string follow_up() const;
  /// A further log with the same causes while the plant follows a motion asked for, CSV text with
  /// the time, the reference, and the load where the plant has one.
  std::string play(const std::string& motion) const;

 private:
  /// Adds the cause if the size can be reached within its limits.
  bool hide(int cause, double size);
  void hide_drawn(size_t count, bool outside, double size);
  std::vector<int> eligible(bool outside) const;
  bool hide_fixed(int cause, double size);
  HiddenCause dose_for(int cause, double size, double sign) const;
  std::string log_text(int number) const;

  Draw draw_;
  std::unique_ptr<Plant> plant_;
  std::vector<Dose> doses_, rivals_;
  Trial trial_;
  Seal seal_;
};

/// Writes train.csv, holdout.csv and nominal.json into `folder`, and the seal as JSON to
/// `seal_file`, which should lie elsewhere.
void write_trial(const SealedTrial& trial, const std::string& folder, const std::string& seal_file);
std::string seal_text(const Seal& seal);
std::string family_name(Family family);
/// How many causes a trial of the family hides.
std::size_t wanted_causes(Family family);

}  // namespace sinew::truth
