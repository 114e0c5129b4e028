// SPDX-License-Identifier: Apache-2.0
// Life of an HDF5 file, its groups and its attributes.
#include "io/hdf5.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "hdf5_handle.hpp"

namespace brunt::io {
namespace {

struct Found {
  std::vector<std::string> names;
  H5O_type_t wanted;
};

herr_t keep_link(hid_t group, const char* name, const H5L_info_t* /*link*/, void* found) {
  auto& result = *static_cast<Found*>(found);
  H5O_info_t info;
  if (H5Oget_info_by_name(group, name, &info, H5P_DEFAULT) < 0) return -1;
  if (info.type == result.wanted) result.names.emplace_back(name);
  return 0;
}

herr_t keep_object(hid_t /*group*/, const char* name, const H5O_info_t* info, void* found) {
  auto& result = *static_cast<Found*>(found);
  if (info->type == result.wanted) result.names.emplace_back(name);
  return 0;
}

}  // namespace

Hdf5File::Hdf5File(const comm::Communicator& ranks, std::string path, Mode mode)
    : ranks_(ranks), path_(std::move(path)) {
  std::string reason;
  file_ = mode == Mode::create ? create_parallel(ranks_, path_, reason)
                               : open_parallel(ranks_, path_, mode == Mode::append, reason);
  if (!ranks_.any(file_ < 0)) return;
  reason = first_reason(ranks_, reason);
  if (mode == Mode::create) throw MachineError(path_ + ": cannot create the file: " + reason);
  throw InputError(path_ + ": cannot read the file as HDF5 (" + reason + "); expected an undamaged file");
}

Hdf5File::~Hdf5File() {
  if (file_ >= 0) H5Fclose(file_);
}

void Hdf5File::flush() {
  require_written(H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0, "flush the file to disk", "");
}

void Hdf5File::close() {
  flush();
  const bool good = H5Fclose(file_) >= 0;
  file_ = -1;
  require_written(good, "close the file", "");
}

bool Hdf5File::contains(const std::string& object) const {
  for (std::size_t end = object.find('/', 1);; end = object.find('/', end + 1)) {
    if (H5Lexists(file_, object.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::vector<std::string> Hdf5File::groups(const std::string& group) const {
  Found found{{}, H5O_TYPE_GROUP};
  const bool good = H5Literate_by_name(file_, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, keep_link, &found,
                                       H5P_DEFAULT) >= 0;
  require_read(good, "list", group);
  std::sort(found.names.begin(), found.names.end());
  return found.names;
}

std::vector<std::string> Hdf5File::datasets(const std::string& group) const {
  Found found{{}, H5O_TYPE_DATASET};
  const bool good =
      H5Ovisit_by_name(file_, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, keep_object, &found, H5P_DEFAULT) >= 0;
  require_read(good, "list", group);
  std::sort(found.names.begin(), found.names.end());
  return found.names;
}

void Hdf5File::create_group(const std::string& group) {
  const Handle created(H5Gcreate2(file_, group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  require_written(created.good(), "create the group", group);
}

void Hdf5File::remove(const std::string& object) {
  require_written(H5Ldelete(file_, object.c_str(), H5P_DEFAULT) >= 0, "remove", object);
}

void Hdf5File::put_attribute(const std::string& object, const std::string& name, std::int64_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  const bool good = attribute.good() && H5Awrite(attribute.id(), type, value) >= 0;
  require_written(good, "write attribute " + name + " of", object);
}

void Hdf5File::get_attribute(const std::string& object, const std::string& name, std::int64_t type, void* value) const {
  const Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  bool good = attribute.good();
  if (good) {
    const Handle space(H5Aget_space(attribute.id()), H5Sclose);
    good = H5Sget_simple_extent_npoints(space.id()) == 1 && H5Aread(attribute.id(), type, value) >= 0;
  }
  require_read(good, "read attribute " + name + " of", object);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  put_attribute(object, name, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, GlobalIndex value) {
  put_attribute(object, name, H5T_NATIVE_INT64, &value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), text.size() + 1);
  put_attribute(object, name, type.id(), text.c_str());
}

bool Hdf5File::has_attribute(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

double Hdf5File::real_attribute(const std::string& object, const std::string& name) const {
  double value = 0;
  get_attribute(object, name, H5T_NATIVE_DOUBLE, &value);
  return value;
}

GlobalIndex Hdf5File::integer_attribute(const std::string& object, const std::string& name) const {
  GlobalIndex value = 0;
  get_attribute(object, name, H5T_NATIVE_INT64, &value);
  return value;
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const {
  std::size_t size = 0;
  {
    const Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const Handle type(attribute.good() ? H5Aget_type(attribute.id()) : -1, H5Tclose);
    if (type.good() && H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0)
      size = H5Tget_size(type.id());
    require_read(size > 0, "read attribute " + name + " of", object);
  }
  std::string text(size, '\0');
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), size);
  get_attribute(object, name, type.id(), text.data());
  text.resize(text.find('\0') == std::string::npos ? size : text.find('\0'));
  return text;
}

}  // namespace brunt::io
