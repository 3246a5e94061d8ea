// SPDX-License-Identifier: GPL-3.0-or-later
// MAT files by the library matio. A variable's unit is the text of the variable <name>_unit.
#include <fmt/format.h>

#include <map>
#include <memory>
#include <stdexcept>

#include "identification/logs/converted_log.h"
#include "symbolic/files/readable.h"

#if __has_include(<matio.h>)
#include <matio.h>
#endif

namespace sinew {

#if __has_include(<matio.h>)
namespace {

struct MatFile {
  explicit MatFile(const std::string& path) : file(Mat_Open(path.c_str(), MAT_ACC_RDONLY)) {
    if (!file)
      throw std::runtime_error(fmt::format(
          "{}:0:0: cannot be read as a MAT file; save it again, or as CSV", readable_line(path)));
  }
  ~MatFile() { Mat_Close(file); }
  MatFile(const MatFile&) = delete;
  MatFile& operator=(const MatFile&) = delete;
  mat_t* file;
};

template <typename Number>
std::vector<double> numbers_of(const matvar_t& variable, std::size_t first, std::size_t count) {
  const Number* data = static_cast<const Number*>(variable.data) + first;
  return {data, data + count};
}

std::vector<double> column_of(const matvar_t& variable, std::size_t first, std::size_t count) {
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      return numbers_of<double>(variable, first, count);
    case MAT_C_SINGLE:
      return numbers_of<float>(variable, first, count);
    case MAT_C_INT64:
      return numbers_of<mat_int64_t>(variable, first, count);
    case MAT_C_UINT64:
      return numbers_of<mat_uint64_t>(variable, first, count);
    case MAT_C_INT32:
      return numbers_of<mat_int32_t>(variable, first, count);
    case MAT_C_UINT32:
      return numbers_of<mat_uint32_t>(variable, first, count);
    case MAT_C_INT16:
      return numbers_of<mat_int16_t>(variable, first, count);
    case MAT_C_UINT16:
      return numbers_of<mat_uint16_t>(variable, first, count);
    case MAT_C_INT8:
      return numbers_of<mat_int8_t>(variable, first, count);
    case MAT_C_UINT8:
      return numbers_of<mat_uint8_t>(variable, first, count);
    default:
      return {};
  }
}

std::string text_of(const matvar_t& variable) {
  std::string text;
  const auto* bytes = static_cast<const unsigned char*>(variable.data);
  const std::size_t width =
      variable.data_size > 0 ? static_cast<std::size_t>(variable.data_size) : 1;
  for (std::size_t at = 0; bytes && at + width <= variable.nbytes; at += width)
    text += static_cast<char>(bytes[at]);  // units are written in ASCII
  return text;
}

void add_columns(const matvar_t& variable, std::vector<LogColumn>& columns) {
  if (variable.rank != 2 || variable.isComplex || !variable.data) return;
  const std::size_t rows = variable.dims[0], cols = variable.dims[1];
  const bool vector = rows == 1 || cols == 1;
  const std::size_t length = vector ? rows * cols : rows, count = vector ? 1 : cols;
  for (std::size_t k = 0; k < count; ++k)
    columns.push_back({vector ? variable.name : fmt::format("{}_{}", variable.name, k + 1),
                       column_of(variable, k * length, length)});
}

}  // namespace

std::vector<LogColumn> read_mat(const std::string& path) {
  const MatFile mat(path);
  std::vector<LogColumn> columns;
  std::map<std::string, std::string> units;
  while (matvar_t* next = Mat_VarReadNext(mat.file)) {
    const std::unique_ptr<matvar_t, void (*)(matvar_t*)> variable(next, &Mat_VarFree);
    const std::string name = variable->name ? variable->name : "";
    if (variable->class_type == MAT_C_CHAR && name.ends_with("_unit"))
      units[name.substr(0, name.size() - 5)] = text_of(*variable);
    else
      add_columns(*variable, columns);
  }
  for (LogColumn& column : columns) {
    auto unit = units.find(column.name);
    if (unit == units.end()) unit = units.find(column.name.substr(0, column.name.rfind('_')));
    if (unit != units.end()) column.name += " [" + unit->second + "]";
  }
  return columns;
}
#else
std::vector<LogColumn> read_mat(const std::string& path) {
  throw std::runtime_error(fmt::format(
      "{}:0:0: is a MAT file, which this program was built without: install libmatio-dev and build "
      "again, or save the log as CSV",
      readable_line(path)));
}
#endif

}  // namespace sinew
