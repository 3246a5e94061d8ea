// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/sampled_facts.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

#include "generator/evaluate.h"
#include "generator/reference.h"
#include "symbolic/tendons/pulling.h"

namespace sinew {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int tip_poses = 1000, closure_poses = 100;

double halton(int k, std::size_t dimension) {
  constexpr std::array<int, 22> primes{2,  3,  5,  7,  11, 13, 17, 19, 23, 29, 31,
                                       37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79};
  const int base = primes[dimension % primes.size()];
  double value = 0.0, share = 1.0;
  for (int i = k + 1 + 37 * static_cast<int>(dimension / primes.size()); i > 0; i /= base) {
    share /= base;
    value += share * (i % base);
  }
  return value;
}

/// P at a state, the columns that tendons have to hold.
MatrixXd coupling_at(const ModelReport& report, const Graph& graph,
                     const std::vector<double>& inputs) {
  const std::vector<double> values = evaluate<double>(graph, inputs);
  const Port& P = graph.outputs.front();
  MatrixXd held(P.rows, static_cast<Index>(report.held.size()));
  for (int row = 0; row < P.rows; ++row)
    for (std::size_t c = 0; c < report.held.size(); ++c)
      held(row, static_cast<Index>(c)) =
          values[static_cast<std::size_t>(row * P.cols + report.held[c])];
  return held;
}

/// Where the tips' positions stand among the results of the function that gives them: the rows of
/// homogeneous transforms that are not the last, their fourth elements.
struct TipFunction {
  const Graph* graph = nullptr;
  std::size_t first = 0, count = 0;
};

TipFunction tips_of(const ModelReport& report) {
  if (const Graph* one = function_named(report.emitted, "forward_kinematics")) return {one, 0, 1};
  const Graph* all = function_named(report.emitted, "fingertips");
  if (!all) return {};
  const auto half = static_cast<std::size_t>(all->outputs.front().size());
  return {all, half, half / 16};
}

}  // namespace

const Graph* function_named(const EmittedModel& model, const std::string& name) {
  for (const Graph& graph : model.functions)
    if (!name.empty() && graph.name == name) return &graph;
  return nullptr;
}

std::vector<std::vector<double>> spread_inputs(const Graph& graph, int count) {
  std::vector<std::vector<double>> all;
  for (int k = 0; k < count; ++k) {
    std::vector<double> inputs;
    for (const Port& port : graph.inputs)
      for (std::size_t i = 0; i < static_cast<std::size_t>(port.size()); ++i) {
        const double share = halton(k, inputs.size());
        inputs.push_back(port.ranges.empty() ? 0.0
                                             : port.ranges[i].low + share * (port.ranges[i].high -
                                                                             port.ranges[i].low));
      }
    all.push_back(std::move(inputs));
  }
  return all;
}

std::optional<Reach> reach_of(const ModelReport& report) {
  const TipFunction tips = tips_of(report);
  if (!tips.graph || tips.count == 0) return std::nullopt;
  Reach reach;
  reach.low.setConstant(1e300);
  reach.high.setConstant(-1e300);
  for (const std::vector<double>& inputs : spread_inputs(*tips.graph, tip_poses)) {
    const std::vector<double> T = evaluate<double>(*tips.graph, inputs);
    for (std::size_t k = 0; k < tips.count; ++k) {
      const double* pose = T.data() + tips.first + 16 * k;
      const Eigen::Vector3d p(pose[3], pose[7], pose[11]);
      reach.low = reach.low.cwiseMin(p);
      reach.high = reach.high.cwiseMax(p);
      reach.farthest = std::max(reach.farthest, p.norm());
    }
  }
  return reach;
}

std::optional<Closure> closure_of(const ModelReport& report) {
  const Graph* graph = function_named(report.emitted, report.coupling);
  if (!graph || report.held.empty()) return std::nullopt;
  Closure closure;
  closure.joints = closure.lowest_rank = static_cast<int>(report.held.size());
  for (const std::vector<double>& inputs : spread_inputs(*graph, closure_poses)) {
    const MatrixXd P = coupling_at(report, *graph, inputs);
    ++closure.poses;
    closure.closed += !motion_against_all(P);
    Eigen::ColPivHouseholderQR<MatrixXd> decomposition(P);
    decomposition.setThreshold(1e-9);
    closure.lowest_rank = std::min(closure.lowest_rank, static_cast<int>(decomposition.rank()));
  }
  return closure;
}

std::vector<std::pair<double, double>> torques_of(const ModelReport& report) {
  const Graph* graph = function_named(report.emitted, report.coupling);
  std::vector<std::pair<double, double>> torques;
  if (!graph) return torques;
  const MatrixXd P = coupling_at(report, *graph, reference_inputs(*graph));
  for (Index c = 0; c < P.cols(); ++c)
    torques.emplace_back(-report.force_high * P.col(c).cwiseMax(0.0).sum(),
                         -report.force_high * P.col(c).cwiseMin(0.0).sum());
  return torques;
}

}  // namespace sinew
