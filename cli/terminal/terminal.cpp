// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terminal/terminal.h"

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "symbolic/files/readable.h"

namespace sinew {
namespace {

bool quiet = false;

}  // namespace

void be_quiet() {
  quiet = true;
}

bool is_quiet() {
  return quiet;
}

void put_readable(std::FILE* stream, std::string_view text) {
  const std::string shown = readable(text);
  std::fwrite(shown.data(), 1, shown.size(), stream);
}

void complain(std::string_view what) noexcept {
  try {
    warn("sinew: {}\n", message_lines(what));
  } catch (...) {
    std::fputs("sinew: memory is not enough to say what went wrong\n", stderr);
  }
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void tell_json(const nlohmann::ordered_json& json) {
  put_readable(stdout, json_text(json));
}

void show_progress(std::string_view text) {
  static const bool terminal = ::isatty(STDERR_FILENO) != 0;
  if (!terminal || quiet) return;
  const std::string line = "\r\033[K" + readable_line(text);
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
}

}  // namespace sinew
