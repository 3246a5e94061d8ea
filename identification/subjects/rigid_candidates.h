// SPDX-License-Identifier: GPL-3.0-or-later
// What a mechanism's mass properties and gravity may get wrong, as columns from its emitted inverse
// dynamics with masses and gravity as arguments.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "identification/regression/candidate.h"
#include "simulation/emitted/compiled_model.h"
#include "symbolic/model/mechanism.h"

namespace sinew::diagnosis {

/// Inverse dynamics that is linear in mass properties and in gravity.
class RigidColumns {
 public:
  /// `runtime`: folder of the runtime's headers.
  RigidColumns(const Mechanism& mechanism, const std::filesystem::path& runtime);

  const Mechanism& mechanism() const { return mechanism_; }

  /// Columns of every effect for a recording, samples x (coordinates * columns), into its wide
  /// signals; columns of one coordinate stand together.
  void add_signals(Recording& log) const;

  /// What the links ask of the joints: samples x coordinates.
  Eigen::MatrixXd effort(const Recording& log) const;

  /// Mass matrix of the links at every sample: samples x (coordinates * coordinates), one column of
  /// it after the other.
  Eigen::MatrixXd mass_matrix(const Recording& log) const;

  /// What ten parameters of a mass that moves with a link ask of the joints (mass, first moments x,
  /// y, z, moments of inertia xx, yy, zz, xy, xz, yz): samples x (coordinates * 10), those of one
  /// coordinate together. Throws std::invalid_argument for a link that does not move.
  Eigen::MatrixXd mass_columns(const std::string& link, const Recording& log) const;
  /// What a point mass of 1 kg at `centre` in the link's frame [m] asks: samples x coordinates.
  Eigen::MatrixXd point_mass(const std::string& link, const Eigen::Vector3d& centre,
                             const Recording& log) const;
  /// What a link asks of the joints as it is drawn, and what the mass of a usual link of this
  /// mechanism asks that sits beside its centre of mass either way along x, y and z, as far as the
  /// link reaches (extent_of()): samples x (coordinates * kBodyColumns), those of one coordinate
  /// together.
  static constexpr Eigen::Index kBodyColumns = 7;
  Eigen::MatrixXd body_columns(const std::string& link, const Recording& log) const;
  /// What an external force at a point of the link ([m], its frame) asks of the resting joints,
  /// -J^T e: samples x (3 * coordinates), those of a force along x of the base's frame together,
  /// then y and z. Reads the positions.
  Eigen::MatrixXd force_columns(const std::string& link, const Eigen::Vector3d& point,
                                const Recording& log) const;
  /// A link's centre of mass, its frame [m], and how far from there the farthest of the joints and
  /// frames is that it carries.
  std::pair<Eigen::Vector3d, double> extent_of(const std::string& link) const;
  Eigen::Index coordinates() const { return coordinates_; }
  /// Of the links that move together: mass [kg], and how far one after the other reaches [m].
  std::pair<double, double> moving_mass_and_reach() const;
  /// Links that move with a joint, and of these the ones that carry no further link.
  std::vector<std::string> moving_links() const;
  std::vector<std::string> last_links() const;

  /// A candidate and the model effect (model_effects.h) that it stands for.
  struct OfMechanism {
    Candidate candidate;
    std::string effect;
  };
  /// Candidates that act on all channels; they read what add_signals left in the recording.
  std::vector<OfMechanism> candidates() const;

 private:
  struct Column {
    Eigen::VectorXd plus, minus;  ///< parameters; the column is their difference * scale
                                  ///< (minus empty: nothing is taken off)
    double scale = 1.0;
  };
  struct Group {
    std::string effect, signal, name, place, experiment, limit;
    std::vector<LinearParameter> parameters;
    std::vector<Column> columns;
    bool unlikely = false;
    /// Of a link's own parameters: its moments per mass and first moment, 6 x 4.
    std::optional<Eigen::MatrixXd> as_drawn;
    std::optional<double> body_within;
  };
  Eigen::VectorXd parameters(const Eigen::VectorXd& mass, const Eigen::MatrixXd& com,
                             const Eigen::MatrixXd& inertia, const Eigen::Vector3d& gravity) const;
  Eigen::VectorXd nominal(const Eigen::Vector3d& gravity) const;
  Group mass_of(const Body& carrier, Eigen::Index body) const;
  std::size_t body_of(const std::string& link) const;
  void add_payload(const Mechanism& mechanism, std::size_t body);
  void add_inertial(const Mechanism& mechanism, std::size_t body, bool leaf);
  void add_density(const Mechanism& mechanism, std::size_t body, bool leaf);
  Eigen::MatrixXd columns_of(const Group& group, const Recording& log) const;
  void add_gravity(const Mechanism& mechanism);

  Mechanism mechanism_;
  std::shared_ptr<CompiledModel> compiled_;
  Eigen::Index bodies_, coordinates_;
  std::vector<Group> groups_;
};

}  // namespace sinew::diagnosis
