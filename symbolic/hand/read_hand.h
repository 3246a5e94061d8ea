// SPDX-License-Identifier: GPL-3.0-or-later
// hand.toml: which models make a hand, where they sit in the palm, which channel each tendon takes.
#pragma once

#include <filesystem>
#include <vector>

#include "symbolic/hand/hand.h"

namespace sinew {

/// Whether a model folder describes a hand (hand.toml).
bool is_hand_folder(const std::filesystem::path& folder);

/// A hand and the folders of the models it is made of.
struct HandDescription {
  Hand hand;
  std::vector<std::filesystem::path> models;
};

/// Reads hand.toml and every model it names, by their path from the folder. Throws DescriptionError
/// with all mistakes found; those in a model it names are reported where they stand.
HandDescription read_hand(const std::filesystem::path& folder);

}  // namespace sinew
