// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/outputs/unfinished_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>  // renameat2
#include <unistd.h>

#include <cerrno>
#include <random>
#include <stdexcept>

#include "generator/outputs/run_note.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

std::string new_run_name() {
  std::random_device random;
  return fmt::format("{:08x}", static_cast<unsigned>(random()));
}

void rename_or_fail(const fs::path& from, const fs::path& to, const fs::path& shown) {
  if (::rename(from.c_str(), to.c_str()) != 0) fail_with_errno(shown, "cannot be replaced");
}

/// Between the two the old folder stands whole beside its place.
void swap_in_two_steps(const fs::path& from, const fs::path& target, const std::string& run) {
  const fs::path gone = beside(target, run, Beside::gone);
  rename_or_fail(target, gone, target);
  if (::rename(from.c_str(), target.c_str()) == 0) return;
  const int error = errno;
  (void)::rename(gone.c_str(), target.c_str());
  errno = error;
  fail_with_errno(target, "cannot be replaced");
}

void remove_entry(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (entry_exists(path))
    throw std::runtime_error(
        fmt::format("{}: cannot be removed: {}", path.string(), error.message()));
}

/// The draft that is still there was never put in place; of a target that was, the draft is gone.
void undo_file(const RunTarget& target, const std::string& run) {
  const fs::path old = beside(target.path, run, Beside::old);
  if (entry_exists(beside(target.path, run, Beside::draft))) return;
  if (!target.replaces)
    remove_entry(target.path);
  else if (entry_exists(old))
    rename_or_fail(old, target.path, target.path);
}

void undo_folder(const RunTarget& target, const std::string& run) {
  const fs::path old = beside(target.path, run, Beside::old);
  if (target.replaces) {
    if (entry_exists(old)) put_in_place(old, target.path, true, run);
  } else if (!entry_exists(beside(target.path, run, Beside::draft))) {
    remove_entry(target.path);
  }
}

}  // namespace

fs::path beside(const fs::path& target, const std::string& run, Beside kind) {
  const char* ending = kind == Beside::draft ? "new" : kind == Beside::old ? "old" : "gone";
  return target.parent_path() / fmt::format(".{}.{}.{}", target.filename().string(), run, ending);
}

void put_in_place(const fs::path& from, const fs::path& target, bool is_folder,
                  const std::string& run) {
  if (!is_folder || !entry_exists(target)) return rename_or_fail(from, target, target);
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP)
    fail_with_errno(target, "cannot be replaced");
  swap_in_two_steps(from, target, run);
}

void undo(const std::vector<RunTarget>& targets, const std::string& run) {
  for (const RunTarget& target : targets) {
    if (!entry_exists(note_path(target.path.parent_path(), run))) continue;
    target.is_folder ? undo_folder(target, run) : undo_file(target, run);
  }
  for (const RunTarget& target : targets) flush_folder(target.path.parent_path());
}

UnfinishedRun::UnfinishedRun() : name_(new_run_name()) {}

UnfinishedRun::~UnfinishedRun() {
  try {
    clear();
  } catch (...) {  // what is left is cleared by the next run
  }
}

void UnfinishedRun::enter(const fs::path& target) {
  const fs::path folder = target.parent_path();
  for (const fs::path& path : {beside(target, name_, Beside::draft),
                               beside(target, name_, Beside::old), note_path(folder, name_)})
    interruptible_.emplace_back([&] { return path; });
  for (const Note& note : notes_)
    if (note.folder == folder) return;
  const NotInterrupted not_after_the_removal;
  notes_.push_back({folder, new_note(folder, name_)});
}

void UnfinishedRun::begin_journal(const std::vector<RunTarget>& targets) {
  const fs::path& home = notes_.front().folder;
  for (std::size_t i = 1; i < notes_.size(); ++i)
    write_note(notes_[i].file, notes_[i].folder, pointer_text(home, notes_[i].folder));
  is_journal_ = true;
  try {
    write_note(notes_.front().file, home, journal_text(targets, home));
  } catch (...) {
    end_journal();
    throw;
  }
}

void UnfinishedRun::end_journal() {
  if (!is_journal_) return;
  empty_note(notes_.front().file, notes_.front().folder);
  is_journal_ = false;
}

void UnfinishedRun::clear() {
  if (is_journal_) return;
  // The journal's folder comes last: the others' notes lead to it.
  for (auto note = notes_.rbegin(); note != notes_.rend(); ++note) {
    clear_left_overs(note->folder, name_);
    ::unlink(note_path(note->folder, name_).c_str());
  }
  notes_.clear();
}

}  // namespace sinew
