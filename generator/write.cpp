// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/write.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "generator/emit_batch.h"
#include "generator/emit_c.h"
#include "generator/emit_catalogue.h"
#include "generator/emit_header.h"
#include "generator/manifest.h"
#include "generator/reference.h"
#include "generator/unified_diff.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const fs::path& path) {
  throw std::runtime_error(fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno)));
}

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Closes on every way out.
struct Descriptor {
  int fd;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

void write_file(const fs::path& path, const std::string& content) {
  const Descriptor file{::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644)};
  if (file.fd < 0) fail("cannot create", path);
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t n = ::write(file.fd, content.data() + done, content.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("cannot write", path);
    done += static_cast<std::size_t>(n);
  }
  if (::fsync(file.fd) != 0) fail("cannot flush", path);
}

void flush_folder(const fs::path& path) {
  const Descriptor folder{::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  if (folder.fd >= 0) (void)::fsync(folder.fd);
}

std::set<std::string> listed_files(const fs::path& folder) {
  const nlohmann::json manifest =
      nlohmann::json::parse(read_file(folder / "manifest.json"), nullptr, false);
  std::set<std::string> names;
  if (manifest.is_object() && manifest.contains("files") && manifest["files"].is_array())
    for (const auto& name : manifest["files"])
      if (name.is_string()) names.insert(name.get<std::string>());
  return names;
}

void refuse_foreign_files(const fs::path& folder) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder))
    throw std::runtime_error(
        fmt::format("{}: is not a folder; give a folder to write into", folder.string()));
  const std::set<std::string> ours = listed_files(folder);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (!ours.count(entry.path().filename().string()))
      throw std::runtime_error(
          fmt::format("{}: not a file that sinew wrote; generating would remove it. Move it away "
                      "or choose another folder",
                      entry.path().string()));
}

std::string temporary_prefix(const fs::path& folder) {
  return "." + folder.filename().string() + ".new-";
}

/// Where the old folder waits on a file system that cannot exchange two folders.
std::string aside_prefix(const fs::path& folder) {
  return "." + folder.filename().string() + ".old-";
}

/// Folders beside the target that a process made which no longer runs.
std::vector<fs::path> left_overs(const fs::path& folder, const std::string& prefix) {
  const fs::path parent = folder.parent_path();
  std::vector<fs::path> dead;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(prefix, 0) != 0) continue;
    int pid = 0;
    std::from_chars(name.data() + prefix.size(), name.data() + name.size(), pid);
    if (pid > 0 && ::kill(pid, 0) != 0 && errno == ESRCH) dead.push_back(entry.path());
  }
  return dead;
}

/// Puts an old folder back that an interrupted run had set aside, and removes what else is left.
void clear_left_overs(const fs::path& folder) {
  for (const fs::path& aside : left_overs(folder, aside_prefix(folder)))
    if (fs::exists(folder))
      fs::remove_all(aside);
    else
      fs::rename(aside, folder);
  for (const fs::path& path : left_overs(folder, temporary_prefix(folder))) fs::remove_all(path);
}

/// Absolute, through links (the folder behind a link is replaced, not the link), without "." or a
/// trailing slash.
fs::path real_path(const fs::path& given) {
  const fs::path path = fs::weakly_canonical(fs::absolute(given));
  return path.has_filename() ? path : path.parent_path();
}

/// Two renames instead of one: between them the old folder stands whole beside its place, and the
/// next run puts it back.
void swap_in_two_steps(const fs::path& temporary, const fs::path& folder) {
  const fs::path aside = folder.parent_path() / (aside_prefix(folder) + std::to_string(::getpid()));
  fs::remove_all(aside);
  if (::rename(folder.c_str(), aside.c_str()) != 0) fail("cannot replace", folder);
  if (::rename(temporary.c_str(), folder.c_str()) != 0) {
    const int error = errno;
    (void)::rename(aside.c_str(), folder.c_str());
    errno = error;
    fail("cannot replace", folder);
  }
  std::error_code ignored;
  fs::remove_all(aside, ignored);
}

void swap_in(const fs::path& temporary, const fs::path& folder) {
  if (!fs::exists(folder)) {
    if (::rename(temporary.c_str(), folder.c_str()) != 0) fail("cannot rename to", folder);
    return;
  }
  if (::renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0)
    return;
  if (errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP) fail("cannot replace", folder);
  swap_in_two_steps(temporary, folder);
}

}  // namespace

std::vector<std::string> emitted_file_names(const EmittedModel& model) {
  std::set<std::string> names{"manifest.json", "reference.csv"};
  for (const char* ending : {".h", ".c", "_batch.h", "_batch.c", "_catalogue.h", "_catalogue.c"})
    names.insert(model.name + ending);
  return {names.begin(), names.end()};
}

FileSet emit_files(const EmittedModel& model) {
  return {{model.name + ".h", emit_header(model)},
          {model.name + ".c", emit_c(model)},
          {model.name + "_batch.h", emit_batch_header(model)},
          {model.name + "_batch.c", emit_batch(model)},
          {model.name + "_catalogue.h", emit_catalogue_header(model)},
          {model.name + "_catalogue.c", emit_catalogue(model)},
          {"manifest.json", emit_manifest(model)},
          {"reference.csv", emit_reference(model)}};
}

void replace_folder(const fs::path& given, const FileSet& files) {
  const fs::path folder = real_path(given);
  fs::create_directories(folder.parent_path());
  clear_left_overs(folder);
  refuse_foreign_files(folder);
  const fs::path temporary =
      folder.parent_path() / (temporary_prefix(folder) + std::to_string(::getpid()));
  fs::remove_all(temporary);
  try {
    if (!fs::create_directory(temporary)) fail("cannot create", temporary);
    for (const auto& [name, content] : files) write_file(temporary / name, content);
    flush_folder(temporary);
    swap_in(temporary, folder);
    flush_folder(folder.parent_path());
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(temporary, ignored);
    throw;
  }
  std::error_code ignored;
  fs::remove_all(temporary, ignored);
}

std::string difference(const fs::path& folder, const FileSet& files) {
  std::string text;
  std::set<std::string> names;
  if (fs::is_directory(folder))
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      names.insert(entry.path().filename().string());
  for (const auto& [name, content] : files) names.insert(name);
  for (const std::string& name : names) {
    const auto now = files.find(name);
    const std::string label = (folder.filename() / name).string();
    text += unified_diff(read_file(folder / name), now == files.end() ? "" : now->second,
                         "a/" + label, "b/" + label);
  }
  return text;
}

}  // namespace sinew
