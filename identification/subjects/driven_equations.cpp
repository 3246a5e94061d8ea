// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/driven_equations.h"

#include <cmath>
#include <limits>
#include <utility>

#include "identification/logs/signal_relations.h"
#include "identification/subjects/block_regression.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Expected of a drawing's masses and of its friction, of a tendon's arm, and of a drive that the
// model is without at a motor or where it has no links: in shares of what it asks of such
// coordinates.
constexpr double kMassOrFriction = 0.1, kArm = 0.05, kDrive = 10.0;
constexpr double kFarFaster = 100.0;    // times the logged speed: there all friction has turned
constexpr double kRounding = 1e-9;      // of what is usual: left of a difference
constexpr std::size_t kMostLinks = 10;  // that are told apart: an arm's or a finger's, not a hand's
constexpr Index kCurve = 3;             // degree, that of a short cable's torque in the library
constexpr Index kPerLink = RigidColumns::kBodyColumns;

/// Each body's own share, and what it may carry.
std::vector<Unknown> unknowns_of_links(Index columns) {
  std::vector<Unknown> unknowns;
  for (Index k = 0; k < columns; ++k)
    unknowns.push_back(
        {k % kPerLink == 0 ? Unknown::Kind::share : Unknown::Kind::added, kMassOrFriction});
  return unknowns;
}

/// samples x (kCurve + 1): Chebyshev polynomials over the reach, for a cable, a spring, a tilted
/// base.
MatrixXd chebyshev(const VectorXd& q) {
  MatrixXd curve = MatrixXd::Ones(q.size(), kCurve + 1);
  const double middle = 0.5 * (q.maxCoeff() + q.minCoeff()),
               half = 0.5 * (q.maxCoeff() - q.minCoeff());
  const VectorXd x = (q.array() - middle) / std::max(half, kRounding);
  curve.col(1) = x;
  for (Index k = 2; k <= kCurve; ++k)
    curve.col(k) = 2.0 * x.cwiseProduct(curve.col(k - 1)) - curve.col(k - 2);
  return curve;
}

/// Whether the model has an inertia, viscous or Coulomb friction (0, 1, 2) of the coordinate.
bool is_drawn(const EffortParts& parts, Index k, double usual) {
  return rms(parts.drive.col(k + 1).array()) > kRounding * usual;
}

}  // namespace

/// By the model, all coordinates: samples x coordinates each.
struct DrivenEquations::Said {
  MatrixXd rest, load, inertia, viscous, coulomb, slow, links, all;
};

struct DrivenEquations::Logged {
  double step = 0.0;  ///< s
  Said said;
  MatrixXd links_at_rest;
};

DrivenEquations::DrivenEquations(const DrivenModel& model, const EffortModel& effort,
                                 const RigidColumns* rigid, Index efforts)
    : model_(model),
      effort_(effort),
      rigid_(rigid && rigid->moving_links().size() <= kMostLinks ? rigid : nullptr),
      coordinates_(static_cast<Index>(model.joints.size())),
      measured_(model.tendons.names.empty() ? efforts : coordinates_),
      by_tendons_(model.tendons.names.empty() ? 0 : coordinates_ - efforts) {}

/// `links`: links_at() the recording.
DrivenEquations::Said DrivenEquations::said_of(const Recording& r, MatrixXd links) const {
  const MatrixXd none = MatrixXd::Zero(r.q.rows(), r.q.cols());
  Said said;
  const MatrixXd loaded = effort_(r, r.q, none, none);
  said.rest = loaded;
  if (r.load.size() > 0) {
    Recording unloaded = r;
    unloaded.load.setZero();
    said.rest = effort_(unloaded, r.q, none, none);
    said.load = loaded - said.rest;
  }
  const MatrixXd starting = effort_(r, r.q, none, r.qdd);
  const auto by_speed = [&](double times) -> MatrixXd {
    return effort_(r, r.q, times * r.qd, r.qdd) - starting;
  };
  said.all = effort_(r, r.q, r.qd, r.qdd);
  const MatrixXd onwards = said.all - starting;
  // Of the motion reversed: friction turns round, centrifugal and Coriolis torques do not.
  const MatrixXd centrifugal = 0.5 * (onwards + by_speed(-1.0));
  const auto friction = [&](double times) -> MatrixXd {
    return by_speed(times) - times * times * centrifugal;
  };
  const MatrixXd fast = friction(kFarFaster), faster = friction(2.0 * kFarFaster);
  said.inertia = starting - loaded + centrifugal;
  said.viscous = (faster - fast) / kFarFaster;
  said.coulomb = 2.0 * fast - faster;
  // Friction of which another power of the speed was learnt turns nowhere: it is told as a whole.
  const MatrixXd bent = friction(4.0 * kFarFaster) - 3.0 * faster + 2.0 * fast;
  for (Index c = 0; c < bent.cols(); ++c)
    if (bent.col(c).norm() > kAnyway * faster.col(c).norm()) {
      said.viscous.col(c).setZero();
      said.coulomb.col(c) = onwards.col(c) - centrifugal.col(c);
    }
  said.slow = onwards - centrifugal - said.viscous - said.coulomb;
  if (!rigid_) return said;
  // The links' part is asked for link by link.
  Recording motion;
  const auto of_links = [&](const MatrixXd& qd, const MatrixXd& qdd) {
    motion.q = r.q;
    motion.qd = qd;
    motion.qdd = qdd;
    return rigid_->effort(motion);
  };
  const MatrixXd at_rest = of_links(none, none);
  const Index n = rigid_->coordinates();
  said.rest.leftCols(n) -= at_rest;
  said.inertia.leftCols(n) -= of_links(r.qd, r.qdd) - at_rest;
  said.links = std::move(links);
  return said;
}

/// samples x (coordinates * links * kPerLink), those of one coordinate together.
MatrixXd DrivenEquations::links_at(const Recording& r) const {
  if (!rigid_) return {};
  const std::vector<std::string> names = rigid_->moving_links();
  const Index n = rigid_->coordinates(), per = kPerLink * static_cast<Index>(names.size());
  MatrixXd all(r.q.rows(), n * per);
  Index link = 0;
  for (const std::string& name : names) {
    const MatrixXd columns = rigid_->body_columns(name, r);
    for (Index c = 0; c < n; ++c)
      all.middleCols(c * per + link * kPerLink, kPerLink) =
          columns.middleCols(c * kPerLink, kPerLink);
    ++link;
  }
  return all;
}

std::vector<EffortParts> DrivenEquations::parts_of(const Recording& recording) const {
  return parts_of(recording, said_of(recording, links_at(recording)));
}

std::shared_ptr<const DrivenEquations::Logged> DrivenEquations::logged(
    const Recording& recording) const {
  Recording resting;
  resting.q = recording.q;
  resting.qd = resting.qdd = MatrixXd::Zero(recording.q.rows(), recording.q.cols());
  return std::make_shared<const Logged>(
      Logged{recording.step, said_of(recording, links_at(recording)), links_at(resting)});
}

/// What moves a body takes goes with the square of the pace.
std::vector<EffortParts> DrivenEquations::parts_of(const Recording& recording,
                                                   const Logged& motion) const {
  if (recording.step == motion.step) return parts_of(recording, motion.said);
  const double pace = motion.step / recording.step;
  const MatrixXd& rest = motion.links_at_rest;
  return parts_of(recording, said_of(recording, rest + pace * pace * (motion.said.links - rest)));
}

std::vector<EffortParts> DrivenEquations::parts_of(const Recording& recording,
                                                   const Said& said) const {
  std::vector<EffortParts> parts;
  for (Index i = 0; i < measured_; ++i) parts.push_back(parts_at(recording, said, i));
  return parts;
}

EffortParts DrivenEquations::parts_at(const Recording& r, const Said& said, Index i) const {
  const Index c = coordinate(i);
  const VectorXd counts = in_motion(r.qd.col(c));
  std::vector<Index> moving;
  for (Index k = 0; k < counts.size(); ++k)
    if (counts(k) > 0.0) moving.push_back(k);
  EffortParts parts;
  parts.measured = r.target[static_cast<std::size_t>(i)](moving);
  parts.said = said.all.col(c)(moving);
  parts.moving = static_cast<double>(moving.size()) / static_cast<double>(counts.size());
  if (said.load.size() > 0) parts.load = said.load.col(c)(moving);
  const Index of_links = rigid_ ? rigid_->coordinates() : 0;
  const Index per = c < of_links ? said.links.cols() / of_links : 0;
  parts.links.resize(parts.said.size(), per);
  if (per > 0) parts.links = said.links(moving, Eigen::seqN(per * c, per));
  parts.drive.resize(parts.said.size(), 4);
  parts.drive << said.rest.col(c)(moving), said.inertia.col(c)(moving), said.viscous.col(c)(moving),
      said.coulomb.col(c)(moving);
  parts.slow = said.slow.col(c)(moving);
  parts.curve = chebyshev(r.q.col(c)(moving));
  parts.own = own_drive(r.qd.col(c), r.qdd.col(c))(moving, Eigen::seqN(0, 3));
  if (i >= by_tendons_) return parts;
  const MatrixXd& tension = r.signals.at("tension");
  const MatrixXd& arms = r.signals.at("moment_arm");
  parts.tendons.resize(parts.said.size(), tension.cols());
  for (Index t = 0; t < tension.cols(); ++t)  // -P^T f
    parts.tendons.col(t) = -arms.col(t * by_tendons_ + c).cwiseProduct(tension.col(t))(moving);
  parts.guides = parts.tendons.cwiseProduct(r.signals.at("tendon_direction")(moving, Eigen::all));
  return parts;
}

/// Efforts of one kind: of joints that turn, of those that slide, of motors.
int DrivenEquations::kind_of(Index i) const {
  const DrivenJoint& joint = model_.joints[static_cast<std::size_t>(coordinate(i))];
  return joint.motor ? 2 : joint.revolute ? 1 : 0;
}

double DrivenEquations::usual(const std::vector<EffortParts>& parts, std::size_t i) const {
  double squares = 0.0, count = 0.0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (kind_of(static_cast<Index>(k)) != kind_of(static_cast<Index>(i))) continue;
    squares += parts[k].said.squaredNorm();
    count += static_cast<double>(parts[k].said.size());
  }
  return std::sqrt(squares / std::max(1.0, count));
}

/// N m or N: what a drive may take that the model is without.
double DrivenEquations::expected_drive(Index i, double usual) const {
  return usual * (rigid_ && kind_of(i) != 2 ? kAnyway : kDrive);
}

EffortEquation DrivenEquations::equation_of(const EffortParts& parts, double usual, double drive,
                                            std::vector<Unknown>& unknowns) const {
  EffortEquation equation{parts.measured, parts.said, kStretches * parts.moving, {}};
  for (Index k = 0; k < parts.links.cols(); ++k)
    equation.terms.push_back({static_cast<int>(k), parts.links.col(k)});
  const auto add = [&](const VectorXd& column, Unknown::Kind kind, double spread) {
    if (!(rms(column.array()) > kRounding * usual)) return;
    equation.terms.push_back({static_cast<int>(unknowns.size()), column});
    unknowns.push_back({kind, spread});
  };
  if (parts.load.size() > 0) add(parts.load, Unknown::Kind::fixed, kOwnConstant);
  for (Index k = 0; k < parts.drive.cols(); ++k)
    add(parts.drive.col(k), Unknown::Kind::share, k < 2 ? kAnyway : kMassOrFriction);
  // Over which speeds friction turns is nobody's measurement.
  add(parts.slow, Unknown::Kind::drawn, 1.0);
  for (Index k = 0; k < parts.own.cols(); ++k) {
    const double size = rms(parts.own.col(k).array());
    // An inertia that the model has is off by a share of itself. A friction's form is off as well.
    const bool has = is_drawn(parts, k, usual);
    if (size > 0.0 && !(has && k == 0))
      add(parts.own.col(k) / size, Unknown::Kind::added, has ? kAnyway * usual : drive);
  }
  // Tendons pull against each other, by more than what moves the joint.
  const double pulled =
      parts.tendons.cols() > 0 ? rms(parts.tendons.rowwise().norm().array()) : 0.0;
  for (Index k = 0; k < parts.curve.cols(); ++k)
    add(std::max(usual, pulled) * parts.curve.col(k), Unknown::Kind::drawn, kAnyway);
  for (Index t = 0; t < parts.tendons.cols(); ++t) {
    add(parts.tendons.col(t), Unknown::Kind::fixed, kArm);
    add(parts.guides.col(t), Unknown::Kind::drawn, kAnyway);
  }
  return equation;
}

double DrivenEquations::evidence_alone(const std::vector<EffortParts>& parts, std::size_t i) const {
  std::vector<Unknown> unknowns = unknowns_of_links(parts[i].links.cols());
  const double asked = usual(parts, i);
  const EffortEquation equation =
      equation_of(parts[i], asked, expected_drive(static_cast<Index>(i), asked), unknowns);
  return explained_by({equation}, unknowns).log_likelihood;
}

std::vector<double> DrivenEquations::evidence_each(const std::vector<EffortParts>& parts) const {
  std::vector<double> all;
  for (std::size_t i = 0; i < parts.size(); ++i) all.push_back(evidence_alone(parts, i));
  return all;
}

/// Efforts have nothing in common but the links.
double DrivenEquations::evidence(const std::vector<EffortParts>& parts) const {
  double sum = 0.0;
  std::vector<Unknown> unknowns;
  std::vector<EffortEquation> joined;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].links.cols() == 0) {
      sum += evidence_alone(parts, i);
      continue;
    }
    if (joined.empty()) unknowns = unknowns_of_links(parts[i].links.cols());
    const double asked = usual(parts, i);
    joined.push_back(
        equation_of(parts[i], asked, expected_drive(static_cast<Index>(i), asked), unknowns));
  }
  return joined.empty() ? sum : sum + explained_by(joined, unknowns).log_likelihood;
}

std::vector<double> DrivenEquations::left_as_drawn(const std::vector<EffortParts>& parts) const {
  std::vector<double> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const EffortParts& p = parts[i];
    EffortEquation equation{p.measured, p.said, kStretches * p.moving, {}};
    std::vector<Unknown> unknowns;
    for (Index k = 0; k < p.own.cols(); ++k) {
      const double size = rms(p.own.col(k).array());
      if (!(size > 0.0) || is_drawn(p, k, usual(parts, i))) continue;
      equation.terms.push_back({static_cast<int>(unknowns.size()), p.own.col(k) / size});
      unknowns.push_back({Unknown::Kind::added, std::numeric_limits<double>::infinity()});
    }
    all.push_back(explained_by({equation}, unknowns).left.front());
  }
  return all;
}

}  // namespace sinew::diagnosis
