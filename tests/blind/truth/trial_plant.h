// SPDX-License-Identifier: GPL-3.0-or-later
// A plant of the trials: what it offers to hide, its motion, what perfect and what real sensors
// show, and the model of it that the program is given.
#pragma once

#include <filesystem>
#include <map>
#include <memory>

#include "tests/blind/truth/hidden.h"
#include "tests/blind/truth/pairs.h"
#include "tests/blind/truth/random_draw.h"

namespace sinew::trials {

/// The true motion of one log at the integrator's steps, `inner` a row of the log.
struct Course {
  double step = 0.0;  ///< s, of the integrator
  int inner = 1;
  MatrixXd q, v, a;  ///< steps x axes
  VectorXd load;     ///< known external load; empty: none
  MatrixXd command;  ///< efforts that another simulator was given, rows x axes; empty: none
  double period() const { return step * inner; }
  Index rows() const { return q.rows() / inner; }
};

/// A log: columns with names and units as the program's channels.
struct Log {
  double step = 0.0;
  std::vector<std::string> names, units;
  MatrixXd columns;  ///< rows x names, SI
  Index column(const std::string& name) const;
};

/// What a joint's drive is, that a model without drives lacks: SI, seen at the joint.
struct DriveTruth {
  std::string joint;
  double armature = 0.0, level = 0.0, viscous = 0.0;
};

class TrialPlant {
 public:
  virtual ~TrialPlant() = default;
  virtual const std::vector<Offer>& offers() const = 0;
  /// The model under test, in folder / "model" and what belongs beside it.
  virtual void write_model(const std::filesystem::path& folder) const = 0;
  /// Log 0 is for training, 1 held out, 2 and 3 for training as well. In closed loop what is hidden
  /// changes the motion.
  virtual Course course(const std::vector<Hidden>& hidden, int log) const = 0;
  /// A planned experiment, played: what follows reference and load [rows, of the log's period].
  /// Throws std::invalid_argument where the plant plays none.
  virtual Course played(const std::vector<Hidden>& hidden, const MatrixXd& reference,
                        const VectorXd& load) const;
  /// The same motion by inverse dynamics: what perfect sensors show.
  virtual Log replay(const Course& course, const std::vector<Hidden>& hidden, int log) const = 0;
  /// Noise and the sensors' own steps; the same numbers whenever the log is the same.
  virtual void measure(Log& log, int number) const = 0;
  /// What the model under test leaves over, a channel that the program compares each.
  virtual std::vector<VectorXd> left_over(const Log& log) const = 0;
  /// Whether a channel shows the cause itself, and not only another motion under it.
  virtual bool shows(const Hidden& hidden, std::size_t channel) const;
  /// What the program fits in any case, of these kinds, a channel each.
  virtual std::vector<MatrixXd> fitted(const Log& log, unsigned which) const = 0;
  /// 1 in motion, 0 at rest, a channel each; and the band in which it is compared [Hz].
  virtual std::vector<VectorXd> moving(const Log& log) const = 0;
  virtual std::vector<double> bands(const Log& perfect, const Log& measured) const = 0;
  /// For the table: resolved pre-sliding, MuJoCo, ...
  virtual std::map<std::string, std::string> traits() const { return {}; }
  /// Empty where the model knows its drives.
  virtual std::vector<DriveTruth> drives() const { return {}; }
};

enum class Mechanics { own, mujoco };

/// `pairing`: as its logs have to be, or nullptr.
std::unique_ptr<TrialPlant> draw_drive(truth::Draw draw, Mechanics mechanics,
                                       const Pairing* pairing = nullptr);
std::unique_ptr<TrialPlant> draw_joint(truth::Draw draw, double heavier = 1.0,
                                       const Pairing* pairing = nullptr);
std::unique_ptr<TrialPlant> draw_arm(truth::Draw draw, Mechanics mechanics);
/// An arm whose model knows no drives, logged at 1 kHz: seven joints, or three of which one slides.
std::unique_ptr<TrialPlant> draw_bare_arm(truth::Draw draw, Mechanics mechanics, bool slides);
std::unique_ptr<TrialPlant> draw_finger(truth::Draw draw, Mechanics mechanics);
std::unique_ptr<TrialPlant> draw_hand(truth::Draw draw);
std::unique_ptr<TrialPlant> draw_lever(truth::Draw draw);
std::unique_ptr<TrialPlant> draw_wrist(truth::Draw draw);

/// Whether this build found MuJoCo.
bool mujoco_is_there();

}  // namespace sinew::trials
