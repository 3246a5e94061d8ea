// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/wrapper_options.h"

#include "cli/runtime_folder.h"
#include "generator/outputs/unfinished_run.h"
#include "generator/unified_diff.h"
#include "generator/wrappers/wrapped_model.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

FileSet runtime_headers(const std::string& given) {
  FileSet headers;
  for (const fs::directory_entry& entry : fs::directory_iterator(runtime_folder(given))) {
    const std::string name = entry.path().filename().string();
    // Installed, the models' headers lie in the same folder.
    if (name.starts_with("sinew_") && name.ends_with(".h"))
      headers[name] = read_whole(entry.path());
  }
  return headers;
}

}  // namespace

bool WrapperOptions::any() const {
  for (const auto& [name, chosen] : wanted)
    if (chosen) return true;
  return false;
}

std::string WrapperOptions::written() const {
  std::string text;
  for (const auto& [name, chosen] : wanted)
    if (chosen) text += " --" + name;
  return text;
}

void add_wrapper_options(CLI::App& command, WrapperOptions& options) {
  for (const Wrapper& wrapper : wrappers())
    command.add_flag(std::string("--") + wrapper.name, options.wanted[wrapper.name],
                     std::string(wrapper.help) + ", as <wrappers>/<model>/" + wrapper.name);
  command.add_option("--wrappers", options.folder,
                     "Folder of what --python and the like write (default: wrappers)");
  command.add_option("--runtime", options.runtime, "Folder of the runtime's headers");
}

std::map<fs::path, FileSet> wrapped_files(const WrapperOptions& options, const std::string& model,
                                          const FileSet& emitted) {
  std::map<fs::path, FileSet> all;
  if (!options.any()) return all;
  const WrappedModel wrapped = wrapped_model(emitted, runtime_headers(options.runtime));
  for (const Wrapper& wrapper : wrappers())
    if (options.wanted.at(wrapper.name))
      all[fs::path(options.folder) / model / wrapper.name] = wrapper.files(wrapped);
  return all;
}

std::string wrapper_difference(const fs::path& folder, const FileSet& files) {
  std::string text;
  for (const auto& [name, now] : files) {
    const std::string label = (folder / name).string();
    const std::string before = entry_exists(folder / name) ? read_whole(folder / name) : "";
    text += unified_diff(before, now, "a/" + label, "b/" + label);
  }
  return text;
}

}  // namespace sinew
