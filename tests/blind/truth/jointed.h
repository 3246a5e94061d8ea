// SPDX-License-Identifier: GPL-3.0-or-later
// Links with driven axes: what drives, lone joints, arms, fingers and hands have in common.
#pragma once

#include "tests/blind/truth/axis.h"
#include "tests/blind/truth/chain.h"
#include "tests/blind/truth/random_draw.h"
#include "tests/blind/truth/signals.h"
#include "tests/blind/truth/trial_plant.h"

namespace sinew::trials {

struct Jointed {
  Chain chain;                  ///< as the model under test has it
  std::vector<AxisModel> axes;  ///< one a link
  std::vector<Bristle> bristles;
  std::vector<double> middle;  ///< about which each axis moves
  bool carries = false;        ///< friction's load is what the links ask for
  double motor_share = 0.0;    ///< of what an axis carries, on the motor's side of a soft gear
};

/// The chain with what is hidden in its bodies.
Chain true_chain(const Chain& chain, const std::vector<Hidden>& hidden);

/// What a motion asks of every joint at the rows of the log, with what is hidden.
MatrixXd needed_efforts(const Jointed& jointed, const Course& course,
                        const std::vector<Hidden>& hidden);

struct Rhythm {
  truth::Course kind = truth::Course::mixed;
  double seconds = 14.0, period = 0.002;
  int inner = 4;
};

/// Every axis follows its reference as it is.
Course commanded(const Jointed& jointed, const Rhythm& rhythm, truth::Draw draw);
/// A reference of the log's rows, straight lines between its speeds.
Course given(const MatrixXd& reference, const Rhythm& rhythm);
/// Position at the instant of a speed that semi-implicit Euler steps leave half a step before it.
VectorXd at_its_speed(const VectorXd& q, const VectorXd& v, double step);
/// A lone axis that follows what is wanted in closed loop, integrated here step by step.
Course in_closed_loop(const Jointed& jointed, const std::vector<Hidden>& hidden,
                      const Course& wanted, const VectorXd& load, truth::Draw draw);
/// All axes in closed loop by the chain's own equations, integrated here step by step.
Course in_joint_torques(const Jointed& jointed, const std::vector<Hidden>& hidden,
                        const Rhythm& rhythm, truth::Draw draw);
/// The same by MuJoCo's mechanics and integrator.
Course in_mujoco(const Jointed& jointed, const std::vector<Hidden>& hidden, const Rhythm& rhythm,
                 const VectorXd& load, truth::Draw draw);

/// Causes that any axis offers; `drive`: it has a motor and a gear of its own; `links`: causes of
/// the bodies as well.
void offer_axis(const Jointed& jointed, std::size_t axis, const std::string& place, bool drive,
                bool loaded, std::vector<Offer>& offers);
/// `products`: of inertia as well, which a finger's thin and light links have next to none of.
void offer_links(const Jointed& jointed, bool products, std::vector<Offer>& offers);
/// Its direction; of a model without any, that it was left out.
void offer_gravity(const Jointed& jointed, std::vector<Offer>& offers);

/// Columns that are fitted with every model at an axis, along a smoothed motion.
MatrixXd fitted_at(const AxisModel& model, const VectorXd& v, const VectorXd& a, double step,
                   unsigned which);
/// How much the samples of a perfect position count.
VectorXd in_motion(const VectorXd& q, double step);
/// 18 Hz where what is left of the acceleration above is no more than twice what the noise of the
/// position makes, else `band`.
double band_of(const VectorXd& perfect, const VectorXd& measured, double step, double band);

/// Scales of the axes from a motion without anything hidden.
void learn_scales(Jointed& jointed, const Course& course);

}  // namespace sinew::trials
