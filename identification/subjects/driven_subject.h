// SPDX-License-Identifier: GPL-3.0-or-later
// Joints with drives under diagnosis: recordings from logs, the baseline whose coefficients are
// changes of the model's own values, and the library of what may be missing at each joint.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "identification/diagnosis/separation.h"
#include "identification/logs/log.h"
#include "identification/regression/candidate.h"
#include "identification/regression/flexible_families.h"
#include "identification/regression/linear_fit.h"
#include "identification/regression/order_spectrum.h"
#include "identification/subjects/effect_candidate.h"
#include "identification/subjects/effort_model.h"
#include "identification/subjects/known_payload.h"
#include "identification/subjects/rigid_candidates.h"
#include "identification/subjects/tendon_candidates.h"
#include "symbolic/extension/driven_model.h"

namespace sinew::diagnosis {

/// Left away at both ends of every log [s]: there the smoothers reach beyond it.
inline constexpr double driven_edge = 0.25;

/// Highest frequency looked at [Hz] unless told otherwise.
inline constexpr double driven_band = 60.0;

/// What a candidate (or a baseline term) stands for in identified.toml.
struct CandidateOrigin {
  std::string effect;  ///< identifier; empty: has no term in the model (decoys, splines)
  std::size_t joint = 0;
  Eigen::VectorXd fixed;    ///< shape parameters that are not searched
  std::string tendon;       ///< its place instead of a joint; empty: none
  bool everywhere = false;  ///< at every joint alike, or at every tendon
};

/// Columns of a log: positions of all coordinates; efforts of those where they are measured, which
/// are all, or the motors' where tendons drive the joints; forces of the tendons.
struct DrivenColumns {
  std::vector<int> positions, efforts, forces;
  int load = -1;                     ///< -1: none
  int payload = -1;                  ///< mass that is carried; -1: none is logged
  std::vector<int> scaled_to_model;  ///< efforts from currents whose constants the model gave
};

/// What a joint's position reads beside its motion, in the training logs together.
struct PositionError {
  bool hides_acceleration = false;  ///< above the smooth motion its noise is all there is
  bool coarse = false;              ///< most of it is the sensor's steps
  double share_of_jounce = 0.0;     ///< of the fourth derivative
};

/// What is to be said of a log's load.
struct PayloadNote {
  std::string log;  ///< file
  std::string text;
};

/// Signals of a log at its own rate: accelerations above the band that is compared, too, and the
/// model's effort with them.
inline constexpr const char *fast_acceleration = "fast_acceleration",
                            *effort_of_fast_motion = "effort_of_fast_motion";

class DrivenSubject {
 public:
  /// `runtime`: folder of the runtime's headers; `rigid`: the mechanism's own columns, or none.
  DrivenSubject(DrivenModel model, Identified identified, std::filesystem::path runtime,
                std::shared_ptr<const RigidColumns> rigid = {});

  /// Adds a log's segments. `carried`: the load of known mass that it was recorded with, or none.
  /// Throws std::invalid_argument for a load that the model has no link for.
  void add_log(const Log& log, const DrivenColumns& columns, bool held_out,
               const CarriedPayload* carried = nullptr);

  /// Takes loads of known mass into account, one whose centre is not known where least squares of
  /// all parameters puts it. After the last log, before prepare(). Gives what is to be said of the
  /// logs. Throws std::invalid_argument where no log tells a centre.
  std::vector<PayloadNote> take_payloads();

  /// A load that only some logs have is none in the others, where what acts by it is looked for.
  /// After the last log. Gives the names of the recordings without a load of their own.
  std::vector<std::string> complete_loads();

  /// Baseline, library and deviations for the logs added so far, which are thinned to what their
  /// comparison needs. Once. Throws std::invalid_argument where no stretch of a log is long enough.
  void prepare(const Settings& settings);

  const Problem& problem() const { return problem_; }
  /// The logs at their own rate, after prepare(): motion, targets, what is known, loads, and of the
  /// signals fast_acceleration, effort_of_fast_motion, "read_q", "read_qd", "read_qdd",
  /// "acceleration", "jerk", "jounce" and "tension".
  const std::vector<Recording>& logged_training() const { return logged_training_; }
  const std::vector<Recording>& logged_holdout() const { return logged_holdout_; }
  /// Step of the values that the logs have of a channel, SI; 0: none is seen.
  void set_quantum(int channel, double step) {
    problem_.quantum.resize(static_cast<std::size_t>(problem_.channels), 0.0);
    problem_.quantum[static_cast<std::size_t>(channel)] = step;
  }
  const DrivenModel& model() const { return model_; }
  const Identified& identified() const { return identified_; }
  const std::filesystem::path& runtime() const { return runtime_; }
  const EffortModel& effort() const { return effort_; }
  /// The mechanism's own columns; nullptr where the model has none.
  const RigidColumns* rigid() const { return rigid_.get(); }
  /// Of a term that is not the baseline's.
  const CandidateOrigin& origin_of(const Term& term) const;
  /// The emitted effort of the model with these entries.
  EffortModel effort_with(const Identified& identified) const;
  const std::vector<CandidateOrigin>& library_origins() const { return library_; }
  /// Rests and reversals count again, which prepare() leaves aside. The library keeps the
  /// candidates `named`, the plays of the sensors, and what has no name.
  void look_at_standstills(const std::vector<int>& named);
  /// Nothing is told any more from these stretches of the training logs, then the held-out ones.
  void leave_out(const std::vector<std::vector<Standstill>>& disturbed);
  /// Experiments that causes at a channel may be told apart by, within what the logs cover; none
  /// where tendons drive the joints. After prepare().
  std::vector<PlannedExperiment> experiments(int channel) const;
  /// Step of a joint's position sensor as logged, rad or m; 0: none seen.
  double position_step(std::size_t joint) const { return quantum_[joint]; }
  const std::vector<CandidateOrigin>& baseline_origins() const { return baseline_; }
  /// What a parameter deviation changes.
  const CandidateOrigin& deviation_origin(int deviation) const;
  /// As causes at a channel have it, "joint elbow" or "motor 3".
  std::string place(std::size_t joint) const;
  /// A line over a shaft's angle that the training logs' efforts have: shaft_log() of them.
  struct ShaftLine {
    std::size_t joint = 0;
    double turn = 0.0;  ///< rad or m of the joint
    OrderLine line;
    int candidate = 0;  ///< the ripple of the library at that order
  };
  const std::vector<ShaftLine>& shaft_lines() const { return lines_; }
  /// A joint's effort as it was logged, above the band of the comparison too, over a shaft's turns:
  /// what the model and splines in position, speed and load leave over. `log`: at its own rate.
  ShaftLog shaft_log(std::size_t joint, double turn, const Recording& log) const;
  /// What is known of a joint's friction direction: true where it is a bristle state.
  bool bristle(std::size_t joint) const { return bristle_[joint]; }

 private:
  void add_baseline(std::size_t joint);
  void add_library(std::size_t joint);
  void add_turning(std::size_t joint);
  void add_free_payload(Candidate payload);
  void add_mechanism_candidates();
  void add_carried_deviations();
  bool shows_weight(const Candidate& mass) const;
  void add_mechanism_deviations();
  /// The candidate's first columns (all: -1) as changes of the model's own values.
  void add_deviation(const Candidate& candidate, CandidateOrigin origin, int columns = -1);
  std::vector<const Recording*> training() const;
  void learn_steps(const Log& log, int position, std::size_t joint);
  bool coarse_sensor(std::size_t joint) const;
  void learn_position_errors();
  bool hides_acceleration(Eigen::Index joint) const;
  void thin_logs(const Settings& settings);
  bool fine_sensor(std::size_t joint) const;
  std::vector<int> coupled_joints(std::size_t joint);
  void add_tendon_forces(const Eigen::MatrixXd& forces, const Eigen::MatrixXd& efforts,
                         Recording& log) const;
  void add_gear(std::size_t joint);
  void add_ripples(std::size_t joint);
  void add_orders(std::size_t joint, double turn, const std::string& shaft,
                  const std::vector<int>& known);
  void add_fast_motion(Recording& log) const;
  std::vector<OrderLine> lines_found(std::size_t joint, double turn) const;
  void add_ripple_of_any_period(std::size_t joint);
  void add_model_candidates(std::size_t joint);
  void add_deviations(std::size_t joint);
  void add_common_deviations(std::size_t joint);
  double most_inertia(std::size_t joint) const;
  void add_delay_deviation(const Candidate& delay, CandidateOrigin origin,
                           std::vector<int> channels);
  void fit_directions(const Settings& settings);
  void expect_motion(Recording& log) const;
  bool reads_in_steps(const Recording& log, Eigen::Index joint) const;
  void add_smooth_motion(Recording& log) const;
  void add_derivatives(Recording& log) const;
  void add_sensor_errors(Recording& log) const;
  void set_bands();
  void add_standstills(Recording& log) const;
  void add_payload(const Log& log, const sinew::Segment& segment, const DrivenColumns& columns,
                   const CarriedPayload* carried, Recording& r);
  void take(const KnownPayload& payload);
  void add_motion(const Eigen::MatrixXd& positions, Recording& log) const;
  void add_model(Recording& log) const;
  void set_directions(Recording& log) const;
  void add_mechanism_signals(Recording& log) const;
  void add_link_signals(Recording& log) const;
  std::vector<int> reacting(std::size_t joint) const;
  void let_others_react(std::size_t joint, Candidate& candidate) const;
  MotionRange covered(std::size_t joint) const;
  Recording planned(const PlannedMotion& motion) const;
  Eigen::MatrixXd effort_of_smooth_load(Recording& log) const;
  bool is_lone_link() const;
  bool moves_links(std::size_t joint) const;
  bool gain_is_only_deviation(std::size_t joint) const;
  bool tendon_driven(std::size_t joint) const;
  bool carries_links(std::size_t joint) const;
  FlexibleRanges ranges(std::size_t joint) const;
  void add(const std::string& effect, std::size_t joint, const std::string& name = {},
           const Eigen::VectorXd& fixed = {}, CandidateKind kind = CandidateKind::named);
  LogScale scale(std::size_t joint) const;

  DrivenModel model_;
  Identified identified_;
  std::filesystem::path runtime_;
  EffortModel effort_;
  EffortModel known_;  ///< without friction whose law is not known
  std::shared_ptr<const RigidColumns> rigid_;
  std::shared_ptr<const TendonColumns> tendons_;  ///< none where efforts are measured at the joints
  std::vector<bool> bristle_;
  std::vector<double> quantum_;      ///< of the logged positions; 0: no steps seen
  std::vector<double> digits_;       ///< what their logs' last digits leave of them
  std::vector<bool> rounded_again_;  ///< their logs have a much finer grid than the sensor
  std::vector<PositionError> position_error_;
  std::vector<double> presliding_;  ///< fitted length, where the direction is a bristle state
  std::vector<KnownPayload> payloads_;
  Problem problem_;
  std::vector<Recording> logged_training_, logged_holdout_;
  std::vector<CandidateOrigin> library_, baseline_, deviations_;
  std::vector<ShaftLine> lines_;
};

}  // namespace sinew::diagnosis
