// SPDX-License-Identifier: GPL-3.0-or-later
// What a path given by --out names, before anything is written.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "generator/outputs/descriptor.h"

namespace sinew {

/// Absolute, every link in it followed, also one that leads to nothing yet; without "." and "..".
/// Throws std::runtime_error where links lead in a circle.
std::filesystem::path real_path(const std::filesystem::path& given);

/// Where one file goes.
struct OutputPlace {
  std::filesystem::path shown;  ///< as it was given
  std::filesystem::path real;   ///< of a regular file, new or to be replaced; else empty
  Descriptor stream;            ///< open where there is nothing to replace: a pipe, a terminal
  bool is_standard_output = false;
};

/// "-", and every path that leads to the file that standard output is open on, is standard output;
/// so is standard error, and a descriptor of this process below /dev/fd. A character device or a
/// FIFO is opened for writing (and SIGPIPE is ignored from then on: a reader that leaves is an
/// error of the write). Of a link its target counts. Throws std::runtime_error saying what was
/// expected for a folder, a disk, a socket, a file that may not be written, and a folder that does
/// not exist.
OutputPlace output_place(const std::filesystem::path& given);

class Inputs;

/// To be asked before long calculations: throws as output_place() does, but opens nothing, and
/// where the place is one of the inputs. Puts right what an interrupted run left in its folder.
void check_output_file(const std::filesystem::path& given, const Inputs& inputs);

/// The real path of a regular file, new or to be replaced. Throws std::runtime_error for anything
/// else.
std::filesystem::path replaceable_file(const std::filesystem::path& given);

/// Whether the file would go to standard output. Throws nothing.
bool is_standard_output(const std::filesystem::path& given) noexcept;

/// The real path of a folder that outputs go into; it need not exist. Throws std::runtime_error for
/// "-" and for what is no folder.
std::filesystem::path output_folder(const std::filesystem::path& given);

/// Files that a command reads, known by device and inode: whatever their paths look like.
class Inputs {
 public:
  /// Names of no regular file are passed over.
  void add(const std::filesystem::path& file);
  /// Throws std::runtime_error where `file` is one of them.
  void refuse(const std::filesystem::path& file) const;

 private:
  struct Known {
    dev_t device;
    ino_t inode;
    std::string path;
  };
  std::vector<Known> files_;
};

}  // namespace sinew
