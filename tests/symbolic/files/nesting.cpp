// SPDX-License-Identifier: GPL-3.0-or-later
// Texts whose nesting would overflow a recursive reader's stack are told before it sees them.
#include <catch2/catch.hpp>

#include "symbolic/files/limits.h"
#include "symbolic/files/toml_nesting.h"
#include "symbolic/files/toml_reader.h"
#include "symbolic/files/xml_nesting.h"

using namespace sinew;

namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// Messages of parse_toml.
std::string toml_messages(const std::string& text) {
  Findings findings;
  std::map<std::string, std::string> provenance;
  parse_toml(text, {"file.toml", findings, provenance});
  try {
    findings.raise_if_any();
    return "";
  } catch (const DescriptionError& error) {
    return error.what();
  }
}

}  // namespace

// Planted: without the check in parse_toml the first text ends the test program by a stack
// overflow.
TEST_CASE("TOML nested too deep is refused with its place", "[limits]") {
  constexpr int many = 100000;
  for (const std::string& text :
       {repeated("a.", many) + "a = 1", "[" + repeated("a.", many) + "a]",
        "a = " + repeated("[", many) + repeated("]", many),
        "a = " + repeated("{a = ", many) + "1" + repeated("}", many),
        "a = {" + repeated("b.", many) + "b = 1}", repeated("\"x\" . ", many) + "a = 1",
        repeated("'.'.", many) + "a = 1"}) {
    const std::string found = toml_messages(text);
    CHECK(found.starts_with("file.toml:1:"));
    CHECK(found.find("nested deeper than 32 levels; expected") != std::string::npos);
  }
  CHECK(toml_messages("# ok\nb = 1\n" + repeated("a.", 40) + "a = 1").starts_with("file.toml:3:"));
}

TEST_CASE("dots and brackets of strings, comments and numbers are no nesting", "[limits]") {
  const std::string dots = repeated(".[{", 1000);
  CHECK(toml_messages("a = \"" + dots + "\" # " + dots + "\nb = '" + dots + "'") == "");
  CHECK(toml_messages("a = \"\"\"\n\\\"" + dots + "\n\"\"\"\nb = '''\n" + dots + "\n'''") == "");
  CHECK(toml_messages("a = [" + repeated("1.5, ", 1000) + "2.5]") == "");
  CHECK(toml_messages(repeated("[[a]]\nb.c = 1\n", 1000)) == "");
  CHECK(toml_messages(repeated("a.", 30) + "a = 1") == "");
}

// Planted: a check that counts '<' and '>' alone takes an attribute's "/>" or a comment's "</a>"
// for markup: 13 checks red here, and a URDF nested so ended the reader by a stack overflow.
TEST_CASE("the depth of XML is never underrated", "[limits]") {
  constexpr int many = 10000;
  for (const char* element :
       {"<a>", "<a x=\"/>\">", "<a x='/>' y=\"'/>\">", "<a><!-- </a> -->", "<_a>",
        "<a><?xml version=\"></a>\"?>", "<a><![CDATA[</a>]]>", "<a>\"<b/>", "<\xc3\xa4>"}) {
    INFO(element);
    CHECK(nesting_depth(repeated(element, many)) >= many);
    CHECK(nesting_depth(repeated("</a>", many) + repeated(element, many)) >= many);
  }
  CHECK(nesting_depth("<?xml version='1.0'?><a><b/><b x=\"1\"/><!-- <c><c> --><b></b></a>") == 2);
}
