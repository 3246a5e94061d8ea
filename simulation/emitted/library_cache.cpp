// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/emitted/library_cache.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace sinew {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_libraries = 400;
constexpr std::size_t digest_letters = 64;

std::string digest_of(const std::string& text) {
  unsigned char bytes[EVP_MAX_MD_SIZE];
  unsigned int count = 0;
  if (EVP_Digest(text.data(), text.size(), bytes, &count, EVP_sha256(), nullptr) != 1) return "";
  std::string letters;
  for (unsigned int i = 0; i < count; ++i) letters += fmt::format("{:02x}", bytes[i]);
  return letters;
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

fs::path cache_folder() {
  if (std::getenv("SINEW_CACHE_DIR")) return environment("SINEW_CACHE_DIR");
  const std::string chosen = environment("XDG_CACHE_HOME"), home = environment("HOME");
  if (chosen.starts_with('/')) return fs::path(chosen) / "sinew";
  return home.starts_with('/') ? fs::path(home) / ".cache" / "sinew" : fs::path();
}

/// Nobody else can have put it there, or can change it.
bool is_ours(const fs::path& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && status.st_uid == ::geteuid() &&
         (status.st_mode & (S_IWGRP | S_IWOTH)) == 0 && !S_ISLNK(status.st_mode);
}

bool make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder.parent_path(), error);
  ::mkdir(folder.c_str(), S_IRWXU);
  return is_ours(folder);
}

std::string contents_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return in ? text.str() : "";
}

/// A loader does not look beyond the library's end, where the digest stands.
bool is_whole(const fs::path& path) {
  const std::string text = contents_of(path);
  if (text.size() <= digest_letters) return false;
  const std::size_t end = text.size() - digest_letters;
  return digest_of(text.substr(0, end)) == text.substr(end);
}

bool write_whole(const fs::path& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file < 0) return false;
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t wrote = ::write(file, text.data() + done, text.size() - done);
    if (wrote <= 0) break;
    done += static_cast<std::size_t>(wrote);
  }
  return ::close(file) == 0 && done == text.size();
}

void remove_oldest(const fs::path& folder) {
  std::error_code error;
  std::vector<std::pair<fs::file_time_type, fs::path>> all;
  for (const auto& entry : fs::directory_iterator(folder, error))
    all.emplace_back(fs::last_write_time(entry.path(), error), entry.path());
  if (all.size() <= most_libraries) return;
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i + most_libraries < all.size(); ++i) fs::remove(all[i].second, error);
}

/// The parts with their lengths, so that no two lists give one text.
std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += fmt::format("{} {}\n", part.size(), part);
  return text;
}

}  // namespace

LibraryCache::LibraryCache(const std::vector<std::string>& texts,
                           const std::vector<std::string>& command) {
  const fs::path folder = cache_folder();
  if (folder.empty() || std::find(command.begin(), command.end(), "") != command.end()) return;
  const std::string name = digest_of(joined(texts) + joined(command));
  if (!name.empty()) file_ = folder / (name + ".so");
}

fs::path LibraryCache::find() const {
  if (file_.empty() || !is_ours(file_.parent_path()) || !is_ours(file_) || !is_whole(file_))
    return {};
  std::error_code ignored;
  fs::last_write_time(file_, fs::file_time_type::clock::now(), ignored);  // it is used
  return file_;
}

void LibraryCache::keep(const fs::path& library) const {
  if (file_.empty() || !make_folder(file_.parent_path())) return;
  const std::string text = contents_of(library);
  const fs::path draft = fmt::format("{}.{}", file_.string(), ::getpid());
  std::error_code ignored;
  if (!text.empty() && write_whole(draft, text + digest_of(text)))
    fs::rename(draft, file_, ignored);
  fs::remove(draft, ignored);
  remove_oldest(file_.parent_path());
}

std::string compiler_identity(const std::string& compiler) {
  std::vector<fs::path> places{compiler};
  if (compiler.find('/') == std::string::npos) {
    places.clear();
    std::istringstream path(environment("PATH"));
    for (std::string folder; std::getline(path, folder, ':');)
      places.push_back(fs::path(folder) / compiler);
  }
  std::ifstream cpu("/proc/cpuinfo");
  std::string processor;
  for (std::string line; std::getline(cpu, line) && !line.empty();)
    if (line.starts_with("model name") || line.starts_with("flags")) processor += line;
  struct stat status {};
  for (const fs::path& place : places)
    if (::access(place.c_str(), X_OK) == 0 && ::stat(place.c_str(), &status) == 0)
      return fmt::format("{} {} {} {} {}", fs::weakly_canonical(place).string(), status.st_size,
                         status.st_mtim.tv_sec, status.st_mtim.tv_nsec, processor);
  return "";
}

}  // namespace sinew
