// SPDX-License-Identifier: GPL-3.0-or-later
// A ROS 2 package in plain CMake: the model as a library, what a node calculates as a header
// without ROS, and the node itself, which is built where rclcpp is found.
#include <fmt/format.h>

#include "generator/wrappers/moving_model.h"
#include "generator/wrappers/template_text.h"

namespace sinew {
namespace {

const char* const ros_package = R"(<?xml version="1.0"?>
<!-- SPDX-License-Identifier: BSD-2-Clause -->
<package format="3">
  <name>sinew_@MODEL@</name>
  <version>0.1.0</version>
  <description>@TITLE@</description>
  <maintainer email="you@example.org">you</maintainer>
  <license>BSD-2-Clause</license>
  <buildtool_depend>cmake</buildtool_depend>
  <depend>rclcpp</depend>
  <depend>sensor_msgs</depend>
  <export><build_type>cmake</build_type></export>
</package>
)";

const char* const ros_cmake = R"(# SPDX-License-Identifier: BSD-2-Clause
# Made by: sinew generate (--ros2). The library and its check are built anywhere; the node where ROS 2 is.
cmake_minimum_required(VERSION 3.16)
project(sinew_@MODEL@ LANGUAGES C CXX)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
include(GNUInstallDirs)

add_library(@MODEL@_model STATIC source/@MODEL@.c)
set_target_properties(@MODEL@_model PROPERTIES C_STANDARD 11 POSITION_INDEPENDENT_CODE ON)
target_include_directories(@MODEL@_model PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/source
                                                ${CMAKE_CURRENT_SOURCE_DIR}/include)
# Under these the emitted C gives the same bits on every machine.
target_compile_options(@MODEL@_model PRIVATE -ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize)

add_executable(@MODEL@_check test/check.cpp)
target_compile_features(@MODEL@_check PRIVATE cxx_std_17)
target_link_libraries(@MODEL@_check PRIVATE @MODEL@_model)
enable_testing()
add_test(NAME @MODEL@_check COMMAND @MODEL@_check)

find_package(rclcpp QUIET)
find_package(sensor_msgs QUIET)
if(rclcpp_FOUND AND sensor_msgs_FOUND)
  add_executable(@MODEL@_node src/@MODEL@_node.cpp)
  target_compile_features(@MODEL@_node PRIVATE cxx_std_17)
  target_link_libraries(@MODEL@_node PRIVATE @MODEL@_model rclcpp::rclcpp
                                             ${sensor_msgs_TARGETS})
  install(TARGETS @MODEL@_node DESTINATION lib/${PROJECT_NAME})
else()
  message(STATUS "rclcpp and sensor_msgs are not found: the node is left out")
endif()
install(TARGETS @MODEL@_model ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES package.xml DESTINATION share/${PROJECT_NAME})
)";

const char* const ros_step = R"(// SPDX-License-Identifier: BSD-2-Clause
// What the node calculates at each message, without ROS. Extend it here: it can be tested anywhere.
//
// Made by: sinew generate (--ros2). Copy the package before you change it: generating writes it anew.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "@MODEL@.h"

namespace sinew_@MODEL@ {

inline const std::array<const char*, @JOINTS@> joints{{@JOINT_NAMES@}};

using Joints = std::array<double, @JOINTS@>;  // rad, or m where a joint slides

/// Torque that holds the mechanism still, in the order of `joints` [N m, or N].
inline Joints holding_torque(const Joints& q) {
  Joints torque;
  ::@MODEL@_gravity(q.data(), torque.data());
  return torque;
}

/// Positions of a message, whatever its order, in the model's. False where a joint is missing.
inline bool positions_of(const std::vector<std::string>& names, const std::vector<double>& values,
                         Joints& q) {
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    std::size_t at = 0;
    while (at < names.size() && names[at] != joints[joint]) ++at;
    if (at >= names.size() || at >= values.size()) return false;
    q[joint] = values[at];
  }
  return true;
}

}  // namespace sinew_@MODEL@
)";

const char* const ros_check = R"(// SPDX-License-Identifier: BSD-2-Clause
// The node's calculation without ROS: holding torques make the mechanism stay where it is.
#include <cmath>

#include "@MODEL@_step.hpp"

int main() {
  using namespace sinew_@MODEL@;
  const std::vector<std::string> names(joints.rbegin(), joints.rend());
  std::vector<double> values;
  for (std::size_t i = 0; i < names.size(); ++i) values.push_back(0.1 * (i + 1.0));
  Joints q;
  if (!positions_of(names, values, q) || q[0] != values.back()) return 1;
  if (positions_of({}, {}, q)) return 2;
  const Joints torque = holding_torque(q);
  const Joints still{};
  Joints acceleration;
  ::@MODEL@_forward_dynamics(q.data(), still.data(), torque.data(), acceleration.data());
  for (const double a : acceleration)
    if (!(std::abs(a) < 1e-6)) return 3;
  return 0;
}
)";

const char* const ros_node = R"(// SPDX-License-Identifier: BSD-2-Clause
// The skeleton of a node: joint states come in, efforts that hold the mechanism go out.
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/joint_state.hpp>

#include "@MODEL@_step.hpp"

class ModelNode : public rclcpp::Node {
 public:
  ModelNode() : Node("sinew_@MODEL@") {
    command_ = create_publisher<sensor_msgs::msg::JointState>("joint_command", 10);
    state_ = create_subscription<sensor_msgs::msg::JointState>(
        "joint_states", 10, [this](const sensor_msgs::msg::JointState& state) { react(state); });
  }

 private:
  void react(const sensor_msgs::msg::JointState& state) {
    sinew_@MODEL@::Joints q;
    if (!sinew_@MODEL@::positions_of(state.name, state.position, q)) {
      RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 1000, "joint_states lacks a joint");
      return;
    }
    const sinew_@MODEL@::Joints torque = sinew_@MODEL@::holding_torque(q);
    sensor_msgs::msg::JointState command;
    command.header.stamp = now();
    command.name.assign(sinew_@MODEL@::joints.begin(), sinew_@MODEL@::joints.end());
    command.effort.assign(torque.begin(), torque.end());
    command_->publish(command);
  }

  rclcpp::Publisher<sensor_msgs::msg::JointState>::SharedPtr command_;
  rclcpp::Subscription<sensor_msgs::msg::JointState>::SharedPtr state_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<ModelNode>());
  rclcpp::shutdown();
  return 0;
}
)";

std::string ros_title(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return escaped;
}

}  // namespace

FileSet ros2_files(const WrappedModel& model) {
  require_moving(model, "ros2");
  std::string names;
  for (const WrappedJoint& joint : model.joints)
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", joint.source_name);
  const std::map<std::string, std::string> values{
      {"JOINTS", fmt::format("{}", model.joints.size())},
      {"JOINT_NAMES", names},
      {"TITLE", ros_title(model.description)}};
  FileSet files{{"package.xml", filled(ros_package, model, values)},
                {"CMakeLists.txt", filled(ros_cmake, model)},
                {"include/" + model.name + "_step.hpp", filled(ros_step, model, values)},
                {"src/" + model.name + "_node.cpp", filled(ros_node, model)},
                {"test/check.cpp", filled(ros_check, model)}};
  add_sources(files, model, "source/", false);
  return files;
}

}  // namespace sinew
