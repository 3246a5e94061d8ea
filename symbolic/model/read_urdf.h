// SPDX-License-Identifier: GPL-3.0-or-later
// A robot described in URDF as a Mechanism.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/files/description_error.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// Reads a URDF file: serial chains and branched trees of revolute, continuous, prismatic and fixed
/// joints. The root link is the base; `gravity` [m/s^2] is in its frame. Joints are ordered
/// depth-first from the root, siblings in file order. Inertias are turned into link axes. Links
/// without inertial are massless. Names become C identifiers. Each leaf link gets a frame. Mimic
/// joints become couplings. Throws DescriptionError; `notes` tells what was assumed, renamed or
/// ignored.
Mechanism read_urdf(const std::filesystem::path& file, const Eigen::Vector3d& gravity,
                    std::vector<std::string>* notes = nullptr);

/// The same from text; `name` is what messages call the file.
Mechanism parse_urdf(std::string_view text, const std::string& name, const Eigen::Vector3d& gravity,
                     std::vector<std::string>* notes = nullptr);

}  // namespace sinew
