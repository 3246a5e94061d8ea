// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/write.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "generator/emit_batch.h"
#include "generator/emit_c.h"
#include "generator/emit_catalogue.h"
#include "generator/emit_header.h"
#include "generator/manifest.h"
#include "generator/outputs/unfinished_run.h"
#include "generator/reference.h"
#include "generator/unified_diff.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

/// Nothing where there is no manifest, or none that can be understood.
nlohmann::json manifest_of(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  if (!entry_exists(file)) return {};
  return nlohmann::json::parse(read_whole(file), nullptr, false);
}

std::set<std::string> listed_files(const fs::path& folder) {
  const nlohmann::json manifest = manifest_of(folder);
  std::set<std::string> names;
  if (manifest.is_object() && manifest.contains("files") && manifest["files"].is_array())
    for (const auto& name : manifest["files"])
      if (name.is_string()) names.insert(name.get<std::string>());
  return names;
}

/// Whether one of `ours` lies in `folder`; both are relative to the same folder.
bool holds_ours(const std::set<std::string>& ours, const fs::path& folder) {
  const auto first = ours.lower_bound((folder / "").string());
  return first != ours.end() && first->starts_with((folder / "").string());
}

void refuse_foreign_files(const fs::path& folder) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder))
    throw std::runtime_error(
        fmt::format("{}: is not a folder; give a folder to write into", folder.string()));
  const std::set<std::string> ours = listed_files(folder);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path name = entry.path().lexically_relative(folder);
    const bool is_folder = fs::is_directory(entry.symlink_status());
    if (is_folder ? !holds_ours(ours, name) : !ours.count(name.string()))
      throw std::runtime_error(
          fmt::format("{}: not a file that sinew wrote; generating would remove it. Move it away "
                      "or choose another folder",
                      entry.path().string()));
  }
}

std::string batch_file(const EmittedModel& model, const char* ending) {
  return fmt::format("{}{}_batch{}", host_folder, model.name, ending);
}

}  // namespace

std::vector<std::string> emitted_file_names(const EmittedModel& model) {
  std::set<std::string> names{"manifest.json", "reference.csv", batch_file(model, ".h"),
                              batch_file(model, ".c")};
  for (const char* ending : {".h", ".c", "_catalogue.h", "_catalogue.c"})
    names.insert(model.name + ending);
  return {names.begin(), names.end()};
}

FileSet emit_files(const EmittedModel& model) {
  return {{model.name + ".h", emit_header(model)},
          {model.name + ".c", emit_c(model)},
          {batch_file(model, ".h"), emit_batch_header(model)},
          {batch_file(model, ".c"), emit_batch(model)},
          {model.name + "_catalogue.h", emit_catalogue_header(model)},
          {model.name + "_catalogue.c", emit_catalogue(model)},
          {"manifest.json", emit_manifest(model)},
          {"reference.csv", emit_reference(model)}};
}

void add_emitted(Outputs& outputs, const fs::path& given, const FileSet& files) {
  const fs::path folder = output_folder(given);
  recover_interrupted(folder.parent_path());
  refuse_foreign_files(folder);
  outputs.folder(folder, files);
}

void replace_folder(const fs::path& folder, const FileSet& files) {
  Outputs outputs;
  add_emitted(outputs, folder, files);
  outputs.commit();
}

std::string difference(const fs::path& folder, const FileSet& files) {
  std::string text;
  std::set<std::string> names;
  if (fs::is_directory(folder))
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (!entry.is_directory()) names.insert(entry.path().lexically_relative(folder).string());
  for (const auto& [name, content] : files) names.insert(name);
  for (const std::string& name : names) {
    const auto now = files.find(name);
    const std::string label = (folder.filename() / name).string();
    const std::string before = entry_exists(folder / name) ? read_whole(folder / name) : "";
    text += unified_diff(before, now == files.end() ? "" : now->second, "a/" + label, "b/" + label);
  }
  return text;
}

}  // namespace sinew
