// SPDX-License-Identifier: GPL-3.0-or-later
// What every wrapper starts from: a manifest as it stands beside the emitted C, and that C. A
// wrapper knows nothing that these do not say, so that it cannot differ from them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/outputs/outputs.h"

namespace sinew {

/// Folder of the sources that are for a host alone: the batch files.
inline constexpr std::string_view host_sources = "host/";

/// An argument or a result of an emitted function; row-major.
struct WrappedArray {
  std::string name;
  int rows = 1, cols = 1;
  std::string unit, doc;
  std::string order;              ///< "joints", "tendons", "wrist", "joints_and_wrist"; "" for none
  std::vector<double> low, high;  ///< inputs only; may be empty
  bool by_value = false;          ///< inputs only: a number, not an array
  std::vector<std::string> states;  ///< outputs only: what 0, 1, ... mean; C has an int then
  int size() const { return rows * cols; }
  bool is_scalar() const { return rows * cols == 1; }
  bool is_vector() const { return cols == 1; }
  bool is_status() const { return !states.empty(); }
};

struct WrappedFunction {
  std::string name;  ///< without the model's prefix
  std::string doc, equation;
  std::vector<WrappedArray> inputs, outputs;
  bool has_batch = false;  ///< <model>_<name>_batch is there
};

struct WrappedJoint {
  std::string name, type, unit;
  std::string source_name;  ///< in the file it was imported from; else its name
  double low = 0.0, high = 0.0, reference = 0.0, damping = 0.0;
};

struct WrappedModel {
  std::string name, description, hash, scalar;
  std::vector<WrappedJoint> joints;
  std::vector<std::string> tendons, frames, wrist;
  std::vector<WrappedFunction> functions;
  FileSet sources;  ///< the emitted C and its headers, by name ("host/index_batch.c")
  FileSet runtime;  ///< the runtime's headers, by name
  std::string manifest;

  /// None where the model has no such function.
  const WrappedFunction* find(const std::string& name) const;
};

/// From the files that `generate` writes (emit_files) and the runtime's headers. Throws
/// std::runtime_error where the manifest among them cannot be understood.
WrappedModel wrapped_model(const FileSet& emitted, FileSet runtime);

/// A language or system that models are wrapped for.
struct Wrapper {
  const char* name;  ///< option and folder: "python"
  const char* help;
  FileSet (*files)(const WrappedModel& model);  ///< throws std::runtime_error where it cannot be
};

/// All of them.
const std::vector<Wrapper>& wrappers();

// One file a language. Names may have folders.
FileSet python_files(const WrappedModel& model);
FileSet cpp_files(const WrappedModel& model);
FileSet octave_files(const WrappedModel& model);
FileSet ros2_files(const WrappedModel& model);
FileSet fmu_files(const WrappedModel& model);
FileSet zephyr_files(const WrappedModel& model);

}  // namespace sinew
