// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>

struct evp_md_ctx_st;

namespace sinew {

/// SHA-256 of a stream of bytes.
class Sha256 {
 public:
  Sha256();
  void update(const char* bytes, size_t count);
  /// 64 hexadecimal digits. Call once, at the end.
  std::string finish();

 private:
  struct Free {
    void operator()(evp_md_ctx_st* state) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> state_;
};

}  // namespace sinew
