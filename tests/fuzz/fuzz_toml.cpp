// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include "tests/fuzz/description.h"
#include "tests/symbolic/model/malformed_case.h"

/// mechanism.toml beside a sound table of mass properties.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  require_sound_or_refused([&] { return sinew::parse_mechanism({text, malformed::sound_csv}); });
  return 0;
}
