// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <stdexcept>

#include "generator/outputs/run_note.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view note_begin = ".sinew-";
constexpr std::size_t run_letters = 8;

std::vector<std::string> runs_in(const fs::path& folder) {
  std::vector<std::string> runs;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (name.size() == note_begin.size() + run_letters && name.starts_with(note_begin))
      runs.push_back(name.substr(note_begin.size()));
  }
  return runs;
}

/// Somebody else could make us replace files of ours by theirs.
bool is_own(const struct stat& note) {
  return S_ISREG(note.st_mode) && note.st_uid == ::geteuid() &&
         (note.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

/// Locked, and the file that has the name now; else closed.
Descriptor locked_note(const fs::path& path) {
  constexpr int flags = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  Descriptor note(::open(path.c_str(), O_RDWR | flags));
  if (!note.is_open()) note = Descriptor(::open(path.c_str(), O_RDONLY | flags));
  struct stat opened, named;
  if (!note.is_open() || ::fstat(note.number(), &opened) != 0 || !is_own(opened))
    return Descriptor();
  if (::flock(note.number(), LOCK_EX | LOCK_NB) != 0) {
    // It lives. With a text in its note it is about to be done.
    if (errno != EWOULDBLOCK || opened.st_size == 0 || ::flock(note.number(), LOCK_EX) != 0)
      return Descriptor();
  }
  if (::lstat(path.c_str(), &named) != 0 || named.st_ino != opened.st_ino) return Descriptor();
  return note;
}

void empty_note_at(const fs::path& path) {
  const Descriptor note(::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC));
  if (!note.is_open()) fail_with_errno(path, "cannot be written");
  empty_note(note, path);
}

void remove_traces(const fs::path& folder, const std::string& run) {
  clear_left_overs(folder, run);
  ::unlink(note_path(folder, run).c_str());
}

/// All targets of a journal as they were, in all folders. The caller has the note's lock.
void roll_back(const fs::path& home, const std::string& run) {
  const fs::path note = note_path(home, run);
  const std::vector<RunTarget> targets = parse_note(read_whole(note), home).targets;
  if (targets.empty()) return;
  try {
    undo(targets, run);
    empty_note_at(note);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format(
        "{}: outputs that an interrupted run half replaced ({}) cannot be put back: {}; expected a "
        "folder that can be written",
        home.string(), note.filename().string(), error.what()));
  }
  for (const RunTarget& target : targets)
    if (target.path.parent_path() != home) remove_traces(target.path.parent_path(), run);
}

void settle(const fs::path& folder, const std::string& run) {
  const Descriptor note = locked_note(note_path(folder, run));
  if (!note.is_open()) return;
  const NoteText text = parse_note(read_whole(note_path(folder, run)), folder);
  if (text.home) {
    const Descriptor journal = locked_note(note_path(*text.home, run));
    if (journal.is_open()) {
      roll_back(*text.home, run);
      remove_traces(*text.home, run);
    } else if (entry_exists(note_path(*text.home, run))) {
      return;
    }
  } else {
    roll_back(folder, run);
  }
  remove_traces(folder, run);
}

}  // namespace

void recover_interrupted(const fs::path& folder) {
  for (const std::string& run : runs_in(folder)) settle(folder, run);
}

}  // namespace sinew
