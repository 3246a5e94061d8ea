// SPDX-License-Identifier: GPL-3.0-or-later
// A rig whose sensors a model predicts (lever and tendon, wrist) under diagnosis: what the emitted
// observation says, and every effect as the derivative of that C by its deviation.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "identification/logs/log.h"
#include "identification/regression/candidate.h"
#include "identification/regression/flexible_families.h"
#include "simulation/emitted/compiled_model.h"
#include "symbolic/extension/observation.h"

namespace sinew::diagnosis {

/// A compiled observation over recordings: inputs by name from Recording::signals (samples x rows),
/// `step` and `state` by themselves.
class ObservedModel {
 public:
  /// `runtime`: folder of the runtime's headers. Throws std::runtime_error where the emitted C does
  /// not compile.
  ObservedModel(const std::string& model, const Function& function,
                const std::filesystem::path& runtime);

  /// samples x channels. deviation and shape as open_observation() orders them; empty for a closed
  /// one. `instead` (may be null): signals that stand for the recording's own.
  Eigen::MatrixXd operator()(const Recording& log, const Eigen::VectorXd& deviation = {},
                             const Eigen::VectorXd& shape = {},
                             const std::map<std::string, Eigen::MatrixXd>* instead = nullptr) const;

  int operations() const { return operations_; }
  /// From now on every channel is given in these units. Losses of all channels are added up.
  void set_units(const Eigen::VectorXd& units) { units_ = units; }

 private:
  int operations_ = 0;
  Eigen::VectorXd units_;
  std::shared_ptr<CompiledModel> compiled_;
};

/// What a measured channel is called.
struct ObservedChannel {
  std::string name, unit;
};

/// What a candidate of the library stands for; effect -1: no term in the model.
struct ObservedOrigin {
  int effect = -1;
  std::string id;
};

class ObservedSubject {
 public:
  ObservedSubject(Observation observation, std::vector<ObservedChannel> channels,
                  Identified identified, std::filesystem::path runtime);

  /// Recordings with their signals, targets, q, qd (what flexible families and plots are over).
  void add(Recording recording, bool held_out);

  /// One candidate for each effect at the deviations learnt so far, with what may act beside them.
  void prepare();
  /// A free value of a channel for each log (a motor's zero), part of the model. After prepare().
  void add_offset(int channel);
  /// A cause that no model can hold, for instance a coarse sensor.
  void add_candidate(Candidate candidate, const std::string& id);

  const Problem& problem() const { return problem_; }
  Problem& problem() { return problem_; }
  const Observation& observation() const { return observation_; }
  const std::vector<ObservedChannel>& channels() const { return channels_; }
  const std::vector<ObservedOrigin>& origins() const { return origins_; }
  const Identified& identified() const { return identified_; }
  const std::filesystem::path& runtime() const { return runtime_; }
  /// What problem()'s channels are in, SI: the rms of what the model leaves over.
  const Eigen::VectorXd& units() const { return units_; }
  const ObservedModel& open() const { return open_; }
  const Eigen::VectorXd& learnt() const { return learnt_; }
  const Eigen::VectorXd& shapes() const { return shapes_; }

 private:
  void set_units();
  void set_known();
  void add_effect(std::size_t index);
  /// Derivatives of what the channels should read by an effect's deviations, a block of columns
  /// (one a channel) for each; at and shape_at: where its deviations and shapes stand among all.
  std::function<Eigen::MatrixXd(const Recording&, const Eigen::VectorXd&)> derivative_columns(
      Eigen::Index at, Eigen::Index shape_at, const std::vector<double>& steps) const;

  Observation observation_;
  std::vector<ObservedChannel> channels_;
  Identified identified_;
  std::filesystem::path runtime_;
  ObservedModel open_;
  Eigen::VectorXd learnt_, shapes_, units_;
  std::vector<Eigen::Index> first_deviation_, first_shape_;
  Problem problem_;
  std::vector<ObservedOrigin> origins_;
};

}  // namespace sinew::diagnosis
