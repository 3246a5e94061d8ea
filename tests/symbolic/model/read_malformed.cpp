// SPDX-License-Identifier: GPL-3.0-or-later
// Every mistake in a description is reported where it stands, in words that help.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <random>

#include "symbolic/model/check_mechanism.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/read_urdf.h"
#include "tests/symbolic/model/malformed_case.h"

namespace malformed {

sinew::Mechanism read(Format format, std::string_view text) {
  if (format == Format::urdf) return sinew::parse_urdf(text, "file", {0, 0, -9.81});
  if (format == Format::toml) return sinew::parse_mechanism({text, sound_csv, "file", "csv"});
  return sinew::parse_mechanism({sound_toml, text, "toml", "file"});
}

std::vector<std::string> mistakes(Format format, std::string_view text) {
  try {
    read(format, text);
    return {};
  } catch (const sinew::DescriptionError& error) {
    return error.messages();
  }
}

std::string spoilt(std::string_view sound, const Case& edit) {
  const std::size_t at = sound.find(edit.from);
  INFO("edited part: " << edit.from);
  REQUIRE(at != std::string_view::npos);
  std::string text(sound);
  return text.replace(at, edit.from.size(), edit.to);
}

namespace {

/// "file:line:column: " of a position, columns counted in UTF-8 characters.
std::string place(std::string_view text, std::size_t position) {
  int line = 1, column = 1;
  for (const char c : text.substr(0, position)) {
    if (c == '\n')
      ++line, column = 1;
    else if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u)
      ++column;
  }
  return fmt::format("file:{}:{}: ", line, column);
}

}  // namespace

std::string expected_place(std::string_view text, std::string_view at) {
  if (at.empty()) return "";
  if (at == "^") return "file:1:1: ";
  const std::size_t position = text.find(at);
  INFO("marked place: " << at);
  REQUIRE(position != std::string_view::npos);
  return place(text, position);
}

void check_messages(const Case& each, std::string_view text,
                    const std::vector<std::string>& found) {
  const std::string where = expected_place(text, each.at);
  bool is_told = false;
  for (const std::string& message : found)
    is_told =
        is_told || (message.starts_with(where) && message.find(each.phrase) != std::string::npos);
  INFO("'" << each.from << "' -> '" << each.to << "'");
  INFO("expected " << where << " ... " << each.phrase);
  std::string list;
  for (const std::string& message : found) list += "\n  " + message;
  INFO("found " << found.size() << ":" << list);
  CHECK(is_told);
  for (const std::string& message : found) CHECK(message.find("; ") != std::string::npos);
}

namespace {

void check(Format format, std::string_view sound, const std::vector<Case>& cases) {
  REQUIRE(mistakes(format, sound).empty());
  for (const Case& each : cases) {
    const std::string text = spoilt(sound, each);
    check_messages(each, text, mistakes(format, text));
  }
}

}  // namespace
}  // namespace malformed

using namespace malformed;

TEST_CASE("mistakes in mechanism.toml", "[malformed]") {
  check(Format::toml, sound_toml, toml_cases());
}

TEST_CASE("mistakes in mass_properties.csv", "[malformed]") {
  check(Format::csv, sound_csv, csv_cases());
}

TEST_CASE("mistakes in URDF", "[malformed]") {
  check(Format::urdf, sound_urdf, urdf_cases());
}

TEST_CASE("the table of mistakes is long", "[malformed]") {
  REQUIRE(toml_cases().size() + csv_cases().size() + urdf_cases().size() >= 200);
}

TEST_CASE("all mistakes of a model folder are reported together", "[malformed]") {
  std::string toml(sound_toml);
  toml.replace(toml.find("\"revolute\""), 10, "\"revolte\"");
  toml.replace(toml.find("description"), 11, "descriptoin");
  std::string csv(sound_csv);
  csv.replace(csv.find("0.5"), 3, "-.5");
  try {
    sinew::parse_mechanism({toml, csv, "toml", "csv"});
    FAIL("read");
  } catch (const sinew::DescriptionError& error) {
    const std::string all = error.what();
    CHECK(all.find("'descriptoin' in mechanism (did you mean 'description'?)") !=
          std::string::npos);
    CHECK(all.find("'revolte' (did you mean 'revolute'?)") != std::string::npos);
    CHECK(all.find("the mass of 'upper' is -0.5 kg") != std::string::npos);
    CHECK(error.messages().size() == 3);
  }
}

namespace {

/// One random edit: a byte changed, a piece removed, doubled or moved.
std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const std::size_t at = below(text.size());
  const std::size_t size = below(std::min<std::size_t>(text.size() - at, 40) + 1);
  static constexpr std::string_view bytes = "\"'[]{}=,.-+e019<>/ \n\r\t#\\\0\xff\xc3";
  switch (random() % 4) {
    case 0:
      text[at] = bytes[below(bytes.size())];
      break;
    case 1:
      text.erase(at, size);
      break;
    case 2:
      text.insert(below(text.size()), text.substr(at, size));
      break;
    default:
      text.insert(at, 1, static_cast<char>(random() % 256));
      break;
  }
  return text;
}

/// Either a sound mechanism or messages; nothing else may come out.
void mutate(Format format, std::string_view sound, unsigned seed, int rounds) {
  std::mt19937 random(seed);
  int sound_ones = 0, refused = 0;
  for (int i = 0; i < rounds; ++i) {
    std::string text(sound);
    for (auto edits = 1 + random() % 3; edits > 0; --edits) text = mutated(std::move(text), random);
    try {
      sinew::require_sound(read(format, text));
      ++sound_ones;
    } catch (const sinew::DescriptionError& error) {
      ++refused;
      for (const std::string& message : error.messages())
        if (message.find("file:") != 0 && message.find("csv:") != 0 && message.find("toml:") != 0)
          FAIL(text << "\n" << message);
    }
  }
  INFO(sound_ones << " read, " << refused << " refused");
  REQUIRE(refused > rounds / 4);
  REQUIRE(sound_ones > rounds / 100);
}

}  // namespace

TEST_CASE("random edits give a sound mechanism or a located message", "[malformed]") {
  mutate(Format::toml, sound_toml, 1, 2000);
  mutate(Format::csv, sound_csv, 2, 2000);
  mutate(Format::urdf, sound_urdf, 3, 2000);
}
