// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a command writes, in one step.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/outputs/output_place.h"

namespace sinew {

class UnfinishedRun;

/// File name -> content; below a folder a name may have folders, "generated/motor/motor.h".
using FileSet = std::map<std::string, std::string>;

/// The outputs of a command: held in memory until commit(), which makes all of them appear together
/// or leaves everything as it was. Regular files and folders are written as drafts beside their
/// places, handed to the disk, and renamed. Permissions of a file that is replaced stay.
///
/// A single output is the old or the new one at every moment. Of several an end by force (SIGKILL,
/// a power cut) between two renames leaves some in place: the next sinew command that reads or
/// writes one of the folders puts the old ones back (recover_interrupted()).
///
/// All functions throw std::runtime_error naming the path, what is wrong, and what was expected.
class Outputs {
 public:
  /// No output that is added from now on may be one of these files.
  void protect(Inputs inputs) { inputs_ = std::move(inputs); }

  /// `target`: see output_place().
  void file(const std::filesystem::path& target, std::string text);

  /// `folder` afterwards has just these files.
  void folder(const std::filesystem::path& folder, const FileSet& files);
  /// What else is in `folder` stays. Parents are made as needed.
  void into_folder(const std::filesystem::path& folder, const FileSet& files);

  void commit();

 private:
  struct Entry {
    std::filesystem::path path;  ///< real
    bool is_folder = false, replaces = false;
    FileSet files;  ///< a folder's; a file's text under ""
  };
  struct Stream {
    OutputPlace place;
    std::string text;
  };
  void new_folder(const std::filesystem::path& folder, const FileSet& files);
  void add(Entry entry);
  void write_drafts(UnfinishedRun& run, bool with_ways_back) const;
  void write_streams();
  void put_all_in_place(UnfinishedRun& run) const;
  void put_all_in_place_or_none(UnfinishedRun& run) const;

  Inputs inputs_;
  std::vector<Entry> entries_;
  std::vector<Stream> streams_;
};

/// One file whole or not at all, as Outputs do it.
void write_output(const std::filesystem::path& target, std::string text);

/// One long output, written as it comes: a regular file appears at commit() or not at all, a stream
/// takes everything at once.
class OutputFile {
 public:
  OutputFile(const std::filesystem::path& target, const Inputs& inputs = {});
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view text);
  void commit();

 private:
  OutputPlace place_;
  std::unique_ptr<UnfinishedRun> run_;  ///< none for a stream
  Descriptor draft_;
};

}  // namespace sinew
