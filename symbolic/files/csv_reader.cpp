// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/csv_reader.h"

#include <utility>

namespace sinew {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

std::string trimmed(std::string text) {
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  std::size_t start = 0;
  while (start < text.size() && is_blank(text[start])) ++start;
  return text.substr(start);
}

/// Walks over the text and knows the line and column it is at.
class CsvScanner {
 public:
  CsvScanner(std::string_view text, const std::string& file, Findings& findings)
      : text_(text), file_(file), findings_(findings) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  std::vector<TableRow> rows() {
    std::vector<TableRow> rows;
    while (!at_end()) {
      if (skip_empty_line()) continue;
      rows.push_back(row());
    }
    return rows;
  }

 private:
  bool at_end() const { return at_ >= text_.size(); }
  char now() const { return text_[at_]; }
  bool at_line_end() const {
    return at_end() || now() == '\n' || text_.substr(at_).starts_with("\r\n");
  }
  SourceLocation here() const { return {file_, line_, column_}; }

  char advance() {
    const char c = text_[at_++];
    if (c == '\n') {
      ++line_;
      column_ = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u) {
      ++column_;  // continuation bytes belong to the character before
    }
    return c;
  }

  void end_line() {
    while (!at_end())
      if (advance() == '\n') return;
  }

  bool skip_empty_line() {
    std::size_t ahead = at_;
    while (ahead < text_.size() && (is_blank(text_[ahead]) || text_[ahead] == '\r')) ++ahead;
    if (ahead < text_.size() && text_[ahead] != '\n' && text_[ahead] != '#') return false;
    end_line();
    return true;
  }

  TableRow row() {
    TableRow row{{}, here()};
    for (;;) {
      row.cells.push_back(cell());
      if (at_line_end()) break;
      advance();  // the comma
    }
    end_line();
    return row;
  }

  TableCell cell() {
    while (!at_line_end() && is_blank(now())) advance();
    TableCell cell{"", here()};
    if (!at_line_end() && now() == '"') {
      cell.text = quoted(cell.where);
    } else {
      while (!at_line_end() && now() != ',') cell.text += advance();
      cell.text = trimmed(std::move(cell.text));
    }
    return cell;
  }

  std::string quoted(const SourceLocation& start) {
    std::string text;
    advance();
    for (;;) {
      if (at_end()) {
        findings_.add(start, "the quoted cell does not end", "expected a closing \"");
        return text;
      }
      const char c = advance();
      if (c != '"')
        text += c;
      else if (!at_end() && now() == '"')
        text += advance();
      else
        break;
    }
    if (while_blank(); !at_line_end() && now() != ',') {
      findings_.add(here(), "text follows a quoted cell",
                    "expected a comma or the end of the line");
      while (!at_line_end() && now() != ',') advance();
    }
    return text;
  }

  void while_blank() {
    while (!at_line_end() && is_blank(now())) advance();
  }

  std::string_view text_;
  const std::string& file_;
  Findings& findings_;
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
};

}  // namespace

std::vector<TableRow> read_csv(std::string_view text, const std::string& file, Findings& findings) {
  return CsvScanner(text, file, findings).rows();
}

}  // namespace sinew
