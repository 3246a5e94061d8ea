// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/put_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>  // renameat2
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace sinew {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: {}", path.string(), what));
}

[[noreturn]] void fail_with_errno(const fs::path& path, std::string_view what) {
  fail(path, fmt::format("{}: {}", what, std::strerror(errno)));
}

/// A new folder beside the target, removed again unless it took the target's place.
class Draft {
 public:
  explicit Draft(const fs::path& target) {
    std::string pattern =
        (target.parent_path() / fmt::format(".{}.XXXXXX", target.filename().string())).string();
    if (mkdtemp(pattern.data()) == nullptr) fail_with_errno(target, "cannot write beside it");
    path_ = pattern;
  }
  ~Draft() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Writes and hands to the disk, so that a folder in place has whole files even after a power cut.
void write_file(const fs::path& path, std::string_view content) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail_with_errno(path, "cannot be written");
  bool is_fine = true;
  while (is_fine && !content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    is_fine = written > 0;
    if (is_fine) content.remove_prefix(static_cast<std::size_t>(written));
  }
  is_fine = is_fine && fsync(file) == 0;
  const int error = errno;
  close(file);
  errno = error;
  if (!is_fine) fail_with_errno(path, "cannot be written");
}

/// Names of files in a folder reach the disk too; not every file system can, which is no mistake.
void flush_folder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)fsync(descriptor);
  close(descriptor);
}

/// Permissions a folder made by mkdir would have; mkdtemp gives its own to the owner only.
void open_permissions(const fs::path& folder) {
  const mode_t mask = umask(0);
  umask(mask);
  fs::permissions(folder, static_cast<fs::perms>(0777 & ~mask));
}

/// For file systems that cannot exchange two folders: the target makes way and comes back where the
/// draft cannot take its place.
void exchange_by_renames(const fs::path& draft, const fs::path& target) {
  const fs::path aside = draft.string() + ".old";
  if (rename(target.c_str(), aside.c_str()) != 0) fail_with_errno(target, "cannot be replaced");
  if (rename(draft.c_str(), target.c_str()) != 0) {
    const int error = errno;
    (void)rename(aside.c_str(), target.c_str());
    errno = error;
    fail_with_errno(target, "cannot be replaced");
  }
  std::error_code ignored;
  fs::rename(aside, draft, ignored);
}

/// The draft takes the target's place in one step; what was there is then the draft.
void exchange(const fs::path& draft, const fs::path& target) {
  if (!fs::exists(target) || fs::is_empty(target)) {
    if (rename(draft.c_str(), target.c_str()) != 0)
      fail_with_errno(target, "cannot be put in place");
  } else if (renameat2(AT_FDCWD, draft.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) != 0) {
    if (errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP)
      fail_with_errno(target, "cannot be replaced in one step");
    exchange_by_renames(draft, target);
  }
}

}  // namespace

void put_files(const fs::path& folder, const std::map<std::string, std::string>& files,
               bool may_replace) {
  fs::path target = fs::absolute(folder).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();
  if (fs::is_symlink(target)) target = fs::canonical(target);
  const bool exists = fs::exists(target);
  if (exists && !fs::is_directory(target))
    fail(folder, "is not a folder; expected a folder or nothing");
  if (exists && !fs::is_empty(target) && !may_replace)
    fail(folder, "is not empty; expected an empty or new folder, or --force");
  fs::create_directories(target.parent_path());
  const Draft draft(target);
  open_permissions(draft.path());
  if (exists)
    fs::copy(target, draft.path(), fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  for (const auto& [name, content] : files) write_file(draft.path() / name, content);
  flush_folder(draft.path());
  exchange(draft.path(), target);
  flush_folder(target.parent_path());
}

}  // namespace sinew
