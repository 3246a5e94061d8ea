// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/outputs/output_place.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <optional>
#include <stdexcept>

#include "generator/outputs/unfinished_run.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // as Linux itself

enum class Opening { now, later };  // of a FIFO: it waits for a reader, who counts how often

[[noreturn]] void refuse_place(const fs::path& given, const std::string& why) {
  throw std::runtime_error(fmt::format("{}: {}", given.string(), why));
}

/// Where the links are that stand for this process's open files.
fs::path descriptor_folder() {
  return fmt::format("/proc/{}/fd", ::getpid());
}

fs::path real_path_within(const fs::path& path, int& links) {
  if (path == path.root_path()) return path;
  const fs::path parent = real_path_within(path.parent_path(), links), name = path.filename();
  if (name.empty() || name == ".") return parent;
  if (name == "..") return parent.parent_path();
  const fs::path here = parent / name;
  std::error_code error;
  if (parent == descriptor_folder() || !fs::is_symlink(here, error)) return here;
  if (++links > most_links) refuse_place(path, "its links lead in a circle; expected a file");
  const fs::path leads_to = fs::read_symlink(here, error);
  return real_path_within(error ? here : parent / leads_to, links);  // "/" keeps an absolute one
}

/// The number that /dev/fd/<number> names.
std::optional<int> named_descriptor(const fs::path& real) {
  if (real.parent_path() != descriptor_folder()) return {};
  const std::string name = real.filename().string();
  int number = -1;
  const auto end = std::from_chars(name.data(), name.data() + name.size(), number);
  if (end.ec != std::errc() || end.ptr != name.data() + name.size()) return {};
  return number;
}

bool is_same(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

/// The standard stream that is open on this very file, which a rename would take from under it.
std::optional<int> stream_on(const struct stat& file) {
  for (const int number : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat opened;
    if (::fstat(number, &opened) == 0 && is_same(opened, file)) return number;
  }
  return {};
}

OutputPlace stream_place(const fs::path& given, int number) {
  ::signal(SIGPIPE, SIG_IGN);
  OutputPlace place{given, {}, Descriptor(::fcntl(number, F_DUPFD_CLOEXEC, 0)), false};
  if (!place.stream.is_open()) fail_with_errno(given, "cannot be written");
  place.is_standard_output = number == STDOUT_FILENO;
  return place;
}

OutputPlace device_place(const fs::path& given, const fs::path& real, Opening opening) {
  if (opening == Opening::later) return {given, {}, Descriptor(), false};
  ::signal(SIGPIPE, SIG_IGN);
  OutputPlace place{
      given, {}, Descriptor(::open(real.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC)), false};
  if (!place.stream.is_open()) fail_with_errno(given, "cannot be written");
  return place;
}

/// Opened or taken for what it is.
OutputPlace existing_place(const fs::path& given, const fs::path& real, const struct stat& is,
                           Opening opening) {
  if (S_ISDIR(is.st_mode)) refuse_place(given, "is a folder; expected a file");
  if (S_ISBLK(is.st_mode))
    refuse_place(given, "is a disk, which would be overwritten; expected a file");
  if (S_ISSOCK(is.st_mode)) refuse_place(given, "is a socket; expected a file");
  if (!S_ISREG(is.st_mode)) return device_place(given, real, opening);
  if (const std::optional<int> open = stream_on(is)) return stream_place(given, *open);
  if (::access(real.c_str(), W_OK) != 0) fail_with_errno(given, "may not be replaced");
  return {given, real, Descriptor(), false};
}

}  // namespace

fs::path real_path(const fs::path& given) {
  int links = 0;
  return real_path_within(fs::absolute(given), links);
}

namespace {

OutputPlace place_of(const fs::path& given, Opening opening) {
  if (given.empty()) throw std::runtime_error("--out: is empty; expected a file");
  if (given == "-") return stream_place(given, STDOUT_FILENO);
  const fs::path real = real_path(given);
  if (const std::optional<int> number = named_descriptor(real)) return stream_place(given, *number);
  struct stat is;
  if (::lstat(real.c_str(), &is) == 0) return existing_place(given, real, is, opening);
  if (errno != ENOENT) fail_with_errno(given, "cannot be written");
  if (!given.has_filename()) refuse_place(given, "is named as a folder; expected a file");
  std::error_code ignored;
  if (!fs::is_directory(real.parent_path(), ignored))
    refuse_place(given, fmt::format("cannot be written: there is no folder {}; expected one",
                                    real.parent_path().string()));
  return {given, real, Descriptor(), false};
}

}  // namespace

OutputPlace output_place(const fs::path& given) {
  return place_of(given, Opening::now);
}

void check_output_file(const fs::path& given, const Inputs& inputs) {
  const OutputPlace place = place_of(given, Opening::later);
  if (place.real.empty()) return;
  recover_interrupted(place.real.parent_path());
  inputs.refuse(place.real);
}

fs::path replaceable_file(const fs::path& given) {
  const fs::path real = real_path(given);
  struct stat is;
  if (::lstat(real.c_str(), &is) != 0) return real;
  if (!S_ISREG(is.st_mode))
    refuse_place(given, "cannot be written: it is no regular file; expected one");
  if (::access(real.c_str(), W_OK) != 0) fail_with_errno(given, "may not be replaced");
  return real;
}

bool is_standard_output(const fs::path& given) noexcept {
  try {
    if (given == "-") return true;
    const fs::path real = real_path(given);
    if (const std::optional<int> number = named_descriptor(real)) return *number == STDOUT_FILENO;
    struct stat is;
    return ::lstat(real.c_str(), &is) == 0 && S_ISREG(is.st_mode) && stream_on(is) == STDOUT_FILENO;
  } catch (...) {
    return false;
  }
}

fs::path output_folder(const fs::path& given) {
  if (given.empty()) throw std::runtime_error("--out: is empty; expected a folder");
  if (given == "-")
    refuse_place(given, "is standard output, which takes no folder; expected a folder");
  const fs::path real = real_path(given);
  std::error_code error;
  const fs::file_status status = fs::status(real, error);
  if (fs::exists(status) && !fs::is_directory(status))
    refuse_place(given, "is not a folder; give a folder to write into");
  return real;
}

void Inputs::add(const fs::path& file) {
  struct stat is;
  if (::stat(file.c_str(), &is) == 0 && S_ISREG(is.st_mode))
    files_.push_back({is.st_dev, is.st_ino, file.string()});
}

void Inputs::refuse(const fs::path& file) const {
  struct stat is;
  if (::stat(file.c_str(), &is) != 0) return;
  for (const Known& known : files_)
    if (known.device == is.st_dev && known.inode == is.st_ino)
      refuse_place(file, fmt::format("is {}, which the command reads, and would be lost; expected "
                                     "another file for the output",
                                     known.path));
}

}  // namespace sinew
