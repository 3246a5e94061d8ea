// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a driven mechanism's log, slowly: what each is, and what the log would be if they
// had been written otherwise.
#pragma once

#include <optional>
#include <vector>

#include "identification/subjects/column_readings.h"
#include "identification/subjects/driven_subject.h"
#include "identification/subjects/tendon_candidates.h"

namespace sinew::diagnosis {

/// What a column means, whatever is in it.
enum class Quantity { position, effort, force, load };

struct ColumnRole {
  Quantity quantity;
  Eigen::Index at = 0;   ///< among those of its quantity
  int channel = 0;       ///< of the log
  bool has_unit = true;  ///< false: what is logged was scaled to what the model says
};

class SlowColumns {
 public:
  /// Below 10 Hz, some hundred samples of `recording`, away from its ends. `tendons`: those that
  /// drive the first coordinates, or null; has to outlive the object.
  SlowColumns(const DrivenColumns& columns, const Recording& recording, const DrivenModel& model,
              const TendonColumns* tendons);

  bool is_long_enough() const;
  const std::vector<ColumnRole>& roles() const { return roles_; }
  const ColumnRole& role_of(int channel) const;
  Eigen::Index count_of(Quantity quantity) const;

  /// Motion, targets, loads and tensions as they would be; null: as the log is. A target for each
  /// measured effort, those of joints that tendons drive first.
  Recording read_as(const ColumnReading* reading) const;

 private:
  /// Each column as logged and differentiated: samples x roles.
  struct Values {
    Eigen::MatrixXd x, xd, xdd;
    void scale(Eigen::Index role, double factor);
    void exchange(Eigen::Index a, Eigen::Index b);
  };
  void add_roles(Quantity quantity, const std::vector<int>& channels);
  Eigen::Index index_of(int channel) const;
  Eigen::MatrixXd taken_from(const Recording& recording) const;
  Recording recording_of(const Values& values, double clock) const;

  Eigen::Index coordinates_, efforts_, forces_;
  const TendonColumns* tendons_;
  double pulley_radius_ = 0.0;  ///< m, of tendons' motors
  std::vector<ColumnRole> roles_;
  Values logged_;
  Recording template_;
};

}  // namespace sinew::diagnosis
