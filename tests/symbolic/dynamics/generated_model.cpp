// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/symbolic/dynamics/generated_model.h"

#include <stdexcept>

namespace sinew::reference {

GeneratedModel::GeneratedModel(const std::filesystem::path& model_folder,
                               const std::vector<std::string>& arguments)
    : emitted_(place_.path() / "emitted") {
  std::vector<std::string> command = {SINEW_PROGRAM, "generate", model_folder.string(), "--out",
                                      emitted_.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::string output;
  const int code = run_program(command, output);
  if (code != 0)
    throw std::runtime_error("sinew generate ended with " + std::to_string(code) + "\n" + output);
}

double unit_limit(const Mechanism& mechanism) {
  return coordinate_count(mechanism) >= 6 ? 64.0 : 16.0;
}

}  // namespace sinew::reference
