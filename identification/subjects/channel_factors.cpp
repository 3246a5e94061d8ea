// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/channel_factors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "identification/subjects/block_regression.h"
#include "identification/subjects/slow_recording.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Gears, units and currents make factors of two and more. A machine's own torque constants, pulleys
// and sensors are hardly ever off by so much, and where one is the log's reader is asked.
constexpr double kBeyond = 1.8;
// What a factor may be off by: a link of other mass changes the weight at the joints before it by
// more, and the factors of known slips are apart by more.
constexpr double kNear = 0.08;

bool is_beyond(double factor) {
  return factor < 0.0 || std::max(factor, 1.0 / factor) > kBeyond;
}

/// Of each joint: what the measured effort has of the model's weight, of its inertia and of what
/// depends on the speed.
std::vector<std::vector<Share>> shares_of(const SmoothEfforts& efforts) {
  const MatrixXd inertia = efforts.starting - efforts.at_rest;
  const MatrixXd of_speed = efforts.said - efforts.starting;
  std::vector<std::vector<Share>> joints;
  for (Index j = 0; j < efforts.qd.cols(); ++j) {
    MatrixXd parts(efforts.qd.rows(), 4);
    parts << efforts.at_rest.col(j), inertia.col(j), of_speed.col(j),
        VectorXd::Ones(efforts.qd.rows());
    BlockRegression regression(3);
    regression.add(parts, efforts.measured.col(j), in_motion(efforts.qd.col(j)));
    joints.push_back(regression.shares());
  }
  return joints;
}

/// A link that is heavier than the model says is so for every joint that carries it.
bool others_are_right(const std::vector<std::vector<Share>>& joints, std::size_t but) {
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (std::size_t part = 0; part < 2; ++part)
      if (j != but && is_known(joints[j][part]) && std::abs(joints[j][part].value - 1.0) > kNear)
        return false;
  return true;
}

void stop(const Log& log, int column, double factor, const std::string& what, FaultList& faults) {
  const Channel& at = log.channels[static_cast<std::size_t>(column)];
  const long row = log.segments.front().first_row;
  const bool turned = factor < 0.0;
  const std::string known = unit_slip_of(std::abs(factor), at.unit, kNear).meaning;
  faults.add(turned ? FaultKind::reversed_sign : FaultKind::unit_slip, Severity::stop, row, row,
             at.column, at.name,
             fmt::format("'{}' is {:.3g} times {}: {}", at.name, factor, what,
                         turned          ? "its sign is reversed"
                         : known.empty() ? "another unit, another gear or a current"
                                         : known),
             turned ? "the log is not used"
                    : fmt::format("units are converted only when told: --map \"{}=#{} [unit]\"",
                                  at.name, at.column));
}

/// -P^T f of one tendon: samples x joints.
MatrixXd torque_of(const Recording& slow, Index tendon, Index joints) {
  const VectorXd f = slow.signals.at("tension").col(tendon);
  return -(slow.signals.at("moment_arm").middleCols(tendon * joints, joints).array().colwise() *
           f.array())
              .matrix();
}

/// What the model asks of the joints that a tendon passes by `forces`, torques of samples x joints,
/// beside what each joint may have of its own.
BlockRegression at_joints_of(const MatrixXd& tendon, const std::vector<MatrixXd>& forces,
                             const MatrixXd& said, const Recording& slow) {
  const auto asked = static_cast<Index>(forces.size());
  BlockRegression regression(asked);
  for (Index j = 0; j < said.cols(); ++j) {
    if (tendon.col(j).isZero(0.0)) continue;
    MatrixXd columns = MatrixXd::Zero(said.rows(), asked + 4 * said.cols());
    for (Index k = 0; k < asked; ++k) columns.col(k) = forces[static_cast<std::size_t>(k)].col(j);
    columns.middleCols(asked + 4 * j, 4) = own_drive(slow.qd.col(j), slow.qdd.col(j));
    regression.add(columns, said.col(j), in_motion(slow.qd.col(j)));
  }
  return regression;
}

/// How many times too large one force is beside all others.
struct Odd {
  Share factor;
  double others = 1.0;  ///< by what the others have to be multiplied for what the model asks for
};

/// What friction and masses are is never known as well as the ratio of two sensors is.
Odd odd_force(const Recording& slow, const std::vector<MatrixXd>& torques, std::size_t tendon,
              const MatrixXd& said) {
  MatrixXd others = MatrixXd::Zero(said.rows(), said.cols());
  for (std::size_t t = 0; t < torques.size(); ++t)
    if (t != tendon) others += torques[t];
  const BlockRegression apart =
      at_joints_of(torques[tendon], {others, torques[tendon]}, said, slow);
  return {apart.ratio(), apart.shares().front().value};
}

/// The force that is off. Of two that pull at the same joints one is too large or the other too
/// small: it is the one without which the others are what the model asks for.
std::optional<std::pair<std::size_t, double>> force_that_is_off(
    const Recording& slow, const std::vector<MatrixXd>& torques, const MatrixXd& said) {
  std::optional<std::pair<std::size_t, double>> found;
  double least = 0.0;
  for (std::size_t t = 0; t < torques.size(); ++t) {
    const Odd odd = odd_force(slow, torques, t, said);
    if (!is_known(odd.factor) || !is_beyond(odd.factor.value) || !(odd.others > 0.0)) continue;
    const double distance = std::abs(std::log(odd.others));
    if (found && distance >= least) continue;
    found = {t, odd.factor.value};
    least = distance;
  }
  return found;
}

}  // namespace

void judge_effort_factors(const Log& log, const DrivenColumns& columns, const Recording& recording,
                          const EffortModel& model, FaultList& faults) {
  if (columns.efforts.size() < 2 || !columns.forces.empty()) return;
  const std::vector<std::vector<Share>> joints = shares_of(smooth_efforts(recording, model));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const std::optional<double> factor = common_factor(joints[j]);
    if (factor && is_beyond(*factor) && others_are_right(joints, j))
      stop(log, columns.efforts[j], *factor,
           "what the model says of this motion, its weight, its inertia and its friction alike",
           faults);
  }
}

void judge_force_factors(const Log& log, const DrivenColumns& columns, const Recording& recording,
                         const DrivenModel& model, const EffortModel& effort, FaultList& faults) {
  const Recording slow = slow_recording(recording);
  if (slow.q.rows() == 0) return;
  const auto tendons = static_cast<Index>(columns.forces.size());
  const auto joints = model.tendons.coordinates();
  const MatrixXd said = effort(slow).leftCols(joints);
  std::vector<MatrixXd> torques;
  for (Index t = 0; t < tendons; ++t) torques.push_back(torque_of(slow, t, joints));
  if (const auto off = force_that_is_off(slow, torques, said))
    stop(log, columns.forces[off->first], off->second,
         "what the joints' torques ask of it, the other forces being right", faults);
}

}  // namespace sinew::diagnosis
