// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of XML elements and attributes, every mistake with its line and column.
#pragma once

#include <tinyxml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/files/description_error.h"

namespace sinew {

class XmlChecks {
 public:
  XmlChecks(std::string file, Findings& findings, std::vector<std::string>& notes)
      : file_(std::move(file)), findings_(findings), notes_(notes) {}

  SourceLocation place(const TiXmlBase& node) const { return {file_, node.Row(), node.Column()}; }
  /// A mistake at a node.
  void report(const TiXmlBase& node, const std::string& wrong, std::string_view expected);
  /// Something ignored or assumed, worth telling.
  void note(const TiXmlBase& node, const std::string& what);

  /// Removes all children but elements with a name in `used`: silently those in `ignored`, with a
  /// note others; a name nearly one of `used` is a mistake, as is text.
  void keep_children(TiXmlElement& parent, const std::vector<std::string>& used,
                     const std::vector<std::string>& ignored);
  /// The child of that name, or null; reports a missing required one and a second one.
  TiXmlElement* only_child(TiXmlElement& parent, const char* name, bool required);
  /// Reports attributes nearly known, notes unknown ones.
  void check_attributes(const TiXmlElement& element, const std::vector<std::string>& known);
  /// The numbers of an attribute, or nothing if absent or wrong (reported). The attribute is
  /// written back with single blanks between the numbers.
  std::optional<std::vector<double>> numbers(TiXmlElement& element, const char* name,
                                             std::size_t size, bool required);

 private:
  void drop(const TiXmlNode& child, const TiXmlElement& parent,
            const std::vector<std::string>& used, const std::vector<std::string>& ignored);

  std::string file_;
  Findings& findings_;
  std::vector<std::string>& notes_;
};

}  // namespace sinew
