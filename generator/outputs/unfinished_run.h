// SPDX-License-Identifier: GPL-3.0-or-later
// What a run leaves in a folder while it writes there, so that the next one can tell what an end by
// force left behind, and puts it right.
//
// A run has an identifier of 8 letters. In every folder it writes into it keeps
//   .sinew-<run>          its note, locked (flock) as long as the run lives
//   .<name>.<run>.new     a draft of <name>
//   .<name>.<run>.old     a second name, or a copy, of what <name> was, to go back to
//   .<name>.<run>.gone    a folder on its way out, where folders cannot be exchanged
// An empty note says that nothing but drafts may be there. Before the first of several outputs
// takes its place, the first folder's note becomes a journal of them, and the notes of the other
// folders say where it is; emptying the journal again is the one step that makes all of them count.
#pragma once

#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include "generator/outputs/descriptor.h"
#include "generator/outputs/interruption.h"

namespace sinew {

/// One output of a run: a file, or a folder as a whole.
struct RunTarget {
  std::filesystem::path path;  ///< absolute
  bool is_folder = false;
  bool replaces = false;  ///< something was there
};

enum class Beside { draft, old, gone };

/// Path of what the run keeps beside a target.
std::filesystem::path beside(const std::filesystem::path& target, const std::string& run,
                             Beside kind);

/// Puts `from` in the place of a target in one step, or, for a folder where the file system cannot
/// exchange two, in two with the old folder's path ending in .gone between them. A folder that was
/// replaced is left as `from` or .gone. Throws std::runtime_error; the target is as it was then.
void put_in_place(const std::filesystem::path& from, const std::filesystem::path& target,
                  bool is_folder, const std::string& run);

/// Takes what a run has put in place out again: every target is what it was. Targets in folders
/// without the run's note are left alone. May be repeated after an interruption.
void undo(const std::vector<RunTarget>& targets, const std::string& run);

/// Puts right what runs that were ended by force left in a folder: what they had begun to replace
/// is as before, wherever it is, and their drafts are gone. Waits for a run that lives and is just
/// putting its outputs in place. Only notes that this user alone may write count. Throws
/// std::runtime_error where outputs of a run stay half replaced.
void recover_interrupted(const std::filesystem::path& folder);

/// The run of this process: its notes and their locks.
class UnfinishedRun {
 public:
  UnfinishedRun();
  /// Removes what is beside the targets, and the notes, unless a journal still stands.
  ~UnfinishedRun();
  UnfinishedRun(const UnfinishedRun&) = delete;
  UnfinishedRun& operator=(const UnfinishedRun&) = delete;

  const std::string& name() const { return name_; }
  /// Leaves a locked note in the target's folder. An interruption removes it, and what is beside
  /// the target. Throws std::runtime_error where nothing can be written.
  void enter(const std::filesystem::path& target);
  /// From here on an interruption removes nothing: the outputs take their places.
  void end_drafts() { interruptible_.clear(); }
  void begin_journal(const std::vector<RunTarget>& targets);
  /// From now on the outputs count.
  void end_journal();
  void clear();

 private:
  struct Note {
    std::filesystem::path folder;
    Descriptor file;
  };
  std::string name_;
  std::list<RemovedIfInterrupted> interruptible_;
  std::vector<Note> notes_;  ///< the first may become the journal
  bool is_journal_ = false;
};

}  // namespace sinew
