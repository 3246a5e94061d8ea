// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/models/model_set.h"

#include <algorithm>

#include "symbolic/hand/read_hand.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

bool describes_model(const fs::path& folder) {
  for (const char* name : {"mechanism.toml", "part.toml", "hand.toml"})
    if (fs::exists(folder / name)) return true;
  return false;
}

bool same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

fs::path without_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

std::vector<fs::path> models_in(const fs::path& folder) {
  std::vector<fs::path> models;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.is_directory() && describes_model(entry.path())) models.push_back(entry.path());
  std::sort(models.begin(), models.end());
  return models;
}

}  // namespace

std::vector<fs::path> model_folders(const fs::path& given) {
  if (describes_model(given)) return {given};
  std::vector<fs::path> models = models_in(given);
  if (models.empty()) return {given};
  std::stable_partition(models.begin(), models.end(),
                        [](const fs::path& folder) { return !is_hand_folder(folder); });
  return models;
}

std::vector<fs::path> hands_made_of(const fs::path& folder) {
  const fs::path real = without_slash(fs::weakly_canonical(fs::absolute(folder)));
  const fs::path given = without_slash(folder);
  const bool named = given.has_parent_path() && given.filename() == real.filename();
  std::vector<fs::path> hands;
  for (const fs::path& beside : models_in(real.parent_path())) {
    const std::vector<fs::path> parts = parts_of(beside);
    if (std::any_of(parts.begin(), parts.end(), [&](const fs::path& p) { return same(p, folder); }))
      hands.push_back(named ? given.parent_path() / beside.filename() : beside);
  }
  return hands;
}

std::vector<fs::path> parts_of(const fs::path& folder) {
  if (!is_hand_folder(folder)) return {};
  try {
    return read_hand(folder).models;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace sinew
