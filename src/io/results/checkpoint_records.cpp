// SPDX-License-Identifier: Apache-2.0
#include "checkpoint_records.hpp"

#include <fmt/format.h>

#include "comm/rendezvous.hpp"
#include "core/error.hpp"
#include "io/disk_space.hpp"
#include "model/hash.hpp"

namespace brunt::io {
namespace {

GlobalIndex hash_of_all(const comm::Communicator& ranks, const RecordTable& table) {
  return ranks.sum(static_cast<GlobalIndex>(model::hash_records(table)));
}

}  // namespace

std::string keys_path(const RecordTable& table) {
  return "/records/" + table.name + "/keys";
}

std::string values_path(const RecordTable& table) {
  return "/records/" + table.name + "/values";
}

GlobalIndex record_bytes(const comm::Communicator& ranks, const RecordTable& table) {
  const GlobalIndex rows = ranks.sum(table.rows());
  return table_bytes(rows, table.key_width) + table_bytes(rows, table.value_width);
}

void write_records(Hdf5File& file, const RecordTable& table) {
  const GlobalIndex first = file.ranks().sum_before(table.rows()), all = file.ranks().sum(table.rows());
  file.create_integers(keys_path(table), all, table.key_width);
  file.write(keys_path(table), first, std::span<const GlobalIndex>(table.keys));
  file.create_doubles(values_path(table), all, table.value_width);
  file.write(values_path(table), first, std::span<const double>(table.values));
  file.set_attribute(values_path(table), "hash", hash_of_all(file.ranks(), table));
}

std::vector<std::string> record_faults(const Hdf5File& file, const RecordTable& table, const std::string& writer) {
  const Hdf5File::Extent keys = file.extent(keys_path(table)), values = file.extent(values_path(table));
  if (keys == Hdf5File::Extent{values.rows, table.key_width, Hdf5File::Type::integers} &&
      values == Hdf5File::Extent{keys.rows, table.value_width, Hdf5File::Type::doubles})
    return {};
  if (!writer.empty())
    return {
        fmt::format("{}: invalid for this version: written by {}, with other columns of records/{} ({} and {}); "
                    "expected {} and {}: "
                    "continue with the version that wrote it, or begin again",
                    file.path(), writer, table.name, keys.width, values.width, table.key_width, table.value_width)};
  return {fmt::format(
      "{}: invalid for this model: records/{} has keys {} x {} and values {} x {}; expected {} and {} columns",
      file.path(), table.name, keys.rows, keys.width, values.rows, values.width, table.key_width, table.value_width)};
}

RecordTable read_records(const Hdf5File& file, const RecordTable& table) {
  const comm::Communicator& ranks = file.ranks();
  const comm::BlockLayout layout{file.extent(keys_path(table)).rows, ranks.size()};
  const auto count = static_cast<std::size_t>(layout.count(ranks.rank()));
  RecordTable read{.name = table.name, .key_width = table.key_width, .value_width = table.value_width};
  read.keys.resize(count * static_cast<std::size_t>(table.key_width));
  read.values.resize(count * static_cast<std::size_t>(table.value_width));
  const GlobalIndex first = layout.first(ranks.rank());
  file.read(keys_path(table), first, std::span<GlobalIndex>(read.keys));
  file.read(values_path(table), first, std::span<double>(read.values));
  if (hash_of_all(ranks, read) != file.integer_attribute(values_path(table), "hash"))
    throw InputError(fmt::format(
        "{}: invalid values of records/{}: their hash differs from the stored one; expected an undamaged file",
        file.path(), table.name));
  return read;
}

}  // namespace brunt::io
