// SPDX-License-Identifier: Apache-2.0
// What ranks have measured is read back from a checkpoint, which is the same checkpoint without it.
#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "io/hdf5.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/compare.hpp"
#include "scratch_folder.hpp"
#include "small_model.hpp"

using namespace brunt;

namespace {

struct Fixture {
  comm::Communicator self = comm::Communicator::self();
  test::ScratchFolder folder{self};
  test::SmallModel model{self};
  io::RankWork work{0.25, 0.125, {std::vector<double>(11, 0.0), {1, 2, 3, 4, 5}}};
  Fixture() { model.fill_known(); }

  std::string write(const io::RankWork* measured) {
    return io::write_checkpoint(self, folder.path(), {7, 0.5, "scene"}, model.registry, measured);
  }
  static std::string fault_of(const std::string& path) {
    try {
      (void)io::read_measured_work(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

}  // namespace

TEST_CASE_METHOD(Fixture, "measured tables: read back, and no part of the state") {
  const std::string path = write(&work);
  const io::MeasuredWork read = io::read_measured_work(path);
  CHECK(read.element_seconds == std::vector<double>{0.25});
  CHECK(read.contact_seconds == std::vector<double>{0.125});
  CHECK(read.rank == std::vector<Rank>(16, 0));
  REQUIRE(read.pairs.size() == 16);
  CHECK(read.pairs[10] == 0);
  CHECK(read.pairs[11] == 1);
  CHECK(read.pairs[15] == 5);
  CHECK(io::read_checkpoint(self, path, "scene", model.registry).step == 7);
  CHECK(model.wrong_values() == 0);
}

TEST_CASE_METHOD(Fixture, "measured tables: a checkpoint without them, no checkpoint, and damage are told") {
  const std::string path = write(nullptr);
  CHECK_THAT(fault_of(path), Catch::Contains("missing measured times"));
  CHECK_THAT(fault_of(folder / "none.h5"), Catch::Contains("none.h5"));
  io::Hdf5File(self, folder / "other.h5", io::Hdf5File::Mode::create).close();
  CHECK_THAT(fault_of(folder / "other.h5"), Catch::Contains("invalid checkpoint"));
  write(&work);
  {
    io::Hdf5File file(self, path, io::Hdf5File::Mode::append);
    const std::vector<std::int64_t> row{3, 0};  // a rank that there is not
    file.write("/measured/elements", 2, std::span<const std::int64_t>(row));
    file.close();
  }
  CHECK_THAT(fault_of(path), Catch::Contains("damaged"));
}
