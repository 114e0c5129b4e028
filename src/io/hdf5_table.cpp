// SPDX-License-Identifier: Apache-2.0
// Tables in an HDF5 file: creation, and collective transfer of each rank's rows.
#include <array>

#include "core/error.hpp"
#include "hdf5_handle.hpp"
#include "io/hdf5.hpp"

namespace brunt::io {
namespace {

// Tables of one column are stored with one dimension, as other readers expect of scalars.
std::array<hsize_t, 2> dimensions(GlobalIndex rows, int width) {
  return {static_cast<hsize_t>(rows), static_cast<hsize_t>(width)};
}
int rank_of_table(int width) {
  return width == 1 ? 1 : 2;
}

}  // namespace

void Hdf5File::create_table(const std::string& name, GlobalIndex rows, int width, std::int64_t type) {
  const auto size = dimensions(rows, width);
  const Handle space(H5Screate_simple(rank_of_table(width), size.data(), nullptr), H5Sclose);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id(), 1);
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_fill_time(layout.id(), H5D_FILL_TIME_NEVER);  // every row is written right after
  H5Pset_obj_track_times(layout.id(), false);          // the same run writes the same bytes
  const Handle table(H5Dcreate2(file_, name.c_str(), type, space.id(), links.id(), layout.id(), H5P_DEFAULT), H5Dclose);
  require_written(table.good(), "create the table", name);
}

void Hdf5File::create_doubles(const std::string& name, GlobalIndex rows, int width) {
  create_table(name, rows, width, H5T_IEEE_F64LE);
}

void Hdf5File::create_integers(const std::string& name, GlobalIndex rows, int width) {
  create_table(name, rows, width, H5T_STD_I64LE);
}

Hdf5File::Extent Hdf5File::extent(const std::string& name) const {
  const Handle table(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  Extent extent;
  bool good = table.good();
  if (good) {
    const Handle space(H5Dget_space(table.id()), H5Sclose);
    const Handle type(H5Dget_type(table.id()), H5Tclose);
    std::array<hsize_t, 2> size{0, 1};
    const int dims = H5Sget_simple_extent_ndims(space.id());
    good = (dims == 1 || dims == 2) && H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) == dims;
    const H5T_class_t kind = H5Tget_class(type.id());
    good = good && (kind == H5T_FLOAT || kind == H5T_INTEGER);
    extent = {static_cast<GlobalIndex>(size[0]), static_cast<int>(size[1]),
              kind == H5T_INTEGER ? Type::integers : Type::doubles};
  }
  require_read(good, "open the table", name);
  return extent;
}

// Either source or target is given. HDF5 wants every rank in the call, also those without rows.
void Hdf5File::transfer(const std::string& name, GlobalIndex first_row, std::size_t values, std::int64_t type,
                        const void* source, void* target) const {
  const Extent table_extent = extent(name);
  if (table_extent.rows == 0) return;
  const auto width = static_cast<std::size_t>(table_extent.width);
  const auto rows = static_cast<GlobalIndex>(values / width);
  demand(values % width == 0 && first_row >= 0 && first_row + rows <= table_extent.rows, "rows outside of a table");

  const Handle table(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle in_file(H5Dget_space(table.id()), H5Sclose);
  const auto start = dimensions(first_row, 0);
  const auto count = dimensions(rows, table_extent.width);
  const Handle in_memory(H5Screate_simple(rank_of_table(table_extent.width), count.data(), nullptr), H5Sclose);
  if (rows > 0) {
    H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  } else {
    H5Sselect_none(in_file.id());
    H5Sselect_none(in_memory.id());
  }
  const Handle together(collective_transfer(), H5Pclose);
  if (source != nullptr) {
    const herr_t status = H5Dwrite(table.id(), type, in_memory.id(), in_file.id(), together.id(), source);
    require_written(status >= 0, "write", name);
  } else {
    const herr_t status = H5Dread(table.id(), type, in_memory.id(), in_file.id(), together.id(), target);
    require_read(status >= 0, "read", name);
  }
}

namespace {
const double no_value = 0;  // an empty span may have no address, which would not tell writing from reading
double unread_value = 0;
}  // namespace

void Hdf5File::write(const std::string& name, GlobalIndex first_row, std::span<const double> rows) {
  transfer(name, first_row, rows.size(), H5T_NATIVE_DOUBLE, rows.empty() ? &no_value : rows.data(), nullptr);
}

void Hdf5File::write(const std::string& name, GlobalIndex first_row, std::span<const std::int64_t> rows) {
  const void* source = rows.empty() ? static_cast<const void*>(&no_value) : rows.data();
  transfer(name, first_row, rows.size(), H5T_NATIVE_INT64, source, nullptr);
}

void Hdf5File::read(const std::string& name, GlobalIndex first_row, std::span<double> rows) const {
  transfer(name, first_row, rows.size(), H5T_NATIVE_DOUBLE, nullptr, rows.empty() ? &unread_value : rows.data());
}

void Hdf5File::read(const std::string& name, GlobalIndex first_row, std::span<std::int64_t> rows) const {
  void* target = rows.empty() ? static_cast<void*>(&unread_value) : rows.data();
  transfer(name, first_row, rows.size(), H5T_NATIVE_INT64, nullptr, target);
}

}  // namespace brunt::io
