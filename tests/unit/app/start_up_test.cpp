// SPDX-License-Identifier: Apache-2.0
// Stages of a start have times and memory, which only grows.
#include "app/program/start_up.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <vector>

using namespace brunt;

TEST_CASE("start-up: each stage has its time, and memory never falls") {
  app::StartUp start_up;
  start_up.end(app::StartStage::reading);
  std::vector<char> held(std::size_t{256} << 20, 1);  // more than a test has used before
  start_up.end(app::StartStage::ordering);
  const auto report = start_up.report(comm::Communicator::self());
  CHECK(report.size() == app::start_stages);
  CHECK(report["ordering"]["seconds"].get<double>() > 0);
  CHECK(report["opening"]["seconds"].get<double>() == 0);
  const auto before = report["reading"]["peak_bytes"].get<GlobalIndex>();
  CHECK(before > 0);
  CHECK(report["ordering"]["peak_bytes"].get<GlobalIndex>() >= before + (GlobalIndex{100} << 20));
  CHECK(app::peak_memory() >= report["ordering"]["peak_bytes"].get<double>());
  CHECK(held.back() == 1);
}
