// SPDX-License-Identifier: GPL-3.0-or-later
// A CAD change through the program: a new wrist width and a new pulley radius. The summary names
// the functions that change and by how much; the hand and the figures follow.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/parts/part.h"
#include "symbolic/tendons/functions.h"
#include "tests/cli/program.h"

using namespace sinew;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string source = SINEW_SOURCE_DIR;

/// Every model and all that is emitted for them, as committed.
struct CadOffice : Workplace {
  CadOffice() {
    fs::remove_all(path("models"));
    fs::copy(source + "/models", path("models"), fs::copy_options::recursive);
    fs::copy(source + "/generated", path("generated"), fs::copy_options::recursive);
  }
};

/// Functions of an emitted C file, name -> text.
std::map<std::string, std::string> functions_in(const std::string& code) {
  std::map<std::string, std::string> functions;
  for (std::size_t at = code.find("\nvoid "); at != std::string::npos;) {
    const std::size_t next = code.find("\nvoid ", at + 1), name = at + 6;
    functions[code.substr(name, code.find('(', name) - name)] = code.substr(at, next - at);
    at = next;
  }
  return functions;
}

std::set<std::string> differing(const std::string& before, const std::string& after) {
  const auto old = functions_in(before), now = functions_in(after);
  std::set<std::string> names;
  for (const auto& [name, text] : now)
    if (!old.count(name) || old.at(name) != text) names.insert(name);
  return names;
}

std::set<std::string> reported(const json& model) {
  std::set<std::string> names;
  for (const json& change : model["changes"])
    if (change["change"] != "unchanged") names.insert(change["name"]);
  return names;
}

/// Argument -> values of one function in one state of a reference.csv.
std::map<std::string, std::vector<double>> row_values(const std::string& csv,
                                                      const std::string& function,
                                                      const std::string& state) {
  std::map<std::string, std::vector<double>> rows;
  const std::string start = "\n" + function + "," + state + ",";
  for (std::size_t at = csv.find(start); at != std::string::npos; at = csv.find(start, at + 1)) {
    const std::size_t name = at + start.size(), comma = csv.find(',', name),
                      end = csv.find('\n', name);
    std::vector<double>& values = rows[csv.substr(name, comma - name)];
    for (std::size_t next = comma; next < end; next = csv.find(',', next + 1))
      values.push_back(std::stod(csv.substr(next + 1)));
  }
  return rows;
}

/// Largest change of each result of `function`, evaluated by the derivations before and after.
std::vector<double> expected_changes(const Function& before, const Function& after,
                                     const std::map<std::string, std::vector<double>>& rows) {
  std::vector<double> inputs;
  for (const Argument& argument : before.inputs)
    inputs.insert(inputs.end(), rows.at(argument.name).begin(), rows.at(argument.name).end());
  const std::vector<double> old = evaluate(before, inputs), now = evaluate(after, inputs);
  std::vector<double> changes;
  std::size_t next = 0;
  for (const Output& output : before.outputs) {
    changes.push_back(0);
    for (std::size_t i = 0; i < output.values.size(); ++i, ++next)
      changes.back() = std::max(changes.back(), std::abs(now[next] - old[next]));
  }
  return changes;
}

/// The summary's numbers against the derivations', for every function that changed.
void check_magnitudes(const json& model, const std::string& old_reference,
                      const std::vector<Function>& before, const std::vector<Function>& after) {
  for (const json& change : model["changes"]) {
    if (change["change"] != "changed") continue;
    const std::string name = change["name"];
    for (std::size_t k = 0; k < before.size(); ++k) {
      if (model["model"].get<std::string>() + "_" + before[k].name != name) continue;
      const auto expected =
          expected_changes(before[k], after[k], row_values(old_reference, name, "reference"));
      REQUIRE(change["results"].size() == expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        INFO(name << " " << change["results"][i]["name"]);
        const double found = change["results"][i]["reference"]["largest"];
        CHECK(found == Approx(expected[i]).epsilon(1e-6).margin(1e-11));
      }
    }
  }
}

std::vector<Function> index_functions(const fs::path& folder) {
  return functions_of(read_mechanism(folder));
}

std::vector<Function> wrist_functions_in(const fs::path& folder) {
  return functions_of(read_part(folder));
}

}  // namespace

TEST_CASE("a new pulley radius: the summary names what changes, and by how much", "[cad]") {
  const CadOffice here;
  const std::string code = here.text("generated/index/index.c"),
                    reference = here.text("generated/index/reference.csv");
  here.change("models/index/mechanism.toml", "r22 = { value = 0.0055", "r22 = { value = 0.0060");
  const Ended shown = here.sinew({"check", "models/index"});
  CHECK(shown.status == 1);
  CHECK(shown.says("index_coupling_matrix"));
  CHECK(here.text("generated/index/index.c") == code);
  const Ended ended = here.sinew({"generate", "models/index", "--json"});
  REQUIRE(ended.status == 0);
  const json model = json::parse(ended.output);
  const std::set<std::string> tendons{"index_tendon_lengths", "index_coupling_matrix",
                                      "index_joint_torque",   "index_joint_stiffness",
                                      "index_link_position",  "index_link_position_covariance"};
  CHECK(reported(model) == tendons);
  CHECK(reported(model) == differing(code, here.text("generated/index/index.c")));
  check_magnitudes(model, reference, index_functions(source + "/models/index"),
                   index_functions(here.path("models/index")));
  // By hand: h5 grows by 0.5 mm a radian, and q22's reference is the middle of its range.
  for (const json& change : model["changes"])
    if (change["name"] == "index_tendon_lengths")
      CHECK(change["results"][0]["reference"]["largest"].get<double>() ==
            Approx(0.0005 * 0.7).epsilon(1e-12));
  REQUIRE(model["left_behind"].size() == 1);
  CHECK(model["left_behind"][0] == "models/hand");
  const Ended again = here.sinew({"generate", "models/index"});
  CHECK(again.says("no function changed"));
  CHECK(again.says("models/hand has to follow: sinew generate models/hand"));
}

TEST_CASE("a new wrist width: the hand follows in the same run, and the figures", "[cad][slow]") {
  const CadOffice here;
  const std::string wrist = here.text("generated/wrist/wrist.c"),
                    hand = here.text("generated/hand/hand.c"),
                    reference = here.text("generated/wrist/reference.csv");
  here.change("models/wrist/part.toml", "width = { value = 0.042", "width = { value = 0.043");
  const Ended ended = here.sinew({"generate", "models/wrist", "--dependents", "--json"});
  INFO(ended.output);
  REQUIRE(ended.status == 0);
  const json run = json::parse(ended.output);
  REQUIRE(run["models"].size() == 2);
  const json &first = run["models"][0], &second = run["models"][1];
  CHECK(first["model"] == "wrist");
  CHECK(second["model"] == "hand");
  CHECK(first["left_behind"].empty());
  CHECK(reported(first) == differing(wrist, here.text("generated/wrist/wrist.c")));
  CHECK(reported(second) == differing(hand, here.text("generated/hand/hand.c")));
  CHECK(reported(second).count("hand_tendon_lengths") == 1);
  check_magnitudes(first, reference, wrist_functions_in(source + "/models/wrist"),
                   wrist_functions_in(here.path("models/wrist")));
  CHECK(here.sinew({"check", "models/hand"}).status == 0);
}

TEST_CASE("what has to follow is found from inside the model's folder, too", "[cad]") {
  const CadOffice here;
  here.change("models/hmc/part.toml", "crank = { value = 10", "crank = { value = 10.1");
  const Ended ended = Workplace::sinew_in(
      here.path("models/hmc"), {"generate", ".", "--out", here.path("generated/hmc").string()});
  INFO(ended.output);
  CHECK(ended.status == 0);
  CHECK(ended.says("models/hand has to follow"));
}

TEST_CASE("a mistake in one of several models leaves all of them as they were", "[cad]") {
  const CadOffice here;
  for (const char* model :
       {"thumb", "thumb_table_5_2", "index", "middle", "ring", "fifth", "wrist", "hand", "effects"})
    fs::remove_all(here.path("models") / model);
  here.change("models/hmc/part.toml", "crank = { value = 10", "crank = { value = 10.1");
  const std::string before = here.text("generated/hmc/hmc.c");
  here.change("models/motor/part.toml", "gamma1", "gama1");
  const Ended refused = here.sinew({"generate", "models"});
  CHECK(refused.status == 2);
  CHECK(refused.says("(did you mean 'gamma1'?)"));
  CHECK(here.text("generated/hmc/hmc.c") == before);
  here.change("models/motor/part.toml", "gama1", "gamma1");
  const Ended written = here.sinew({"generate", "models"});
  CHECK(written.status == 0);
  CHECK(written.says("hmc_four_bar"));
  CHECK(here.text("generated/hmc/hmc.c") != before);
}

TEST_CASE("without values from before the summary says so", "[cad]") {
  const CadOffice here;
  fs::remove(here.path("generated/hmc/reference.csv"));
  here.change("models/hmc/part.toml", "crank = { value = 10", "crank = { value = 10.1");
  const Ended ended = here.sinew({"generate", "models/hmc"});
  INFO(ended.output);
  CHECK(ended.status == 0);
  CHECK(ended.says("no values known from before"));
  CHECK(here.sinew({"check", "models/hmc"}).status == 0);
  const Ended fresh = here.sinew({"generate", "models/hmc", "--out", "new"});
  CHECK(fresh.says("functions are new"));
}

TEST_CASE("figures follow a wrist's new width", "[cad][slow]") {
  const CadOffice here;
  const auto draw = [&](const std::string& out) {
    return here.sinew({"figures", "--chapter", "5", "--chapter", "6", "--out", out, "--runtime",
                       source + "/runtime"});
  };
  REQUIRE(draw("before").status == 0);
  here.change("models/wrist/part.toml", "width = { value = 0.042", "width = { value = 0.043");
  REQUIRE(here.sinew({"generate", "models/wrist"}).status == 0);
  REQUIRE(draw("after").status == 0);
  const auto follows = [&](const std::string& figure) {
    return here.text("before/" + figure + ".csv") != here.text("after/" + figure + ".csv");
  };
  for (const char* figure : {"figure_6_09", "figure_6_10", "figure_6_12"}) CHECK(follows(figure));
  CHECK_FALSE(follows("figure_5_16"));
}
