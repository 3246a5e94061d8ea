// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of ROS 2, as rosbag2 writes them into SQLite and into MCAP: written here byte by byte,
// read as the log that they hold, and refused where they are broken.
// Planted, and seen red here: doubles aligned to four bytes; the order of the names in a message
// not looked at; stamps of the header left for those of the recorder; a message that ends early
// taken as zeros; MCAP's chunks passed over; a second topic taken for the first.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "identification/logs/read_csv.h"
#include "tests/identification/logs/planted_log.h"
#include "tests/identification/logs/written_recordings.h"
#include "tests/skip.h"

using namespace sinew;
using namespace sinew::test;

namespace {

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
