// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/program.h"

#include <stdexcept>

namespace sinew {

namespace fs = std::filesystem;

Workplace::Workplace() {
  fs::create_directory(path("models"));
  fs::copy(SINEW_SOURCE_DIR "/models/index", path("models/index"), fs::copy_options::recursive);
}

Ended Workplace::sinew(const std::vector<std::string>& arguments) const {
  return sinew_in(place_.path(), arguments);
}

Ended Workplace::sinew_in(const fs::path& folder, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"env", "-C", folder.string(), SINEW_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  Ended ended;
  ended.status = reference::run_program(command, ended.output);
  return ended;
}

Ended Workplace::shell(const std::string& command) const {
  Ended ended;
  const std::string program = "sinew() { " SINEW_PROGRAM " \"$@\"; }; ";
  ended.status = reference::run_program(
      {"env", "-C", place_.path().string(), "sh", "-c", program + command}, ended.output);
  return ended;
}

void Workplace::change(const std::string& file, const std::string& before,
                       const std::string& after) const {
  std::string text = this->text(file);
  const std::size_t at = text.find(before);
  if (at == std::string::npos) throw std::runtime_error(file + ": has no '" + before + "'");
  reference::write_text(path(file), text.replace(at, before.size(), after));
}

}  // namespace sinew
