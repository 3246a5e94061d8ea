// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/csv_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "identification/logs/converted_log.h"
#include "identification/logs/units.h"
#include "symbolic/files/limits.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

constexpr size_t block_size = size_t{1} << 20;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

bool is_missing_word(std::string_view text) {
  static constexpr std::array<std::string_view, 12> words = {
      "nan", "NaN", "NAN", "-nan", "NA", "N/A", "null", "NULL", "inf", "-inf", "Inf", "-Inf"};
  return std::find(words.begin(), words.end(), text) != words.end();
}

std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

// Separators inside quotes or inside a unit's brackets do not count.
long count_outside(std::string_view line, char wanted) {
  long count = 0;
  bool quoted = false;
  int depth = 0;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '[' || c == '(') ++depth;
    if (c == ']' || c == ')') --depth;
    if (c == wanted && depth <= 0) ++count;
  }
  return count;
}

char delimiter_of(std::string_view line) {
  if (count_outside(line, ';') > 0) return ';';
  if (count_outside(line, '\t') > 0) return '\t';
  return ',';
}

size_t cell_end(std::string_view line, size_t from, char delimiter) {
  bool quoted = false;
  for (size_t i = from; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == delimiter && !quoted) return i;
  }
  return line.size();
}

// The common case by memchr: a line without quotes.
size_t plain_cell_end(std::string_view line, size_t from, char delimiter) {
  const void* hit = std::memchr(line.data() + from, delimiter, line.size() - from);
  return hit == nullptr ? line.size()
                        : static_cast<size_t>(static_cast<const char*>(hit) - line.data());
}

int decimals_of(std::string_view cell, char decimal) {
  const size_t point = cell.find(decimal);
  const size_t exponent = cell.find_first_of("eE");
  if (exponent != std::string_view::npos) {
    int power = 0;
    const char* first = cell.data() + exponent + 1;
    if (first < cell.data() + cell.size() && *first == '+') ++first;
    std::from_chars(first, cell.data() + cell.size(), power);
    const size_t digits = point == std::string_view::npos ? 0 : exponent - point - 1;
    return static_cast<int>(digits) - power;
  }
  return point == std::string_view::npos ? 0 : static_cast<int>(cell.size() - point - 1);
}

[[noreturn]] void fail_reading(const std::string& path) {
  throw std::runtime_error(
      fmt::format("{}:0:0: cannot be read to its end; expected a readable file", path));
}

/// A log is read from its beginning more than once, which a pipe or a device does not give; and
/// opening a pipe that nobody writes to would never return.
void require_log_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::uintmax_t size = 0;
  for (const std::string& file : files_of_log(path)) {
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) return;  // told where it is opened
    if (!fs::is_regular_file(status))
      throw std::runtime_error(fmt::format(
          "{}:0:0: is no file but a pipe or a device; expected a log, written to a file",
          readable_line(file)));
    size += fs::file_size(file, error);
  }
  if (!error && size > limits::log_bytes)
    throw std::runtime_error(fmt::format("{}:0:0: holds {} bytes; expected at most {}: divide it",
                                         readable_line(path), size, limits::log_bytes));
}

}  // namespace

std::vector<std::string> split_cells(std::string_view line, char delimiter) {
  std::vector<std::string> cells;
  for (size_t at = 0; at <= line.size();) {
    const size_t end = cell_end(line, at, delimiter);
    std::string cell(unquoted(line.substr(at, end - at)));
    for (size_t q = cell.find("\"\""); q != std::string::npos; q = cell.find("\"\"", q + 1))
      cell.erase(q, 1);
    cells.push_back(std::move(cell));
    at = end + 1;
  }
  return cells;
}

double parse_cell(std::string_view cell, char decimal, CellState& state) {
  cell = unquoted(cell);
  if (cell.empty()) {
    state = CellState::empty;
    return no_number;
  }
  std::array<char, 64> swapped;
  if (decimal != '.' && cell.size() < swapped.size() && cell.find('.') == std::string_view::npos) {
    std::replace_copy(cell.begin(), cell.end(), swapped.begin(), decimal, '.');
    cell = std::string_view(swapped.data(), cell.size());
  }
  const std::string_view digits = cell.front() == '+' ? cell.substr(1) : cell;
  double value = no_number;
  const char* end = digits.data() + digits.size();
  const auto parsed = std::from_chars(digits.data(), end, value);
  if (parsed.ec == std::errc() && parsed.ptr == end && std::isfinite(value)) {
    state = CellState::number;
    return value;
  }
  // "1.#QNAN" and its kin are what some C libraries print.
  const bool missing = is_missing_word(cell) || cell.find('#') != std::string_view::npos ||
                       (parsed.ec == std::errc() && parsed.ptr == end);
  state = missing && !cell.starts_with('#') ? CellState::nan : CellState::text;
  return no_number;
}

CsvReader::CsvReader(const std::string& path) : path_(path), shown_path_(readable_line(path)) {
  require_log_file(path);
  file_.reset(converted_log(path));
  converted_ = file_ != nullptr;
  if (!converted_) file_.reset(std::fopen(path.c_str(), "rb"));
  if (!file_)
    throw std::runtime_error(fmt::format("{}:0:0: cannot be opened; expected a log", shown_path_));
  buffer_.resize(block_size);
  read_header();
  find_decimal_sign();
}

void CsvReader::on_bytes(std::function<void(const char*, size_t)> listener) {
  listener_ = std::move(listener);
  if (converted_) {  // the digest is of the files as they are
    for (const std::string& file : files_of_log(path_)) pass_on(file, limits::log_bytes);
    listener_ = nullptr;
    return;
  }
  // What was read while the header was looked for.
  const auto already = static_cast<std::uintmax_t>(std::ftell(file_.get()));
  // A digest of less than the file would be another file's.
  if (pass_on(path_, already) != already) fail_reading(path_);
}

/// To the listener, from the beginning; returns how many bytes there were.
std::uintmax_t CsvReader::pass_on(const std::string& path, std::uintmax_t most) {
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
  if (!file) fail_reading(path);
  std::vector<char> block(block_size);
  std::uintmax_t passed = 0;
  while (passed < most) {
    const size_t got = std::fread(
        block.data(), 1, std::min<std::uintmax_t>(block.size(), most - passed), file.get());
    if (got == 0) break;
    listener_(block.data(), got);
    passed += got;
  }
  if (std::ferror(file.get()) != 0) fail_reading(path);
  return passed;
}

bool CsvReader::fill() {
  if (at_end_) return false;
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) {
    if (buffer_.size() >= limits::log_line_bytes)
      throw std::runtime_error(
          fmt::format("{}:{}:0: a line longer than {} bytes; expected text with line ends",
                      shown_path_, line_ + 1, limits::log_line_bytes));
    buffer_.resize(2 * buffer_.size());
  }
  const size_t got = std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, file_.get());
  if (std::ferror(file_.get()) != 0) fail_reading(path_);
  if (got == 0) {
    at_end_ = true;
    return false;
  }
  if (listener_) listener_(buffer_.data() + end_, got);
  end_ += got;
  return true;
}

bool CsvReader::next_line(std::string_view& line) {
  size_t searched = begin_;
  for (;;) {
    const void* hit =
        searched < end_ ? std::memchr(buffer_.data() + searched, '\n', end_ - searched) : nullptr;
    if (hit != nullptr) {
      const auto stop = static_cast<size_t>(static_cast<const char*>(hit) - buffer_.data());
      line = std::string_view(buffer_.data() + begin_, stop - begin_);
      begin_ = stop + 1;
      break;
    }
    const size_t kept = end_ - begin_;
    if (fill()) {
      searched = begin_ + kept;
      continue;
    }
    if (begin_ == end_) return false;
    line = std::string_view(buffer_.data() + begin_, end_ - begin_);
    begin_ = end_;
    break;
  }
  ++line_;
  if (!line.empty() && line.back() == '\r') {
    line.remove_suffix(1);
    dialect_.carriage_returns = true;
  }
  return true;
}

void CsvReader::read_header() {
  std::string_view line;
  while (next_line(line)) {
    if (line_ == 1) {
      if (line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF"))
        throw std::runtime_error(
            fmt::format("{}:1:1: the file is UTF-16; expected UTF-8, save it so", shown_path_));
      if (line.starts_with("\xEF\xBB\xBF")) {
        line.remove_prefix(3);
        dialect_.byte_order_mark = true;
      }
    }
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#') continue;
    // Excel's own line about the separator.
    if (text.size() == 5 && text.starts_with("sep=")) continue;
    dialect_.delimiter = delimiter_of(line);
    dialect_.header = split_cells(line, dialect_.delimiter);
    dialect_.header_row = line_;
    if (dialect_.header.size() > limits::log_columns)
      throw std::runtime_error(
          fmt::format("{}:{}:1: the header has {} columns; expected at most {}", shown_path_, line_,
                      dialect_.header.size(), limits::log_columns));
    CellState state = CellState::empty;
    for (const std::string& cell : dialect_.header) {
      parse_cell(cell, '.', state);
      if (state == CellState::number)
        throw std::runtime_error(
            fmt::format("{}:{}:1: numbers where the header was expected, '{}'; expected one row of "
                        "'name [unit]' cells before the data",
                        shown_path_, line_, message_part(cell)));
    }
    return;
  }
  throw std::runtime_error(fmt::format(
      "{}:{}:1: no header; expected one row of 'name [unit]' cells", shown_path_, line_));
}

// A decimal comma can only be meant where the comma does not separate cells.
void CsvReader::find_decimal_sign() {
  if (dialect_.delimiter == ',') return;
  while (end_ - begin_ < 65536 && fill()) {
  }
  const std::string_view ahead(buffer_.data() + begin_, std::min<size_t>(end_ - begin_, 65536));
  const auto commas = std::count(ahead.begin(), ahead.end(), ',');
  const auto points = std::count(ahead.begin(), ahead.end(), '.');
  if (commas > points) dialect_.decimal = ',';
}

void CsvReader::select(const std::vector<int>& columns) {
  slot_.assign(dialect_.header.size(), -1);
  selected_ = columns.size();
  for (size_t i = 0; i < columns.size(); ++i)
    slot_[static_cast<size_t>(columns[i] - 1)] = static_cast<int>(i);
}

bool CsvReader::next(CsvRow& row) {
  std::string_view line;
  while (next_line(line)) {
    if (trimmed(line).empty()) continue;
    parse(line, row);
    return true;
  }
  return false;
}

void CsvReader::parse(std::string_view line, CsvRow& row) const {
  row.line = line_;
  row.cells = 0;
  row.value.assign(selected_, no_number);
  row.state.assign(selected_, CellState::absent);
  const bool quotes = std::memchr(line.data(), '"', line.size()) != nullptr;
  for (size_t at = 0; at <= line.size();) {
    const size_t end = quotes ? cell_end(line, at, dialect_.delimiter)
                              : plain_cell_end(line, at, dialect_.delimiter);
    const auto column = static_cast<size_t>(row.cells++);
    if (column < slot_.size() && slot_[column] >= 0) {
      const auto slot = static_cast<size_t>(slot_[column]);
      const std::string_view cell = line.substr(at, end - at);
      row.value[slot] = parse_cell(cell, dialect_.decimal, row.state[slot]);
      if (slot == 0) row.time_decimals = decimals_of(unquoted(cell), dialect_.decimal);
    }
    // Some tools close every row with a separator.
    if (end == line.size() && row.cells == static_cast<int>(slot_.size()) + 1 &&
        trimmed(line.substr(at)).empty())
      --row.cells;
    at = end + 1;
  }
}

}  // namespace sinew
