// SPDX-License-Identifier: Apache-2.0
// The result folder and its summary.
#include "io/results/result_folder.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "io/results/summary.hpp"
#include "io/text_file.hpp"
#include "scratch_folder.hpp"

using namespace brunt;
using io::ExistingResults;
namespace fs = std::filesystem;

TEST_CASE("result folder: made with those above it; results in it are kept, replaced or refused as asked") {
  const auto self = comm::Communicator::self();
  const test::ScratchFolder scratch(self);
  const std::string folder = scratch / "a/b.out";
  io::prepare_result_folder(self, folder, ExistingResults::refuse, {});
  CHECK(fs::is_empty(folder));
  io::replace_text(folder + "/notes.txt", "mine");
  io::prepare_result_folder(self, folder, ExistingResults::refuse, {});  // the user's own files are no results

  for (const char* name : {"summary.json", "checkpoint_000000001.h5"}) io::replace_text(folder + "/" + name, "");
  CHECK_THROWS_WITH(io::prepare_result_folder(self, folder, ExistingResults::refuse, {}),
                    Catch::Contains("checkpoint_000000001.h5") && Catch::Contains("--force"));
  io::prepare_result_folder(self, folder, ExistingResults::keep, {});
  CHECK(fs::exists(folder + "/summary.json"));
  io::prepare_result_folder(self, folder, ExistingResults::replace, {});
  CHECK_FALSE(fs::exists(folder + "/summary.json"));
  CHECK(fs::exists(folder + "/notes.txt"));
}

TEST_CASE("result folder: a request to stop from before the run is removed, whatever its time; a newer one is kept") {
  const auto self = comm::Communicator::self();
  const test::ScratchFolder scratch(self);
  const std::string folder = scratch / "out", request = folder + "/" + io::stop_file;
  CHECK_FALSE(io::prepare_result_folder(self, folder, ExistingResults::refuse, io::stop_request(folder)));
  for (const auto existing : {ExistingResults::refuse, ExistingResults::replace, ExistingResults::keep}) {
    for (const int hours : {-2, 0, 24 * 365}) {  // also of a machine whose clock is ahead
      io::replace_text(request, "");
      fs::last_write_time(request, fs::last_write_time(request) + std::chrono::hours(hours));
      const io::StopRequest earlier = io::stop_request(folder);
      CHECK(io::prepare_result_folder(self, folder, existing, earlier));
      CHECK_FALSE(fs::exists(request));
      io::replace_text(request, "");  // made while the mesh is read
      CHECK_FALSE(io::prepare_result_folder(self, folder, existing, earlier));
      CHECK(fs::exists(request));
      const io::StopRequest second = io::stop_request(folder);
      fs::last_write_time(request, fs::last_write_time(request) + std::chrono::hours(hours + 1));
      CHECK_FALSE(io::prepare_result_folder(self, folder, existing, second));  // touched
      fs::remove(request);
    }
  }
}

TEST_CASE("result folder: a file in its place and a place where nothing can be made are the user's fault") {
  const auto self = comm::Communicator::self();
  const test::ScratchFolder scratch(self);
  io::replace_text(scratch / "file", "");
  CHECK_THROWS_AS(io::prepare_result_folder(self, scratch / "file", ExistingResults::refuse, {}), InputError);
  CHECK_THROWS_AS(io::prepare_result_folder(self, scratch / "file/below", ExistingResults::refuse, {}), InputError);
  for (const char* place : {"/proc", "/proc/results", "/proc/results/x"}) {
    INFO(place);
    CHECK_THROWS_AS(io::prepare_result_folder(self, place, ExistingResults::refuse, {}), InputError);
    CHECK_THROWS_WITH(io::prepare_result_folder(self, place, ExistingResults::refuse, {}), Catch::Contains("--out"));
  }
}

TEST_CASE("summary: readable JSON in the order given, numbers that JSON has not become null") {
  const test::ScratchFolder folder(comm::Communicator::self());
  nlohmann::ordered_json summary;
  summary["steps"] = 400;
  summary["momentum_error"] = std::numeric_limits<double>::quiet_NaN();
  summary["warnings"] = {"bad \xff byte"};
  io::write_summary(folder.path(), summary);
  const auto read = nlohmann::ordered_json::parse(io::read_text(folder / "summary.json"));
  CHECK(read.begin().key() == "steps");
  CHECK(read["steps"] == 400);
  CHECK(read["momentum_error"].is_null());
  CHECK_FALSE(fs::exists(folder / "summary.json.tmp"));
  CHECK_THROWS_AS(io::write_summary(folder / "none", summary), MachineError);
}
