// SPDX-License-Identifier: GPL-3.0-or-later
// Targets and regressor columns of a problem, filtered alike and taken to the band (spectrum.h).
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "identification/logs/filter.h"
#include "identification/regression/candidate.h"

namespace sinew::diagnosis {

/// One channel of one log.
struct Segment {
  int recording = 0;  ///< index into training, then holdout
  int channel = 0;
  bool holdout = false;
  DecimatingFilter filter;
  Eigen::Index samples = 0;  ///< after decimation
  Eigen::Index bins = 0;
  double rate_hz = 0.0;  ///< after decimation
};

/// Columns of a group in the band, one matrix for each segment; 0 x 0 where it does not act.
using BandColumns = std::vector<Eigen::MatrixXd>;

/// Columns that no longer change, shared by all models that hold them: a search copies models
/// often, and the columns of an arm's model are tens of megabytes.
class SharedColumns {
 public:
  SharedColumns() = default;
  SharedColumns(BandColumns columns) : held_(std::make_shared<Held>()) {
    held_->columns = std::move(columns);
  }
  SharedColumns(std::initializer_list<Eigen::MatrixXd> columns)
      : SharedColumns(BandColumns(columns)) {}

  const BandColumns& get() const {
    static const BandColumns none;
    return held_ ? held_->columns : none;
  }
  operator const BandColumns&() const { return get(); }
  const Eigen::MatrixXd& operator[](std::size_t segment) const { return get()[segment]; }
  std::size_t size() const { return get().size(); }
  bool empty() const { return get().empty(); }
  BandColumns::const_iterator begin() const { return get().begin(); }
  BandColumns::const_iterator end() const { return get().end(); }

  /// Their time derivatives, which `make` makes the first time. Threads that ask at once make them
  /// at once, rather than that one waits for another's task.
  template <typename Make>
  SharedColumns rates(Make make) const {
    if (!held_) return SharedColumns(make());
    {
      const std::lock_guard<std::mutex> lock(held_->guard);
      if (held_->rates) return SharedColumns(held_->rates);
    }
    const SharedColumns made(make());
    const std::lock_guard<std::mutex> lock(held_->guard);
    if (!held_->rates) held_->rates = made.held_;
    return SharedColumns(held_->rates);
  }

 private:
  struct Held {
    BandColumns columns;
    std::mutex guard;
    std::shared_ptr<Held> rates;
  };
  explicit SharedColumns(std::shared_ptr<Held> held) : held_(std::move(held)) {}

  std::shared_ptr<Held> held_;
};

/// Whether a candidate is asked for a channel's columns.
bool acts_on(const Candidate& candidate, int channel);

/// Filters what a problem holds. Keeps a reference to the problem. Logs sampled faster than their
/// comparison needs are thinned first (thinned_recording.h): no regressor needs more samples, and
/// the work of evaluating them is what a long log costs.
class Design {
 public:
  Design(const Problem& problem, const Settings& settings);

  const Problem& problem() const { return problem_; }
  const std::vector<Segment>& segments() const { return segments_; }
  /// As the candidates see it: thinned where the log was.
  const Recording& recording(int index) const;

  /// Filtered target of one segment in the band, `advance` [s] later than the model's time, less
  /// what the recording says is known.
  Eigen::VectorXd target(int segment, double advance = 0.0) const;

  /// Filtered known part of one segment in the band (derivative = 1: its time derivative).
  std::optional<Eigen::VectorXd> known(int segment, int derivative) const;

  /// Coefficients of a candidate over all logs: per-log nuisances count once for each log.
  Eigen::Index width(const Candidate& candidate) const;

  /// Linear parameter behind a coefficient, and its stretch or the first one of its log (-1:
  /// shared).
  struct Coefficient {
    int parameter = 0;
    int recording = -1;
  };
  std::vector<Coefficient> coefficients(const Candidate& candidate) const;

  /// Filtered columns (derivative = 1: their time derivative) of all segments.
  BandColumns columns(const Candidate& candidate, const Eigen::VectorXd& nonlinear,
                      int derivative = 0) const;
  /// The same of some segments, those of the others empty.
  BandColumns columns_at(const std::vector<bool>& segments, const Candidate& candidate,
                         const Eigen::VectorXd& nonlinear) const;
  /// Raw columns put through the segment's filter, decimated time domain. They may have the samples
  /// of the log as given or of recording().
  Eigen::MatrixXd filtered(int segment, const Eigen::MatrixXd& raw, double advance = 0.0,
                           int derivative = 0) const;

  /// At a segment's instants: 1, and 0 at standstill. Targets and columns are multiplied with it.
  const Eigen::VectorXd& window(int segment) const {
    return windows_[static_cast<std::size_t>(segment)];
  }

  /// The same where every sample counts, as it would be.
  Eigen::VectorXd motion_window_of(int segment) const;

  /// What errors of a channel are counted in, so that those of a heavy joint and of a light one,
  /// or of a force and a torque, can be added: 1 in the target's unit, or what was set.
  double unit(int channel) const { return units_(channel); }
  /// Of each channel one; channels of one noise group get their root mean square.
  void set_units(const Eigen::VectorXd& units);

  /// A signal of the recording in a segment's band, `advance` [s] later.
  Eigen::VectorXd in_band(int segment, const Eigen::VectorXd& raw, double advance = 0.0) const;

  /// A signal of the recording at the decimated instants, unfiltered, for plots and splines.
  Eigen::VectorXd at_instants(int segment, const Eigen::VectorXd& raw) const;

 private:
  Eigen::MatrixXd segment_columns(std::size_t segment, const Candidate& candidate,
                                  const Eigen::VectorXd& nonlinear, int derivative) const;
  Eigen::MatrixXd seen_band(int segment, const Eigen::MatrixXd& samples) const;
  void add_segments(const std::vector<Recording>& recordings, int first, bool holdout);
  const Recording& given(int index) const;
  int first_of_log(int index) const;
  /// Whose coefficient a stretch has of a parameter that is not shared.
  int owner_of(const Candidate& candidate, int parameter, int recording) const;
  Eigen::MatrixXd thinned(int segment, const Eigen::MatrixXd& raw) const;
  const Problem& problem_;
  Settings settings_;
  struct Thinned {
    DecimatingFilter filter;
    Recording log;
  };
  std::map<int, Thinned> thinned_;  ///< by recording, where thinned
  std::vector<Segment> segments_;
  std::vector<Eigen::VectorXd> windows_;
  Eigen::VectorXd units_;
};

}  // namespace sinew::diagnosis
