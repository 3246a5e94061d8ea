// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/outputs/run_note.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

namespace sinew {
namespace {

namespace fs = std::filesystem;

// A record ends with a zero byte: the one that no path has.
constexpr char record_end = '\0';
constexpr std::string_view last_record = "all";

std::string record(std::string_view kind, const fs::path& path) {
  return fmt::format("{} {}{}", kind, path.string(), record_end);
}

std::string kind_of(const RunTarget& target) {
  return fmt::format("{} {}", target.replaces ? "replaced" : "new",
                     target.is_folder ? "folder" : "file");
}

bool take(std::string_view& text, std::string_view begin) {
  if (!text.starts_with(begin)) return false;
  text.remove_prefix(begin.size());
  return true;
}

fs::path path_in(const fs::path& folder, std::string_view relative) {
  return (folder / fs::path(relative)).lexically_normal();
}

/// A record of a journal: "<replaced|new> <file|folder> <path>".
std::optional<RunTarget> target_of(std::string_view text, const fs::path& folder) {
  RunTarget target;
  target.replaces = take(text, "replaced ");
  if (!target.replaces && !take(text, "new ")) return {};
  target.is_folder = take(text, "folder ");
  if (!target.is_folder && !take(text, "file ")) return {};
  target.path = path_in(folder, text);
  return target;
}

bool ends_with(const std::string& name, const std::string& end) {
  return name.size() > end.size() + 1 && name.front() == '.' &&
         name.compare(name.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

fs::path note_path(const fs::path& folder, const std::string& run) {
  return folder / (".sinew-" + run);
}

Descriptor new_note(const fs::path& folder, const std::string& run) {
  const fs::path path = note_path(folder, run);
  Descriptor note(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
  if (!note.is_open()) fail_with_errno(folder, "nothing can be written there");
  // Where a file system has no locks, nobody takes the note for a dead run's either.
  (void)::flock(note.number(), LOCK_EX);
  struct stat opened, named;
  if (::fstat(note.number(), &opened) != 0 || ::lstat(path.c_str(), &named) != 0 ||
      opened.st_ino != named.st_ino)  // cleared in the moment between both calls
    return new_note(folder, run);
  return note;
}

void write_note(const Descriptor& note, const fs::path& folder, const std::string& text) {
  write_all(note, text, folder);
  if (::fsync(note.number()) != 0) fail_with_errno(folder, "cannot be written into");
}

void empty_note(const Descriptor& note, const fs::path& folder) {
  if (::ftruncate(note.number(), 0) != 0 || ::fsync(note.number()) != 0)
    fail_with_errno(folder, "cannot be written into");
}

std::string journal_text(const std::vector<RunTarget>& targets, const fs::path& home) {
  std::string text;
  for (const RunTarget& target : targets)
    text += record(kind_of(target), target.path.lexically_relative(home));
  return text.append(last_record) + record_end;
}

std::string pointer_text(const fs::path& home, const fs::path& folder) {
  return record("journal", home.lexically_relative(folder)).append(last_record) + record_end;
}

NoteText parse_note(const std::string& text, const fs::path& folder) {
  NoteText note;
  std::string_view left = text;
  for (std::size_t end; (end = left.find(record_end)) != std::string_view::npos;) {
    std::string_view each = left.substr(0, end);
    left.remove_prefix(end + 1);
    if (each == last_record) return note;
    if (take(each, "journal "))
      note.home = path_in(folder, each);
    else if (const std::optional<RunTarget> target = target_of(each, folder))
      note.targets.push_back(*target);
  }
  return {};  // cut short: it was not yet in force
}

void clear_left_overs(const fs::path& folder, const std::string& run) {
  const std::string gone = fmt::format(".{}.gone", run);
  std::error_code ignored;
  std::vector<fs::path> left;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (ends_with(name, gone)) {
      const fs::path target = folder / name.substr(1, name.size() - 1 - gone.size());
      if (::access(target.c_str(), F_OK) != 0 &&
          ::rename(entry->path().c_str(), target.c_str()) == 0)
        continue;
    }
    for (const char* kind : {"new", "old", "gone"})
      if (ends_with(name, fmt::format(".{}.{}", run, kind))) left.push_back(entry->path());
  }
  for (const fs::path& path : left) fs::remove_all(path, ignored);
}

}  // namespace sinew
