// SPDX-License-Identifier: Apache-2.0
#include "io/results/partition_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"
#include "io/hdf5.hpp"

namespace brunt::io {
namespace {

constexpr GlobalIndex format_version = 1;

std::string file_in(const std::string& folder) {
  return (std::filesystem::path(folder) / "partition.h5").string();
}

}  // namespace

void write_partition(const std::string& folder, const PartitionFile& partition) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw MachineError(fmt::format("{}: cannot create the folder: {}", folder, failed.message()));
  Hdf5File file(comm::Communicator::self(), file_in(folder), Hdf5File::Mode::create);
  file.set_attribute("/", "partition_format", format_version);
  file.set_attribute("/", "parts", GlobalIndex{partition.parts});
  file.set_attribute("/", "fingerprint", partition.fingerprint);
  constexpr std::size_t longest_attribute = 60000;  // HDF5 takes 64 kB
  if (partition.scene.size() < longest_attribute) file.set_attribute("/", "scene", partition.scene);
  file.create_integers("/part", static_cast<GlobalIndex>(partition.part.size()), 1);
  const std::vector<std::int64_t> rows(partition.part.begin(), partition.part.end());
  file.write("/part", 0, std::span<const std::int64_t>(rows));
  file.close();
}

PartitionFile read_partition(const std::string& folder) {
  const std::string path = file_in(folder);
  if (!std::filesystem::exists(path))
    throw InputError(folder + ": invalid partition; expected a folder written by `brunt partition ... --write DIR`");
  const Hdf5File file(comm::Communicator::self(), path, Hdf5File::Mode::read);
  if (!file.has_attribute("/", "partition_format") || !file.has_attribute("/", "fingerprint") ||
      !file.contains("/part"))
    throw InputError(path + ": invalid partition; expected a file written by `brunt partition ... --write DIR`");
  if (const GlobalIndex version = file.integer_attribute("/", "partition_format"); version != format_version)
    throw InputError(fmt::format("{}: unknown partition format {}; expected {}", path, version, format_version));
  PartitionFile partition;
  partition.parts = static_cast<int>(file.integer_attribute("/", "parts"));
  partition.fingerprint = file.text_attribute("/", "fingerprint");
  if (file.has_attribute("/", "scene")) partition.scene = file.text_attribute("/", "scene");
  std::vector<std::int64_t> rows(static_cast<std::size_t>(file.extent("/part").rows));
  file.read("/part", 0, std::span<std::int64_t>(rows));
  partition.part.reserve(rows.size());
  for (const std::int64_t part : rows) {
    if (part < 0 || part >= partition.parts)
      throw InputError(fmt::format("{}: out of range: part {}; expected 0 to {}", path, part, partition.parts - 1));
    partition.part.push_back(static_cast<Rank>(part));
  }
  return partition;
}

}  // namespace brunt::io
