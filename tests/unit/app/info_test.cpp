// SPDX-License-Identifier: Apache-2.0
// `brunt info` names itself, its libraries and what it can do.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <sstream>

#include "app/program/commands.hpp"
#include "prepared_scene.hpp"

using namespace brunt;

TEST_CASE("info: version, libraries, elements, materials") {
  const support::SceneFolder folder;
  std::fflush(stdout);
  const int terminal = dup(1);
  REQUIRE(std::freopen(folder.file("info").c_str(), "w", stdout));
  const int code = app::info(comm::Communicator::self());
  std::fflush(stdout);
  dup2(terminal, 1);
  close(terminal);
  CHECK(code == 0);
  std::stringstream said;
  said << std::ifstream(folder.file("info")).rdbuf();
  CHECK_THAT(said.str(), Catch::StartsWith(app::version() + "\n"));
  CHECK_THAT(app::version(), Catch::Matches("brunt [0-9]+\\.[0-9]+.*"));
  for (const char* word : {"MPI", "PETSc", "METIS", "Eigen", "hex8_full", "tet4", "j2", "Exodus II"})
    CHECK_THAT(said.str(), Catch::Contains(word));
}
