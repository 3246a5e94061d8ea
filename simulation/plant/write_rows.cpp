// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/write_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <stdexcept>

namespace sinew {

RowWriter::RowWriter(const std::filesystem::path& file, const std::vector<std::string>& header,
                     const Inputs& inputs)
    : path_(file), file_(file, inputs), columns_(header.size()) {
  file_.write(fmt::format("{}\n", fmt::join(header, ",")));
}

RowWriter::~RowWriter() {
  if (writing_.valid()) writing_.wait();
}

void RowWriter::add_row(const double* row) {
  constexpr std::size_t longest = 32;  // of a number's shortest text, with its comma
  const std::size_t before = text_.size();
  text_.resize(before + longest * columns_);
  char* next = text_.data() + before;
  for (std::size_t i = 0; i < columns_; ++i) {
    next = std::to_chars(next, next + longest, row[i]).ptr;
    *next++ = ',';
  }
  next[-1] = '\n';
  text_.resize(static_cast<std::size_t>(next - text_.data()));
}

void RowWriter::hand_over() {
  if (writing_.valid()) writing_.get();
  std::swap(held_, written_);
  held_.clear();
  writing_ = std::async(std::launch::async, [this] {
    text_.clear();
    for (std::size_t at = 0; at < written_.size(); at += columns_) add_row(written_.data() + at);
    file_.write(text_);
  });
}

void RowWriter::write(const std::vector<double>& row) {
  if (row.size() != columns_)
    throw std::runtime_error(fmt::format("{}: a row of {} numbers under a header of {}",
                                         path_.string(), row.size(), columns_));
  constexpr std::size_t batch = std::size_t{1} << 16;  // numbers
  held_.insert(held_.end(), row.begin(), row.end());
  if (held_.size() >= batch) hand_over();
}

void RowWriter::finish() {
  hand_over();
  writing_.get();
  file_.commit();
}

}  // namespace sinew
