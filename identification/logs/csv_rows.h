// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a CSV file, one after the other, in memory that does not grow with the file.
#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

enum class CellState : unsigned char { number, empty, nan, text, absent };

/// How a file is written: found out from its first lines.
struct CsvDialect {
  char delimiter = ',';
  char decimal = '.';
  bool byte_order_mark = false;
  bool carriage_returns = false;
  long header_row = 1;  ///< line number
  std::vector<std::string> header;
};

/// One data row. Only the columns asked for are read; `value` is NaN unless the state is number.
struct CsvRow {
  long line = 0;
  int cells = 0;  ///< in the row, used or not
  std::vector<double> value;
  std::vector<CellState> state;
  int time_decimals = 0;  ///< digits after the decimal sign in the first column asked for
};

/// Reads a file once, front to back; another format as the text it is converted to. Throws
/// std::runtime_error "file:row:column: ..." where the file cannot be opened, is no file (a folder,
/// a pipe, a device), is larger than a log may be (symbolic/files/limits.h), is UTF-16, or has no
/// header row.
class CsvReader {
 public:
  explicit CsvReader(const std::string& path);

  const CsvDialect& dialect() const { return dialect_; }
  /// Columns to read, from 1, in the order wanted; the first is the time.
  void select(const std::vector<int>& columns);
  /// False at the end of the file. Blank lines are passed over.
  bool next(CsvRow& row);
  /// Called with every block of bytes as it comes from the file.
  void on_bytes(std::function<void(const char*, size_t)> listener);

 private:
  std::uintmax_t pass_on(const std::string& path, std::uintmax_t most);
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  bool fill();
  bool next_line(std::string_view& line);
  void read_header();
  void find_decimal_sign();
  void parse(std::string_view line, CsvRow& row) const;

  std::string path_, shown_path_;
  std::unique_ptr<std::FILE, Closer> file_;
  std::vector<char> buffer_;
  size_t begin_ = 0, end_ = 0;
  bool at_end_ = false;
  bool converted_ = false;  ///< file_ is text made of a file of another format
  long line_ = 0;
  CsvDialect dialect_;
  std::vector<int> slot_;  ///< column index -> place in CsvRow, -1 unused
  size_t selected_ = 0;
  std::function<void(const char*, size_t)> listener_;
};

/// Cells of a line; quotes are taken off, doubled quotes inside become one.
std::vector<std::string> split_cells(std::string_view line, char delimiter);

/// A number with the decimal sign given; NaN and a state that says why where it is none.
double parse_cell(std::string_view cell, char decimal, CellState& state);

}  // namespace sinew
