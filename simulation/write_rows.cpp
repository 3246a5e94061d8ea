// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/write_rows.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <iterator>
#include <stdexcept>

namespace sinew {

RowWriter::RowWriter(const std::filesystem::path& file, const std::vector<std::string>& header)
    : file_(file), partial_(file.string() + fmt::format(".part-{}", ::getpid())) {
  stream_ = std::fopen(partial_.c_str(), "wb");
  if (!stream_) fail("cannot be written");
  put(fmt::format("{}\n", fmt::join(header, ",")));
}

RowWriter::~RowWriter() {
  if (!stream_) return;
  std::fclose(stream_);
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void RowWriter::fail(const char* what) const {
  throw std::runtime_error(fmt::format("{}: {}: {}", file_.string(), what, std::strerror(errno)));
}

void RowWriter::put(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) fail("cannot be written");
}

void RowWriter::write(const std::vector<double>& row) {
  line_.clear();
  for (const double value : row) {
    if (!line_.empty()) line_ += ',';
    fmt::format_to(std::back_inserter(line_), "{}", value);
  }
  line_ += '\n';
  put(line_);
}

void RowWriter::finish() {
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
