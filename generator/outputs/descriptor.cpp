// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/outputs/descriptor.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "generator/outputs/interruption.h"

namespace sinew {

namespace fs = std::filesystem;

void fail_with_errno(const fs::path& path, std::string_view what) {
  throw std::runtime_error(fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno)));
}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this == &other) return *this;
  if (number_ >= 0) ::close(number_);
  number_ = other.number_;
  other.number_ = -1;
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

void Descriptor::close(const fs::path& shown) {
  const int number = number_;
  number_ = -1;
  if (number >= 0 && ::close(number) != 0 && errno != EINTR)
    fail_with_errno(shown, "cannot be written");
}

void write_all(const Descriptor& file, std::string_view text, const fs::path& shown) {
  while (!text.empty()) {
    const ssize_t written = ::write(file.number(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_with_errno(shown, "cannot be written");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

Descriptor new_file(const fs::path& path, unsigned mode) {
  const NotInterrupted not_after_the_removal;
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
  if (!file.is_open()) fail_with_errno(path, "cannot be created");
  return file;
}

void write_new_file(const fs::path& path, std::string_view text, unsigned mode) {
  Descriptor file = new_file(path, mode);
  write_all(file, text, path);
  if (::fsync(file.number()) != 0) fail_with_errno(path, "cannot be written");
  file.close(path);
}

void flush_folder(const fs::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.is_open()) (void)::fsync(opened.number());
}

bool entry_exists(const fs::path& path) {
  struct stat ignored;
  return ::lstat(path.c_str(), &ignored) == 0;
}

std::string read_whole(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) fail_with_errno(path, "cannot be read");
  std::string text;
  std::array<char, 65536> block;
  for (;;) {
    const ssize_t got = ::read(file.number(), block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_with_errno(path, "cannot be read");
    if (got == 0) return text;
    text.append(block.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace sinew
