// SPDX-License-Identifier: GPL-3.0-or-later
// Several outputs in one step, as `sinew diagnose` has them: a file of the model's folder, files of
// the report's folder and a folder of C in it.
#pragma once

#include "tests/generator/lettered_files.h"

namespace sinew {

inline void put_outputs(const std::filesystem::path& place, char letter) {
  const std::string text(5000, letter);
  Outputs outputs;
  outputs.into_folder(place / "model", {{"identified.toml", text}});
  outputs.into_folder(place / "found", {{"findings.json", text}, {"report.html", text}});
  outputs.folder(place / "found" / "generated" / "model", lettered_files(letter, 6000));
  outputs.commit();
}

}  // namespace sinew
