// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of ROS 2 in MCAP: records of a kind, a length and that many bytes, alone or in chunks.
// https://mcap.dev/spec says the layout. A chunk may be compressed; this reads those by zstd.
#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "identification/logs/converted_log.h"
#include "identification/logs/joint_states.h"
#include "symbolic/files/readable.h"

#if __has_include(<zstd.h>)
#include <zstd.h>
#endif

namespace sinew {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 30;  ///< of one record

/// Numbers of an MCAP file stand with the lowest byte first, packed.
class McapBytes {
 public:
  explicit McapBytes(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    const std::string_view digits = taken(size);
    for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(digits[i]);
    return value;
  }
  std::string text() { return std::string(taken(number(4))); }
  std::string_view taken(std::uint64_t size) {
    if (size > bytes_.size()) throw std::runtime_error("has a record that is shorter than it says");
    const std::string_view part = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return part;
  }
  std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
};

std::string unpacked(const std::string& how, std::string_view bytes, std::uint64_t size) {
#if __has_include(<zstd.h>)
  if (how == "zstd" && size <= kMostBytes) {
    std::string out(size, '\0');
    if (ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size()) == size) return out;
    throw std::runtime_error("has a chunk whose compressed bytes are broken");
  }
#endif
  static_cast<void>(bytes), static_cast<void>(size);
  throw std::runtime_error(
      fmt::format("has chunks compressed by '{}', which cannot be read here{}; record without "
                  "compression, or write it anew with mcap compress --compression none",
                  readable_line(how), how == "zstd" ? " without libzstd-dev at build" : ""));
}

class McapLog {
 public:
  explicit McapLog(JointStateTopics& topics) : topics_(topics) {}

  void record(unsigned kind, std::string_view content) {
    McapBytes bytes(content);
    if (kind == 3) schema(bytes);
    if (kind == 4) channel(bytes);
    if (kind == 5) message(bytes);
    if (kind == 6) chunk(bytes);
  }

 private:
  void schema(McapBytes& bytes) {
    const std::uint64_t id = bytes.number(2);
    if (bytes.text() == kJointStateType) schemas_.insert(id);
  }

  void channel(McapBytes& bytes) {
    const std::uint64_t id = bytes.number(2);
    const bool states = schemas_.count(bytes.number(2)) != 0;
    const std::string topic = bytes.text();
    if (!states || bytes.text() != "cdr") return;
    topics_[topic];
    channels_[id] = topic;
  }

  void message(McapBytes& bytes) {
    const auto topic = channels_.find(bytes.number(2));
    if (topic == channels_.end()) return;
    const std::uint64_t number = bytes.number(4);
    const std::uint64_t logged = bytes.number(8);
    bytes.number(8);  // when it was published
    try {
      topics_[topic->second].add(static_cast<std::int64_t>(logged),
                                 parse_joint_state(bytes.rest()));
    } catch (const std::runtime_error& wrong) {
      throw std::runtime_error(fmt::format("has a message, {} of {}, that {}", number,
                                           readable_line(topic->second), wrong.what()));
    }
  }

  void chunk(McapBytes& bytes) {
    bytes.number(8), bytes.number(8);  // first and last time
    const std::uint64_t size = bytes.number(8);
    bytes.number(4);  // checksum
    const std::string how = bytes.text();
    std::string_view packed = bytes.taken(bytes.number(8));
    const std::string whole = how.empty() ? std::string() : unpacked(how, packed, size);
    McapBytes records(how.empty() ? packed : std::string_view(whole));
    while (!records.rest().empty()) {
      const auto kind = static_cast<unsigned>(records.number(1));
      const std::string_view content = records.taken(records.number(8));
      if (kind != 6) record(kind, content);  // no chunk stands in a chunk
    }
  }

  std::set<std::uint64_t> schemas_;
  std::map<std::uint64_t, std::string> channels_;
  JointStateTopics& topics_;
};

void read_records(std::FILE* file, std::uintmax_t left, McapLog& log) {
  std::string content;
  char head[9];
  while (left > 8 && std::fread(head, 1, sizeof head, file) == sizeof head) {
    const auto kind = static_cast<unsigned char>(head[0]);
    const std::uint64_t size = McapBytes(std::string_view(head + 1, 8)).number(8);
    left -= sizeof head;
    if (size > left || size > kMostBytes)
      throw std::runtime_error("ends within a record; mcap recover writes those that are whole");
    content.resize(size);
    if (std::fread(content.data(), 1, size, file) != size)
      throw std::runtime_error("cannot be read to its end");
    left -= size;
    log.record(kind, content);
    if (kind == 15) return;  // the end of the data; what follows is an index of it
  }
  throw std::runtime_error("has no end of its data; mcap recover writes what is whole");
}

}  // namespace

void add_mcap_states(const std::string& path, JointStateTopics& topics) {
  constexpr std::string_view kMagic = "\x89MCAP0\r\n";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  McapLog log(topics);
  try {
    char head[kMagic.size()];
    if (!file) throw std::runtime_error("cannot be opened; expected a log");
    if (std::fread(head, 1, sizeof head, file.get()) != sizeof head ||
        std::string_view(head, sizeof head) != kMagic)
      throw std::runtime_error("does not begin as MCAP does; expected a part of an MCAP recording");
    read_records(file.get(), std::filesystem::file_size(path) - kMagic.size(), log);
  } catch (const std::runtime_error& wrong) {
    throw std::runtime_error(fmt::format("{}:0:0: {}", readable_line(path), wrong.what()));
  }
}

std::vector<LogColumn> read_mcap(const std::string& path) {
  JointStateTopics topics;
  add_mcap_states(path, topics);
  return joint_state_columns(topics, path);
}

}  // namespace sinew
