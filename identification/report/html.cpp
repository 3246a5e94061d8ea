// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/html.h"

#include "identification/report/page.h"
#include "identification/report/sections.h"
#include "identification/report/wording.h"

namespace sinew::diagnosis {
namespace {

struct Entry {
  const char* id;
  const char* name;
};
constexpr Entry kEntries[] = {
    {"channels", "Before and after"},
    {"pictures", "Plots"},
    {"terms", "The equation"},
    {"ranking", "Evidence"},
    {"unexplained", "Still unexplained"},
    {"extension", "The model"},
    {"logs", "Logs"},
    {"method", "Method"},
};

std::string contents(const std::string& body) {
  std::string items;
  for (const Entry& entry : kEntries) {
    const std::string id = entry.id;
    if (body.find("<section id=\"" + id + "\"") != std::string::npos)
      items += "<li><a href=\"#" + id + "\">" + entry.name + "</a></li>\n";
  }
  return "<nav aria-label=\"Sections\"><ul class=\"toc\">\n" + items + "</ul></nav>\n";
}

std::string head(const Findings& findings) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'\">\n<title>" +
         escaped("Diagnosis of " + findings.model + ": " + headline_of(findings)) +
         "</title>\n<style>" + page_style() + "</style>\n</head>\n<body>\n<main>\n";
}

}  // namespace

std::string report_html(const Findings& findings) {
  const std::string body = channel_section(findings) + term_section(findings) +
                           ranking_section(findings) + unexplained_section(findings) +
                           extension_section(findings) + log_section(findings) +
                           method_section(findings);
  return head(findings) + first_screen(findings) + contents(body) + body +
         "<footer><p>Written by sinew. findings.json beside this file has the same facts for "
         "programs.</p></footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace sinew::diagnosis
