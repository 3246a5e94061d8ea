// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/outputs/draft.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <set>
#include <stdexcept>

#include "generator/outputs/interruption.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  const NotInterrupted not_after_the_removal;
  if (::mkdir(folder.c_str(), 0777) != 0) fail_with_errno(folder, "cannot be created");
}

bool linked(const fs::path& file, const fs::path& to) {
  const NotInterrupted not_after_the_removal;
  return ::link(file.c_str(), to.c_str()) == 0;
}

void link_or_copy(const fs::path& file, const fs::path& to) {
  if (linked(file, to)) return;
  struct stat is;
  if (::lstat(file.c_str(), &is) != 0 || !S_ISREG(is.st_mode))
    throw std::runtime_error(file.string() + ": is no regular file; expected one");
  write_new_file(to, read_whole(file), is.st_mode & 07777u);
}

}  // namespace

Descriptor new_draft(const fs::path& draft, const fs::path& target) {
  Descriptor file = new_file(draft, 0666);
  struct stat is;
  if (::stat(target.c_str(), &is) == 0) (void)::fchmod(file.number(), is.st_mode & 07777u);
  return file;
}

void write_draft_file(const fs::path& draft, const std::string& text, const fs::path& target) {
  Descriptor file = new_draft(draft, target);
  write_all(file, text, target);
  if (::fsync(file.number()) != 0) fail_with_errno(target, "cannot be written");
  file.close(target);
}

void write_draft_folder(const fs::path& draft, const FileSet& files) {
  std::set<fs::path> folders{draft};
  make_folder(draft);
  for (const auto& [name, text] : files) {
    fs::path folder = draft;
    for (const fs::path& part : fs::path(name).parent_path()) {
      folder /= part;
      if (folders.insert(folder).second) make_folder(folder);
    }
    write_new_file(draft / name, text);
  }
  for (const fs::path& folder : folders) flush_folder(folder);
}

void keep_way_back(const fs::path& target, const fs::path& old) {
  if (!fs::is_directory(target)) return link_or_copy(target, old);
  make_folder(old);
  for (const fs::directory_entry& entry : fs::directory_iterator(target)) {
    const fs::path kept = old / entry.path().filename();
    if (fs::is_directory(entry.symlink_status()))
      keep_way_back(entry.path(), kept);
    else
      link_or_copy(entry.path(), kept);
  }
  flush_folder(old);
}

}  // namespace sinew
