// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/operation_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <catch2/catch.hpp>
#include <charconv>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "tests/cli/program.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

const std::string source = SINEW_SOURCE_DIR;

void add_manifest(const fs::path& folder, OperationTable& table) {
  const auto manifest = nlohmann::json::parse(reference::read_text(folder / "manifest.json"));
  for (const auto& function : manifest.at("functions")) {
    OperationCounts counts{};
    for (std::size_t kind = 0; kind < counts.size(); ++kind)
      counts[kind] = function.at("operations").at(operation_kinds[kind]).get<int>();
    table[{manifest.at("model"), function.at("name")}] = counts;
  }
}

/// A robot as the benchmarks emit it (benchmarks/CMakeLists.txt).
void add_robot(const std::string& name, const std::vector<std::string>& gravity,
               OperationTable& table) {
  const Workplace here;
  std::vector<std::string> import{"import", source + "/benchmarks/robots/" + name + ".urdf",
                                  "--out", "models/" + name, "--gravity"};
  import.insert(import.end(), gravity.begin(), gravity.end());
  for (const auto& arguments :
       {import, std::vector<std::string>{"generate", "models/" + name, "--out", "emitted"}}) {
    const Ended ended = here.sinew(arguments);
    if (ended.status != 0) throw std::runtime_error(ended.output);
  }
  add_manifest(here.path("emitted"), table);
}

int sum(const OperationCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0);
}

/// What grew or shrank, kind by kind.
std::string differences(const OperationCounts& accepted, const OperationCounts& derived) {
  std::vector<std::string> parts;
  for (std::size_t kind = 0; kind < accepted.size(); ++kind)
    if (accepted[kind] != derived[kind])
      parts.push_back(
          fmt::format("{} {} -> {}", operation_kinds[kind], accepted[kind], derived[kind]));
  return fmt::format("{}", fmt::join(parts, ", "));
}

bool any_grew(const OperationCounts& accepted, const OperationCounts& derived) {
  for (std::size_t kind = 0; kind < accepted.size(); ++kind)
    if (derived[kind] > accepted[kind]) return true;
  return false;
}

}  // namespace

OperationTable derived_operations() {
  OperationTable table;
  for (const auto& entry : fs::directory_iterator(source + "/generated"))
    if (fs::exists(entry.path() / "manifest.json")) add_manifest(entry.path(), table);
  add_robot("finger", {"1.7", "-3.1", "-9.1"}, table);
  add_robot("panda", {"0", "0", "-9.81"}, table);
  return table;
}

OperationTable parse_operations(const std::string& csv) {
  OperationTable table;
  std::istringstream lines(csv);
  std::string line, word;
  std::getline(lines, line);
  for (int number = 2; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::array<std::string, 2> name;
    for (std::string& part : name) std::getline(words, part, ',');
    OperationCounts counts{};
    for (int& count : counts) {
      std::getline(words, word, ',');
      const auto end = std::from_chars(word.data(), word.data() + word.size(), count);
      if (!words || end.ec != std::errc() || end.ptr != word.data() + word.size())
        throw std::runtime_error(fmt::format("line {}: '{}'; expected {} numbers after two names",
                                             number, line, counts.size()));
    }
    table[name] = counts;
  }
  return table;
}

std::string csv_text(const OperationTable& table) {
  std::string text = fmt::format("model,function,{}\n", fmt::join(operation_kinds, ","));
  for (const auto& [name, counts] : table)
    text += fmt::format("{},{},{}\n", name[0], name[1], fmt::join(counts, ","));
  return text;
}

std::vector<std::string> changes(const OperationTable& accepted, const OperationTable& derived) {
  std::vector<std::string> more, fewer;
  for (const auto& [name, counts] : derived) {
    const auto before = accepted.find(name);
    if (before == accepted.end()) {
      more.push_back(fmt::format("{}: new, {} operations", name[1], sum(counts)));
    } else if (before->second != counts) {
      const bool grew = any_grew(before->second, counts);
      (grew ? more : fewer)
          .push_back(fmt::format("{}: {} operations: {}", name[1], grew ? "more" : "fewer",
                                 differences(before->second, counts)));
    }
  }
  for (const auto& [name, counts] : accepted)
    if (!derived.count(name)) fewer.push_back(name[1] + ": no longer emitted");
  more.insert(more.end(), fewer.begin(), fewer.end());
  return more;
}

}  // namespace sinew
