// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/toml_nesting.h"

#include <algorithm>
#include <string>

namespace sinew {
namespace {

/// Walks over strings and comments, and counts dots and brackets elsewhere.
class NestingScanner {
 public:
  NestingScanner(std::string_view text, int most) : text_(text), most_(most) {}

  std::optional<TextPlace> find() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else if (c == '"' || c == '\'')
        skip_string(c);
      else if (is_too_deep(c))
        return place();
      else
        ++at_;
    }
    return std::nullopt;
  }

 private:
  bool is_too_deep(char c) {
    if (c == '[' || c == '{') ++brackets_;
    if (c == ']' || c == '}') brackets_ = std::max(0, brackets_ - 1);
    // A value has at most one dot, so that every run of them is a key's.
    if (c == '.') ++dots_;
    if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots_ = 0;
    return brackets_ > most_ || dots_ >= most_;
  }

  /// Without an end the string goes to the end of its line, or of the text: an error of its own.
  void skip_string(char quote) {
    const bool is_long = text_.substr(at_).starts_with(std::string(3, quote));
    const std::string end(is_long ? 3 : 1, quote);
    for (at_ += end.size(); at_ < text_.size(); ++at_) {
      if (text_[at_] == '\\' && quote == '"') {
        ++at_;
      } else if (text_.substr(at_).starts_with(end)) {
        at_ += end.size();
        return;
      } else if (text_[at_] == '\n' && !is_long) {
        return;
      }
    }
  }

  TextPlace place() const {
    TextPlace place;
    for (const char c : text_.substr(0, at_)) {
      if (c == '\n') {
        ++place.line;
        place.column = 1;
      } else if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u) {
        ++place.column;
      }
    }
    return place;
  }

  std::string_view text_;
  int most_;
  std::size_t at_ = 0;
  int brackets_ = 0, dots_ = 0;
};

}  // namespace

std::optional<TextPlace> nested_deeper(std::string_view toml, int most) {
  return NestingScanner(toml, most).find();
}

}  // namespace sinew
