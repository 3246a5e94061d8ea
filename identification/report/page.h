// SPDX-License-Identifier: GPL-3.0-or-later
// Building blocks of the report's page: escaping, tables that become cards on a phone, bars, style.
#pragma once

#include <string>
#include <vector>

#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// Text as HTML; also good inside double-quoted attributes.
std::string escaped(const std::string& text);

/// The same for names and paths: long ones may break after an underscore or a slash.
std::string escaped_name(const std::string& name);

/// The first letter as a capital, where it is a plain letter.
std::string capitalised(std::string text);

/// A table whose cells are HTML. On narrow screens every row becomes a block that repeats the
/// headings. Columns whose heading begins with '#' are numbers (right-aligned), without the '#'.
class Table {
 public:
  explicit Table(std::vector<std::string> headings, std::string caption = "", bool narrow = false);
  void row(const std::vector<std::string>& cells);
  bool empty() const { return rows_.empty(); }
  std::string html() const;

 private:
  std::vector<std::string> headings_;
  std::string caption_, rows_;
  bool narrow_;  ///< as wide as its cells need, not as the page
};

/// A bar filled to `share` (0..1); `role`: "before", "after", "noise", "ink".
std::string bar(double share, const std::string& role);

/// A gain on a scale from nothing to all: its interval as a band, its value as a mark.
std::string interval_bar(const Gain& gain);

/// <section> with a heading and an anchor; nothing where `content` is empty.
std::string section(const std::string& id, const std::string& heading, const std::string& content);

/// <details>, open or closed.
std::string folded(const std::string& summary, const std::string& content, bool open = false);

/// The style sheet: light and dark, narrow and wide, print.
std::string page_style();

}  // namespace sinew::diagnosis
