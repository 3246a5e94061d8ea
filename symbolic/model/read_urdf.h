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
/// without inertial are massless. Names become C identifiers; `source_name` keeps the others. Each
/// leaf link gets a frame. Mimic joints become couplings; joints that cannot move (floating,
/// planar, a range of one value) are fixed where they stand. Throws DescriptionError; `notes` tells
/// what was assumed, renamed or ignored, `warnings` (`notes` where there is none) what of the file
/// the mechanism does not have.
Mechanism read_urdf(const std::filesystem::path& file, const Eigen::Vector3d& gravity,
                    std::vector<std::string>* notes = nullptr,
                    std::vector<std::string>* warnings = nullptr);

/// The same from text; `name` is what messages call the file.
Mechanism parse_urdf(std::string_view text, const std::string& name, const Eigen::Vector3d& gravity,
                     std::vector<std::string>* notes = nullptr,
                     std::vector<std::string>* warnings = nullptr);

}  // namespace sinew
