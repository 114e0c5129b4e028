// SPDX-License-Identifier: Apache-2.0
// A partition is read back; other files and parts out of range are refused by name.
#include "io/results/partition_file.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "io/hdf5.hpp"
#include "scratch_folder.hpp"

using namespace brunt;

namespace {

std::string fault_of(const std::string& path) {
  try {
    (void)io::read_partition(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("partition file: read back, others refused") {
  const comm::Communicator self = comm::Communicator::self();
  const test::ScratchFolder folder(self);
  const std::string path = folder / "p";
  io::write_partition(path, {3, "f", "a=1\n", {0, 2, 1, 1}});
  const io::PartitionFile read = io::read_partition(path);
  CHECK(read.parts == 3);
  CHECK(read.fingerprint == "f");
  CHECK(read.scene == "a=1\n");
  CHECK(read.part == std::vector<Rank>{0, 2, 1, 1});

  CHECK_THAT(fault_of(folder / "none"), Catch::Contains("none"));
  io::write_partition(folder / "other", {1, "f", "", {0}});
  io::Hdf5File(self, folder / "other/partition.h5", io::Hdf5File::Mode::create).close();
  CHECK_THAT(fault_of(folder / "other"), Catch::Contains("invalid partition"));
  io::write_partition(path, {2, "f", "", {0, 2}});
  CHECK_THAT(fault_of(path), Catch::Contains("out of range: part 2; expected 0 to 1"));
}
