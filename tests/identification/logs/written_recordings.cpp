// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/logs/written_recordings.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "tests/identification/logs/planted_log.h"

#if __has_include(<sqlite3.h>)
#include <sqlite3.h>
#endif

namespace sinew::test {
namespace {

constexpr const char* kType = "sensor_msgs/msg/JointState";

std::string sized(const std::string& text) {
  return raw(static_cast<std::uint32_t>(text.size())) + text;
}
std::string record(char kind, const std::string& content) {
  return kind + raw(static_cast<std::uint64_t>(content.size())) + content;
}

}  // namespace

double theta_at(int k) {
  return 0.5 * std::sin(0.02 * k) + 0.2 * std::sin(0.0311 * k);
}
double tau_at(int k) {
  return 0.3 * std::tanh(40.0 * std::cos(0.02 * k)) + 0.1 * std::sin(0.7 * k);
}

std::string message_at(int k, const Style& style) {
  const std::int64_t at = style.stamped ? kStart + 2000000LL * k : 0;
  Cdr cdr(style.big);
  cdr.put(static_cast<std::int32_t>(at / 1000000000));
  cdr.put(static_cast<std::uint32_t>(at % 1000000000)).put(std::string("base"));
  const bool turned = style.names_first != 0 && k % style.names_first == 0;
  const std::vector<std::string> names = turned ? std::vector<std::string>{"other", "drive"}
                                                : std::vector<std::string>{"drive", "other"};
  cdr.put(std::uint32_t{2}).put(names[0]).put(names[1]);
  cdr.put(turned ? std::vector{7.0, theta_at(k)} : std::vector{theta_at(k), 7.0});
  cdr.put(std::vector<double>{});
  cdr.put(turned ? std::vector{9.0, tau_at(k)} : std::vector{tau_at(k), 9.0});
  return cdr.bytes();
}

std::vector<Recorded> drive_messages(const Style& style) {
  std::vector<Recorded> all;
  for (int k = 0; k < kRows; ++k)  // the recorder is late, now more and now less
    all.push_back({"/joint_states", message_at(k, style),
                   kStart + 2000000LL * k + 3000000 + (style.stamped ? 400000 * (k % 3) : 0)});
  return all;
}

std::string write_mcap(const std::vector<Recorded>& messages, bool chunks,
                       const std::string& packing, bool whole, const std::string& name) {
  std::map<std::string, std::uint16_t> topics;
  std::string file = std::string("\x89MCAP0\r\n", 8) + record(1, sized("ros2") + sized("test"));
  file += record(3, raw(std::uint16_t{7}) + sized(kType) + sized("ros2msg") + sized("text"));
  std::string part;
  for (std::size_t k = 0; k < messages.size(); ++k) {
    const Recorded& m = messages[k];
    if (const auto [at, fresh] = topics.try_emplace(m.topic, topics.size() + 1); fresh)
      part += record(4, raw(at->second) + raw(std::uint16_t{7}) + sized(m.topic) + sized("cdr") +
                            raw(std::uint32_t{0}));
    part += record(5, raw(topics[m.topic]) + raw(static_cast<std::uint32_t>(k)) + raw(m.logged) +
                          raw(m.logged) + m.bytes);
    if (k % 100 != 99 && k + 1 != messages.size()) continue;
    const auto size = static_cast<std::uint64_t>(part.size());
    file += !chunks ? part
                    : record(6, raw(m.logged) + raw(m.logged) + raw(size) + raw(std::uint32_t{0}) +
                                    sized(packing) + raw(size) + part);
    part.clear();
  }
  if (whole) file += record(15, raw(std::uint32_t{0})) + record(2, std::string(20, '\0'));
  return write_file(name, file + (whole ? std::string("\x89MCAP0\r\n", 8) : ""));
}

#if __has_include(<sqlite3.h>)
/// The tables of rosbag2's storage plugin, with the columns of Humble.
std::string write_db3(const std::vector<Recorded>& messages, const std::string& name) {
  const std::string path = write_file(name, "");
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open(path.c_str(), &database) == SQLITE_OK);
  const char* tables =
      "BEGIN; CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
      "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER "
      "NOT NULL, data BLOB NOT NULL); CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
      "INSERT INTO topics VALUES(1, '/rosout', 'rcl_interfaces/msg/Log', 'cdr', '');"
      "INSERT INTO messages VALUES(NULL, 1, 5, x'00010000');";
  REQUIRE(sqlite3_exec(database, tables, nullptr, nullptr, nullptr) == SQLITE_OK);
  std::map<std::string, int> topics;
  for (const Recorded& m : messages) {
    const auto [at, fresh] = topics.try_emplace(m.topic, static_cast<int>(topics.size()) + 2);
    const std::string add = fmt::format("INSERT INTO topics VALUES({}, '{}', '{}', 'cdr', '')",
                                        at->second, m.topic, kType);
    if (fresh) REQUIRE(sqlite3_exec(database, add.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
    sqlite3_stmt* insert = nullptr;
    sqlite3_prepare_v2(database, "INSERT INTO messages VALUES(NULL, ?, ?, ?)", -1, &insert,
                       nullptr);
    sqlite3_bind_int(insert, 1, at->second);
    sqlite3_bind_int64(insert, 2, m.logged);
    sqlite3_bind_blob(insert, 3, m.bytes.data(), static_cast<int>(m.bytes.size()), SQLITE_STATIC);
    REQUIRE(sqlite3_step(insert) == SQLITE_DONE);
    sqlite3_finalize(insert);
  }
  REQUIRE(sqlite3_exec(database, "COMMIT", nullptr, nullptr, nullptr) == SQLITE_OK);
  sqlite3_close(database);
  return path;
}
#else
std::string write_db3(const std::vector<Recorded>&, const std::string&) {
  return "";
}
#endif

}  // namespace sinew::test
