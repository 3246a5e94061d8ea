// SPDX-License-Identifier: GPL-3.0-or-later
// `sinew import`, run as a user runs it.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/read_urdf.h"
#include "tests/symbolic/model/malformed_case.h"
#include "tests/symbolic/model/same_mechanism.h"

namespace fs = std::filesystem;

namespace {

/// A folder with arm.urdf in it, removed at the end.
class Workshop {
 public:
  Workshop() {
    std::string pattern = (fs::temp_directory_path() / "sinew_import_XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
    put("arm.urdf", malformed::sound_urdf);
  }
  ~Workshop() { fs::remove_all(path_); }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  const fs::path& path() const { return path_; }
  void put(const std::string& name, std::string_view text) { std::ofstream(path_ / name) << text; }
  std::string get(const std::string& name) const {
    std::ifstream stream(path_ / name);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// Runs `sinew import` here; its exit status, its words in the files out and err.
  int import(const std::string& arguments) const {
    const int status = std::system(fmt::format("cd '{}' && '{}' import {} > out 2> err",
                                               path_.string(), SINEW_PROGRAM, arguments)
                                       .c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("a robot is imported with gravity as given", "[import]") {
  const Workshop here;
  REQUIRE(here.import("arm.urdf --out models/arm --gravity 1.7 -3.1 -9.1") == 0);
  const sinew::Mechanism read = sinew::read_mechanism(here.path() / "models/arm");
  const sinew::Mechanism source = sinew::read_urdf(here.path() / "arm.urdf", {1.7, -3.1, -9.1});
  REQUIRE(first_difference(source, read) == "");
  REQUIRE_THAT(here.get("out"),
               Catch::Contains("2 moving joints: shoulder; and following them: elbow"));
}

TEST_CASE("the report of an import as JSON", "[import]") {
  const Workshop here;
  REQUIRE(here.import("arm.urdf --out arm --json") == 0);
  REQUIRE_THAT(
      here.get("out"),
      Catch::Contains("\"coordinates\": [\n    \"shoulder\"\n  ],\n  \"followers\": [\n    "
                      "\"elbow\"\n  ]"));
}

TEST_CASE("a folder that holds something needs --force", "[import]") {
  Workshop here;
  fs::create_directories(here.path() / "arm");
  here.put("arm/identified.toml", "kept");
  REQUIRE(here.import("arm.urdf --out arm") == 2);
  REQUIRE_THAT(here.get("err"), Catch::Contains("arm: is not empty"));
  REQUIRE_FALSE(fs::exists(here.path() / "arm/mechanism.toml"));
  REQUIRE(here.import("arm.urdf --out arm --force") == 0);
  REQUIRE(here.get("arm/identified.toml") == "kept");
  REQUIRE(fs::exists(here.path() / "arm/mechanism.toml"));
}

TEST_CASE("a wrong robot or wrong usage ends with status 2 and writes nothing", "[import]") {
  Workshop here;
  here.put("wrong.urdf", "<robot name='a'>\n<link/>\n</robot>");
  REQUIRE(here.import("wrong.urdf --out wrong") == 2);
  REQUIRE_THAT(here.get("err"), Catch::Contains("wrong.urdf:2:1: <link> has no name; expected"));
  REQUIRE(here.import("absent.urdf --out wrong") == 2);
  REQUIRE_THAT(here.get("err"), Catch::Contains("absent.urdf: cannot be read"));
  REQUIRE(here.import("arm.urdf") == 2);
  REQUIRE(here.import("arm.urdf --out wrong --gravity 1 2") == 2);
  REQUIRE(here.import("arm.urdf --out wrong --gravity 0 0 down") == 2);
  REQUIRE(here.import("arm.urdf --out wrong --gravity 0 0 inf") == 2);
  REQUIRE(here.import("arm.urdf --out arm.urdf/models/arm") == 2);
  REQUIRE_FALSE(fs::exists(here.path() / "wrong"));
}
