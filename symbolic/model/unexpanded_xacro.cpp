// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/unexpanded_xacro.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace sinew {
namespace {

bool is_ignored_element(const std::string& name) {
  static constexpr std::array<std::string_view, 6> ignored{"visual",       "collision", "material",
                                                           "transmission", "gazebo",    "sensor"};
  return std::find(ignored.begin(), ignored.end(), name) != ignored.end();
}

const TiXmlAttribute* substituted(const TiXmlElement& element) {
  for (const TiXmlAttribute* each = element.FirstAttribute(); each != nullptr; each = each->Next())
    if (each->ValueStr().find("${") != std::string::npos ||
        each->ValueStr().find("$(") != std::string::npos)
      return each;
  return nullptr;
}

const TiXmlBase* first_macro(const TiXmlElement& element, bool ignored) {
  if (element.ValueStr().starts_with("xacro:")) return &element;
  const bool unused = ignored || is_ignored_element(element.ValueStr());
  if (!unused)
    if (const TiXmlAttribute* attribute = substituted(element)) return attribute;
  for (const TiXmlElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement())
    if (const TiXmlBase* found = first_macro(*child, unused)) return found;
  return nullptr;
}

}  // namespace

const TiXmlBase* unexpanded_xacro(const TiXmlElement& robot) {
  return first_macro(robot, false);
}

std::string how_to_expand(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  const bool is_called_so = name.ends_with(".xacro");
  return fmt::format(
      "expected a URDF file: run xacro first ('xacro {} > robot.urdf', from ROS, or 'pip install "
      "xacro') and import robot.urdf",
      is_called_so ? name : "robot.urdf.xacro");
}

}  // namespace sinew
