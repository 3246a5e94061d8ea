// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/outputs/outputs.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <stdexcept>

#include "generator/outputs/draft.h"
#include "generator/outputs/interruption.h"
#include "generator/outputs/unfinished_run.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

bool is_within(const fs::path& path, const fs::path& folder) {
  const fs::path below = path.lexically_relative(folder);
  return !below.empty() && *below.begin() != "..";
}

// What an interrupted run left is put right before anything is asked of what is there: a file may
// be new because of that run alone.

/// What would have to be made first so that `folder` can be: itself, or a parent that is missing.
fs::path first_missing(fs::path folder) {
  while (folder.has_relative_path() && !entry_exists(folder.parent_path()))
    folder = folder.parent_path();
  return folder;
}

}  // namespace

void Outputs::file(const fs::path& target, std::string text) {
  OutputPlace place = output_place(target);
  if (place.real.empty()) {
    streams_.push_back({std::move(place), std::move(text)});
    return;
  }
  recover_interrupted(place.real.parent_path());
  inputs_.refuse(place.real);
  add({place.real, false, entry_exists(place.real), {{"", std::move(text)}}});
}

void Outputs::folder(const fs::path& given, const FileSet& files) {
  const fs::path folder = output_folder(given);
  recover_interrupted(first_missing(folder).parent_path());
  if (!entry_exists(folder)) return new_folder(folder, files);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    inputs_.refuse(entry.path());
  add({folder, true, true, files});
}

void Outputs::into_folder(const fs::path& given, const FileSet& files) {
  const fs::path folder = output_folder(given);
  recover_interrupted(first_missing(folder).parent_path());
  if (!entry_exists(folder)) return new_folder(folder, files);
  recover_interrupted(folder);
  for (const auto& [name, text] : files) {
    const fs::path target = folder / name, parent = real_path(target.parent_path());
    if (!entry_exists(parent)) {
      new_folder(parent, {{target.filename(), text}});
      continue;
    }
    const fs::path real = replaceable_file(target);
    inputs_.refuse(real);
    add({real, false, entry_exists(real), {{"", text}}});
  }
}

/// Together with the parents that are missing: they appear with it.
void Outputs::new_folder(const fs::path& folder, const FileSet& files) {
  const fs::path first = first_missing(folder);
  FileSet below;
  for (const auto& [name, text] : files) below[(folder / name).lexically_relative(first)] = text;
  for (Entry& entry : entries_)
    if (entry.is_folder && !entry.replaces && entry.path == first) {
      entry.files.merge(below);
      if (below.empty()) return;
      throw std::runtime_error(
          fmt::format("{}: is written twice; expected another place for one of the outputs",
                      (first / below.begin()->first).string()));
    }
  add({first, true, false, std::move(below)});
}

void Outputs::add(Entry entry) {
  for (const Entry& other : entries_)
    if (is_within(entry.path, other.path) || is_within(other.path, entry.path))
      throw std::runtime_error(
          fmt::format("{}: is written twice; expected another place for one of the outputs",
                      entry.path.string()));
  entries_.push_back(std::move(entry));
}

void Outputs::write_drafts(UnfinishedRun& run, bool with_ways_back) const {
  for (const Entry& entry : entries_) {
    const fs::path draft = beside(entry.path, run.name(), Beside::draft);
    if (entry.is_folder)
      write_draft_folder(draft, entry.files);
    else
      write_draft_file(draft, entry.files.at(""), entry.path);
    if (entry.replaces && with_ways_back)
      keep_way_back(entry.path, beside(entry.path, run.name(), Beside::old));
  }
  for (const Entry& entry : entries_) flush_folder(entry.path.parent_path());
}

void Outputs::put_all_in_place(UnfinishedRun& run) const {
  for (const Entry& entry : entries_)
    put_in_place(beside(entry.path, run.name(), Beside::draft), entry.path, entry.is_folder,
                 run.name());
  for (const Entry& entry : entries_) flush_folder(entry.path.parent_path());
}

void Outputs::write_streams() {
  for (Stream& stream : streams_) {
    write_all(stream.place.stream, stream.text, stream.place.shown);
    stream.place.stream.close(stream.place.shown);
  }
}

void Outputs::put_all_in_place_or_none(UnfinishedRun& run) const {
  const bool several = entries_.size() > 1;
  std::vector<RunTarget> targets;
  for (const Entry& entry : entries_)
    targets.push_back({entry.path, entry.is_folder, entry.replaces});
  if (several) run.begin_journal(targets);
  try {
    put_all_in_place(run);
    run.end_journal();
  } catch (...) {
    if (several) {
      undo(targets, run.name());
      run.end_journal();
    }
    throw;
  }
}

void Outputs::commit() {
  UnfinishedRun run;
  for (const Entry& entry : entries_) run.enter(entry.path);
  write_drafts(run, entries_.size() > 1);
  write_streams();
  run.end_drafts();
  const NotInterrupted together;
  put_all_in_place_or_none(run);
  run.clear();
}

void write_output(const fs::path& target, std::string text) {
  Outputs outputs;
  outputs.file(target, std::move(text));
  outputs.commit();
}

}  // namespace sinew
