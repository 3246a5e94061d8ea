// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted C compiled with the host's compiler and called: numbers come from what runs on the board.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "runtime/sinew_catalogue.h"

namespace sinew {

class CompiledModel {
 public:
  /// `folder`: emitted C of one double-precision model, named after it; `runtime`: the runtime's
  /// headers. Throws std::runtime_error where it does not compile or cannot be loaded.
  CompiledModel(const std::filesystem::path& folder, const std::filesystem::path& runtime);

  /// All inputs one after the other in, all results one after the other out. Throws
  /// std::runtime_error where the model has no such function (`name` without the model's prefix) or
  /// takes another number of inputs.
  std::vector<double> operator()(const std::string& name, const std::vector<double>& inputs) const;

 private:
  std::string name_;
  std::shared_ptr<void> library_;
  const sinew_catalogue* catalogue_ = nullptr;
};

}  // namespace sinew
