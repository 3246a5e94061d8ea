// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/learnt_mass_matrix.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/effects/effects.h"
#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/model/singular_mass_matrix.h"

namespace sinew {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using GiNaC::ex;

constexpr double least_eigenvalue = 1e-12;  // of a matrix with unit diagonal

/// Points spread evenly over the unit cube: the additive recurrence of Roberts' generalised golden
/// ratio.
std::vector<VectorXd> spread_points(Index dimensions, int count) {
  double ratio = 2.0;
  for (int i = 0; i < 60; ++i)
    ratio = std::pow(1.0 + ratio, 1.0 / (static_cast<double>(dimensions) + 1.0));
  std::vector<VectorXd> points;
  for (int k = 1; k <= count; ++k) {
    VectorXd point(dimensions);
    for (Index d = 0; d < dimensions; ++d)
      point(d) = std::fmod(0.5 + k * std::pow(ratio, -static_cast<double>(d + 1)), 1.0);
    points.push_back(point);
  }
  return points;
}

/// Smallest eigenvalue of the symmetric matrix scaled to a unit diagonal; 0 where an entry of the
/// diagonal is 0, rounding aside, and -1 where one is negative.
double definiteness(const MatrixXd& M) {
  const double rounding = 1e-14 * M.diagonal().cwiseAbs().maxCoeff();
  if (!(M.diagonal().minCoeff() >= -rounding)) return -1.0;
  if (M.diagonal().minCoeff() <= rounding) return 0.0;
  const VectorXd scale = M.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scale.asDiagonal() * M * scale.asDiagonal(),
                                                       Eigen::EigenvaluesOnly);
  return solver.eigenvalues()(0);
}

/// Mass matrix of a mechanism's coordinates, couplings and four-bars regarded.
class RigidMass {
 public:
  explicit RigidMass(const Mechanism& mechanism) : mechanism_(mechanism) {
    const Coordinates coordinates(mechanism);
    n_ = coordinates.count();
    const int m = coordinate_count(mechanism);
    DefinitionList list;
    const Argument q = array_argument("q", static_cast<int>(n_), 1, "", {-1.0, 1.0}, "");
    const JointMap map = coordinates.at(list, {q.symbols.begin(), q.symbols.end()});
    std::vector<ex> identity(static_cast<std::size_t>(m * m), ex(0));
    for (int i = 0; i < m; ++i) identity[static_cast<std::size_t>(i * m + i)] = 1;
    joints_ = {"joints",
               "",
               "",
               {q},
               list.items(),
               {{"positions", m, 1, map.positions(), "", ""},
                {"slopes", m, static_cast<int>(n_), map.projected_columns(identity), "", ""}}};
    if (coordinates.linear()) std::tie(zero_, linear_) = joints_at(VectorXd::Zero(n_));
  }

  MatrixXd operator()(const VectorXd& q) const {
    const auto [positions, slopes] = joints_at(q);
    return slopes.transpose() * mass_matrix_at(mechanism_, positions) * slopes;
  }

 private:
  /// Positions of all moving joints, and their derivatives by the coordinates.
  std::pair<VectorXd, MatrixXd> joints_at(const VectorXd& q) const {
    if (linear_.size() > 0) return {linear_ * q + zero_, linear_};
    const std::vector<double> values = evaluate(joints_, {q.begin(), q.end()});
    const auto m = static_cast<Index>(joints_.outputs.front().rows);
    const Eigen::Map<const MatrixXd> transposed(values.data() + m, n_, m);
    return {VectorXd::Map(values.data(), m), transposed.transpose()};
  }

  const Mechanism& mechanism_;
  Index n_ = 0;
  Function joints_;
  MatrixXd linear_;  ///< those derivatives, where they are the same everywhere
  VectorXd zero_;    ///< and the positions at coordinates zero
};

/// What an entry adds to its joint's effort per unit of acceleration, all else at rest; 0 for
/// effects with memory.
double added_inertia(const IdentifiedEffect& entry) {
  const auto& all = effects();
  const auto effect =
      std::find_if(all.begin(), all.end(), [&](const Effect& e) { return e.id == entry.effect; });
  if (effect == all.end() || !effect->states.empty() || effect->at_tendon) return 0.0;
  const EffectSignals& s = effect_signals();
  GiNaC::exmap map;
  for (const GiNaC::symbol& signal : signal_list()) map[signal] = 0;
  for (std::size_t k = 0; k < effect->shapes.size(); ++k)
    map[effect->shapes[k].symbol] = exact_number(entry.shape.at(k).value);
  map.erase(s.acceleration);
  double sum = 0.0;
  for (std::size_t k = 0; k < effect->columns.size(); ++k) {
    const ex& term = effect->columns[k].term;
    if (!term.has(s.acceleration)) continue;
    const ex slope = term.diff(s.acceleration).subs(s.acceleration == 0).subs(map).evalf();
    sum += entry.coefficients.at(k).value * GiNaC::ex_to<GiNaC::numeric>(slope).to_double();
  }
  return sum;
}

double added_inertia(const Identified& identified, const std::string& place) {
  double sum = 0.0;
  for (const IdentifiedEffect& entry : identified.effects)
    if (entry.place == place) sum += added_inertia(entry);
  return sum;
}

std::string to_blame(const Identified& identified) {
  std::vector<std::string> names;
  for (const IdentifiedEffect& entry : identified.effects)
    if (changes_link(entry) || added_inertia(entry) < 0.0)
      names.push_back(fmt::format("'{}' at '{}'", entry.effect, entry.place));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::optional<std::string> why_motor(const Function& rigid, const std::string& place,
                                     const Identified& identified) {
  const double added = added_inertia(identified, place);
  const double inertia = evaluate(rigid, {0.0, 0.0, 1.0})[0] - evaluate(rigid, {0.0, 0.0, 0.0})[0];
  if (inertia + added > 0.0) return std::nullopt;
  return fmt::format(
      "the inertia of '{}' would be {:.4g} kg*m^2: {:.4g} of the model, {:.4g} by {}", place,
      inertia + added, inertia, added, to_blame(identified));
}

std::string state_text(const std::vector<DrivenJoint>& joints, const VectorXd& q) {
  std::string text;
  for (std::size_t i = 0; i < joints.size(); ++i)
    text += fmt::format("{}{} = {:.4g} {}", i ? ", " : "", joints[i].name, q(static_cast<Index>(i)),
                        joints[i].revolute ? "rad" : "m");
  return text;
}

}  // namespace

std::vector<VectorXd> workspace_samples(const std::vector<Range>& ranges) {
  constexpr Index all_corners_up_to = 8;
  const auto n = static_cast<Index>(ranges.size());
  std::vector<VectorXd> samples;
  const auto add = [&](const auto& share) {
    VectorXd q(n);
    for (Index k = 0; k < n; ++k) {
      const Range& range = ranges[static_cast<std::size_t>(k)];
      q(k) = range.low + share(k) * (range.high - range.low);
    }
    samples.push_back(q);
  };
  add([](Index) { return 0.5; });
  if (n <= all_corners_up_to) {
    for (int corner = 0; corner < 1 << n; ++corner)
      add([&](Index k) { return (corner >> k) & 1 ? 1.0 : 0.0; });
  } else {
    for (const VectorXd& point : spread_points(n, 1 << all_corners_up_to))
      add([&](Index k) { return std::round(point(k)); });
  }
  for (const VectorXd& point : spread_points(n, 64)) add([&](Index k) { return point(k); });
  return samples;
}

std::optional<std::string> why_not_definite(const Mechanism& learnt,
                                            const std::optional<MotorParameters>& motor,
                                            const Identified& identified) {
  if (to_blame(identified).empty()) return std::nullopt;
  const std::vector<DrivenJoint> joints = driven_joints(learnt);
  std::vector<Range> ranges;
  VectorXd armature(static_cast<Index>(joints.size())), added = armature;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    ranges.push_back(joints[i].position);
    armature(static_cast<Index>(i)) = joints[i].armature;
    added(static_cast<Index>(i)) = added_inertia(identified, joints[i].name);
  }
  const RigidMass rigid(learnt);
  for (const VectorXd& q : workspace_samples(ranges)) {
    MatrixXd M = rigid(q);
    M.diagonal() += armature;
    const double before = definiteness(M);
    M.diagonal() += added;
    const double after = definiteness(M);
    // A pose in which a joint moves nothing is singular in any case; that is not what was learnt.
    if (after > least_eigenvalue || (after >= -least_eigenvalue && before <= least_eigenvalue))
      continue;
    return fmt::format(
        "the mass matrix would not be positive definite at {}: a torque there would accelerate "
        "the joints the wrong way; to blame: {}",
        state_text(joints, q), to_blame(identified));
  }
  for (std::size_t i = 1; motor && i <= learnt.tendons.size(); ++i)
    if (const auto why =
            why_motor(motor_rigid_torque(*motor), "motor " + std::to_string(i), identified))
      return why;
  return std::nullopt;
}

std::optional<std::string> why_not_definite(const DrivenModel& motor,
                                            const Identified& identified) {
  return why_motor(motor.rigid, motor.joints.front().name, identified);
}

}  // namespace sinew
