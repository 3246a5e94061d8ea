// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/error_report.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <vector>

#include "cli/terminal/terminal.h"
#include "symbolic/files/identifier.h"

namespace sinew {
namespace {

/// The number in front of `text`'s ":", which is taken away; nothing where there is none.
std::optional<int> number_before_colon(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto length = static_cast<std::size_t>(end - text.data());
  if (error != std::errc() || length == text.size() || text[length] != ':') return std::nullopt;
  text.remove_prefix(length + 1);
  return number;
}

/// {"message", "file", "line", "column"} of a line of a report.
nlohmann::ordered_json error_json(std::string_view line) {
  nlohmann::ordered_json error{
      {"message", line}, {"file", nullptr}, {"line", nullptr}, {"column", nullptr}};
  for (std::size_t colon = line.find(':'); colon != std::string_view::npos;
       colon = line.find(':', colon + 1)) {
    std::string_view rest = line.substr(colon + 1);
    const std::optional<int> row = number_before_colon(rest);
    const std::optional<int> column = row ? number_before_colon(rest) : std::nullopt;
    if (!column) continue;
    error["file"] = line.substr(0, colon);
    error["line"] = *row;
    error["column"] = *column;
    error["message"] = rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
    break;
  }
  return error;
}

}  // namespace

bool wants_json(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--") return false;
    if (argument == "--json") return true;
  }
  return false;
}

void tell_errors(std::string_view text) {
  nlohmann::ordered_json errors = nlohmann::ordered_json::array();
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) errors.push_back(error_json(line));
  tell_json({{"errors", errors}, {"exit_status", 2}});
}

std::string meant_option(const std::string& message, const std::string& options) {
  static const std::regex option("--[A-Za-z][A-Za-z-]*");
  const auto all_of = [](const std::string& text) {
    return std::vector<std::string>(std::sregex_token_iterator(text.begin(), text.end(), option),
                                    {});
  };
  const std::vector<std::string> unknown = all_of(message), known = all_of(options);
  const bool is_misspelt =
      !unknown.empty() && std::find(known.begin(), known.end(), unknown.front()) == known.end();
  return is_misspelt ? did_you_mean(unknown.front(), known) : "";
}

}  // namespace sinew
