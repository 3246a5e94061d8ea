// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <filesystem>
#include <future>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// A CSV file that appears whole or not at all: rows go to a file beside it, which replaces the old
/// one in finish() and vanishes otherwise. Numbers are written so that they read back the same, by
/// another thread: as text a hand's row takes as long as its simulation. Throws std::runtime_error
/// naming the file where writing fails, at the latest from finish().
class RowWriter {
 public:
  RowWriter(const std::filesystem::path& file, const std::vector<std::string>& header);
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;
  ~RowWriter();

  void write(const std::vector<double>& row);
  void finish();

 private:
  [[noreturn]] void fail(const char* what) const;
  void put(std::string_view text);
  void put_row(const double* row);
  /// Gives the rows held to the other thread, once it is done with the last ones.
  void hand_over();

  std::filesystem::path file_, partial_;
  std::FILE* stream_ = nullptr;
  std::size_t columns_;
  std::string text_;                    ///< of one row
  std::vector<double> held_, written_;  ///< rows that wait; rows the other thread writes
  std::future<void> writing_;
};

}  // namespace sinew
