// SPDX-License-Identifier: Apache-2.0
// Checkpoints: damage is found, other models are refused, the last two are kept, a full disk loses nothing.
#include "io/results/checkpoint.hpp"

#include <fmt/format.h>

#include <bit>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "file_size_limit.hpp"
#include "io/hdf5.hpp"
#include "model/hash.hpp"
#include "scratch_folder.hpp"
#include "small_model.hpp"

using namespace brunt;
namespace fs = std::filesystem;

namespace {

struct Fixture {
  comm::Communicator self = comm::Communicator::self();
  test::ScratchFolder folder{self};
  test::SmallModel model{self};
  Fixture() { model.fill_known(); }

  std::string write(GlobalIndex step) {
    return io::write_checkpoint(self, folder.path(), {step, 0.5, "scene"}, model.registry);
  }
  std::string fault_of(const std::string& path, const model::Registry& registry,
                       const std::string& fingerprint = "scene") {
    try {
      io::read_checkpoint(self, path, fingerprint, registry);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE_METHOD(Fixture, "checkpoint: the last two are kept, and later ones of a run given up are not") {
  CHECK_FALSE(io::latest_checkpoint(folder / "none"));
  for (const int step : {10, 20, 30}) write(step);
  CHECK_FALSE(fs::exists(folder / "checkpoint_000000010.h5"));
  CHECK(fs::exists(folder / "checkpoint_000000020.h5"));
  CHECK(io::latest_checkpoint(folder.path()) == folder / "checkpoint_000000030.h5");
  write(25);
  CHECK(fs::exists(folder / "checkpoint_000000020.h5"));
  CHECK(io::latest_checkpoint(folder.path()) == folder / "checkpoint_000000025.h5");
  CHECK(io::read_checkpoint_header(self, folder / "checkpoint_000000025.h5").step == 25);
}

TEST_CASE_METHOD(Fixture, "checkpoint: a file cut anywhere is refused and changes nothing") {
  const std::string path = write(1);
  const std::string whole = bytes_of(path);
  test::SmallModel target(self);
  const int before = target.wrong_values();
  for (int tenth = 0; tenth < 10; ++tenth) {
    write_bytes(path, whole.substr(0, whole.size() * static_cast<std::size_t>(tenth) / 10));
    const std::string fault = fault_of(path, target.registry);
    CHECK_THAT(fault, Catch::Contains(path));
    CHECK(target.wrong_values() == before);
  }
}

TEST_CASE_METHOD(Fixture, "checkpoint: a flipped bit among the values is found and the table named") {
  const std::string path = write(1);
  std::string bytes = bytes_of(path);
  const double value = test::SmallModel::known(0, 2, 1);  // velocity of node 2
  const std::size_t at = bytes.find(std::string(reinterpret_cast<const char*>(&value), sizeof value));
  REQUIRE(at != std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);  // the last bit of the mantissa
  write_bytes(path, bytes);
  CHECK_THAT(fault_of(path, model.registry),
             Catch::Contains(path) && Catch::Contains("invalid values of nodes/velocity: their hash differs"));
}

TEST_CASE_METHOD(Fixture, "checkpoint: a flipped bit among records is found, and what was read before is kept") {
  RecordTable pairs{.name = "pairs", .key_width = 1, .value_width = 1, .keys = {0x1234567}, .values = {0.7}};
  model.registry.tables.push_back(&pairs);
  const std::string path = write(1);
  const std::string whole = bytes_of(path);
  for (const void* place :
       {static_cast<const void*>(pairs.keys.data()), static_cast<const void*>(pairs.values.data())}) {
    std::string bytes = whole;
    const std::size_t at = bytes.find(std::string(static_cast<const char*>(place), 8));
    REQUIRE(at != std::string::npos);
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    write_bytes(path, bytes);
    RecordTable target{.name = "pairs", .key_width = 1, .value_width = 1, .keys = {5}, .values = {5}};
    model.registry.tables = {&target};
    CHECK_THAT(fault_of(path, model.registry), Catch::Contains("invalid values of records/pairs: their hash differs"));
    CHECK((target.keys[0] == 5 && target.values[0] == 5));
  }
}

TEST_CASE_METHOD(Fixture, "checkpoint: a bit flipped anywhere is refused, or harmless") {
  const std::string path = write(1);
  const std::string whole = bytes_of(path);
  int refused = 0;
  for (std::size_t i = 0; i < 250; ++i) {
    std::string bytes = whole;
    char& byte = bytes[i * 7919 % whole.size()];
    byte = static_cast<char>(byte ^ (1 << (i % 8)));
    write_bytes(path, bytes);
    test::SmallModel target(self);
    const bool read = fault_of(path, target.registry).empty();
    CHECK((read ? target.wrong_values() == 0 : true));
    refused += read ? 0 : 1;
  }
  CHECK(refused > 20);  // the others lie in unused space of the file
}

TEST_CASE_METHOD(Fixture, "checkpoint: another scene, other arrays, other counts are told") {
  const std::string path = write(1);
  CHECK_THAT(fault_of(path, model.registry, "another"), Catch::Contains("another scene or program version"));
  model::Registry renamed = model.registry;
  renamed.arrays[0].name = "momentum";
  CHECK_THAT(fault_of(path, renamed),
             Catch::Contains("missing table nodes/momentum") && Catch::Contains("unknown table nodes/velocity"));
  model::Registry larger = model.registry;
  larger.global_nodes += 1;
  CHECK_THAT(fault_of(path, larger), Catch::Contains("nodes/velocity has the size 23 x 3; expected 24 x 3"));
}

TEST_CASE_METHOD(Fixture, "checkpoint: format 3, which had no measured times, is read; an older one is refused") {
  const io::RankWork work{0.25, 0.125, {std::vector<double>(11, 0.0), std::vector<double>(5, 0.0)}};
  const std::string path = io::write_checkpoint(self, folder.path(), {7, 0.5, "scene"}, model.registry, &work);
  const std::string old = folder / "old.h5";
  const auto make = [&](GlobalIndex format) {
    const io::Hdf5File from(self, path, io::Hdf5File::Mode::read);
    io::Hdf5File file(self, old, io::Hdf5File::Mode::create);
    for (const std::string& name : from.datasets("/")) {
      if (name.starts_with("measured/")) continue;
      const io::Hdf5File::Extent extent = from.extent("/" + name);
      std::vector<double> rows(static_cast<std::size_t>(extent.rows) * static_cast<std::size_t>(extent.width));
      from.read("/" + name, 0, std::span<double>(rows));
      file.create_doubles("/" + name, extent.rows, extent.width);
      file.write("/" + name, 0, std::span<const double>(rows));
      file.set_attribute("/" + name, "hash", from.integer_attribute("/" + name, "hash"));
    }
    const std::string header =
        fmt::format("{} 7 {} {} scene", format, std::bit_cast<std::uint64_t>(0.5), test::SmallModel::nodes);
    file.set_attribute("/", "format", format);
    file.set_attribute("/", "fingerprint", std::string("scene"));
    file.set_attribute("/", "step", GlobalIndex{7});
    file.set_attribute("/", "time", 0.5);
    file.set_attribute("/", "nodes", test::SmallModel::nodes);
    file.set_attribute("/", "hash", static_cast<GlobalIndex>(model::hash_text(header)));
    file.close();
  };
  make(3);
  test::SmallModel target(self);
  CHECK(target.wrong_values() > 0);
  const io::CheckpointHeader header = io::read_checkpoint(self, old, "scene", target.registry);
  CHECK((header.step == 7 && header.time == 0.5));
  CHECK(target.wrong_values() == 0);
  make(2);
  CHECK_THAT(fault_of(old, target.registry), Catch::Contains("unknown checkpoint format 2; expected 3 to 5"));
}

TEST_CASE_METHOD(Fixture, "checkpoint: what it may lack stays as it is, and is read where it is there") {
  const std::string path = write(1);
  double later = 5;
  model::Registry more = model.registry;
  more.arrays.push_back({"later", model::StateArray::Entity::global, -1, 1, 1, &later, 1, 1});
  CHECK_THAT(fault_of(path, more), Catch::Contains("missing table globals/later"));
  more.arrays.back().expected = false;
  CHECK(fault_of(path, more).empty());
  CHECK(later == 5);
  io::write_checkpoint(self, folder.path(), {1, 0.5, "scene"}, more);
  later = 6;
  CHECK(fault_of(path, more).empty());
  CHECK(later == 5);
}

TEST_CASE_METHOD(Fixture, "checkpoint: a full disk is a MachineError and leaves the checkpoints before as they were") {
  const std::string sound = write(1);
  {
    const test::FileSizeLimit full_disk(4096);
    CHECK_THROWS_AS(write(2), MachineError);
  }
  CHECK(io::latest_checkpoint(folder.path()) == sound);
  CHECK_FALSE(fs::exists(folder / "checkpoint_000000002.h5.tmp"));
  CHECK(fault_of(sound, model.registry).empty());
}

TEST_CASE_METHOD(Fixture, "checkpoint: no folder, and a file in the folder's place") {
  CHECK_THROWS_WITH(io::write_checkpoint(self, folder / "none", {1, 0, ""}, model.registry),
                    Catch::Contains("No such file"));
  write_bytes(folder / "file", "x");
  CHECK_THROWS_WITH(io::write_checkpoint(self, folder / "file", {1, 0, ""}, model.registry),
                    Catch::Contains("Not a directory"));
  CHECK_THAT(fault_of(folder / "none.h5", model.registry), Catch::Contains("No such file"));
  CHECK_THAT(fault_of(folder / "file", model.registry),
             Catch::Contains("cannot read the file as HDF5") && Catch::Contains("signature"));
}
