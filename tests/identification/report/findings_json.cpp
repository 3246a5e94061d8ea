// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "identification/report/findings_json.h"
#include "tests/identification/report/example.h"
#include "tests/reference/temporary_folder.h"

using namespace sinew::diagnosis;
using Json = nlohmann::ordered_json;

namespace {

const Json& schema() {
  static const Json text =
      Json::parse(sinew::reference::read_text(SINEW_SOURCE_DIR "/docs/findings.schema.json"));
  return text;
}

bool is_of_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == "null" && value.is_null();
}

bool has_type(const Json& value, const Json& type) {
  if (type.is_string()) return is_of_type(value, type);
  return std::any_of(type.begin(), type.end(), [&](const Json& t) { return is_of_type(value, t); });
}

/// The first place where the value is not what the schema wants, empty where there is none. Knows
/// the words that docs/findings.schema.json uses.
std::string mismatch(const Json& value, const Json& wanted, const std::string& at = "") {
  if (wanted.contains("$ref")) {
    const std::string name = wanted["$ref"].get<std::string>().substr(8);
    return mismatch(value, schema()["$defs"].at(name), at);
  }
  if (!has_type(value, wanted.at("type"))) return at + ": type";
  if (wanted.contains("enum") &&
      std::find(wanted["enum"].begin(), wanted["enum"].end(), value) == wanted["enum"].end())
    return at + ": value";
  if (value.is_number() && wanted.contains("maximum") && value > wanted["maximum"])
    return at + ": too large";
  if (value.is_number() && wanted.contains("minimum") && value < wanted["minimum"])
    return at + ": too small";
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string inner =
          mismatch(value[i], wanted.at("items"), at + "/" + std::to_string(i));
      if (!inner.empty()) return inner;
    }
  if (!value.is_object()) return "";
  for (const Json& key : wanted.at("required"))
    if (!value.contains(key.get<std::string>())) return at + ": lacks " + key.get<std::string>();
  for (const auto& [key, item] : value.items()) {
    if (!wanted["properties"].contains(key)) return at + ": unknown " + key;
    const std::string inner = mismatch(item, wanted["properties"][key], at + "/" + key);
    if (!inner.empty()) return inner;
  }
  return "";
}

std::vector<Findings> all() {
  return {example::rich_drive(),        example::inseparable_pair(),
          example::none_of_the_known(), example::nothing_beyond_noise(),
          example::large_finger(),      example::empty(),
          example::hostile(),           example::lone_cause(),
          example::awkward_numbers()};
}

}  // namespace

TEST_CASE("findings.json is what its schema says") {
  for (const Findings& findings : all())
    CHECK(mismatch(Json::parse(findings_json(findings)), schema()) == "");
}

TEST_CASE("the comparison with the schema sees what is wrong") {
  const Json good = Json::parse(findings_json(example::rich_drive()));
  Json lacking = good, unknown = good, wrong = good, other = good, sure = good, negative = good;
  lacking["verdict"]["causes"][1].erase("confidence");
  unknown["channels"][0]["colour"] = "red";
  wrong["verdict"]["causes"][0]["parameters"][0]["value"] = "12";
  other["verdict"]["outcome"] = "perhaps";
  sure["verdict"]["causes"][0]["confidence"] = 0.98;
  negative["channels"][0]["unexplained_after"] = -0.1;
  CHECK(mismatch(lacking, schema()) == "/verdict/causes/1: lacks confidence");
  CHECK(mismatch(unknown, schema()) == "/channels/0: unknown colour");
  CHECK(mismatch(wrong, schema()) == "/verdict/causes/0/parameters/0/value: type");
  CHECK(mismatch(other, schema()) == "/verdict/outcome: value");
  CHECK(mismatch(sure, schema()) == "/verdict/causes/0/confidence: too large");
  CHECK(mismatch(negative, schema()) == "/channels/0/unexplained_after: too small");
}

TEST_CASE("every field of the schema is described in docs/findings.md") {
  const std::string text = sinew::reference::read_text(SINEW_SOURCE_DIR "/docs/findings.md");
  const auto described = [&](const Json& object) {
    for (const auto& [key, unused] : object["properties"].items()) {
      INFO(key);
      CHECK(text.find("`" + key + "`") != std::string::npos);
    }
  };
  described(schema());
  for (const auto& [name, definition] : schema()["$defs"].items()) described(definition);
}

TEST_CASE("keys come in one order, the same findings give the same bytes") {
  const std::string text = findings_json(example::rich_drive());
  CHECK(text == findings_json(example::rich_drive()));
  std::vector<std::string> keys;
  const Json parsed = Json::parse(text);
  for (const auto& [key, value] : parsed.items()) keys.push_back(key);
  CHECK(keys == std::vector<std::string>{"schema", "schema_version", "headline", "next_step",
                                         "model", "verdict", "terms", "channels", "extension",
                                         "logs", "seconds"});
}

TEST_CASE("the facts arrive unchanged") {
  const Json j = Json::parse(findings_json(example::rich_drive()));
  const Json& cause = j["verdict"]["causes"][0];
  CHECK(j["verdict"]["outcome"] == "causes named");
  CHECK(cause["members"][0]["name"] == "friction concave in speed");
  CHECK(cause["parameters"][0]["value"].get<double>() == 12.34);
  CHECK(j["verdict"]["held_out"] == j["channels"][0]["domains"][0]["gain"]);
  CHECK(j["logs"][1]["faults"].size() == 2);
  CHECK(Json::parse(findings_json(example::inseparable_pair()))["verdict"]["outcome"] ==
        "cannot tell");
  CHECK(Json::parse(findings_json(example::none_of_the_known()))["verdict"]["outcome"] ==
        "none of the known causes");
  CHECK(Json::parse(findings_json(example::nothing_beyond_noise()))["verdict"]["outcome"] ==
        "nothing beyond noise");
}

TEST_CASE("what is no number is null, what is no UTF-8 is replaced") {
  const Json j = Json::parse(findings_json(example::hostile()));
  CHECK(j["channels"][0]["measured_rms"].is_null());
  CHECK(j["channels"][0]["noise_floor"].is_null());
  CHECK(j["channels"][0]["domains"][0]["gain"]["low"].is_null());
  CHECK(j["channels"][0]["plots"][0]["series"][0]["y"].empty());
  CHECK(j["model"]["kind"] == "\uFFFD\uFFFD not UTF-8");
}
