// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "identification/report/html.h"
#include "tests/identification/report/browser.h"
#include "tests/identification/report/example.h"
#include "tests/skip.h"

using namespace sinew;
using namespace sinew::diagnosis;
using namespace sinew::report;

namespace {

bool no_browser() {
  if (!browser().empty()) return false;
  test::skip("no browser is installed (chromium)");
  return true;
}

std::vector<Shown> all_at(int width, int height) {
  const auto shown = [&](const char* name, const Findings& findings) {
    return Shown{name, report_html(findings), width, height};
  };
  return {shown("rich", example::rich_drive()),
          shown("pair", example::inseparable_pair()),
          shown("none", example::none_of_the_known()),
          shown("noise", example::nothing_beyond_noise()),
          shown("empty", example::empty()),
          shown("hostile", example::hostile()),
          shown("lone", example::lone_cause()),
          shown("awkward", example::awkward_numbers()),
          shown("finger", example::large_finger())};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string without_policy(const std::string& html) {
  return replaced(html, "<meta http-equiv=\"Content-Security-Policy\"", "<meta name=\"off\"");
}

void check_quiet(const Visit& visited) {
  for (const std::string& line : visited.complaints) INFO(line);
  CHECK(visited.complaints.empty());
  for (const Seen& seen : visited.seen) {
    INFO(seen.name << " at " << seen.width);
    CHECK(seen.requests == 0);
    CHECK(seen.content_width <= seen.width);
    CHECK(seen.widest_element <= seen.width);
    // Planted defect: with the drawing's own 460 x 300 for every plot (with_labels() left away in
    // svg.cpp) labels of "awkward" are cut.
    CHECK(seen.cut_labels == 0);
    CHECK((seen.labels > 0) == (seen.pictures > 0));
  }
}

}  // namespace

TEST_CASE("a desktop shows every report without a complaint, a request or sideways scrolling",
          "[slow]") {
  if (no_browser()) return;
  const Visit visited = visit(all_at(1280, 900));
  check_quiet(visited);
  const Seen& rich = visited.seen.front();
  CHECK(rich.width == 1280);
  CHECK(rich.pictures == 5);
  CHECK(rich.equations > 8);
  // Headline, what to do and the first verdict without scrolling.
  CHECK(rich.first_card > 0);
  CHECK(rich.first_card <= 900);
  CHECK(rich.next_step > 0);
  CHECK(rich.next_step <= 900);
}

TEST_CASE("a phone shows every report without sideways scrolling, with legible pictures",
          "[slow]") {
  if (no_browser()) return;
  const Visit visited = visit(all_at(390, 844));
  check_quiet(visited);
  CHECK(visited.seen.front().width == 390);
  CHECK(visited.seen.front().smallest_text >= 10);
  CHECK(visited.seen.front().next_step <= 844);
}

TEST_CASE("the report opened as a file is silent") {
  if (no_browser()) return;
  CHECK(complaints_of_file(report_html(example::rich_drive())).empty());
}

TEST_CASE("what would spoil a report is seen", "[slow]") {
  if (no_browser()) return;
  const std::string html = report_html(example::inseparable_pair());
  const std::string picture = "<main>\n<img alt=\"\" src=\"http://127.0.0.1:9/planted.png\">";
  const std::string script = "<main>\n<script>throw new Error('planted')</script>";
  const std::string wide = "<main>\n<div style=\"width:2000px\">planted</div>";
  SECTION("a request, forbidden by the page's policy") {
    CHECK_FALSE(visit({{"x", replaced(html, "<main>", picture), 390, 844}}).complaints.empty());
  }
  SECTION("a request that is let through") {
    const Visit visited =
        visit({{"x", without_policy(replaced(html, "<main>", picture)), 390, 844}});
    CHECK(visited.seen.front().requests > 0);
  }
  SECTION("a script's error") {
    CHECK_FALSE(visit({{"x", replaced(html, "<main>", script), 390, 844}}).complaints.empty());
    CHECK_FALSE(complaints_of_file(without_policy(replaced(html, "<main>", script))).empty());
  }
  SECTION("an element that is too wide") {
    const Visit visited = visit({{"x", replaced(html, "<main>", wide), 390, 844}});
    CHECK(visited.seen.front().content_width > 390);
    CHECK(visited.seen.front().widest_element > 390);
  }
  SECTION("a label that is cut off") {
    const std::string label =
        "<main>\n<svg viewBox=\"0 0 40 40\" width=\"40\"><text x=\"-3\" "
        "y=\"20\">−1</text></svg>";
    const Seen clean = visit({{"x", html, 390, 844}}).seen.front();
    CHECK(visit({{"x", replaced(html, "<main>", label), 390, 844}}).seen.front().cut_labels ==
          clean.cut_labels + 1);
  }
}
