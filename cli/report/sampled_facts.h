// SPDX-License-Identifier: GPL-3.0-or-later
// What a model can do, over poses spread evenly over its joints' ranges.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cli/report/model_report.h"

namespace sinew {

/// A function of the model by its name without prefix; nullptr where it has none.
const Graph* function_named(const EmittedModel& model, const std::string& name);

/// `count` inputs of a function, spread evenly over their ranges (Halton's sequence); 0 without a
/// range.
std::vector<std::vector<double>> spread_inputs(const Graph& graph, int count);

struct Reach {
  Eigen::Vector3d low, high;  ///< m, of all tips
  double farthest = 0.0;      ///< m, from the drawing's origin
};
/// Of the tips' positions; nothing without tips.
std::optional<Reach> reach_of(const ModelReport& report);

/// Whether tensions can balance each other: P^T f = 0 with f > 0.
struct Closure {
  int poses = 0, closed = 0;
  int lowest_rank = 0, joints = 0;
};
std::optional<Closure> closure_of(const ModelReport& report);

/// Largest torques either way [N m] that the tendons make at each coordinate in the reference pose,
/// none pulling more than `force_high`: (negative, positive).
std::vector<std::pair<double, double>> torques_of(const ModelReport& report);

}  // namespace sinew
