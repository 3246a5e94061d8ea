// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/unified_diff.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "generator/outputs/descriptor.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

/// A private folder that goes away with the object.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::string name = (fs::temp_directory_path() / "sinew-diff-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("cannot create a temporary folder");
    path_ = name;
  }
  ~PrivateFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  fs::path file(const std::string& name, const std::string& content) const {
    write_new_file(path_ / name, content);  // cut short it would hide a difference
    return path_ / name;
  }

 private:
  fs::path path_;
};

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

std::string unified_diff(const std::string& before, const std::string& after,
                         const std::string& before_label, const std::string& after_label) {
  if (before == after) return "";
  const PrivateFolder folder;
  const std::string command = fmt::format(
      "LC_ALL=C diff -u --label {} --label {} {} {}", quoted(before_label), quoted(after_label),
      quoted(folder.file("before", before).string()), quoted(folder.file("after", after).string()));
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
