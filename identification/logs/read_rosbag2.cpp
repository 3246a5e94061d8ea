// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of ROS 2 in SQLite (rosbag2's .db3), by SQLite's own library.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "identification/logs/converted_log.h"
#include "identification/logs/joint_states.h"
#include "symbolic/files/readable.h"

#if __has_include(<sqlite3.h>)
#include <sqlite3.h>
#endif

namespace sinew {

#if __has_include(<sqlite3.h>)
namespace {

class Database {
 public:
  explicit Database(const std::string& path) : path_(path) {
    sqlite3* opened = nullptr;
    const int status = sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
    database_.reset(opened);
    if (status != SQLITE_OK) fail();
    // The file may be anybody's: nothing in it is run, and no page of it is believed unseen.
    sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_exec(opened, "PRAGMA cell_size_check = ON", nullptr, nullptr, nullptr);
  }

  /// Calls `row` with each row of the answer.
  template <typename Row>
  void ask(const char* question, const std::string& value, const Row& row) {
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v2(database_.get(), question, -1, &prepared, nullptr) != SQLITE_OK) fail();
    const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement(prepared,
                                                                          &sqlite3_finalize);
    sqlite3_bind_text(prepared, 1, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT);
    int status = SQLITE_ROW;
    while ((status = sqlite3_step(prepared)) == SQLITE_ROW) row(prepared);
    if (status != SQLITE_DONE) fail();
  }

 private:
  [[noreturn]] void fail() {
    throw std::runtime_error(fmt::format(
        "{}:0:0: cannot be read as a recording of ROS 2 ({}); expected rosbag2's tables topics and "
        "messages",
        readable_line(path_), readable_line(sqlite3_errmsg(database_.get()))));
  }

  std::string path_;
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_{nullptr, &sqlite3_close};
};

std::string text_at(sqlite3_stmt* row, int column) {
  const void* text = sqlite3_column_text(row, column);
  return text ? std::string(static_cast<const char*>(text)) : std::string();
}

std::string_view bytes_at(sqlite3_stmt* row, int column) {
  const void* bytes = sqlite3_column_blob(row, column);
  const int size = sqlite3_column_bytes(row, column);
  return bytes ? std::string_view(static_cast<const char*>(bytes), static_cast<std::size_t>(size))
               : std::string_view();
}

}  // namespace

void add_sqlite_states(const std::string& path, JointStateTopics& topics) {
  Database database(path);
  std::vector<std::string> names;
  database.ask("SELECT name FROM topics WHERE type = ? ORDER BY name", std::string(kJointStateType),
               [&](sqlite3_stmt* row) { names.push_back(text_at(row, 0)); });
  for (const std::string& topic : names) {
    JointStateLog& log = topics[topic];
    database.ask(
        "SELECT messages.id, timestamp, data FROM messages JOIN topics ON topic_id = topics.id "
        "WHERE topics.name = ? ORDER BY timestamp, messages.id",
        topic, [&](sqlite3_stmt* row) {
          try {
            log.add(sqlite3_column_int64(row, 1), parse_joint_state(bytes_at(row, 2)));
          } catch (const std::runtime_error& wrong) {
            throw std::runtime_error(fmt::format("{}:0:0: message {} of {} {}", readable_line(path),
                                                 sqlite3_column_int64(row, 0), readable_line(topic),
                                                 wrong.what()));
          }
        });
  }
}
#else
void add_sqlite_states(const std::string& path, JointStateTopics&) {
  throw std::runtime_error(fmt::format(
      "{}:0:0: is an SQLite file, as ROS 2 records them, which this program was built without: "
      "install libsqlite3-dev and build again, or save the log as CSV",
      readable_line(path)));
}
#endif

std::vector<LogColumn> read_rosbag2(const std::string& path) {
  JointStateTopics topics;
  add_sqlite_states(path, topics);
  return joint_state_columns(topics, path);
}

}  // namespace sinew
