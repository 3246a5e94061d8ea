// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/xml_nesting.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>

namespace sinew {
namespace {

/// Walks over markup as TinyXML does: where one ends decides what the other takes for an element.
class XmlNestingScanner {
 public:
  explicit XmlNestingScanner(std::string_view text) : text_(text) {}

  int deepest() {
    while ((at_ = text_.find('<', at_)) < text_.size()) pass_markup();
    return deepest_;
  }

 private:
  bool starts(std::string_view with) const { return text_.substr(at_).starts_with(with); }

  void pass_markup() {
    if (starts("<!--")) {
      skip_behind("-->");
    } else if (starts("<![CDATA[")) {
      skip_behind("]]>");
    } else if (starts("</")) {
      depth_ = std::max(0, depth_ - 1);
      skip_behind(">");
    } else if (begins_element()) {
      pass_tag();
    } else {
      // A declaration in the midst of elements has rules of its own, and no business there.
      if (is_declaration() && depth_ > 0) deepest_ = std::numeric_limits<int>::max();
      skip_behind(">");
    }
  }

  bool is_declaration() const {
    std::string start(text_.substr(at_, 5));
    for (char& c : start) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return start == "<?xml";
  }

  bool begins_element() const {
    const unsigned char next =
        at_ + 1 < text_.size() ? static_cast<unsigned char>(text_[at_ + 1]) : 0;
    return next == '_' || next >= 127 || (next >= 'a' && next <= 'z') ||
           (next >= 'A' && next <= 'Z');
  }

  /// To behind the '>' that is in no quotes.
  void pass_tag() {
    char quote = 0;
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (quote != 0) {
        if (c == quote) quote = 0;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        break;
      }
    }
    const bool is_empty = at_ < text_.size() && text_[at_ - 1] == '/';
    if (!is_empty) deepest_ = std::max(deepest_, ++depth_);
  }

  void skip_behind(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0, deepest_ = 0;
};

}  // namespace

int nesting_depth(std::string_view text) {
  return XmlNestingScanner(text).deepest();
}

}  // namespace sinew
