// SPDX-License-Identifier: GPL-3.0-or-later
// What a page keeps of a run: so many instants, and what lies between them as a band.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace sinew {

/// Rows of a simulation, gathered into instants of equal length. Of each channel an instant keeps
/// its first value, its least and its largest: no peak gets lost.
class RecordedRun {
 public:
  /// `columns`: "name [unit]", the first one the time [s].
  RecordedRun(std::vector<std::string> columns, double duration);

  void add(const std::vector<double>& row);

  const std::vector<std::string>& columns() const { return columns_; }
  std::size_t instants() const { return times_.size(); }
  /// As base64 of little-endian floats: the times, and for every column but the time its first
  /// values, least and largest.
  std::string packed_times() const;
  std::string packed_values() const;

 private:
  std::vector<std::string> columns_;
  double length_;  ///< s, of an instant
  long last_ = -1;
  std::vector<float> times_;
  std::vector<std::array<std::vector<float>, 3>> values_;
};

/// Energy books, thinned to some hundred steps.
class RecordedBooks {
 public:
  explicit RecordedBooks(double duration) : gap_(duration / 500.0) {}
  void add(double time, double energy, const std::vector<double>& work);

  std::vector<double> time, energy, missing;  ///< s, J, J: energy less its start and all work
  std::vector<std::vector<double>> work;      ///< of each power, over time

 private:
  double gap_, start_ = 0.0;
};

}  // namespace sinew
