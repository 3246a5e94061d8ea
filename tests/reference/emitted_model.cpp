// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/emitted_model.h"

#include <dlfcn.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace sinew::reference {
namespace {

constexpr const char* kCatalogueEnding = "_catalogue.c";

std::vector<std::string> c_files(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".c") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

std::string model_in(const std::filesystem::path& folder) {
  std::string model;
  for (const std::string& file : c_files(folder)) {
    const std::string name = std::filesystem::path(file).filename().string();
    if (!name.ends_with(kCatalogueEnding)) continue;
    if (!model.empty()) throw std::runtime_error(folder.string() + ": holds two catalogues");
    model = name.substr(0, name.size() - std::string(kCatalogueEnding).size());
  }
  if (model.empty()) throw std::runtime_error(folder.string() + ": holds no *_catalogue.c");
  return model;
}

void compile(const std::filesystem::path& folder, const std::filesystem::path& library,
             const CompileOptions& options) {
  std::vector<std::string> command = {options.compiler};
  command.insert(command.end(), options.flags.begin(), options.flags.end());
  for (const char* argument : {"-shared", "-fPIC", "-fvisibility=default"})
    command.emplace_back(argument);
  command.emplace_back("-I" SINEW_RUNTIME_DIR);
  command.push_back("-I" + folder.string());
  command.insert(command.end(), {"-o", library.string()});
  for (const std::string& file : c_files(folder)) command.push_back(file);
  std::string output;
  if (run_program(command, output) != 0)
    throw std::runtime_error(folder.string() + ": does not compile\n" + output);
}

std::shared_ptr<void> load(const std::filesystem::path& library) {
  void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw std::runtime_error(::dlerror());
  return {handle, [](void* opened) { ::dlclose(opened); }};
}

template <class Real>
std::vector<double> call_as(const sinew_function& function, const std::vector<double>& inputs) {
  std::vector<Real> in;
  for (double value : inputs) in.push_back(static_cast<Real>(value));
  std::vector<Real> out(static_cast<std::size_t>(function.output_size),
                        std::numeric_limits<Real>::quiet_NaN());
  function.call(in.data(), out.data());
  std::vector<double> results;
  for (Real value : out) results.push_back(static_cast<double>(value));
  return results;
}

}  // namespace

EmittedModel::EmittedModel(const std::filesystem::path& folder, const CompileOptions& options)
    : model_(model_in(folder)) {
  const std::filesystem::path library = folder_.path() / "model.so";
  compile(folder, library, options);
  library_ = load(library);
  const std::string symbol = model_ + "_catalogue";
  catalogue_ = static_cast<const sinew_catalogue*>(::dlsym(library_.get(), symbol.c_str()));
  if (catalogue_ == nullptr) throw std::runtime_error(folder.string() + ": defines no " + symbol);
}

const sinew_function* EmittedModel::find(const std::string& name) const {
  const std::string full = model_ + "_" + name;
  const sinew_function* end = catalogue_->functions + catalogue_->function_count;
  const sinew_function* found = std::find_if(
      catalogue_->functions, end, [&](const sinew_function& each) { return full == each.name; });
  return found == end ? nullptr : found;
}

const sinew_function& EmittedModel::function(const std::string& name) const {
  const sinew_function* found = find(name);
  if (found == nullptr) throw std::out_of_range(model_ + "_" + name + " is not in the catalogue");
  return *found;
}

std::vector<double> EmittedModel::call(const std::string& name,
                                       const std::vector<double>& inputs) const {
  return call(function(name), inputs);
}

std::vector<double> EmittedModel::call(const sinew_function& function,
                                       const std::vector<double>& inputs) const {
  if (inputs.size() != static_cast<std::size_t>(function.input_size))
    throw std::invalid_argument(std::string(function.name) + ": takes " +
                                std::to_string(function.input_size) + " numbers, not " +
                                std::to_string(inputs.size()));
  return catalogue_->scalar_bytes == 4 ? call_as<float>(function, inputs)
                                       : call_as<double>(function, inputs);
}

}  // namespace sinew::reference
