// SPDX-License-Identifier: GPL-3.0-or-later
// cost and dump.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/cli/program.h"

using namespace sinew;
using nlohmann::json;

namespace {

constexpr const char* model = "models/index";

}  // namespace

TEST_CASE("cost agrees with the manifest, function by function") {
  const Workplace here;
  REQUIRE(here.sinew({"generate", model}).status == 0);
  const json manifest = json::parse(here.text("generated/index/manifest.json"));
  const json costs = json::parse(here.sinew({"cost", model, "--json"}).output);
  REQUIRE(costs.size() == manifest["functions"].size());
  const Ended table = here.sinew({"cost", model});
  CHECK(table.status == 0);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    json operations = costs[i];
    const std::string name = operations["function"];
    operations.erase("function");
    INFO(name);
    CHECK("index_" + name == manifest["functions"][i]["name"]);
    CHECK(operations == manifest["functions"][i]["operations"]);
    CHECK(table.says(name));
  }
}

TEST_CASE("cost and dump take the targets that generate takes") {
  const Workplace here;
  const json plain = json::parse(here.sinew({"cost", model, "--json"}).output);
  const json fused = json::parse(here.sinew({"cost", model, "--json", "--fma"}).output);
  const json small =
      json::parse(here.sinew({"cost", model, "--json", "--optimise", "size"}).output);
  REQUIRE(fused.size() == plain.size());
  REQUIRE(small.size() == plain.size());
  int fused_operations = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    INFO(plain[i]["function"]);
    CHECK(!plain[i].contains("fused"));
    // a product that two sums take in is computed in both
    CHECK(fused[i]["multiply_add"].get<int>() - fused[i]["fused"].get<int>() <=
          plain[i]["multiply_add"].get<int>());
    fused_operations += fused[i]["fused"].get<int>();
    CHECK(small[i]["multiply_add"] == plain[i]["multiply_add"]);
    CHECK(small[i]["copies"].get<int>() == (plain[i]["sincos"] > 0 ? 1 : 0));
  }
  CHECK(fused_operations > 100);
  const Ended table = here.sinew({"cost", model, "--fma", "--optimise", "size"});
  CHECK(table.says("fused"));
  CHECK(table.says("copies"));
  const json gains = json::parse(here.sinew({"cost", model, "--passes", "--fma", "--json"}).output);
  bool fuse_helps = false;
  for (const json& row : gains["gains"])
    if (row["pass"] == "fuse") fuse_helps = row["multiply_add"] > 100;
  CHECK(fuse_helps);

  const Ended dumped = here.sinew({"dump", model, "--function", "bias", "--fma"});
  CHECK(dumped.status == 0);
  CHECK(dumped.says(" = fma "));
  CHECK(!here.sinew({"dump", model, "--function", "bias"}).says(" = fma "));
  CHECK(here.sinew({"dump", model, "--function", "bias", "--fma", "--after", "fuse"}).status == 0);
  const Ended no_such_pass = here.sinew({"dump", model, "--function", "bias", "--after", "fuse"});
  CHECK(no_such_pass.status == 2);
  CHECK(no_such_pass.says("expected --fma with it"));
}

TEST_CASE("cost --passes tells what each pass brings") {
  const Workplace here;
  const Ended table = here.sinew({"cost", model, "--passes"});
  CHECK(table.status == 0);
  const json report = json::parse(here.sinew({"cost", model, "--passes", "--json"}).output);
  CHECK(report["multiply_add"] > 100);
  std::set<std::string> names;
  for (const json& row : report["gains"]) {
    CHECK(names.insert(row["pass"]).second);
    CHECK(table.says(row["pass"].get<std::string>()));
    CHECK(row["multiply_add"].is_number_integer());
  }
  for (const char* pass : {"share", "fold_constants", "factor_sums", "remove_dead", "schedule"})
    CHECK(names.count(pass) == 1);
}

TEST_CASE("cost --reduced sets the error against the operations saved") {
  const Workplace here;
  const Ended table = here.sinew({"cost", model, "--reduced"});
  CHECK(table.status == 0);
  CHECK(table.says("Coriolis"));
  const json rows = json::parse(here.sinew({"cost", model, "--reduced", "--json"}).output);
  REQUIRE(rows.size() == 3);
  for (const json& row : rows) CHECK(row["multiply_add_left"] <= row["multiply_add"]);
  // Gravity carries most of a light finger's torque; its pulleys' arms are constant.
  CHECK(rows[0]["rms_error"] > rows[1]["rms_error"]);
  CHECK(rows[1]["rms_error"] > 0.01);
  CHECK(rows[1]["multiply_add_left"] < rows[1]["multiply_add"]);
  CHECK(rows[2]["largest_error"] == 0.0);

  // Where there is no gravity, leaving it out costs nothing.
  here.change("models/index/mechanism.toml", "value = [0, 0, -9.81]", "value = [0, 0, 0]");
  const json weightless = json::parse(here.sinew({"cost", model, "--reduced", "--json"}).output);
  CHECK(weightless[0]["largest_error"] == 0.0);
  CHECK(weightless[0]["multiply_add_left"] == weightless[0]["multiply_add"]);
  CHECK(weightless[1]["rms_error"] > rows[1]["rms_error"]);
}

TEST_CASE("dump shows any stage, as text and as dot") {
  const Workplace here;
  const Ended lowered = here.sinew({"dump", model, "--function", "bias", "--after", "lower"});
  const Ended last = here.sinew({"dump", model, "--function", "bias"});
  CHECK(lowered.status == 0);
  CHECK(last.status == 0);
  CHECK(lowered.output.rfind("function bias\n", 0) == 0);
  CHECK(lowered.output != last.output);
  CHECK(here.sinew({"dump", model, "--function", "bias", "--after", "schedule"}).output ==
        last.output);
  const Ended dot = here.sinew({"dump", model, "--function", "bias", "--after", "lower", "--dot"});
  CHECK(dot.status == 0);
  CHECK(dot.output.rfind("digraph bias {", 0) == 0);
  CHECK(dot.output.ends_with("}\n"));
}
