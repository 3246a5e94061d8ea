// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/joint_states.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "symbolic/files/limits.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

/// Values in OMG's Common Data Representation: each stands at a multiple of its size, counted from
/// behind the four bytes that say the order of bytes.
class CdrReader {
 public:
  explicit CdrReader(std::string_view bytes) : bytes_(bytes) {
    if (bytes.size() < 4 || bytes[0] != 0 || (bytes[1] != 0 && bytes[1] != 1))
      throw std::runtime_error(
          "does not begin as CDR does; expected messages that are not compressed one by one");
    swapped_ = (bytes[1] == 1) != (std::endian::native == std::endian::little);
    bytes_.remove_prefix(4);
  }

  template <typename Number>
  Number number() {
    at_ += (sizeof(Number) - at_ % sizeof(Number)) % sizeof(Number);
    char raw[sizeof(Number)];
    std::memcpy(raw, taken(sizeof(Number)).data(), sizeof(Number));
    if (swapped_) std::reverse(raw, raw + sizeof(Number));
    Number value;
    std::memcpy(&value, raw, sizeof(Number));
    return value;
  }

  std::string text() {
    const std::string_view whole = taken(number<std::uint32_t>());
    return std::string(whole.substr(0, whole.find('\0')));
  }

  /// Elements of at least `size` bytes each, so that a wrong count takes no memory.
  std::size_t count(std::size_t size) {
    const std::size_t n = number<std::uint32_t>();
    if (n > (bytes_.size() - at_) / size) end_early();
    return n;
  }

  std::vector<double> numbers() {
    std::vector<double> values(count(sizeof(double)));
    for (double& value : values) value = number<double>();
    return values;
  }

 private:
  [[noreturn]] static void end_early() {
    throw std::runtime_error(
        fmt::format("ends before its last value; expected a whole {}", kJointStateType));
  }

  std::string_view taken(std::size_t size) {
    if (at_ > bytes_.size() || size > bytes_.size() - at_) end_early();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  bool swapped_ = false;
};

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The stamps that are told by most: of the headers, or of the recorder where one header has none.
template <typename Rows>
std::vector<double> seconds_of(const Rows& rows) {
  const bool headers =
      std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.stamp != 0; });
  std::vector<double> seconds;
  for (const auto& row : rows) {
    // Whole nanoseconds first: of a date in seconds a double keeps no more than 0.2 µs.
    const auto since = static_cast<double>(headers ? row.stamp - rows.front().stamp
                                                   : row.logged - rows.front().logged);
    seconds.push_back(since * 1e-9);
  }
  return seconds;
}

}  // namespace

JointState parse_joint_state(std::string_view bytes) {
  CdrReader cdr(bytes);
  JointState state;
  const auto seconds = cdr.number<std::int32_t>();
  const auto nanoseconds = cdr.number<std::uint32_t>();
  state.stamp = std::int64_t{seconds} * 1000000000 + nanoseconds;
  cdr.text();  // the frame
  state.names.resize(cdr.count(5));
  if (3 * state.names.size() >= limits::log_columns)
    throw std::runtime_error(
        fmt::format("names {} joints; expected as many as a robot has", state.names.size()));
  for (std::string& name : state.names) name = cdr.text();
  state.position = cdr.numbers();
  state.velocity = cdr.numbers();
  state.effort = cdr.numbers();
  for (const std::vector<double>* values : {&state.position, &state.velocity, &state.effort})
    if (!values->empty() && values->size() != state.names.size())
      throw std::runtime_error(fmt::format("has {} joints and {} values; expected one a joint",
                                           state.names.size(), values->size()));
  return state;
}

void JointStateLog::add(std::int64_t logged, JointState message) {
  const std::size_t joints = message.names.size();
  std::vector<std::size_t> order(joints);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return message.names[a] < message.names[b]; });
  Row row{logged, message.stamp, {}};
  for (const std::vector<double>* values : {&message.position, &message.velocity, &message.effort})
    for (const std::size_t i : order) row.values.push_back(values->empty() ? kNone : (*values)[i]);
  std::sort(message.names.begin(), message.names.end());
  groups_[std::move(message.names)].push_back(std::move(row));
}

std::vector<LogColumn> JointStateLog::columns() const {
  const auto most =
      std::max_element(groups_.begin(), groups_.end(), [](const auto& a, const auto& b) {
        return a.second.size() * a.first.size() < b.second.size() * b.first.size();
      });
  std::vector<LogColumn> columns;
  if (most == groups_.end()) return columns;
  const auto& [names, rows] = *most;
  columns.push_back({"time [s]", seconds_of(rows)});
  std::size_t at = 0;
  for (const char* prefix : {"q_", "qd_", "tau_"})
    for (const std::string& name : names) {
      LogColumn column{fmt::format("{}{} [SI]", prefix, name), {}};
      for (const Row& row : rows) column.values.push_back(row.values[at]);
      ++at;
      const auto& values = column.values;
      if (!std::all_of(values.begin(), values.end(), [](double v) { return v != v; }))
        columns.push_back(std::move(column));
    }
  return columns;
}

std::string joint_state_topic(const std::vector<std::string>& topics, const std::string& path) {
  if (topics.empty())
    throw std::runtime_error(
        fmt::format("{}:0:0: has no topic of the type {}; record /joint_states",
                    readable_line(path), kJointStateType));
  std::vector<std::string> named;
  for (const std::string& topic : topics)
    if (topic == "joint_states" || topic.ends_with("/joint_states")) named.push_back(topic);
  const std::vector<std::string>& candidates = named.empty() ? topics : named;
  if (candidates.size() == 1) return candidates.front();
  throw std::runtime_error(fmt::format(
      "{}:0:0: has several topics of the type {} ({}); write the one that is meant to a "
      "recording of its own, with ros2 bag convert",
      readable_line(path), kJointStateType,
      readable_line(fmt::format("{}", fmt::join(candidates, ", ")))));
}

std::vector<LogColumn> joint_state_columns(const JointStateTopics& topics,
                                           const std::string& path) {
  std::vector<std::string> names;
  for (const auto& [name, log] : topics) names.push_back(name);
  return topics.at(joint_state_topic(names, path)).columns();
}

}  // namespace sinew
