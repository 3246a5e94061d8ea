// SPDX-License-Identifier: GPL-3.0-or-later
// A thing that can be measured, with causes hidden in it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/blind/truth/random_draw.h"

namespace sinew::truth {

/// Columns of a log with their `name [unit]` headers; the first is the time.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<double>> columns;
  int column(const std::string& name) const;  ///< -1 if there is none
};

/// Something that may be hidden. `guess` is a dose to start from, `most` and
/// `least` are physical limits.
struct Cause {
  std::string name;   ///< as the effect library calls it
  std::string place;  ///< "motor", "tendon 3", "joint 2", "sensor", ...
  std::string unit;
  double guess = 0.0;
  double most = 0.0;
  double least = 0.0;    ///< negative where it can act either way
  bool outside = false;  ///< not in the library
  bool fixed = false;    ///< there or not there: `guess` is the only dose, the noise gives the size
};

struct Dose {
  int cause = 0;
  double value = 0.0;
};

/// One set-up, drawn once from a seed: nominal values, motions, noise. Log 0 is for training, log 1
/// is held out, others are follow-up experiments.
class Plant {
 public:
  virtual ~Plant() = default;
  /// "drive", "linear_drive", "lever", "finger", "wrist".
  virtual std::string kind() const = 0;
  /// Nominal values of the model under test: JSON object text.
  virtual std::string nominal() const = 0;
  virtual const std::vector<Cause>& causes() const = 0;
  /// What a perfect sensor would log.
  virtual Table simulate(const std::vector<Dose>& doses, int log) const = 0;
  /// The same while it follows a motion that somebody asks for: `motion` has the time, the
  /// reference, and the load where the plant has one. Throws std::runtime_error where the plant
  /// follows no motions.
  virtual Table play(const std::vector<Dose>& doses, const Table& motion) const;
  /// What the model leaves over, per channel, in units of that channel's noise: the channels'
  /// residuals behind a low-pass, with the model's own terms fitted and taken out, but for those
  /// that the doses' causes themselves are.
  virtual std::vector<std::vector<double>> left_over(const Table& log,
                                                     const std::vector<Dose>& doses) const = 0;
  /// Adds measurement noise and the sensors' steps.
  virtual void measure(Table& log, int number) const = 0;
  /// Makes the measurement noise so many times larger.
  virtual void scale_noise(double factor) = 0;
};

/// Rotary or linear drive, with or without a measured load.
enum class DriveCourse { any, one_speed, constant_load, one_way };
std::unique_ptr<Plant> draw_drive(Draw draw, DriveCourse course = DriveCourse::any);
/// The same with MuJoCo's mechanics, and fewer causes; nullptr where this build has no MuJoCo.
std::unique_ptr<Plant> draw_mujoco_drive(Draw draw);
/// Lever and tendon on a calibration rig.
std::unique_ptr<Plant> draw_lever(Draw draw);
/// Finger with four joints and eight tendons.
std::unique_ptr<Plant> draw_finger(Draw draw);
/// Wrist moving, fingers held.
std::unique_ptr<Plant> draw_wrist(Draw draw);

/// A table from CSV text: lines that begin with # first, then names, then numbers.
Table table_of(const std::string& csv);

/// The log as CSV text, nine digits.
std::string csv_text(const Table& log);

/// Residual of y after least squares on the columns.
std::vector<double> without_columns(const std::vector<double>& y,
                                    const std::vector<std::vector<double>>& columns);
/// Twice a moving mean over 2 m + 1 samples; ends shrink the window.
std::vector<double> smoothed(const std::vector<double>& x, int m);
/// Central derivative by two samples each side.
std::vector<double> derivative(const std::vector<double>& x, double period);

}  // namespace sinew::truth
