// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/converted_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "identification/logs/bag_folder.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

std::string first_bytes(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  std::string bytes(128, '\0');
  if (!file) return "";  // told where it is opened as text
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (std::ferror(file.get()) != 0)
    throw std::runtime_error(fmt::format(
        "{}:0:0: cannot be read to its end; expected a readable file", readable_line(path)));
  return bytes;
}

/// Quotes around the name: units have commas in brackets, names may have them anywhere.
std::string cell_of(const std::string& name) {
  std::string cell = "\"";
  for (const char c : name)
    cell += c == '"' ? std::string("\"\"") : c == '\n' || c == '\r' ? " " : std::string(1, c);
  return cell + "\"";
}

/// Files that no reader here can read, but that people have of their logs.
std::vector<LogColumn> refuse_ros1(const std::string& path) {
  throw std::runtime_error(fmt::format(
      "{}:0:0: is a recording of ROS 1; write it as one of ROS 2 (rosbags-convert), or as CSV",
      readable_line(path)));
}
std::vector<LogColumn> refuse_packed(const std::string& path) {
  throw std::runtime_error(fmt::format("{}:0:0: is compressed; unpack it first: unzstd, or gunzip",
                                       readable_line(path)));
}

struct BinaryFormat {
  std::string_view first_bytes;
  std::vector<LogColumn> (*read)(const std::string& path);
};

constexpr BinaryFormat kFormats[] = {
    {"\x89HDF\r\n\x1a\n", &read_hdf5},
    {"MATLAB 5.0 MAT-file", &read_mat},
    {"MATLAB 7.3 MAT", &read_mat},
    {std::string_view("SQLite format 3\0", 16), &read_rosbag2},
    {"\x89MCAP0\r\n", &read_mcap},
    {"#ROSBAG V2.0", &refuse_ros1},
    {"\x28\xb5\x2f\xfd", &refuse_packed},
    {"\x1f\x8b\x08", &refuse_packed},
};

/// nullptr: text, or nothing that is known.
auto reader_of(const std::string& path) -> decltype(BinaryFormat::read) {
  const std::string bytes = first_bytes(path);
  const BinaryFormat* format =
      std::find_if(std::begin(kFormats), std::end(kFormats),
                   [&](const BinaryFormat& f) { return bytes.starts_with(f.first_bytes); });
  return format == std::end(kFormats) ? nullptr : format->read;
}

void write_text(std::FILE* to, const std::vector<LogColumn>& columns) {
  std::string line;
  for (const LogColumn& column : columns) line += (line.empty() ? "" : ",") + cell_of(column.name);
  for (std::size_t row = 0; row <= columns.front().values.size(); ++row) {
    line += '\n';
    std::fwrite(line.data(), 1, line.size(), to);
    line.clear();
    if (row == columns.front().values.size()) break;
    for (const LogColumn& column : columns)
      fmt::format_to(std::back_inserter(line), "{}{}", line.empty() ? "" : ",", column.values[row]);
  }
}

}  // namespace

std::vector<LogColumn> of_one_length(std::vector<LogColumn> columns, const std::string& path) {
  std::map<std::size_t, int> lengths;
  for (const LogColumn& column : columns)
    if (column.values.size() > 1) ++lengths[column.values.size()];
  const auto most =
      std::max_element(lengths.begin(), lengths.end(), [](const auto& a, const auto& b) {
        return a.second <= b.second;  // of equally many the longer ones
      });
  if (most == lengths.end() || most->second < 2)
    throw std::runtime_error(fmt::format(
        "{}:0:0: holds no two vectors of one length; expected the time and channels, each a vector",
        readable_line(path)));
  std::erase_if(columns, [&](const LogColumn& c) { return c.values.size() != most->first; });
  return columns;
}

std::vector<std::string> files_of_log(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return {path};
  const BagFolder bag = open_bag_folder(path);
  std::vector<std::string> files{bag.metadata.string()};
  files.insert(files.end(), bag.parts.begin(), bag.parts.end());
  return files;
}

std::FILE* converted_log(const std::string& path) {
  std::error_code error;
  const auto read = std::filesystem::is_directory(path, error) ? &read_bag_folder : reader_of(path);
  if (!read) return nullptr;
  const std::vector<LogColumn> columns = of_one_length(read(path), path);
  std::FILE* text = std::tmpfile();
  if (!text) throw std::runtime_error("no temporary file can be made; expected room in /tmp");
  write_text(text, columns);
  if (std::fflush(text) != 0 || std::ferror(text) != 0) {
    std::fclose(text);
    throw std::runtime_error("the temporary file cannot be written; expected room in /tmp");
  }
  std::rewind(text);
  return text;
}

}  // namespace sinew
