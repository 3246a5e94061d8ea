// SPDX-License-Identifier: GPL-3.0-or-later
// The note of a run in a folder (unfinished_run.h): its file, its lock and its text.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/outputs/unfinished_run.h"

namespace sinew {

std::filesystem::path note_path(const std::filesystem::path& folder, const std::string& run);

/// A new, empty, locked note. Throws std::runtime_error naming the folder.
Descriptor new_note(const std::filesystem::path& folder, const std::string& run);

/// Its text, on the disk on return. Throw std::runtime_error.
void write_note(const Descriptor& note, const std::filesystem::path& folder,
                const std::string& text);
void empty_note(const Descriptor& note, const std::filesystem::path& folder);

/// Paths are relative to the folder of the note, so that they hold where all are moved together.
std::string journal_text(const std::vector<RunTarget>& targets, const std::filesystem::path& home);
std::string pointer_text(const std::filesystem::path& home, const std::filesystem::path& folder);

/// What a note says; both empty: nothing was put in place.
struct NoteText {
  std::vector<RunTarget> targets;             ///< a journal's, complete
  std::optional<std::filesystem::path> home;  ///< a pointer's
};
NoteText parse_note(const std::string& text, const std::filesystem::path& folder);

/// Removes what the run keeps beside its targets in a folder. A folder on its way out comes back
/// where nothing has taken its place. What cannot be removed stays.
void clear_left_overs(const std::filesystem::path& folder, const std::string& run);

}  // namespace sinew
