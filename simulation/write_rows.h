// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// A CSV file that appears whole or not at all: rows go to a file beside it, which replaces the old
/// one in finish() and vanishes otherwise. Numbers are written so that they read back the same.
/// Throws std::runtime_error naming the file where writing fails.
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

  std::filesystem::path file_, partial_;
  std::FILE* stream_ = nullptr;
  std::string text_;  ///< of one row
};

}  // namespace sinew
