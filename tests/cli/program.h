// SPDX-License-Identifier: GPL-3.0-or-later
// The program run in a folder of its own, with copies of models to change.
#pragma once

#include <string>
#include <vector>

#include "tests/reference/temporary_folder.h"

namespace sinew {

struct Ended {
  int status = 0;
  std::string output;  ///< both streams
  bool says(const std::string& text) const { return output.find(text) != std::string::npos; }
};

/// A working folder with models/index below it.
class Workplace {
 public:
  Workplace();

  /// `sinew <arguments>` with this folder as the current one.
  Ended sinew(const std::vector<std::string>& arguments) const;
  /// The same in `folder`.
  static Ended sinew_in(const std::filesystem::path& folder,
                        const std::vector<std::string>& arguments);
  /// A command line for a POSIX shell, here.
  Ended shell(const std::string& command) const;

  std::filesystem::path path(const std::string& below) const { return place_.path() / below; }
  std::string text(const std::string& file) const { return reference::read_text(path(file)); }
  /// Replaces the first `before` of a file by `after`. Throws where there is none.
  void change(const std::string& file, const std::string& before, const std::string& after) const;

 private:
  reference::TemporaryFolder place_;
};

}  // namespace sinew
