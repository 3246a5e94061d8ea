// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/outputs/scratch_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace sinew {
namespace {

std::filesystem::path new_folder() {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
  if (error)
    throw std::runtime_error("there is no folder for temporary files: " + error.message() +
                             "; name one by TMPDIR");
  std::string name = (parent / "sinew-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw std::runtime_error(name + ": cannot be made: " + std::strerror(errno) +
                             "; name another folder for temporary files by TMPDIR");
  return name;
}

}  // namespace

ScratchFolder::ScratchFolder() : folder_(new_folder) {}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_.path(), ignored);
}

}  // namespace sinew
