// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for any input of a reader of descriptions.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "symbolic/model/check_mechanism.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/write_mechanism.h"

/// Either messages, each with its "; expected" part, or a sound mechanism that reads back as
/// written. Anything else ends the process.
template <typename Read>
void require_sound_or_refused(Read read) {
  const auto fail = [](const std::string& what) {
    fmt::print(stderr, "{}\n", what);
    std::abort();
  };
  sinew::Mechanism mechanism;
  try {
    mechanism = read();
  } catch (const sinew::DescriptionError& error) {
    if (error.messages().empty()) fail("refused without a message");
    for (const std::string& message : error.messages())
      if (message.find("; ") == std::string::npos)
        fail("a message without expectation: " + message);
    return;
  }
  try {
    sinew::require_sound(mechanism);
    const sinew::ModelText first = sinew::describe_mechanism(mechanism, "");
    const sinew::ModelText second =
        sinew::describe_mechanism(sinew::parse_mechanism({first.toml, first.csv}), "");
    if (first.toml != second.toml || first.csv != second.csv)
      fail("does not read back:\n" + first.toml + second.toml);
  } catch (const std::exception& error) {
    fail(std::string("was read, but: ") + error.what());
  }
}
