// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of ROS 2, as rosbag2 writes them into SQLite and into MCAP: written here byte by byte,
// read as the log that they hold, and refused where they are broken.
// Planted, and seen red here: doubles aligned to four bytes; the order of the names in a message
// not looked at; stamps of the header left for those of the recorder; a message that ends early
// taken as zeros; MCAP's chunks passed over; a second topic taken for the first.
#include <fmt/format.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>

#include "identification/logs/read_csv.h"
#include "identification/logs/sha256.h"
#include "tests/identification/logs/planted_log.h"
#include "tests/skip.h"

#if __has_include(<sqlite3.h>)
#include <sqlite3.h>
#endif

using namespace sinew;
using sinew::test::write_file;

namespace {

template <typename Number>
std::string raw(Number value, bool big = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// A message as CDR: every number at a multiple of its size behind the four bytes of the head.
class Cdr {
 public:
  explicit Cdr(bool big) : big_(big), bytes_{'\0', big ? '\0' : '\1', '\0', '\0'} {}
  template <typename Number>
  Cdr& put(Number value) {
    while ((bytes_.size() - 4) % sizeof value != 0) bytes_ += '\x5a';  // whatever was there
    bytes_ += raw(value, big_);
    return *this;
  }
  Cdr& put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes_ += text + '\0';
    return *this;
  }
  Cdr& put(const std::vector<double>& values) {
    put(static_cast<std::uint32_t>(values.size()));
    for (const double value : values) put(value);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  bool big_;
  std::string bytes_;
};

constexpr int kRows = 600;
constexpr std::int64_t kStart = 1700000000123456789;

double theta_at(int k) {
  return 0.5 * std::sin(0.02 * k) + 0.2 * std::sin(0.0311 * k);
}
double tau_at(int k) {
  return 0.3 * std::tanh(40.0 * std::cos(0.02 * k)) + 0.1 * std::sin(0.7 * k);
}

struct Style {
  bool big = false, stamped = true;
  int names_first = 0;  ///< every so many messages name the joints the other way round
};

/// The drive, and another joint that rests; no velocities.
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

struct Recorded {
  std::string topic, bytes;
  std::int64_t logged = 0;  // ns
};

std::vector<Recorded> drive_messages(const Style& style) {
  std::vector<Recorded> all;
  for (int k = 0; k < kRows; ++k)  // the recorder is late, now more and now less
    all.push_back({"/joint_states", message_at(k, style),
                   kStart + 2000000LL * k + 3000000 + (style.stamped ? 400000 * (k % 3) : 0)});
  return all;
}

constexpr const char* kType = "sensor_msgs/msg/JointState";

std::string sized(const std::string& text) {
  return raw(static_cast<std::uint32_t>(text.size())) + text;
}
std::string record(char kind, const std::string& content) {
  return kind + raw(static_cast<std::uint64_t>(content.size())) + content;
}

std::string write_mcap(const std::vector<Recorded>& messages, bool chunks,
                       const std::string& packing = "", bool whole = true) {
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
  return write_file("recording.mcap", file + (whole ? std::string("\x89MCAP0\r\n", 8) : ""));
}

#if __has_include(<sqlite3.h>)
/// The tables of rosbag2's storage plugin, with the columns of Humble.
std::string write_db3(const std::vector<Recorded>& messages) {
  const std::string path = write_file("recording.db3", "");
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
std::string write_db3(const std::vector<Recorded>&) {
  return "";
}
#endif

const std::vector<std::string> kMap{"theta=q_drive", "tau_m=tau_drive"};

void check_read(const std::string& path) {
  ReadOptions options;
  options.map = kMap;
  const Log log = read_csv(path, rotary_drive_channels(), options);
  REQUIRE(log.segments.size() == 1);
  REQUIRE(log.segments[0].samples.rows() == kRows);
  CHECK(log.period == Approx(0.002).epsilon(1e-9));
  CHECK(log.segments[0].start == Approx(0.0).margin(1e-12));
  double worst = 0.0;
  for (int k = 0; k < kRows; ++k)
    worst = std::max({worst, std::abs(log.segments[0].samples(k, 0) - theta_at(k)),
                      std::abs(log.segments[0].samples(k, 1) - tau_at(k))});
  CHECK(worst < 1e-12);
  CHECK(log.sha256.size() == 64);
}

void check_refused(const std::string& path, const std::string& reason) {
  ReadOptions options;
  options.map = kMap;
  CHECK_THROWS_WITH(read_csv(path, rotary_drive_channels(), options), Catch::Contains(reason));
}

/// Both ways of writing it; what only SQLite's library can write is skipped where it is not there.
template <typename Check>
void each_storage(const std::vector<Recorded>& messages, const Check& check) {
  check(write_mcap(messages, true));
  const std::string path = write_db3(messages);
  if (path.empty())
    test::skip("libsqlite3-dev is not installed: no rosbag2 file can be written");
  else
    check(path);
}

}  // namespace

TEST_CASE("joint states of a recording of ROS 2 are a log", "[logs]") {
  for (const bool big : {false, true})
    for (const bool stamped : {false, true})
      each_storage(drive_messages({big, stamped, 3}), check_read);
  check_read(write_mcap(drive_messages({}), false));
}

TEST_CASE("of several topics the one called joint_states is read, or none", "[logs]") {
  std::vector<Recorded> messages = drive_messages({});
  for (int k = 0; k < kRows; ++k) messages.push_back({"/aim", message_at(k + 50, {}), 5});
  each_storage(messages, check_read);
  for (Recorded& m : messages)
    if (m.topic == "/joint_states") m.topic = "/measured";
  each_storage(messages, [](const std::string& path) { check_refused(path, "/aim, /measured"); });
  each_storage({}, [](const std::string& path) { check_refused(path, "no topic of the type"); });
}

TEST_CASE("messages of other joints on the same topic are left out", "[logs]") {
  std::vector<Recorded> messages = drive_messages({});
  Cdr cdr(false);
  cdr.put(std::int32_t{5}).put(std::uint32_t{5}).put(std::string()).put(std::uint32_t{1});
  cdr.put(std::string("gripper")).put(std::vector{0.5}).put(std::vector{0.5}).put(std::vector{0.5});
  for (int k = 0; k < kRows; ++k)
    messages.insert(messages.begin() + 2 * k,
                    {"/joint_states", cdr.bytes(), kStart + 2000000LL * k});
  each_storage(messages, check_read);
}

TEST_CASE("a broken recording of ROS 2 is refused, wherever it ends", "[logs]") {
  const std::vector<Recorded> good = drive_messages({});
  const auto with = [&](const std::string& bytes) {
    std::vector<Recorded> messages = good;
    messages[17].bytes = bytes;
    return messages;
  };
  const std::string& whole = good[17].bytes;
  for (std::size_t size = 0; size < whole.size(); ++size)
    check_refused(write_mcap(with(whole.substr(0, size)), size % 2 == 0),
                  size < 4 ? "does not begin as CDR does" : "ends before its last value");
  std::string many = whole;
  many.replace(4 + 20, 4, "\xff\xff\xff\x7f");  // how many names there are
  each_storage(with(many), [](const std::string& path) { check_refused(path, "ends before its"); });
  each_storage(with("\x28\xb5\x2f\xfd packed"),
               [](const std::string& path) { check_refused(path, "compressed one by one"); });

  check_refused(write_mcap(good, true, "lz4"), "compressed by 'lz4'");
  check_refused(write_mcap(good, true, "zstd"), "compressed");
  check_refused(write_mcap(good, true, "", false), "mcap recover");
  check_refused(write_file("recording.mcap",
                           std::string("\x89MCAP0\r\n\5\xff\xff\xff\xff\xff\xff\xff\xff!", 18)),
                "ends within a record");
  check_refused(write_file("recording.mcap", "\x89MCAP0\r\n"), "mcap recover");
  check_refused(write_file("recording.bag", "#ROSBAG V2.0\n"), "recording of ROS 1");
  check_refused(write_file("recording.db3.zstd", "\x28\xb5\x2f\xfd......"), "is compressed");
}

TEST_CASE("a file of SQLite that is no recording is refused", "[logs]") {
  const std::string path = write_db3(drive_messages({}));
  if (path.empty()) return test::skip("libsqlite3-dev is not installed");
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  check_refused(write_file("half.db3", bytes.substr(0, bytes.size() / 2)), "cannot be read as");
  check_refused(write_file("head.db3", bytes.substr(0, 100)), "cannot be read as");
  std::string other = bytes;
  const std::size_t at = other.find("CREATE TABLE topics");
  REQUIRE(at != std::string::npos);
  other.replace(at, 19, "CREATE TABLE topica");
  check_refused(write_file("other.db3", other), "cannot be read as");
}
