// SPDX-License-Identifier: Apache-2.0
// State files: the same content however the mesh is split; restart drops later records.
#include "io/results/state_file.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/error.hpp"
#include "io/results/compare.hpp"
#include "unit/io/file_size_limit.hpp"
#include "unit/io/scratch_folder.hpp"
#include "unit/io/small_mesh.hpp"

using namespace brunt;

TEST_CASE("state file: every split of the mesh gives the same file content, in the input's order") {
  const auto world = comm::Communicator::world();
  const auto self = comm::Communicator::self();
  const test::ScratchFolder folder(world);
  const test::SmallMesh split(world), whole(self);
  {
    io::StateFile file(world, folder.path(), split.mesh);
    file.write(0, 0.0, split.fields(0));
    file.write(10, 2.5, split.fields(10));
  }
  const std::string single = folder / "single";
  if (world.is_root()) {
    std::filesystem::create_directories(single);
    io::StateFile file(self, single, whole.mesh);
    file.write(0, 0.0, whole.fields(0));
    file.write(10, 2.5, whole.fields(10));
  }
  world.barrier();
  const io::Comparison same = io::compare_results(world, folder / "state.h5", single + "/state.h5");
  CHECK(same.mismatches.empty());
  REQUIRE(same.fields.size() == 4);  // time, displacement, stress, alive
  CHECK(same.within(0));

  const io::Hdf5File file(self, folder / "state.h5", io::Hdf5File::Mode::read);
  const auto records = io::state_records(file);
  REQUIRE(records.size() == 2);
  CHECK(records[1].time == 2.5);
  std::vector<double> stress(static_cast<std::size_t>(test::SmallMesh::elements) * 6);
  file.read(records[1].group + "/element/stress", 0, std::span<double>(stress));
  for (GlobalIndex e = 0; e < test::SmallMesh::elements; ++e)
    for (int c = 0; c < 6; ++c) CHECK(stress[static_cast<std::size_t>(6 * e + c)] == test::SmallMesh::stress(10, e, c));
}

TEST_CASE("state file: after a restart the records of later steps are gone and writing goes on") {
  const auto world = comm::Communicator::world();
  const test::ScratchFolder folder(world);
  const test::SmallMesh split(world);
  {
    io::StateFile file(world, folder.path(), split.mesh);
    for (const int step : {0, 10, 20, 30}) file.write(step, 0.1 * step, split.fields(step));
  }
  {
    io::StateFile file(world, folder.path(), split.mesh, 15);
    file.write(25, 2.5, split.fields(25));
  }
  const io::Hdf5File file(world, folder / "state.h5", io::Hdf5File::Mode::read);
  std::vector<GlobalIndex> steps;
  for (const io::StateRecord& record : io::state_records(file)) steps.push_back(record.step);
  CHECK(steps == std::vector<GlobalIndex>{0, 10, 25});

  test::SmallMesh other(world);
  other.mesh.global_elements += 1;
  CHECK_THROWS_WITH(io::StateFile(world, folder.path(), other.mesh, 15), Catch::Contains("another mesh"));
}

TEST_CASE("state file: a full disk throws on all ranks and the records before stay readable") {
  const auto world = comm::Communicator::world();
  const test::ScratchFolder folder(world);
  const test::SmallMesh split(world);
  {
    io::StateFile file(world, folder.path(), split.mesh);
    file.write(0, 0, split.fields(0));
    world.barrier();
    const test::FileSizeLimit full_disk(std::filesystem::file_size(folder / "state.h5"));
    CHECK_THROWS_AS(file.write(10, 1, split.fields(10)), MachineError);
    world.barrier();
  }
  CHECK(io::state_records(io::Hdf5File(world, folder / "state.h5", io::Hdf5File::Mode::read)).size() == 1);
}
