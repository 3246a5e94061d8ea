// SPDX-License-Identifier: GPL-3.0-or-later
// The log's file: whole or not there, and its numbers those that were given.
#include "simulation/plant/write_rows.h"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <random>
#include <sstream>

#include "tests/reference/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

using sinew::reference::TemporaryFolder;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// Files of this process end at a size, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace

TEST_CASE("rows of several batches come back in their order, bit by bit") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "log.csv";
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> rows(40000, std::vector<double>(5));
  for (auto& row : rows)
    for (double& value : row) value = normal(random);
  sinew::RowWriter out(file, {"a", "b", "c", "d", "e"});
  for (const auto& row : rows) out.write(row);
  CHECK_FALSE(fs::exists(file));
  out.finish();
  CHECK(files_in(folder.path()) == 1);
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  CHECK(line == "a,b,c,d,e");
  std::size_t wrong = 0, read = 0;
  for (; std::getline(in, line); ++read) {
    std::istringstream cells(line);
    std::string cell;
    for (const double value : rows.at(read)) {
      std::getline(cells, cell, ',');
      wrong += std::stod(cell) == value ? 0U : 1U;
    }
  }
  CHECK(read == rows.size());
  CHECK(wrong == 0);
}

TEST_CASE("where the disk is full the old log stays and nothing else is left") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "log.csv";
  sinew::reference::write_text(file, "old");
  {
    sinew::RowWriter out(file, {"a"});
    const FullDisk full(1 << 20);
    const auto write_all = [&] {
      for (int i = 0; i < 1000000; ++i) out.write({1.0 / i});
      out.finish();
    };
    CHECK_THROWS_WITH(write_all(), Catch::Contains("log.csv: cannot be written: File too large"));
  }
  CHECK(files_in(folder.path()) == 1);
  CHECK(fs::file_size(file) == 3);
}

TEST_CASE("a row that does not fit its header is refused") {
  const TemporaryFolder folder;
  sinew::RowWriter out(folder.path() / "log.csv", {"a", "b"});
  CHECK_THROWS_WITH(out.write({1.0}), Catch::Contains("a row of 1 numbers under a header of 2"));
}
