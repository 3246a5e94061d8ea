// SPDX-License-Identifier: GPL-3.0-or-later
// The declarations of rclcpp that the node's skeleton uses, to compile it where there is no ROS.
#pragma once

#include <functional>
#include <memory>
#include <string>

#define RCLCPP_WARN_THROTTLE(logger, clock, duration, text) \
  (void)(logger), (void)(clock), (void)(duration), (void)(text)

namespace rclcpp {
struct Logger {};
struct Clock {};
struct Time {};
template <typename Message>
struct Publisher {
  using SharedPtr = std::shared_ptr<Publisher>;
  void publish(const Message&);
};
template <typename Message>
struct Subscription {
  using SharedPtr = std::shared_ptr<Subscription>;
};
class Node {
 public:
  explicit Node(const std::string& name);
  template <typename Message>
  std::shared_ptr<Publisher<Message>> create_publisher(const std::string& topic, int depth);
  template <typename Message>
  std::shared_ptr<Subscription<Message>> create_subscription(
      const std::string& topic, int depth, std::function<void(const Message&)> callback);
  Logger get_logger();
  std::shared_ptr<Clock> get_clock();
  Time now();
};
void init(int argc, char** argv);
void spin(std::shared_ptr<Node> node);
void shutdown();
}  // namespace rclcpp
