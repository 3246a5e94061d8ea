// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/runtime_folder.h"

#include <stdexcept>
#include <system_error>

namespace sinew {

std::filesystem::path runtime_folder(const std::string& given) {
  namespace fs = std::filesystem;
  const auto holds_headers = [](const fs::path& folder) {
    return fs::exists(folder / "sinew_math.h");
  };
  if (!given.empty()) {
    if (holds_headers(given)) return given;
    throw std::runtime_error(given + ": holds no sinew_math.h; expected the runtime's headers");
  }
  if (holds_headers("runtime")) return "runtime";
  std::error_code ignored;
  for (fs::path at = fs::read_symlink("/proc/self/exe", ignored).parent_path();
       at.has_relative_path(); at = at.parent_path())
    for (const char* place : {"runtime", "include/sinew"})
      if (holds_headers(at / place)) return at / place;
  throw std::runtime_error("the runtime's headers are not found; name their folder by --runtime");
}

void add_runtime(Inputs& inputs, const std::filesystem::path& runtime) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(runtime, ignored))
    inputs.add(entry.path());
}

}  // namespace sinew
