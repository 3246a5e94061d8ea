// SPDX-License-Identifier: GPL-3.0-or-later
// HDF5 files: every dataset of numbers with one axis, or two; its unit is the attribute unit or
// units. A dataset inside groups is called by its path, with points.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "identification/logs/converted_log.h"
#include "symbolic/files/readable.h"

#if __has_include(<hdf5.h>)
#include <hdf5.h>
#endif

namespace sinew {

#if __has_include(<hdf5.h>)
namespace {

/// An identifier of the library, closed at the end.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

std::string unit_attribute(hid_t dataset) {
  for (const char* name : {"unit", "units"}) {
    if (H5Aexists(dataset, name) <= 0) continue;
    const Handle attribute(H5Aopen(dataset, name, H5P_DEFAULT), H5Aclose);
    const Handle type(H5Aget_type(attribute), H5Tclose);
    if (attribute < 0 || H5Tget_class(type) != H5T_STRING) continue;
    if (H5Tis_variable_str(type) > 0) {
      char* text = nullptr;
      const Handle whole(H5Tcopy(H5T_C_S1), H5Tclose);
      H5Tset_size(whole, H5T_VARIABLE);
      H5Tset_cset(whole, H5Tget_cset(type));
      if (H5Aread(attribute, whole, &text) < 0 || !text) continue;
      const std::string unit = text;
      H5free_memory(text);
      return unit;
    }
    std::string text(H5Tget_size(type) + 1, '\0');
    if (H5Aread(attribute, type, text.data()) >= 0) return text.c_str();
  }
  return "";
}

void add_dataset(hid_t file, const char* path, std::vector<LogColumn>& columns) {
  const Handle dataset(H5Dopen2(file, path, H5P_DEFAULT), H5Dclose);
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const Handle type(H5Dget_type(dataset), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type);
  const int axes = H5Sget_simple_extent_ndims(space);
  if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || axes < 1 || axes > 2) return;
  hsize_t shape[2] = {0, 1};
  H5Sget_simple_extent_dims(space, shape, nullptr);
  std::vector<double> all(shape[0] * shape[1]);
  if (all.empty() ||
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0)
    return;
  std::string name = path;
  std::replace(name.begin(), name.end(), '/', '.');
  if (shape[0] == 1) std::swap(shape[0], shape[1]);  // a row is a vector, too
  const std::string unit = unit_attribute(dataset);
  for (hsize_t k = 0; k < shape[1]; ++k) {
    LogColumn column{shape[1] == 1 ? name : fmt::format("{}_{}", name, k + 1), {}};
    if (!unit.empty()) column.name += " [" + unit + "]";
    for (hsize_t row = 0; row < shape[0]; ++row) column.values.push_back(all[row * shape[1] + k]);
    columns.push_back(std::move(column));
  }
}

herr_t visit(hid_t file, const char* path, const H5O_info_t* info, void* columns) {
  if (info->type == H5O_TYPE_DATASET)
    add_dataset(file, path, *static_cast<std::vector<LogColumn>*>(columns));
  return 0;
}

}  // namespace

std::vector<LogColumn> read_hdf5(const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // the library would print by itself
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  std::vector<LogColumn> columns;
  if (file < 0 || H5Ovisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, visit, &columns) < 0)
    throw std::runtime_error(fmt::format(
        "{}:0:0: cannot be read as an HDF5 file; save it again, or as CSV", readable_line(path)));
  return columns;
}
#else
std::vector<LogColumn> read_hdf5(const std::string& path) {
  throw std::runtime_error(
      fmt::format("{}:0:0: is an HDF5 file, which this program was built without: install "
                  "libhdf5-dev and build "
                  "again, or save the log as CSV",
                  readable_line(path)));
}
#endif

}  // namespace sinew
