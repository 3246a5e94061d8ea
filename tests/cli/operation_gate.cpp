// SPDX-License-Identifier: GPL-3.0-or-later
// Operations of emitted functions change where someone accepts it, and benchmarks/operations.csv
// says what they are.
#include <catch2/catch.hpp>

#include "tests/cli/operation_table.h"
#include "tests/reference/temporary_folder.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

const fs::path committed = SINEW_SOURCE_DIR "/benchmarks/operations.csv";

}  // namespace

TEST_CASE("emitted functions have the operations that were accepted") {
  // Planted defects: generated --without factor_sums, fourteen of the robots' functions have more
  // ("panda_bias: more operations: multiply 279 -> 275, add 233 -> 239"); with a count in the table
  // one too large, "panda_gravity: fewer operations: multiply 58 -> 57".
  const std::vector<std::string> changed =
      changes(parse_operations(reference::read_text(committed)), derived_operations());
  std::string text;
  for (const std::string& line : changed) text += "  " + line + "\n";
  INFO(text << "where this is meant: scripts/accept_operations, and commit " << committed);
  CHECK(changed.empty());
}

TEST_CASE("planted: one operation more or fewer, a new and a missing function are told") {
  const OperationTable accepted = parse_operations(reference::read_text(committed));
  CHECK(changes(accepted, accepted).empty());
  CHECK(csv_text(accepted) == reference::read_text(committed));
  OperationTable other = accepted;
  ++other.at({"panda", "panda_inverse_dynamics"})[0];
  --other.at({"finger", "finger_mass_matrix"})[1];
  other.erase({"index", "index_bias"});
  other[{"index", "index_new"}] = {1, 2, 0, 0, 0, 0, 0};
  const std::vector<std::string> told = changes(accepted, other);
  REQUIRE(told.size() == 4);
  CHECK(told[0] == "index_new: new, 3 operations");
  CHECK_THAT(told[1], Catch::StartsWith("panda_inverse_dynamics: more operations: multiply "));
  CHECK_THAT(told[2], Catch::StartsWith("finger_mass_matrix: fewer operations: add "));
  CHECK(told[3] == "index_bias: no longer emitted");
  CHECK_THROWS_WITH(parse_operations("header\na,b,1,2,x,0,0,0,0\n"), Catch::StartsWith("line 2"));
}

TEST_CASE("accept operations", "[.accept_operations]") {
  fs::path written = committed;
  written += ".new";
  reference::write_text(written, csv_text(derived_operations()));
  fs::rename(written, committed);
  CHECK(fs::exists(committed));
}
