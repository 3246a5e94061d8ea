// SPDX-License-Identifier: GPL-3.0-or-later
// Libraries that were compiled before, in the user's cache folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sinew {

/// Shared libraries by the hash of all that they are made from. The folder is
/// $XDG_CACHE_HOME/sinew, or ~/.cache/sinew; SINEW_CACHE_DIR names another one, and empty it means
/// none. It is used only where it, and the file, belong to this user and nobody else may write
/// them, and a file only where its contents have the digest that it ends with. Nothing here throws:
/// what cannot be cached is compiled.
class LibraryCache {
 public:
  /// `texts`: the sources and headers; `command`: the compiler and its options, and whatever else
  /// the result depends on.
  LibraryCache(const std::vector<std::string>& texts, const std::vector<std::string>& command);

  /// The library; empty where there is none.
  std::filesystem::path find() const;
  /// Keeps a copy of it; the oldest ones go where there are too many.
  void keep(const std::filesystem::path& library) const;

 private:
  std::filesystem::path file_;  ///< empty: nothing is cached
};

/// What tells one compiler from another: its path, size and time of change, and this machine's
/// processor, which -march=native asks about. Empty where the compiler is not found.
std::string compiler_identity(const std::string& compiler);

}  // namespace sinew
