// SPDX-License-Identifier: Apache-2.0
// Figures in messages.
#include "app/program/log.hpp"

#include <sys/file.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "prepared_scene.hpp"

using brunt::app::reported_from;

TEST_CASE("log: a folder that another run has taken since it was looked at is left as it is") {
  const brunt::support::SceneFolder folder;
  const std::string path = folder.write("log.txt", "of the other run\n");
  std::FILE* other = std::fopen(path.c_str(), "a");
  REQUIRE(flock(fileno(other), LOCK_EX | LOCK_NB) == 0);
  {
    brunt::app::Log log(true, true);
    CHECK_THROWS_AS(log.open(folder.path.string(), false), brunt::InputError);
  }
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  CHECK(text.str() == "of the other run\n");
  std::fclose(other);
  brunt::app::Log log(true, true);
  log.open(folder.path.string(), false);  // free again: begun anew
  CHECK(std::filesystem::file_size(path) == 0);
}

TEST_CASE("log: a figure above a limit is never written as the limit") {
  CHECK(reported_from(0.25, 1e-3) == "0.25");
  CHECK(reported_from(0.0123456, 1e-3) == "0.012");  // no more digits than it takes
  CHECK(reported_from(0.00100049, 1e-3) == "0.0010005");
  CHECK(reported_from(1.00000000000002e-4, 1e-4) != "0.0001");
  CHECK(reported_from(1e-3, 1e-3) == "0.001");  // nothing to tell
}

TEST_CASE("log: a duration is hours, minutes and seconds, and a dash where it is not known") {
  using brunt::app::clock_text;
  CHECK(clock_text(-1) == "-");
  CHECK(clock_text(0) == "0:00:00");
  CHECK(clock_text(59.6) == "0:01:00");
  CHECK(clock_text(3 * 3600 + 25 * 60 + 7.2) == "3:25:07");
  CHECK(clock_text(1e300) == "277777:46:40");
}
