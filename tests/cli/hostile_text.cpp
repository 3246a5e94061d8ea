// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/hostile_text.h"

#include <catch2/catch.hpp>

namespace sinew {

std::string first_raw(const std::string& output) {
  for (std::size_t at = 0; at < output.size(); ++at) {
    const auto byte = static_cast<unsigned char>(output[at]);
    const std::string two = output.substr(at, 2), three = output.substr(at, 3);
    const bool is_control = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F;
    const bool is_c1 = two.size() == 2 && byte == 0xC2 && static_cast<unsigned char>(two[1]) < 0xA0;
    const bool is_mark = three == "\u202e" || three == "\u202d" || three == "\u2066";
    const bool is_broken = byte == 0xFF || byte == 0xFE;
    if (is_control || is_c1 || is_mark || is_broken) return "byte " + std::to_string(byte);
  }
  return "";
}

void check_refused(const Workplace& here, const std::string& command, const std::string& words) {
  const Ended ended = here.shell("ulimit -v 2000000; timeout 20 " SINEW_PROGRAM " " + command);
  INFO(command << "\n" << ended.output.substr(0, 4000));
  CHECK(ended.status == 2);
  CHECK(ended.says(words));
  CHECK((ended.says("expected") || ended.says("; ")));
  CHECK(first_raw(ended.output) == "");
  CHECK(ended.output.size() < 30000);
}

}  // namespace sinew
