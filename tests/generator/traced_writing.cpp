// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generator/traced_writing.h"

#include <stdexcept>

#include "tests/reference/temporary_folder.h"

namespace sinew {

namespace fs = std::filesystem;
using reference::TemporaryFolder;

FileSet files_in(const fs::path& folder) {
  FileSet files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory())
      files[entry.path().lexically_relative(folder).string()] = reference::read_text(entry.path());
  return files;
}

std::size_t entries_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

Injected inject(const std::string& call, const std::string& action, int count,
                const fs::path& folder, const std::vector<std::string>& more,
                const std::string& writer) {
  const TemporaryFolder place;
  const std::string trace = (place.path() / "trace").string();
  std::vector<std::string> command{
      "strace", "-f",
      "-o",     trace,
      "-E",     "ASAN_OPTIONS=detect_leaks=0",  // a traced process cannot be searched for leaks
      "-e",     "trace=" + call,
      "-e",     "inject=" + call + ":" + action + ":when=" + std::to_string(count)};
  command.insert(command.end(), more.begin(), more.end());
  const std::vector<std::string> program{writer, folder.string(), "n"};
  command.insert(command.end(), program.begin(), program.end());
  std::string output;
  Injected result;
  result.status = reference::run_program(command, output);
  const std::string log = reference::read_text(trace);
  result.happened = log.find("INJECTED") != std::string::npos ||
                    log.find("killed by SIGKILL") != std::string::npos;
  return result;
}

bool strace_works() {
  std::string output;
  try {
    return reference::run_program({"strace", "-e", "trace=write", "-o", "/dev/null", "true"},
                                  output) == 0;
  } catch (const std::runtime_error&) {
    return false;
  }
}

bool writes_may_fail() {
#if defined(__SANITIZE_ADDRESS__)
  return false;
#elif defined(__has_feature)
  return !__has_feature(address_sanitizer);
#else
  return true;
#endif
}

}  // namespace sinew
