// SPDX-License-Identifier: GPL-3.0-or-later
// Text from outside in messages: escaped, in one line, of readable length.
#include "symbolic/files/readable.h"

#include <catch2/catch.hpp>

#include "symbolic/files/description_error.h"
#include "symbolic/files/limits.h"

using namespace sinew;

// Planted: readable() and readable_line() giving their text back turned 23 checks of this file red.
TEST_CASE("what a terminal would act upon is escaped, what is read stays", "[readable]") {
  const std::vector<std::pair<std::string, std::string>> table{
      {"tau_m [N·m] 关节 é 🤖", "tau_m [N·m] 关节 é 🤖"},
      {"a\x1b[31mb", "a\\u001b[31mb"},
      {"a\rb\bc\x7f", "a\\u000db\\u0008c\\u007f"},
      {std::string("a\0b", 3), "a\\u0000b"},
      {"\xc2\x9b"
       "31m",
       "\\u009b31m"},
      {"\u202eevil\u202c \u2066x\u2069 \u200f \u061c",
       "\\u202eevil\\u202c \\u2066x\\u2069 \\u200f \\u061c"},
      {"a\u2028b\ufeff", "a\\u2028b\\ufeff"},
      {"\xff \xc3", "\\xff \\xc3"},
      {"\x9b", "\\x9b"},
      {"\xc0\x9b", "\\xc0\\x9b"},                     // longer than need be
      {"\xed\xa0\x80", "\\xed\\xa0\\x80"},            // a surrogate
      {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"}};  // beyond U+10FFFF
  for (const auto& [raw, shown] : table) {
    CHECK(readable(raw) == shown);
    CHECK(readable_line(raw) == shown);
    CHECK(readable(shown) == shown);
  }
  CHECK(readable("a\n\tb") == "a\n\tb");
  CHECK(readable_line("a\n\tb") == "a\\n\\tb");
}

TEST_CASE("long text and long lists are cut, and say by how much", "[readable]") {
  const std::string text = shortened(std::string(1'000'000, 'x'), 600);
  CHECK(text.size() < 700);
  CHECK(text.find("(999500 bytes left out)") != std::string::npos);
  CHECK(shortened("short", 600) == "short");
  // Nothing is cut inside a character.
  std::string umlauts;
  for (int i = 0; i < 1000; ++i) umlauts += "ä";
  for (const std::size_t longest : {600u, 601u, 602u, 603u})
    CHECK(readable(shortened(umlauts, longest)).find('\\') == std::string::npos);

  std::vector<std::string> names;
  for (int i = 0; i < 5000; ++i) names.push_back("joint_" + std::to_string(i));
  const std::string list = listed(names);
  CHECK(list.size() < 1000);
  CHECK(list.find(" and 4970 more") != std::string::npos);
  CHECK(listed({"a", "b"}) == "a, b");

  std::string lines;
  for (int i = 0; i < 100000; ++i) lines += "line\n";
  CHECK(message_lines(lines).size() < 2000);
  CHECK(message_lines("one\ntwo") == "one\ntwo");
}

TEST_CASE("findings are escaped, shortened and counted", "[readable]") {
  Findings findings;
  findings.add({"a\nb\x1b.toml", 3, 4}, "name '\x1b[2J\nc' is unknown",
               std::string(1'000'000, 'y'));
  for (int i = 0; i < 1000; ++i)
    for (int twice = 0; twice < 2; ++twice) findings.add({"file", i, 1}, "wrong", "expected right");
  try {
    findings.raise_if_any();
    FAIL("not raised");
  } catch (const DescriptionError& error) {
    REQUIRE(error.messages().size() == limits::shown_mistakes + 1);
    CHECK(error.messages()[0].starts_with(
        "a\\nb\\u001b.toml:3:4: name '\\u001b[2J\\nc' is unknown; yyy"));
    CHECK(error.messages()[0].size() < 1500);
    CHECK(error.messages().back() == "file: and 901 more mistakes; mend these first");
  }
}
