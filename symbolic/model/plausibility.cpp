// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/plausibility.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "symbolic/files/description_error.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Bodies that show one thing, told in one suspicion.
struct Shown {
  std::vector<std::string> names;
  SourceLocation where;
  std::string first;  ///< what is seen at the first

  void add(const std::string& name, const SourceLocation& place, std::string what) {
    if (names.empty()) where = place, first = std::move(what);
    names.push_back(name);
  }

  void tell(const std::string& meaning, std::vector<Suspicion>& into) const {
    if (names.empty()) return;
    const std::string others =
        names.size() == 1 ? ""
                          : fmt::format(" (and so {})", listed({names.begin() + 1, names.end()}));
    into.push_back({where, first + others + "; " + meaning});
  }
};

/// Second moments of a body's mass about its centre over the mass [m^2]: the covariance of where it
/// is.
Matrix3d mass_covariance(const Body& body, const Matrix3d& inertia) {
  return (0.5 * inertia.trace() * Matrix3d::Identity() - inertia) / body.mass;
}

Matrix3d with_turned_products(Matrix3d inertia) {
  const Vector3d diagonal = inertia.diagonal();
  inertia = -inertia;
  inertia.diagonal() = diagonal;
  return inertia;
}

Vector3d principal_covariance(const Matrix3d& covariance) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance, Eigen::EigenvaluesOnly).eigenvalues();
}

class BodyPlausibility {
 public:
  explicit BodyPlausibility(const Mechanism& mechanism) : mechanism_(mechanism) {
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      reach_.push_back(reach_of(i));
      longest_ = std::max(longest_, reach_.back());
    }
    size_ = std::accumulate(reach_.begin(), reach_.end(), 0.0);
  }

  std::vector<Suspicion> all() {
    lengths();
    pulleys();
    densities();
    gyrations();
    default_masses();
    product_signs();
    return std::move(found_);
  }

 private:
  /// Where the body's own joint, the joints and frames on it are, in its frame.
  std::vector<Vector3d> points_on(std::size_t index) const {
    std::vector<Vector3d> points{Vector3d::Zero()};
    for (const Joint& joint : mechanism_.joints)
      if (joint.parent == static_cast<int>(index)) points.push_back(joint.origin.translation);
    for (const Frame& frame : mechanism_.frames)
      if (frame.body == mechanism_.bodies[index].name) points.push_back(frame.pose.translation);
    return points;
  }

  double reach_of(std::size_t index) const {
    double reach = mechanism_.bodies[index].centre_of_mass.norm();
    for (const Vector3d& point : points_on(index)) reach = std::max(reach, point.norm());
    return reach;
  }

  void lengths() {
    Shown shown;
    for (std::size_t i = 0; i < reach_.size(); ++i) {
      const Body& body = mechanism_.bodies[i];
      if (reach_[i] > plausible::longest_link)
        shown.add(body.name, body.where,
                  fmt::format("body '{}' reaches {:.4g} m from its joint", body.name, reach_[i]));
    }
    shown.tell(fmt::format("no link of a robot is {:g} m long: are these millimetres, given as "
                           "metres? Look at the joints' origins and the centre of mass",
                           plausible::longest_link),
               found_);
  }

  void pulleys() {
    Shown shown;
    const double largest =
        size_ > 0.0 ? std::min(plausible::largest_pulley, size_) : plausible::largest_pulley;
    for (const Tendon& tendon : mechanism_.tendons)
      for (const PulleyRouting& pulley : tendon.pulleys)
        if (std::abs(pulley.radius) > largest)
          shown.add(tendon.name, tendon.where,
                    fmt::format("tendon '{}' runs over a pulley with a radius of {:.4g} m at '{}'",
                                tendon.name, std::abs(pulley.radius), pulley.joint));
    shown.tell(fmt::format("it is larger than {}: are these millimetres, given as metres? Look at "
                           "the pulley's unit",
                           largest < plausible::largest_pulley
                               ? fmt::format("all links together ({:.3g} m)", size_)
                               : fmt::format("any pulley of a robot ({:g} m)", largest)),
               found_);
  }

  /// kg/m^3 that the body has at least somewhere.
  double least_density(const Body& body) const {
    const Vector3d variance = principal_covariance(mass_covariance(body, body.inertia));
    // A point or a rod says nothing of its volume; the longest link says how large it may be.
    if (variance[0] <= 1e-9 * variance[2] || variance[2] <= 0.0)
      return longest_ > 0.0 ? body.mass / std::pow(longest_, 3) : 0.0;
    const Vector3d half_axes = (5.0 * variance).cwiseSqrt();
    return body.mass / (4.0 / 3.0 * std::numbers::pi * half_axes.prod());
  }

  void densities() {
    Shown shown;
    for (const Body& body : mechanism_.bodies) {
      if (body.mass <= 0.0) continue;
      const double density = least_density(body);
      if (density > plausible::densest)
        shown.add(body.name, body.where,
                  fmt::format("body '{}' of {:.4g} kg has at least {:.3g} kg/m^3 by its size",
                              body.name, body.mass, density));
    }
    shown.tell(
        "no material is so dense (osmium: 22600): are these grams, given as kilograms, or is the "
        "inertia too small? Look at the units of mass and inertia",
        found_);
  }

  void gyrations() {
    Shown shown;
    const bool has_size =
        std::count_if(reach_.begin(), reach_.end(), [](double reach) { return reach > 0.0; }) > 1;
    const double widest =
        has_size ? std::min(plausible::longest_link, plausible::widest_gyration * size_)
                 : plausible::longest_link;
    for (const Body& body : mechanism_.bodies) {
      if (body.mass <= 0.0) continue;
      const double radius =
          std::sqrt(std::max(0.0, principal_covariance(mass_covariance(body, body.inertia))[2]));
      if (radius > widest)
        shown.add(body.name, body.where,
                  fmt::format("the inertia of body '{}' is that of {:.4g} kg spread over {:.3g} m "
                              "around its centre",
                              body.name, body.mass, radius));
    }
    shown.tell(fmt::format("the links together are {:.3g} m long: is the inertia in another unit "
                           "(g mm^2, kg mm^2, kg cm^2)? Look at its unit",
                           size_),
               found_);
  }

  void default_masses() {
    Shown shown;
    std::size_t masses = 0;
    for (const Body& body : mechanism_.bodies) {
      if (body.mass <= 0.0) continue;
      ++masses;
      if (body.mass == plausible::default_mass)
        shown.add(body.name, body.where, fmt::format("body '{}' has a mass of 1 kg", body.name));
    }
    if (masses > 1 && shown.names.size() == masses)
      shown.tell("exporters write 1 kg where no mass was set: set the bodies' materials in CAD",
                 found_);
  }

  /// Mean squared distance of the body's joints from its mass, in standard deviations of where that
  /// mass is; nothing where the inertia is a rod's or a point's.
  std::optional<double> distance_from_mass(std::size_t index, const Matrix3d& inertia) const {
    const Body& body = mechanism_.bodies[index];
    const Matrix3d covariance = mass_covariance(body, inertia);
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(covariance);
    if (solver.eigenvalues()[0] <= 1e-3 * solver.eigenvalues()[2]) return std::nullopt;
    const Matrix3d weight = solver.eigenvectors() *
                            solver.eigenvalues().cwiseInverse().asDiagonal() *
                            solver.eigenvectors().transpose();
    double sum = 0.0;
    const std::vector<Vector3d> points = points_on(index);
    for (const Vector3d& point : points) {
      const Vector3d r = point - body.centre_of_mass;
      sum += r.dot(weight * r);
    }
    return sum / static_cast<double>(points.size());
  }

  void product_signs() {
    Shown shown;
    bool contradicted = false;
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
      const Body& body = mechanism_.bodies[i];
      if (body.mass <= 0.0) continue;
      const auto given = distance_from_mass(i, body.inertia);
      const auto turned = distance_from_mass(i, with_turned_products(body.inertia));
      if (!given || !turned) continue;
      contradicted = contradicted || *turned > plausible::sign_evidence * *given;
      if (*given > plausible::sign_evidence * *turned && *given > plausible::far_from_mass)
        shown.add(body.name, body.where,
                  fmt::format("the mass of body '{}' lies across its joints by the signs of ixy, "
                              "ixz, iyz, and along them with the other signs",
                              body.name));
    }
    if (!contradicted)
      shown.tell(
          "are these the integrals +x y dm that some CAD programs export? The entries of the "
          "inertia tensor are -x y dm: turn the signs",
          found_);
  }

  const Mechanism& mechanism_;
  std::vector<double> reach_;  ///< m, of each body from its joint
  double longest_ = 0.0, size_ = 0.0;
  std::vector<Suspicion> found_;
};

}  // namespace

std::string to_text(const Suspicion& suspicion) {
  return to_text(suspicion.where) + ": " + message_part(suspicion.text);
}

std::vector<Suspicion> implausible_bodies(const Mechanism& mechanism) {
  return BodyPlausibility(mechanism).all();
}

}  // namespace sinew
