// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of ROS 2 in several files: the folder that rosbag2 makes is read as one log.
// Planted, and seen red here: parts in the order of their names.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "identification/logs/bag_folder.h"
#include "identification/logs/read_csv.h"
#include "tests/identification/logs/written_recordings.h"
#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

using test::Recorded;

/// What Jazzy's rosbag2 writes, but for keys between those that are read.
std::string metadata_of(const std::string& storage, const std::string& files,
                        const std::string& more = "") {
  return fmt::format(
      "rosbag2_bagfile_information:\n  version: 9\n  storage_identifier: {}\n  duration:\n"
      "    nanoseconds: 1198000000\n  topics_with_message_count:\n    - topic_metadata:\n"
      "        name: /joint_states\n        type: sensor_msgs/msg/JointState\n"
      "        offered_qos_profiles: \"- history: 3\\n  depth: 0\"\n      message_count: 600\n"
      "  compression_format: \"\"\n  compression_mode: \"\"\n{}  relative_file_paths:\n{}"
      "  files:\n    - path: run_0.mcap\n      message_count: 600\n  custom_data: ~\n"
      "  ros_distro: jazzy\n",
      storage, more, files);
}

const char* const three = "    - run_2\n    - run_10\n    - run_1\n";

/// Parts whose names say another order than metadata.yaml does; the folder goes with its owner.
class Bag {
 public:
  explicit Bag(const std::string& storage) {
    const std::vector<Recorded> all = test::drive_messages({});
    std::size_t from = 0;
    for (const auto& [name, to] : {std::pair{"run_2", 150u}, {"run_10", 400u}, {"run_1", 600u}}) {
      const std::vector<Recorded> part(all.begin() + static_cast<std::ptrdiff_t>(from),
                                       all.begin() + to);
      const std::string file =
          storage == "mcap" ? test::write_mcap(part, true) : test::write_db3(part);
      if (file.empty()) return;
      fs::copy_file(file, path(name));
      from = to;
    }
    write("metadata.yaml", metadata_of(storage, three));
    whole_ = true;
  }

  bool whole() const { return whole_; }
  std::string folder() const { return folder_.path().string(); }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    reference::write_text(folder_.path() / name, text);
  }

 private:
  reference::TemporaryFolder folder_;
  bool whole_ = false;
};

Log read(const std::string& path) {
  ReadOptions options;
  options.map = {"theta=q_drive", "tau_m=tau_drive"};
  return read_csv(path, rotary_drive_channels(), options);
}

void check_refused(const Bag& bag, const std::string& file, const std::string& reason) {
  CHECK_THROWS_WITH(read(bag.folder()),
                    Catch::StartsWith(bag.path(file)) && Catch::Contains(reason));
}

}  // namespace

TEST_CASE("a recording in several files is one log, in the order of its metadata", "[logs]") {
  for (const char* storage : {"mcap", "sqlite3"}) {
    const Bag bag(storage);
    if (!bag.whole()) return test::skip("libsqlite3-dev is not installed");
    const Log log = read(bag.folder());
    REQUIRE(log.segments.size() == 1);
    REQUIRE(log.segments[0].samples.rows() == test::kRows);
    for (const int k : {0, 149, 150, 399, 400, 599})
      CHECK(log.segments[0].samples(k, 0) == Approx(test::theta_at(k)).margin(1e-12));
    // One line of the metadata or one byte of a part, and it is another log.
    bag.write("metadata.yaml", metadata_of(storage, three) + "# another\n");
    const std::string commented = read(bag.folder()).sha256;
    CHECK(commented != log.sha256);
    std::ofstream(bag.path("run_1"), std::ios::app) << 'x';
    CHECK(read(bag.folder()).sha256 != commented);
  }
}

TEST_CASE("metadata.yaml may be of older versions, and by other writers", "[logs]") {
  const Bag bag("mcap");
  std::string text = metadata_of("mcap", "    - run/run_2\n    - run/run_10\n    - run/run_1\n");
  text.replace(text.find("version: 9"), 10, "version: 3");
  bag.write("metadata.yaml", text);
  CHECK(read(bag.folder()).rows == test::kRows);
  // Lists not indented, quotes, a comment, CR LF.
  text = metadata_of("'mcap'", "  - run_2\n  # the middle\n  - \"run_10\"\n  - 'run_1'\n");
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\r');
  bag.write("metadata.yaml", text);
  CHECK(read(bag.folder()).rows == test::kRows);
}

TEST_CASE("a folder that is no whole recording is refused with what to do", "[logs]") {
  const Bag bag("mcap");
  const auto with = [&](const std::string& storage, const std::string& files,
                        const std::string& more = "") {
    bag.write("metadata.yaml", metadata_of(storage, files, more));
  };
  with("mcap", "    - run_2\n    - run_3\n");
  check_refused(bag, "run_3:0:0: is missing", "ros2 bag reindex");
  with("rosbag_v2", three);
  check_refused(bag, "metadata.yaml:0:0: ", "'rosbag_v2', which is not read here");
  with("mcap", "    - ../run_2\n");
  check_refused(bag, "metadata.yaml:0:0: ", "not in this folder");
  with("mcap", "    - /etc/hostname\n");
  check_refused(bag, "metadata.yaml:0:0: ", "not in this folder");
  with("mcap", "    - run_2\n    - run_2\n");
  check_refused(bag, "metadata.yaml:0:0: ", "twice");
  with("sqlite3", three);
  check_refused(bag, "run_2:0:0: ",
                Bag("sqlite3").whole() ? "cannot be read as a recording of ROS 2" : "SQLite");
  with("mcap", "    - metadata.yaml\n");
  check_refused(bag, "metadata.yaml:0:0: ", "does not begin as MCAP does");
  fs::remove(bag.path("metadata.yaml"));
  CHECK_THROWS_WITH(read(bag.folder()),
                    Catch::StartsWith(bag.folder() + ":0:0: is a folder without metadata.yaml"));
}

TEST_CASE("a recording that is compressed by its recorder is refused", "[logs]") {
  const Bag bag("mcap");
  for (const char* mode : {"FILE", "MESSAGE", "file"}) {
    std::string text = metadata_of("mcap", three);
    text.replace(text.find("compression_mode: \"\""), 20,
                 fmt::format("compression_mode: {}", mode));
    text.replace(text.find("compression_format: \"\""), 22, "compression_format: zstd");
    bag.write("metadata.yaml", text);
    check_refused(bag, "metadata.yaml:0:0: ", "(zstd), which is not read here");
  }
  std::string text = metadata_of("mcap", three);
  text.replace(text.find("compression_mode: \"\""), 20, "compression_mode: NONE");
  bag.write("metadata.yaml", text);
  CHECK(read(bag.folder()).rows == test::kRows);
}

TEST_CASE("metadata that rosbag2 does not write is refused at its line", "[logs]") {
  const auto refused = [](const std::string& text, const std::string& reason) {
    INFO(text);
    CHECK_THROWS_WITH(parse_bag_metadata(text, "m"), Catch::StartsWith("m:" + reason));
  };
  const std::string head = "rosbag2_bagfile_information:\n  version: 5\n";
  refused("", "1:0: has no table");
  refused("other:\n  version: 5\n", "1:0: has no table");
  refused("- a\n", "1:0: has no table");
  refused("rosbag2_bagfile_information:\n", "1:0: has no table");
  refused(head, "2:0: has no key storage_identifier");
  refused(head + "  storage_identifier: mcap\n", "2:0: has no key relative_file_paths");
  refused(head + "  storage_identifier: mcap\n  relative_file_paths: []\n", "2:0: names no file");
  refused(head + "  storage_identifier: mcap\n  relative_file_paths:\n    a\n",
          "5:0: 'relative_file_paths' is not of its type");
  refused(head + "  storage_identifier: [mcap]\n", "3:0: 'storage_identifier' is not of its type");
  refused(head + "  storage_identifier: {mcap\n", "4:0: is no YAML");
  refused("rosbag2_bagfile_information:\n  version: five\n", "2:0: 'version' is not of its type");
  refused("a: " + std::string(100000, '['), "1:0: is no YAML");
  // Wherever it ends, it ends with a message or a list.
  const std::string whole = metadata_of("mcap", three);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    bool told = false;
    try {
      told = !parse_bag_metadata(whole.substr(0, size), "m").files.empty();
    } catch (const std::runtime_error& wrong) {
      told = std::string(wrong.what()).starts_with("m:");
    }
    CHECK(told);
  }
}
