// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/compiled_model.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace sinew {
namespace {

namespace fs = std::filesystem;

/// Exit status of a program, its output where ours goes; 127 where it cannot be started.
int run(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::execvp(words[0], words.data());
    ::_exit(127);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return 127;
  return WEXITSTATUS(status);
}

/// A folder that goes with the object.
struct Scratch {
  fs::path path;
  Scratch() {
    std::string name = (fs::temp_directory_path() / "sinew_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be created");
    path = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

}  // namespace

CompiledModel::CompiledModel(const fs::path& folder, const fs::path& runtime)
    : name_((folder / "").lexically_normal().parent_path().filename().string()) {
  const Scratch scratch;
  const fs::path library = scratch.path / "model.so";
  const char* compiler = std::getenv("CC");
  const std::string stem = (folder / name_).string();
  if (run({compiler ? compiler : "cc", "-std=c11", "-O1", "-ffp-contract=off", "-fno-math-errno",
           "-shared", "-fPIC", "-I" + runtime.string(), "-I" + folder.string(), "-o",
           library.string(), stem + ".c", stem + "_catalogue.c"}) != 0)
    throw std::runtime_error(folder.string() + ": the emitted C does not compile");
  void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(::dlerror());
  library_ = {handle, [](void* opened) { ::dlclose(opened); }};
  catalogue_ = static_cast<const sinew_catalogue*>(::dlsym(handle, (name_ + "_catalogue").c_str()));
  if (!catalogue_ || catalogue_->scalar_bytes != 8)
    throw std::runtime_error(folder.string() + ": no double-precision model called " + name_);
}

std::vector<double> CompiledModel::operator()(const std::string& name,
                                              const std::vector<double>& inputs) const {
  const std::string full = name_ + "_" + name;
  for (int i = 0; i < catalogue_->function_count; ++i) {
    const sinew_function& function = catalogue_->functions[i];
    if (full != function.name) continue;
    if (inputs.size() != static_cast<std::size_t>(function.input_size))
      throw std::runtime_error(fmt::format("{} takes {} numbers", full, function.input_size));
    std::vector<double> results(static_cast<std::size_t>(function.output_size));
    function.call(inputs.data(), results.data());
    return results;
  }
  throw std::runtime_error(full + " is not in the catalogue; generate the model again");
}

}  // namespace sinew
