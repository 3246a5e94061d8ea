// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/checked_extension.h"

#include <fmt/format.h>

#include "simulation/plant/learnt_model.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/extension/learnt_mass_matrix.h"
#include "symbolic/files/description_error.h"
#include "symbolic/hand/hand_mechanism.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

void refuse_indefinite(const std::optional<std::string>& why, const fs::path& folder) {
  if (why)
    throw DescriptionError(
        {fmt::format("{}: {}; expected an extension that leaves every joint its inertia",
                     (folder / "identified.toml").string(), *why)});
}

Identified extension_of(const fs::path& folder, const Mechanism& described, bool motors) {
  Identified identified = read_identified(folder, learnt_places(described, motors));
  if (identified.empty()) return identified;
  const auto motor = speaks_of_motors(identified) ? motor_beside(folder) : std::nullopt;
  refuse_indefinite(why_not_definite(with_identified(described, identified), motor, identified),
                    folder);
  return identified;
}

}  // namespace

Identified checked_extension(const fs::path& folder, const Mechanism& described) {
  return extension_of(folder, described, is_part_folder(folder_of_motor(folder)));
}

Identified checked_extension(const fs::path& folder, const Hand& hand) {
  // The held hand is taken exactly, which takes a while.
  if (!fs::exists(folder / "identified.toml")) return {};
  return extension_of(folder, held_hand(hand).mechanism, false);
}

Identified checked_extension(const fs::path& folder, const MotorParameters& motor) {
  Identified identified = read_identified(folder, learnt_places_of_motor());
  if (!identified.empty())
    refuse_indefinite(why_not_definite(driven_model(motor, "motor"), identified), folder);
  return identified;
}

}  // namespace sinew
