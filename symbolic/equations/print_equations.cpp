// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "symbolic/equations/equations.h"

namespace sinew {
namespace {

constexpr const char* source_line =
    "Numbers in parentheses are those of the equations in the source that the project implements "
    "(docs/source_errata.md says where the two differ)";

/// Whether the values are told: what is not an argument.
std::string value_text(const EquationSymbol& symbol) {
  return symbol.value ? fmt::format("{:.6g}", *symbol.value) : "";
}

std::string latex_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("#$%&_{}").find(c) != std::string_view::npos)
      out += fmt::format("\\{}", c);
    else if (c == '^' || c == '~')
      out += fmt::format("\\{}{{}}", c);
    else if (c == '\\')
      out += "\\textbackslash{}";
    else
      out += c;
  }
  return out;
}

std::string html_escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

std::string shown(const EquationPage& page, const std::string& name) {
  const auto found = page.shown.find(name);
  return found == page.shown.end() ? name : found->second;
}

std::string latex_document(const EquationPage& page) {
  std::string text = fmt::format(
      "\\documentclass[a4paper]{{article}}\n\\usepackage{{amsmath,longtable}}\n"
      "\\allowdisplaybreaks\n\\begin{{document}}\n\\section*{{{}}}\n{}.\n",
      latex_escaped(page.title), latex_escaped(source_line));
  for (const EquationSection& section : page.sections) {
    text += fmt::format("\n\\subsection*{{{}{}}}\n{}\n", latex_escaped(section.title),
                        section.source.empty() ? "" : " " + section.source,
                        latex_escaped(section.text));
    if (section.equations.empty()) continue;
    std::string rows;
    for (const ReadableEquation& equation : section.equations)
      rows += (rows.empty() ? "" : " \\\\\n") +
              latex_equation(shown(page, equation.left), equation.right, page.shown);
    text += "\\begin{align*}\n" + rows + "\n\\end{align*}\n";
  }
  text +=
      "\n\\subsection*{Symbols}\n\\begin{longtable}{llrll}\nsymbol & meaning & value & unit & "
      "origin \\\\ \\hline\n";
  for (const EquationSymbol& symbol : page.symbols)
    text += fmt::format("${}$ & {} & {} & {} & {} \\\\\n", latex_name(symbol.name),
                        latex_escaped(symbol.meaning), value_text(symbol),
                        latex_escaped(symbol.unit), latex_escaped(symbol.origin));
  return text + "\\end{longtable}\n\\end{document}\n";
}

std::string html_document(const EquationPage& page) {
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
             "name=\"viewport\" "
             "content=\"width=device-width\"><title>{0}</"
             "title>\n<style>body{{font-family:sans-serif;"
             "max-width:70em;margin:auto;padding:1em}}math{{overflow-x:auto;display:block}}td "
             "math{{"
             "display:inline}}td,th{{text-align:left;padding:0 1em 0 0}}</style></head><body>\n"
             "<h1>{0}</h1>\n",
             html_escaped(page.title)) +
         html_sections(page, 2, false) + "</body></html>\n";
}

std::string text_document(const EquationPage& page) {
  std::string text = fmt::format("{}\n\n{}.\n", page.title, source_line);
  for (const EquationSection& section : page.sections) {
    text += fmt::format("\n{}{}\n  {}\n\n", section.title,
                        section.source.empty() ? "" : " " + section.source, section.text);
    for (const ReadableEquation& equation : section.equations)
      text +=
          "    " + plain_equation(shown(page, equation.left), equation.right, page.shown) + "\n";
  }
  text += "\nSymbols\n\n";
  for (const EquationSymbol& symbol : page.symbols)
    text +=
        fmt::format("    {:<16} {}{}{}\n", symbol.name, symbol.meaning,
                    symbol.value || !symbol.unit.empty()
                        ? fmt::format("; {}{}{}", value_text(symbol),
                                      symbol.value && !symbol.unit.empty() ? " " : "", symbol.unit)
                        : "",
                    symbol.origin.empty() ? "" : "; " + symbol.origin);
  return text;
}

}  // namespace

std::string html_sections(const EquationPage& page, int level, bool folds) {
  std::string text = fmt::format("<p>{}.</p>\n", html_escaped(source_line));
  for (const EquationSection& section : page.sections) {
    text += folds ? "<details><summary>" : fmt::format("<h{}>", level);
    text += html_escaped(section.title) +
            (section.source.empty() ? "" : " " + html_escaped(section.source));
    text += folds ? "</summary><div class=\"inside\">\n" : fmt::format("</h{}>\n", level);
    text += "<p>" + html_escaped(section.text) + "</p>\n";
    for (const ReadableEquation& equation : section.equations)
      text += "<div class=\"math\" tabindex=\"0\" role=\"region\" aria-label=\"equation\">" +
              mathml_equation(shown(page, equation.left), equation.right, page.shown) + "</div>\n";
    if (folds) text += "</div></details>\n";
  }
  text += fmt::format(
      "<h{0}>Symbols</h{0}>\n<table><thead><tr><th scope=\"col\">symbol</th><th "
      "scope=\"col\">meaning"
      "</th><th scope=\"col\">value</th><th scope=\"col\">unit</th><th "
      "scope=\"col\">origin</th></tr>"
      "</thead><tbody>\n",
      level);
  for (const EquationSymbol& symbol : page.symbols)
    text += fmt::format(
        "<tr><th scope=\"row\"><math>{}</math></th><td data-label=\"meaning\">{}</td><td "
        "data-label=\"value\">{}</td><td data-label=\"unit\">{}</td><td "
        "data-label=\"origin\">{}</td>"
        "</tr>\n",
        mathml_name(symbol.name), html_escaped(symbol.meaning), value_text(symbol),
        html_escaped(symbol.unit), html_escaped(symbol.origin));
  return text + "</tbody></table>\n";
}

std::string printed(const EquationPage& page, EquationFormat format) {
  switch (format) {
    case EquationFormat::latex:
      return latex_document(page);
    case EquationFormat::mathml:
      return html_document(page);
    case EquationFormat::text:
      break;
  }
  return text_document(page);
}

}  // namespace sinew
