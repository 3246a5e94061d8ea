// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <memory>
#include <utility>
#include <vector>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// All moving joints as functions of the coordinates, at one set of coordinates: positions, and
/// with J = d(positions)/d(coordinates) what follows from them. Each joint follows one coordinate.
class JointMap {
 public:
  struct Entry {
    int coordinate;
    GiNaC::ex position;
    GiNaC::ex slope;      ///< its derivative by the coordinate
    GiNaC::ex curvature;  ///< and the second
  };
  JointMap(std::vector<Entry> joints, std::size_t coordinates)
      : joints_(std::move(joints)), coordinates_(coordinates) {}

  std::vector<GiNaC::ex> positions() const;
  /// J qd.
  std::vector<GiNaC::ex> velocities(const std::vector<GiNaC::ex>& qd) const;
  /// J qdd + dJ/dt qd.
  std::vector<GiNaC::ex> accelerations(DefinitionList& list, const std::vector<GiNaC::ex>& qd,
                                       const std::vector<GiNaC::ex>& qdd) const;
  /// J^T tau.
  std::vector<GiNaC::ex> projected(const std::vector<GiNaC::ex>& joint_forces) const;
  /// J^T M J, row-major.
  std::vector<GiNaC::ex> projected_matrix(const std::vector<GiNaC::ex>& joint_matrix) const;
  /// J^T (C J + M dJ/dt), row-major: Christoffel symbols of J^T M J where C has those of M.
  std::vector<GiNaC::ex> projected_coriolis(const std::vector<GiNaC::ex>& C,
                                            const std::vector<GiNaC::ex>& M,
                                            const std::vector<GiNaC::ex>& qd) const;
  /// A J for a row-major matrix with one column a moving joint.
  std::vector<GiNaC::ex> projected_columns(const std::vector<GiNaC::ex>& matrix) const;

 private:
  /// J^T A for a row-major matrix with one row a moving joint and one column a coordinate.
  std::vector<GiNaC::ex> projected_rows(const std::vector<GiNaC::ex>& matrix) const;

  std::vector<Entry> joints_;  // per moving joint
  std::size_t coordinates_;
};

/// Generalised coordinates of a mechanism whose joints may be coupled: a dependent joint follows an
/// independent one, q_dependent = ratio * q_independent + offset (5.16) or as a four-bar linkage
/// makes it (5.5), and has no coordinate of its own.
class Coordinates {
 public:
  /// Throws std::invalid_argument where a coupling names no joint or a joint depends on itself.
  explicit Coordinates(const Mechanism& mechanism);

  int count() const { return static_cast<int>(joints_.size()); }
  /// Index into mechanism.joints of each coordinate's own joint.
  const std::vector<int>& joints() const& { return joints_; }
  std::vector<int> joints() && { return std::move(joints_); }  // outlives a temporary
  /// Whether J is constant: no four-bar.
  bool linear() const;

  /// The joints at coordinates `q`; what four-bars need is appended to `list`.
  JointMap at(DefinitionList& list, const std::vector<GiNaC::ex>& q) const;

 private:
  struct Follows {
    int coordinate;
    GiNaC::ex ratio, offset;                  ///< of a linear coupling
    std::shared_ptr<const Function> linkage;  ///< of a four-bar, from the crank's angle
    GiNaC::ex crank_angle;                    ///< at coordinate zero
  };
  int coordinate_of(const Mechanism& mechanism, const std::vector<int>& coordinate,
                    const std::string& dependent, const std::string& independent) const;

  std::vector<int> joints_;
  std::vector<Follows> moving_;  // per moving joint
};

}  // namespace sinew
