// SPDX-License-Identifier: GPL-3.0-or-later
// A fresh folder that is gone when its owner is.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sinew::reference {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs a program without a shell; both output streams into `output`. Returns its exit code, or
/// 128 + signal. Throws std::runtime_error where it cannot be started.
int run_program(const std::vector<std::string>& arguments, std::string& output);

/// Whole file as text, and back. Throw std::runtime_error naming the file.
std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace sinew::reference
