// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/emitted/compiled_model.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "generator/emit_batch.h"
#include "generator/outputs/scratch_folder.h"
#include "generator/write.h"
#include "simulation/emitted/compiling.h"
#include "simulation/emitted/library_cache.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

constexpr int kNotStarted = 127;

/// Exit status of a program started in `folder`, its output where ours goes or, `quiet`, nowhere;
/// kNotStarted where it cannot be started.
int run(const std::vector<std::string>& command, const fs::path& folder, bool quiet = false) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    const int nowhere = quiet ? ::open("/dev/null", O_WRONLY) : -1;
    for (const int stream : {1, 2})
      if (nowhere >= 0) ::dup2(nowhere, stream);
    if (::chdir(folder.c_str()) == 0) ::execvp(words[0], words.data());
    ::_exit(kNotStarted);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return kNotStarted;
  return WEXITSTATUS(status);
}

bool has_ccache() {
  static const bool found = run({"sh", "-c", "command -v ccache"}, "/", true) == 0;
  return found;
}

std::string compiler() {
  const char* chosen = std::getenv("CC");
  return chosen && *chosen ? chosen : "cc";
}

void require(int status, const fs::path& folder) {
  if (status == kNotStarted)
    throw std::runtime_error("no C compiler: '" + compiler() +
                             "' cannot be started; install gcc or clang, or name yours in CC");
  if (status != 0) throw std::runtime_error(folder.string() + ": the emitted C does not compile");
}

/// One source of `folder`, by its name there alone: what is compiled is then the same wherever the
/// folder lies, and ccache, where it is installed, finds what was compiled before.
void compile(const fs::path& folder, const fs::path& runtime, const std::string& source,
             const fs::path& object, const std::vector<std::string>& optimisation) {
  // The rules of the package (runtime/CMakeLists.txt), so that the bits are those of the boards.
  std::vector<std::string> command{compiler(),
                                   "-std=c11",
                                   "-ffp-contract=off",
                                   "-fno-math-errno",
                                   "-fno-tree-slp-vectorize",
                                   "-fPIC",
                                   "-I" + fs::absolute(runtime).string(),
                                   "-c",
                                   source,
                                   "-o",
                                   object.string()};
  command.insert(command.end(), optimisation.begin(), optimisation.end());
  std::vector<std::string> cached{"env", "CCACHE_NOHASHDIR=1", "ccache"};
  cached.insert(cached.end(), command.begin(), command.end());
  // Where it fails, whatever the reason, the compiler itself says why.
  if (has_ccache() && run(cached, folder, true) == 0) return;
  require(run(command, folder), folder);
}

void link(const std::vector<fs::path>& objects, const fs::path& library) {
  std::vector<std::string> command{compiler(), "-shared", "-o", library.string()};
  for (const fs::path& object : objects) command.push_back(object.string());
  require(run(command, library.parent_path()), library.parent_path());
}

std::function<void(const std::string&)>& listener() {
  static std::function<void(const std::string&)> instance;
  return instance;
}

/// Tells what is being compiled, until its end.
class Told {
 public:
  explicit Told(const std::string& model) {
    if (listener()) listener()(model);
  }
  ~Told() {
    if (listener()) listener()("");
  }
};

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The sources and headers that a library is made from, and the runtime's headers.
std::vector<std::string> texts_of(const fs::path& folder, const fs::path& runtime,
                                  const std::string& name) {
  std::vector<fs::path> paths;
  for (const fs::path& place : {folder, folder / host_folder, runtime}) {
    if (place != runtime && !fs::exists(place)) continue;  // scalar C alone will do
    for (const fs::directory_entry& entry : fs::directory_iterator(place)) {
      const std::string file = entry.path().filename().string();
      const bool source = entry.path().extension() == ".h" || entry.path().extension() == ".c";
      if (source && (place == runtime || file.starts_with(name))) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const fs::path& path : paths) {
    texts.push_back(path.filename().string());
    texts.push_back(text_of(path));
  }
  return texts;
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
  const ScratchFolder scratch;
  fs::create_directory(scratch.path() / host_folder);
  for (const auto& [file, text] : emit_files(model)) {
    std::ofstream out(scratch.path() / file, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error((scratch.path() / file).string() + ": not written");
  }
  load(scratch.path(), runtime, {"-O3", "-march=native"}, with_batch);
}

void CompiledModel::load(const fs::path& folder, const fs::path& runtime,
                         const std::vector<std::string>& optimisation, bool with_batch) {
  const fs::path first = folder / (name_ + ".c");
  if (!fs::exists(first))
    throw std::runtime_error(first.string() + ": not found; expected the emitted C of a model");
  // Of neighbours in loops gcc fuses what this machine can fuse; batch forms have no neighbours.
  std::vector<std::string> apart = optimisation;
  apart.push_back("-fno-tree-vectorize");
  const std::vector<std::string> texts = texts_of(folder, runtime, name_);
  // The version stands for the options that every source is compiled with.
  std::vector<std::string> command{"1", compiler_identity(compiler()), name_};
  command.insert(command.end(), apart.begin(), apart.end());
  const LibraryCache one(texts, command);
  command.push_back("batch");
  const LibraryCache many(texts, command);
  const fs::path found = one.find(), found_batch = with_batch ? many.find() : fs::path();
  if (!found.empty()) library_ = open_library(found);
  if (!found_batch.empty()) batch_ = open_library(found_batch);
  if (!library_ || (with_batch && !batch_)) {
    const Told told(name_);
    const ScratchFolder scratch;
    const auto made = [&](const std::vector<std::string>& sources,
                          const std::vector<std::string>& options, const LibraryCache& cache) {
      std::vector<fs::path> objects;
      for (const std::string& source : sources) {
        objects.push_back(scratch.path() / (fs::path(source).stem().string() + ".o"));
        compile(folder, runtime, source, objects.back(), options);
      }
      const fs::path library = fs::path(objects.front()).replace_extension(".so");
      link(objects, library);
      cache.keep(library);
      return open_library(library);
    };
    const std::string batch = std::string(host_folder) + name_ + "_batch.c";
    if (!library_) library_ = made({name_ + ".c", name_ + "_catalogue.c"}, apart, one);
    if (with_batch && !batch_) batch_ = made({batch}, optimisation, many);
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

void on_compiling(std::function<void(const std::string& model)> told) {
  listener() = std::move(told);
}

}  // namespace sinew
