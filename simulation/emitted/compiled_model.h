// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted C compiled with the host's compiler and called: numbers come from what runs on the board.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "generator/model.h"
#include "runtime/sinew_catalogue.h"

namespace sinew {

class CompiledModel {
 public:
  /// `folder`: emitted C of one double-precision model, named after it; `runtime`: the runtime's
  /// headers. The compiler is `cc`, or the one that the environment names in CC; the options are
  /// those of the package. Throws std::runtime_error where the model does not compile or cannot be
  /// loaded.
  CompiledModel(const std::filesystem::path& folder, const std::filesystem::path& runtime);
  /// The same from a model that is not written anywhere, compiled for this machine. `with_batch`:
  /// the loops over many states too; all numbers are the same bit by bit.
  CompiledModel(const EmittedModel& model, const std::filesystem::path& runtime,
                bool with_batch = false);

  const std::string& name() const { return name_; }
  bool has(const std::string& name) const;

  /// An emitted function (`name` without the model's prefix), to be looked up once and called
  /// often: `find("bias").call(in, out)` with input_size and output_size numbers. Lives as long as
  /// the model. Throws std::runtime_error where the model has no such function.
  const sinew_function& find(const std::string& name) const;

  /// The loop over many states of an emitted function: its arguments are a count and one array for
  /// each input and each result (host/<model>_batch.h). Throws std::runtime_error where there is
  /// none.
  template <typename Loop>
  Loop* batch(const std::string& name) const {
    return reinterpret_cast<Loop*>(find_batch(name));
  }

  /// All inputs one after the other in, all results one after the other out. Throws
  /// std::runtime_error where the model has no such function or takes another number of inputs.
  std::vector<double> operator()(const std::string& name, const std::vector<double>& inputs) const;

 private:
  void load(const std::filesystem::path& folder, const std::filesystem::path& runtime,
            const std::vector<std::string>& optimisation, bool with_batch);
  void* find_batch(const std::string& name) const;
  const sinew_function* search(const std::string& name) const;

  std::string name_;
  std::shared_ptr<void> library_, batch_;
  const sinew_catalogue* catalogue_ = nullptr;
};

}  // namespace sinew
