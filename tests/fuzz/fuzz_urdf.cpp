// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include "symbolic/model/read_urdf.h"
#include "tests/fuzz/description.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  require_sound_or_refused([&] {
    return sinew::parse_urdf(text, "robot.urdf", {0.0, 0.0, -9.81});
  });
  return 0;
}
