// SPDX-License-Identifier: Apache-2.0
// Checkpoints written on one number of ranks and read on another restore every bit.
#include "io/results/checkpoint.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/error.hpp"
#include "model/hash.hpp"
#include "unit/io/file_size_limit.hpp"
#include "unit/io/scratch_folder.hpp"
#include "unit/io/small_model.hpp"

using namespace brunt;

namespace {

const io::CheckpointHeader header{42, 1.5e-6, "brunt 0.1 scene abc"};

GlobalIndex state_hash(const comm::Communicator& ranks, const model::Registry& registry) {
  return ranks.sum(static_cast<GlobalIndex>(model::hash_of_rank(registry, ranks.is_root())));
}

/// This rank's share of so many records, dealt out unevenly: the last rank has none.
RecordTable records_of(const comm::Communicator& ranks, GlobalIndex count) {
  RecordTable table{.name = "pairs", .key_width = 2, .value_width = 3};
  const GlobalIndex takers = std::max(1, ranks.size() - 1);
  for (GlobalIndex i = 0; i < count; ++i) {
    if (i % takers != ranks.rank()) continue;
    table.keys.insert(table.keys.end(), {i / 3, -i});
    for (int c = 0; c < 3; ++c) table.values.push_back(test::SmallModel::known(7, i, c + 1));
  }
  return table;
}

}  // namespace

TEST_CASE("checkpoint: records written by any ranks are all read, by any others") {
  const auto world = comm::Communicator::world();
  const auto self = comm::Communicator::self();
  const test::ScratchFolder folder(world);
  for (const GlobalIndex count : {0, 1, 50}) {
    test::SmallModel model(world);
    model.fill_known();
    RecordTable records = records_of(world, count);
    model.registry.tables.push_back(&records);
    const std::string path = io::write_checkpoint(world, folder.path(), header, model.registry);
    const GlobalIndex written = state_hash(world, model.registry);
    records.keys.assign(2, 99);
    records.values.assign(3, 99);
    io::read_checkpoint(world, path, header.fingerprint, model.registry);
    CHECK(world.sum(records.rows()) == count);
    CHECK(state_hash(world, model.registry) == written);

    test::SmallModel alone(self);
    RecordTable whole{.name = "pairs", .key_width = 2, .value_width = 3};
    alone.registry.tables.push_back(&whole);
    io::read_checkpoint(self, path, header.fingerprint, alone.registry);
    CHECK(whole.rows() == count);
    CHECK(state_hash(self, alone.registry) == written);

    whole.value_width = 2;
    CHECK_THROWS_WITH(io::read_checkpoint(self, path, header.fingerprint, alone.registry),
                      Catch::Contains("invalid for this model: records/pairs has keys"));
    alone.registry.tables.clear();
    CHECK_THROWS_WITH(io::read_checkpoint(self, path, header.fingerprint, alone.registry),
                      Catch::Contains("invalid for this model: unknown table records/pairs/keys"));
    world.barrier();
  }
}

TEST_CASE("checkpoint: all ranks to all ranks, to one rank, and from one rank") {
  const auto world = comm::Communicator::world();
  const auto self = comm::Communicator::self();
  const test::ScratchFolder folder(world);
  test::SmallModel written(world);
  written.fill_known();
  const std::string path = io::write_checkpoint(world, folder.path(), header, written.registry);
  CHECK(path == folder / "checkpoint_000000042.h5");
  CHECK_FALSE(std::filesystem::exists(path + ".tmp"));

  test::SmallModel by_all(world);
  REQUIRE(by_all.wrong_values() > 0);
  CHECK(io::read_checkpoint(world, path, header.fingerprint, by_all.registry).step == 42);
  CHECK(by_all.wrong_values() == 0);
  test::SmallModel by_one(self);
  CHECK(io::read_checkpoint(self, path, header.fingerprint, by_one.registry).time == 1.5e-6);
  CHECK(by_one.wrong_values() == 0);
  CHECK(state_hash(world, by_all.registry) == state_hash(self, by_one.registry));

  const std::string single = folder / "single";
  if (world.is_root()) {
    std::filesystem::create_directories(single);
    io::write_checkpoint(self, single, header, by_one.registry);
  }
  world.barrier();
  test::SmallModel from_one(world);
  io::read_checkpoint(world, single + "/checkpoint_000000042.h5", header.fingerprint, from_one.registry);
  CHECK(from_one.wrong_values() == 0);
}

TEST_CASE("checkpoint: a damaged file and an unwritable folder are told on all ranks alike") {
  const auto world = comm::Communicator::world();
  const test::ScratchFolder folder(world);
  test::SmallModel model(world);
  model.fill_known();
  const std::string path = io::write_checkpoint(world, folder.path(), header, model.registry);
  if (world.is_root()) std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  world.barrier();
  CHECK_THROWS_AS(io::read_checkpoint(world, path, header.fingerprint, model.registry), InputError);
  CHECK_THROWS_WITH(io::write_checkpoint(world, folder / "none", header, model.registry),
                    Catch::Contains("No such file"));
}

TEST_CASE("checkpoint: a full disk throws on all ranks, none waits, and the run can go on") {
  const auto world = comm::Communicator::world();
  const test::ScratchFolder folder(world);
  test::SmallModel model(world);
  model.fill_known();
  {
    const test::FileSizeLimit full_disk(4096);
    CHECK_THROWS_AS(io::write_checkpoint(world, folder.path(), header, model.registry), MachineError);
  }
  const std::string path = io::write_checkpoint(world, folder.path(), header, model.registry);
  CHECK(io::read_checkpoint(world, path, header.fingerprint, model.registry).step == 42);
}
