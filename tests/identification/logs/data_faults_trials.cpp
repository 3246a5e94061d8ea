// SPDX-License-Identifier: GPL-3.0-or-later
// How often a planted fault is found and named rightly, and how often a clean log is suspected.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "identification/logs/read_csv.h"
#include "tests/identification/logs/planted_log.h"
#include "tests/reference/record_line.h"

using namespace sinew;
using namespace sinew::test;

namespace {

std::vector<DataFault> findings(const PlantedLog& log, const std::string& name) {
  const std::string path = write_file(name, log.text());
  try {
    return read_csv(path, log.specs).faults;
  } catch (const LogError& error) {
    return error.faults;
  }
}

bool is_named(const std::vector<DataFault>& found, const Planted& planted) {
  for (const DataFault& fault : found) {
    if (fault.kind != planted.kind || fault.severity == Severity::note) continue;
    if (!planted.either && fault.channel != planted.channel) continue;
    if (planted.row > 0 && (planted.row < fault.row || planted.row > fault.last_row)) continue;
    return true;
  }
  return false;
}

int trials_each() {
  const char* asked = std::getenv("SINEW_FAULT_TRIALS");
  return asked != nullptr ? std::atoi(asked) : 2;
}

}  // namespace

TEST_CASE("planted faults are found, with row and column", "[slow][thorough]") {
  int planted_total = 0, found_total = 0;
  std::string table;
  for (int fault = 0; fault < planted_kinds; ++fault) {
    int found_here = 0, here = 0;
    for (int kind = 0; kind < clean_kinds; ++kind)
      for (int trial = 0; trial < trials_each(); ++trial) {
        std::mt19937_64 random(static_cast<unsigned long>(1000 * fault + 100 * kind + trial + 1));
        PlantedLog log = clean_log(kind, random);
        const Planted planted = plant(fault, log, random);
        const auto found = findings(log, "planted.csv");
        const bool named = is_named(found, planted);
        ++here;
        found_here += named ? 1 : 0;
        if (!named) {
          std::string what;
          for (const DataFault& f : found)
            if (f.severity != Severity::note) what += "\n    " + message(f);
          UNSCOPED_INFO(fmt::format("missed: {} in kind {}, trial {} (row {}){}",
                                    planted_name(fault), kind, trial, planted.row, what));
        }
      }
    table += fmt::format("{:22} {:4} of {:4}\n", planted_name(fault), found_here, here);
    reference::record_line(
        fmt::format(R"({{"what": "planted", "kind": "{}", "found": {}, "of": {}}})",
                    planted_name(fault), found_here, here));
    CHECK(found_here >= 0.85 * here);  // one miss of a kind; the sum below is the goal
    planted_total += here;
    found_total += found_here;
  }
  WARN(table << "all " << found_total << " of " << planted_total);
  CHECK(found_total >= 0.95 * planted_total);
}

TEST_CASE("clean logs are not suspected", "[slow]") {
  int clean = 0, suspected = 0;
  for (int kind = 0; kind < clean_kinds; ++kind)
    for (int trial = 0; trial < 5 * trials_each(); ++trial) {
      std::mt19937_64 random(static_cast<unsigned long>(900000 + 1000 * kind + trial));
      const auto found = findings(clean_log(kind, random), "clean.csv");
      ++clean;
      std::string what;
      for (const DataFault& f : found)
        if (f.severity != Severity::note) what += "\n    " + message(f);
      if (what.empty()) continue;
      ++suspected;
      UNSCOPED_INFO(fmt::format("suspected: kind {}, trial {}{}", kind, trial, what));
    }
  reference::record_line(
      fmt::format(R"({{"what": "clean", "suspected": {}, "of": {}}})", suspected, clean));
  WARN(suspected << " of " << clean << " clean logs suspected");
  CHECK(suspected <= 0.01 * clean);
}
