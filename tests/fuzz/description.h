// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for any input of a reader of descriptions.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "symbolic/files/limits.h"
#include "symbolic/files/readable.h"
#include "symbolic/model/check_mechanism.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/write_mechanism.h"

/// Of a message: nothing that a terminal would act upon, and a length to be read.
inline bool is_readable(const std::string& message) {
  return sinew::readable_line(message) == message && message.size() < 10'000;
}

/// Either messages, each readable and with its "; expected" part, or a sound mechanism that reads
/// back as written. Anything else ends the process.
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
    if (error.messages().size() > sinew::limits::shown_mistakes + 1) fail("too many messages");
    for (const std::string& message : error.messages()) {
      if (message.find("; ") == std::string::npos)
        fail("a message without expectation: " + message);
      if (!is_readable(message)) fail("a message that is raw or endless: " + message);
    }
    return;
  }
  try {
    sinew::require_sound(mechanism);
    const sinew::ModelText first = sinew::describe_mechanism(mechanism, "");
    const sinew::ModelText second = sinew::describe_mechanism(
        sinew::parse_mechanism({first.toml, first.csv, "toml", "csv", first.names, "names"}), "");
    if (first.toml != second.toml || first.csv != second.csv || first.names != second.names)
      fail("does not read back:\n" + first.toml + second.toml);
  } catch (const std::exception& error) {
    fail(std::string("was read, but: ") + error.what());
  }
}
