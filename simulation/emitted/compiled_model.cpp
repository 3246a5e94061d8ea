// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/emitted/compiled_model.h"

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

void compile(const fs::path& folder, const fs::path& runtime, const fs::path& library,
             const std::vector<std::string>& more) {
  const char* compiler = std::getenv("CC");
  // The rules of the package (runtime/CMakeLists.txt), so that the bits are those of the boards.
  std::vector<std::string> command{compiler ? compiler : "cc",
                                   "-std=c11",
                                   "-ffp-contract=off",
                                   "-fno-math-errno",
                                   "-fno-tree-slp-vectorize",
                                   "-shared",
                                   "-fPIC",
                                   "-I" + runtime.string(),
                                   "-I" + folder.string(),
                                   "-o",
                                   library.string()};
  command.insert(command.end(), more.begin(), more.end());
  if (run(command) != 0)
    throw std::runtime_error(folder.string() + ": the emitted C does not compile");
}

std::shared_ptr<void> open_library(const fs::path& library) {
  void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(::dlerror());
  return {handle, [](void* opened) { ::dlclose(opened); }};
}

}  // namespace

CompiledModel::CompiledModel(const fs::path& folder, const fs::path& runtime)
    : name_((folder / "").lexically_normal().parent_path().filename().string()) {
  load(folder, runtime, {"-O2"}, false);
}

CompiledModel::CompiledModel(const EmittedModel& model, const fs::path& runtime, bool with_batch)
    : name_(model.name) {
  const Scratch scratch;
  for (const auto& [file, text] : emit_files(model)) {
    std::ofstream out(scratch.path / file, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error((scratch.path / file).string() + ": not written");
  }
  load(scratch.path, runtime, {"-O3", "-march=native"}, with_batch);
}

void CompiledModel::load(const fs::path& folder, const fs::path& runtime,
                         std::vector<std::string> options, bool with_batch) {
  const Scratch scratch;
  const std::string stem = (folder / name_).string();
  const fs::path library = scratch.path / "model.so";
  options.insert(options.end(), {stem + ".c", stem + "_catalogue.c"});
  compile(folder, runtime, library, options);
  library_ = open_library(library);
  if (with_batch) {
    const fs::path loops = scratch.path / "batch.so";
    compile(folder, runtime, loops, {"-O3", "-march=native", stem + "_batch.c"});
    batch_ = open_library(loops);
  }
  catalogue_ =
      static_cast<const sinew_catalogue*>(::dlsym(library_.get(), (name_ + "_catalogue").c_str()));
  if (!catalogue_ || catalogue_->scalar_bytes != 8)
    throw std::runtime_error(folder.string() + ": no double-precision model called " + name_);
}

const sinew_function* CompiledModel::search(const std::string& name) const {
  const std::string full = name_ + "_" + name;
  for (int i = 0; i < catalogue_->function_count; ++i)
    if (full == catalogue_->functions[i].name) return &catalogue_->functions[i];
  return nullptr;
}

void* CompiledModel::find_batch(const std::string& name) const {
  void* found = batch_ ? ::dlsym(batch_.get(), (name_ + "_" + name + "_batch").c_str()) : nullptr;
  if (!found) throw std::runtime_error(fmt::format("{}_{} has no batch form", name_, name));
  return found;
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
