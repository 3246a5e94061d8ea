// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "generator/outputs/outputs.h"

namespace sinew {

/// CSV into an output file (generator/outputs/outputs.h): a regular file appears whole in finish()
/// or not at all, a stream gets its rows as they come. Numbers are written so that they read back
/// the same, by another thread: as text a hand's row takes as long as its simulation. Throws
/// std::runtime_error naming the file where writing fails, at the latest from finish().
class RowWriter {
 public:
  RowWriter(const std::filesystem::path& file, const std::vector<std::string>& header,
            const Inputs& inputs = {});
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;
  ~RowWriter();

  void write(const std::vector<double>& row);
  void finish();

 private:
  void add_row(const double* row);
  /// Gives the rows held to the other thread, once it is done with the last ones.
  void hand_over();

  std::filesystem::path path_;
  OutputFile file_;
  std::size_t columns_;
  std::string text_;                    ///< of the rows the other thread writes
  std::vector<double> held_, written_;  ///< rows that wait; rows the other thread writes
  std::future<void> writing_;
};

}  // namespace sinew
