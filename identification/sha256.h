// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace sinew {

/// SHA-256 of a stream of bytes (FIPS 180-4).
class Sha256 {
 public:
  void update(const char* bytes, size_t count);
  /// 64 hexadecimal digits. Call once, at the end.
  std::string finish();

 private:
  void block(const unsigned char* bytes);
  std::array<std::uint32_t, 8> state_{0x6a09e667u, 0xbb67ae85u, 0x3c6ef372u, 0xa54ff53au,
                                      0x510e527fu, 0x9b05688cu, 0x1f83d9abu, 0x5be0cd19u};
  std::array<unsigned char, 64> pending_{};
  size_t pending_count_ = 0;
  std::uint64_t total_ = 0;
};

}  // namespace sinew
