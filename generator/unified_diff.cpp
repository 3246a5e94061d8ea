// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/unified_diff.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "generator/outputs/descriptor.h"
#include "generator/outputs/scratch_folder.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

fs::path written(const fs::path& file, const std::string& content) {
  write_new_file(file, content);  // cut short it would hide a difference
  return file;
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

std::string unified_diff(const std::string& before, const std::string& after,
                         const std::string& before_label, const std::string& after_label) {
  if (before == after) return "";
  const ScratchFolder folder;
  const std::string command =
      fmt::format("LC_ALL=C diff -u --label {} --label {} {} {}", quoted(before_label),
                  quoted(after_label), quoted(written(folder.path() / "before", before).string()),
                  quoted(written(folder.path() / "after", after).string()));
  FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot run diff");
  std::string text;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = ::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), n);
  const int status = ::pclose(pipe);
  if (!WIFEXITED(status) || WEXITSTATUS(status) > 1)
    throw std::runtime_error("diff failed; is diffutils installed?");
  return text;
}

}  // namespace sinew
