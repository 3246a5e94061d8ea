// SPDX-License-Identifier: GPL-3.0-or-later
// What is too small to be worth telling, whatever it is: an error of a channel below a share of its
// rms, or below what the steps make in which the log writes it.
#pragma once

#include <vector>

#include "identification/diagnosis/verdict.h"
#include "identification/regression/cross_validation.h"

namespace sinew::diagnosis {

/// Sums of squares over the training logs inside the band, per channel, in the targets' units.
struct ChannelSquares {
  Eigen::VectorXd error;     ///< of what the model leaves over
  Eigen::VectorXd measured;  ///< of the targets, with what the recordings say is known
  Eigen::VectorXd samples;   ///< how many count
};

/// The model's free coefficients fitted under these weights.
ChannelSquares channel_squares(const Design& design, const Model& model, const Weights& weights);

/// rms of a channel's error that is not worth telling, in the channel's unit. `rms`: what was
/// measured; `quantum`: step of the logged values, 0 where none is seen: rounding to it makes an
/// error of quantum / sqrt(12). `share`: Settings::material_share.
double immaterial_error(double rms, double quantum, double share);

/// rms of what is left over of each channel of the held-out logs, in the targets' units; 0 where
/// there are none.
Eigen::VectorXd held_out_rms(const Design& design, const BlockLosses& losses);

/// Of each channel, whether what the model before any cause leaves over is immaterial, in the
/// training logs (`errors`) and in the held-out ones.
std::vector<bool> immaterial_channels(const Problem& problem, const ChannelSquares& errors,
                                      const Eigen::VectorXd& held_out, double share);

/// Takes back what is told of immaterial channels alone: causes, which are then ruled out as such,
/// structure without a name, and held-out logs that leave more over than the training logs.
void remove_immaterial(const Problem& problem, const std::vector<bool>& immaterial,
                       Verdict& verdict);

}  // namespace sinew::diagnosis
