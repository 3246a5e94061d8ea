// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/clear_message.h"

#include <cln/exception.h>
#include <fmt/format.h>
#include <ginac/ginac.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <system_error>
#include <typeinfo>

#include "identification/logs/log.h"
#include "symbolic/files/description_error.h"

namespace sinew {
namespace {

/// Sentences are the program's own. Libraries name functions: "power::eval(): division by zero",
/// "stod", "basic_string::at: ...".
bool is_sentence(const std::string& text) {
  static const std::regex names_function(R"(^\s*[\w:<>~ ]*::[\w~]+(\(\))?\s*:|^[\w:]+\(\))");
  return text.find(' ') != std::string::npos && !std::regex_search(text, names_function);
}

/// The program throws these, and types of its own; what is derived from them is a library's.
bool is_own(const std::exception& error) {
  if (dynamic_cast<const DescriptionError*>(&error) || dynamic_cast<const LogError*>(&error))
    return true;
  const std::type_info& type = typeid(error);
  const bool thrown_here = type == typeid(std::runtime_error) ||
                           type == typeid(std::invalid_argument) ||
                           type == typeid(std::domain_error) || type == typeid(std::range_error);
  return thrown_here && is_sentence(error.what());
}

std::string of_files(const std::filesystem::filesystem_error& error) {
  std::string text = error.path1().string();
  if (!error.path2().empty()) text += " and " + error.path2().string();
  return fmt::format("{}: {}", text.empty() ? "a file" : text, error.code().message());
}

/// What it means, for the kinds there are.
std::string meaning(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) || dynamic_cast<const std::length_error*>(&error))
    return "this machine's memory is not enough for this input; give it less at once";
  if (dynamic_cast<const GiNaC::pole_error*>(&error) ||
      dynamic_cast<const cln::runtime_exception*>(&error) ||
      dynamic_cast<const std::overflow_error*>(&error))
    return "a formula of the model has no value for the numbers in its files: it divides by zero, "
           "or nearly so. Look for a value that is 0 or far too small or large";
  if (dynamic_cast<const nlohmann::json::exception*>(&error))
    return "a JSON text that was to be read or written is none";
  if (dynamic_cast<const CLI::Error*>(&error))
    return "the arguments cannot be understood; --help lists them";
  return "something that was not foreseen went wrong";
}

}  // namespace

std::string clear_message(const std::exception& error) {
  if (is_own(error)) return error.what();
  if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
    return of_files(*of_file);
  if (const auto* of_system = dynamic_cast<const std::system_error*>(&error))
    return of_system->code().message();
  std::string words = error.what();
  std::replace(words.begin(), words.end(), '\n', ' ');
  return fmt::format("{}. Please report it with the input that shows it [{}]", meaning(error),
                     words);
}

}  // namespace sinew
