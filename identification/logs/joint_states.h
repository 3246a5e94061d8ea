// SPDX-License-Identifier: GPL-3.0-or-later
// Messages sensor_msgs/msg/JointState of a ROS 2 recording, and the columns of a log made of them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "identification/logs/converted_log.h"

namespace sinew {

/// One message. Positions in rad or m, velocities in rad/s or m/s, efforts in N·m or N, each empty
/// or one value a joint.
struct JointState {
  std::int64_t stamp = 0;  ///< ns, of the header; 0 where nobody set it
  std::vector<std::string> names;
  std::vector<double> position, velocity, effort;
};

/// Reads a message as ROS 2 serialises it (CDR, either order of bytes). Throws std::runtime_error
/// with what is wrong and what was expected, without the file.
JointState parse_joint_state(std::string_view bytes);

/// Takes the messages of one topic in the order they were recorded in.
class JointStateLog {
 public:
  /// `logged` [ns]: when the recorder received the message.
  void add(std::int64_t logged, JointState message);
  bool empty() const { return groups_.empty(); }
  /// time [s] from the first message on, and q_<joint>, qd_<joint>, tau_<joint>, in the SI unit of
  /// whatever they are (unit "SI"); those that no message has are left out, and NaN is what one of
  /// them lacks. Where messages name different joints, those of the names that occur most often.
  std::vector<LogColumn> columns() const;

 private:
  struct Row {
    std::int64_t logged = 0, stamp = 0;
    std::vector<double> values;  ///< positions, velocities, efforts, each in the order of the names
  };
  std::map<std::vector<std::string>, std::vector<Row>> groups_;  ///< by sorted names
};

/// All topics of the type that a recording has, also those without a message.
using JointStateTopics = std::map<std::string, JointStateLog>;

/// Adds the joint states of a file of a recording, behind those of the files before it. Throw
/// std::runtime_error "file:0:0: ..." where the file cannot be understood, or its format needs a
/// library that this program was built without.
void add_sqlite_states(const std::string& path, JointStateTopics& topics);
void add_mcap_states(const std::string& path, JointStateTopics& topics);

/// The log of the topic that is read. `path`: the recording, for errors; throws as above.
std::vector<LogColumn> joint_state_columns(const JointStateTopics& topics, const std::string& path);

/// The topic that is read: the only one, or the one called joint_states. Throws
/// std::runtime_error "file:0:0: ..." where there is none, or which one is meant is open.
std::string joint_state_topic(const std::vector<std::string>& topics, const std::string& path);

/// "sensor_msgs/msg/JointState", as recordings name the type.
inline constexpr std::string_view kJointStateType = "sensor_msgs/msg/JointState";

}  // namespace sinew
