// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted C, compiled on the spot, loaded and called by name.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "runtime/sinew_catalogue.h"
#include "tests/reference/temporary_folder.h"

namespace sinew::reference {

struct CompileOptions {
  std::string compiler = "cc";
  std::vector<std::string> flags = {"-std=c11", "-O1", "-ffp-contract=off", "-fno-math-errno"};
};

/// Every .c file of a folder that holds <model>.c and <model>_catalogue.c, as a shared object.
class EmittedModel {
 public:
  /// Throws std::runtime_error with the compiler's output where the C does not compile, and where
  /// the folder holds no catalogue, or more than one.
  explicit EmittedModel(const std::filesystem::path& folder, const CompileOptions& options = {});

  const std::string& model() const { return model_; }
  const sinew_catalogue& catalogue() const { return *catalogue_; }

  /// `name` without the model's prefix, for instance "mass_matrix"; null where not offered.
  const sinew_function* find(const std::string& name) const;
  /// The same, but throws std::out_of_range with the missing function's full name.
  const sinew_function& function(const std::string& name) const;

  /// All inputs one after the other in, all results one after the other out, as doubles whatever
  /// the model's scalar. Results start as NaN, so that one left unwritten shows. Throws
  /// std::invalid_argument where the number of inputs is wrong.
  std::vector<double> call(const std::string& name, const std::vector<double>& inputs) const;
  std::vector<double> call(const sinew_function& function, const std::vector<double>& inputs) const;

 private:
  TemporaryFolder folder_;
  std::string model_;
  std::shared_ptr<void> library_;
  const sinew_catalogue* catalogue_ = nullptr;
};

}  // namespace sinew::reference
