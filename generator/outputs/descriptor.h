// SPDX-License-Identifier: GPL-3.0-or-later
// Files by their descriptors: every error is seen, and what is written reaches the disk.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sinew {

/// Throws std::runtime_error "<path>: <what>: <what errno says>".
[[noreturn]] void fail_with_errno(const std::filesystem::path& path, std::string_view what);

/// An open file; closed on every way out.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  /// Closes and throws std::runtime_error naming `shown` where that fails: a write that was put off
  /// may fail only now.
  void close(const std::filesystem::path& shown);

 private:
  int number_;
};

/// Writes all of `text`, or throws std::runtime_error naming `shown`.
void write_all(const Descriptor& file, std::string_view text, const std::filesystem::path& shown);

/// A new file, opened to be written; none once an interruption removes what is unfinished. `mode`:
/// its permissions, less the umask. Throws std::runtime_error, also where the file exists.
Descriptor new_file(const std::filesystem::path& path, unsigned mode);
/// The same with this text, on the disk when this returns.
void write_new_file(const std::filesystem::path& path, std::string_view text, unsigned mode = 0666);

/// Hands the names in a folder to the disk; not every file system can, which is no mistake.
void flush_folder(const std::filesystem::path& folder);

/// Whether anything has the name, also a link that leads to nothing.
bool entry_exists(const std::filesystem::path& path);

/// The whole file. Throws std::runtime_error naming it where it cannot be opened or read to its
/// end.
std::string read_whole(const std::filesystem::path& path);

}  // namespace sinew
