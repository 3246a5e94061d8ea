// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/write_rows.h"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <cstring>
#include <stdexcept>

namespace sinew {

RowWriter::RowWriter(const std::filesystem::path& file, const std::vector<std::string>& header)
    : file_(file),
      partial_(file.string() + fmt::format(".part-{}", ::getpid())),
      columns_(header.size()) {
  stream_ = std::fopen(partial_.c_str(), "wb");
  if (!stream_) fail("cannot be written");
  constexpr std::size_t buffer = std::size_t{1} << 20;  // a hand's row is longer than the usual one
  std::setvbuf(stream_, nullptr, _IOFBF, buffer);
  put(fmt::format("{}\n", fmt::join(header, ",")));
}

RowWriter::~RowWriter() {
  if (writing_.valid()) writing_.wait();
  if (!stream_) return;
  std::fclose(stream_);
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void RowWriter::fail(const char* what) const {
  throw std::runtime_error(fmt::format("{}: {}: {}", file_.string(), what, std::strerror(errno)));
}

void RowWriter::put(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) fail("cannot be written");
}

void RowWriter::put_row(const double* row) {
  constexpr std::size_t longest = 32;  // of a number's shortest text, with its comma
  text_.resize(longest * columns_);
  char* next = text_.data();
  for (std::size_t i = 0; i < columns_; ++i) {
    next = std::to_chars(next, next + longest, row[i]).ptr;
    *next++ = ',';
  }
  next[-1] = '\n';
  put({text_.data(), next});
}

void RowWriter::hand_over() {
  if (writing_.valid()) writing_.get();
  std::swap(held_, written_);
  held_.clear();
  writing_ = std::async(std::launch::async, [this] {
    for (std::size_t at = 0; at < written_.size(); at += columns_) put_row(written_.data() + at);
  });
}

void RowWriter::write(const std::vector<double>& row) {
  if (row.size() != columns_)
    throw std::runtime_error(fmt::format("{}: a row of {} numbers under a header of {}",
                                         file_.string(), row.size(), columns_));
  constexpr std::size_t batch = std::size_t{1} << 16;  // numbers
  held_.insert(held_.end(), row.begin(), row.end());
  if (held_.size() >= batch) hand_over();
}

void RowWriter::finish() {
  hand_over();
  writing_.get();
  if (std::fflush(stream_) != 0 || ::fsync(::fileno(stream_)) != 0) fail("cannot be written");
  std::fclose(stream_);
  stream_ = nullptr;
  std::error_code error;
  std::filesystem::rename(partial_, file_, error);
  if (error) {
    std::error_code ignored;
    std::filesystem::remove(partial_, ignored);
    throw std::runtime_error(fmt::format("{}: {}", file_.string(), error.message()));
  }
}

}  // namespace sinew
