// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of ROS 2 written byte by byte, as rosbag2 writes them into SQLite and into MCAP.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace sinew::test {

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

inline constexpr int kRows = 600;
inline constexpr std::int64_t kStart = 1700000000123456789;

/// rad and N·m of the drive at a row.
double theta_at(int k);
double tau_at(int k);

struct Style {
  bool big = false, stamped = true;
  int names_first = 0;  ///< every so many messages name the joints the other way round
};

/// The drive, and another joint that rests; no velocities.
std::string message_at(int k, const Style& style);

struct Recorded {
  std::string topic, bytes;
  std::int64_t logged = 0;  // ns
};

std::vector<Recorded> drive_messages(const Style& style);

/// Files of this process, and their paths. `packing`: what the chunks say they are compressed by;
/// `whole`: with an end.
std::string write_mcap(const std::vector<Recorded>& messages, bool chunks,
                       const std::string& packing = "", bool whole = true,
                       const std::string& name = "recording.mcap");
/// "" where SQLite's library is not there.
std::string write_db3(const std::vector<Recorded>& messages,
                      const std::string& name = "recording.db3");

}  // namespace sinew::test
