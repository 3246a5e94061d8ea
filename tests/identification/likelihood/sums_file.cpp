// SPDX-License-Identifier: GPL-3.0-or-later
// A file of sums read back, and what is refused.
#include "identification/likelihood/sums_file.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/reference/temporary_folder.h"

namespace {

using namespace sinew::diagnosis;
using sinew::reference::TemporaryFolder;

SumsFile small_file() {
  SumsFile f;
  f.origin = {"0.1",     "motor", "aa", "bb", {"cc", "dd"},        "band 60 Hz",
              "run.csv", "ee",    2001, 8.0,  {"run.csv:7: a gap"}};
  ColumnSums& c = f.sums.columns;
  c.free = 1;
  c.width = {2, 0};
  Eigen::Matrix3d lower;
  lower << 1.0, 0.0, 0.0, 0.1, 2.0, 0.0, 1.0 / 3.0, -4e-300, 3.0;
  c.gram = RegionProducts(lower);
  c.target = Eigen::Vector3d(1.0, 2.0, 1e300);
  c.deviance = 5.0;
  c.rows = 7.0;
  c.energy = Eigen::RowVector2d(1.0, 2.0);
  c.acting = Eigen::Vector2d(3.0, 3.0);
  c.measured = c.samples = f.sums.error = Eigen::VectorXd::Constant(1, 0.7);
  return f;
}

std::filesystem::path written(const TemporaryFolder& folder, const std::string& bytes) {
  const auto file = folder.path() / "a.sums";
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

}  // namespace

TEST_CASE("a file of sums gives back every bit") {
  const TemporaryFolder folder;
  const SumsFile f = small_file();
  const SumsFile back = read_sums(written(folder, sums_bytes(f)));
  CHECK(back.sums.columns.gram.dense() == f.sums.columns.gram.dense());
  CHECK(back.sums.columns.target == f.sums.columns.target);
  CHECK(back.sums.columns.energy == f.sums.columns.energy);
  CHECK(back.sums.columns.width == f.sums.columns.width);
  CHECK(back.sums.error == f.sums.error);
  CHECK(back.origin.reference == f.origin.reference);
  CHECK(back.origin.faults == f.origin.faults);
  check_same_fleet(f.origin, "a", back.origin, "b");
}

// Every length and every byte is a planted defect.
TEST_CASE("a file that is cut short or changed in one bit is refused by name") {
  const TemporaryFolder folder;
  const std::string bytes = sums_bytes(small_file());
  for (std::size_t length = 0; length < bytes.size(); length += 7)
    CHECK_THROWS_WITH(read_sums(written(folder, bytes.substr(0, length))),
                      Catch::Contains("a.sums: "));
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    INFO("byte " << at);
    CHECK_THROWS_WITH(read_sums(written(folder, changed)), Catch::Contains("a.sums: "));
  }
  CHECK_THROWS_WITH(read_sums(folder.path() / "none.sums"), Catch::Contains("none.sums: "));
}

TEST_CASE(
    "sums of different models, settings, references or versions are refused with both named") {
  const SumsOrigin a = small_file().origin;
  const auto refused = [&](SumsOrigin b, const std::string& what) {
    CHECK_THROWS_WITH(check_same_fleet(a, "first.sums", b, "second.sums"),
                      Catch::Contains("first.sums and second.sums") && Catch::Contains(what));
  };
  SumsOrigin b = a;
  b.model_hash = "ab";
  refused(b, "model");
  b = a;
  b.settings = "band 25 Hz";
  refused(b, "band 60 Hz and band 25 Hz");
  b = a;
  b.reference = {"cc"};
  refused(b, "reference");
  b = a;
  b.columns_hash = "b0";
  refused(b, "columns");
  b = a;
  b.program = "0.2";
  refused(b, "version");
}
