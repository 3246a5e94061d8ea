// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/xml_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "symbolic/files/identifier.h"
#include "symbolic/files/limits.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

using Names = std::vector<std::string>;

/// The numbers of an attribute, separated by blanks; nothing if a word is none.
std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t at = 0;
       (at = text.find_first_not_of(" \t\r\n", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    std::string_view word = text.substr(at, end - at);
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    double number = 0.0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || stop != word.data() + word.size()) return std::nullopt;
    numbers.push_back(number);
    at = end;
  }
  return numbers;
}

const TiXmlAttribute* attribute_of(const TiXmlElement& element, std::string_view name) {
  const TiXmlAttribute* each = element.FirstAttribute();
  while (each != nullptr && each->Name() != name) each = each->Next();
  return each;
}

}  // namespace

void XmlChecks::report(const TiXmlBase& node, const std::string& wrong, std::string_view expected) {
  findings_.add(place(node), wrong, expected);
}

void XmlChecks::note(const TiXmlBase& node, const std::string& what) {
  if (notes_.size() < limits::shown_mistakes)
    notes_.push_back(fmt::format("{}: {}", to_text(place(node)), message_part(what)));
  else if (notes_.size() == limits::shown_mistakes)
    notes_.push_back(fmt::format("{}: and more that is ignored or assumed", readable_line(file_)));
}

void XmlChecks::keep_children(TiXmlElement& parent, const Names& used, const Names& ignored) {
  for (TiXmlNode *child = parent.FirstChild(), *next = nullptr; child != nullptr; child = next) {
    next = child->NextSibling();
    const std::string& name = child->ValueStr();
    const bool is_used = std::find(used.begin(), used.end(), name) != used.end();
    if (child->ToElement() != nullptr && is_used) continue;
    if (child->ToElement() != nullptr) drop(*child, parent, used, ignored);
    if (child->ToText() != nullptr)
      report(*child, fmt::format("text inside <{}>", parent.ValueStr()), "expected elements only");
    parent.RemoveChild(child);
  }
}

void XmlChecks::drop(const TiXmlNode& child, const TiXmlElement& parent, const Names& used,
                     const Names& ignored) {
  const std::string& name = child.ValueStr();
  if (std::find(ignored.begin(), ignored.end(), name) != ignored.end()) return;
  if (const std::string nearby = nearest(name, used); !nearby.empty())
    report(child, fmt::format("unknown element <{}> in <{}>", name, parent.ValueStr()),
           fmt::format("expected <{}>", nearby));
  else
    note(child, fmt::format("<{}> in <{}> is ignored", name, parent.ValueStr()));
}

TiXmlElement* XmlChecks::only_child(TiXmlElement& parent, const char* name, bool required) {
  TiXmlElement* child = parent.FirstChildElement(name);
  if (child == nullptr && required)
    report(parent, fmt::format("<{}> has no <{}>", parent.ValueStr(), name),
           fmt::format("expected a <{}>", name));
  if (child != nullptr && child->NextSiblingElement(name) != nullptr)
    report(*child->NextSiblingElement(name),
           fmt::format("<{}> has a second <{}>", parent.ValueStr(), name), "expected one");
  return child;
}

void XmlChecks::check_attributes(const TiXmlElement& element, const Names& known) {
  for (const TiXmlAttribute* each = element.FirstAttribute(); each != nullptr;
       each = each->Next()) {
    const std::string name = each->Name();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string nearby = nearest(name, known);
    if (nearby.empty())
      note(*each, fmt::format("attribute '{}' of <{}> is ignored", name, element.ValueStr()));
    else
      findings_.add(place(*each),
                    fmt::format("unknown attribute '{}' of <{}>", name, element.ValueStr()),
                    fmt::format("expected '{}'", nearby));
  }
}

std::optional<std::vector<double>> XmlChecks::numbers(TiXmlElement& element, const char* name,
                                                      std::size_t size, bool required) {
  const TiXmlAttribute* attribute = attribute_of(element, name);
  const std::string expected =
      size == 1 ? "expected a finite number" : fmt::format("expected {} finite numbers", size);
  if (attribute == nullptr) {
    if (required)
      report(element, fmt::format("<{}> has no {}", element.ValueStr(), name), expected);
    return std::nullopt;
  }
  const auto values = parse_numbers(attribute->ValueStr());
  const bool is_fine =
      values && values->size() == size &&
      std::all_of(values->begin(), values->end(), [](double v) { return std::isfinite(v); });
  if (!is_fine) {
    findings_.add(
        place(*attribute),
        fmt::format("{} of <{}> is '{}'", name, element.ValueStr(), attribute->ValueStr()),
        expected);
    return std::nullopt;
  }
  element.SetAttribute(name, fmt::format("{}", fmt::join(*values, " ")));
  return values;
}

}  // namespace sinew
