// SPDX-License-Identifier: GPL-3.0-or-later
// Robots written with the macros of xacro, which another program turns into URDF.
#pragma once

#include <tinyxml.h>

#include <string>

namespace sinew {

/// The first macro, "${...}" or "$(...)" of a document, or null. An expanded file may still declare
/// xacro's namespace, and what is ignored (meshes, plugins) may hold anything but macros.
const TiXmlBase* unexpanded_xacro(const TiXmlElement& robot);

/// What a user has to do with such a file, in a line.
std::string how_to_expand(const std::string& file);

}  // namespace sinew
