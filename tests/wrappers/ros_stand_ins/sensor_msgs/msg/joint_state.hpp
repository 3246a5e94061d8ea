// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rclcpp/rclcpp.hpp>
#include <string>
#include <vector>

namespace sensor_msgs::msg {
struct Header {
  rclcpp::Time stamp;
};
struct JointState {
  Header header;
  std::vector<std::string> name;
  std::vector<double> position, velocity, effort;
};
}  // namespace sensor_msgs::msg
