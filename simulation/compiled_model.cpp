// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/compiled_model.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "generator/write.h"

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
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

void compile(const fs::path& folder, const std::string& name, const fs::path& runtime,
             const fs::path& library) {
  const char* compiler = std::getenv("CC");
  const std::string stem = (folder / name).string();
  // The rules of the package (runtime/CMakeLists.txt), so that the bits are those of the boards.
  if (run({compiler ? compiler : "cc", "-std=c11", "-O2", "-ffp-contract=off", "-fno-math-errno",
           "-fno-tree-slp-vectorize", "-shared", "-fPIC", "-I" + runtime.string(),
           "-I" + folder.string(), "-o", library.string(), stem + ".c", stem + "_catalogue.c"}) !=
      0)
    throw std::runtime_error(folder.string() + ": the emitted C does not compile");
}

}  // namespace

CompiledModel::CompiledModel(const fs::path& folder, const fs::path& runtime)
    : name_((folder / "").lexically_normal().parent_path().filename().string()) {
  load(folder, runtime);
}

CompiledModel::CompiledModel(const EmittedModel& model, const fs::path& runtime)
    : name_(model.name) {
  const Scratch scratch;
  for (const auto& [file, text] : emit_files(model)) {
    std::ofstream out(scratch.path / file, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error((scratch.path / file).string() + ": not written");
  }
  load(scratch.path, runtime);
}

void CompiledModel::load(const fs::path& folder, const fs::path& runtime) {
  const Scratch scratch;
  const fs::path library = scratch.path / "model.so";
  compile(folder, name_, runtime, library);
  void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(::dlerror());
  library_ = {handle, [](void* opened) { ::dlclose(opened); }};
  catalogue_ = static_cast<const sinew_catalogue*>(::dlsym(handle, (name_ + "_catalogue").c_str()));
  if (!catalogue_ || catalogue_->scalar_bytes != 8)
    throw std::runtime_error(folder.string() + ": no double-precision model called " + name_);
}

const sinew_function* CompiledModel::search(const std::string& name) const {
  const std::string full = name_ + "_" + name;
  for (int i = 0; i < catalogue_->function_count; ++i)
    if (full == catalogue_->functions[i].name) return &catalogue_->functions[i];
  return nullptr;
}

bool CompiledModel::has(const std::string& name) const {
  return search(name) != nullptr;
}

const sinew_function& CompiledModel::find(const std::string& name) const {
  if (const sinew_function* function = search(name)) return *function;
  throw std::runtime_error(
      fmt::format("{}_{} is not in the catalogue; generate the model again", name_, name));
}

std::vector<double> CompiledModel::operator()(const std::string& name,
                                              const std::vector<double>& inputs) const {
  const sinew_function& function = find(name);
  if (inputs.size() != static_cast<std::size_t>(function.input_size))
    throw std::runtime_error(
        fmt::format("{} takes {} numbers", function.name, function.input_size));
  std::vector<double> results(static_cast<std::size_t>(function.output_size));
  function.call(inputs.data(), results.data());
  return results;
}

}  // namespace sinew
