// SPDX-License-Identifier: Apache-2.0
// `brunt info` names itself, its libraries and what it can do.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/program/commands.hpp"
#include "prepared_scene.hpp"

using namespace brunt;

namespace {

/// What the command prints.
std::string printed(const app::InfoOptions& options) {
  const support::SceneFolder folder;
  std::fflush(stdout);
  const int terminal = dup(1);
  REQUIRE(std::freopen(folder.file("info").c_str(), "w", stdout));
  const int code = app::info(comm::Communicator::self(), options);
  std::fflush(stdout);
  dup2(terminal, 1);
  close(terminal);
  CHECK(code == 0);
  std::stringstream said;
  said << std::ifstream(folder.file("info")).rdbuf();
  return said.str();
}

}  // namespace

TEST_CASE("info: version, libraries, elements, materials") {
  const std::string said = printed({});
  CHECK_THAT(said, Catch::StartsWith(app::version() + "\n"));
  CHECK_THAT(app::version(), Catch::Matches("brunt [0-9]+\\.[0-9]+.*"));
  for (const char* word : {"MPI", "PETSc", "METIS", "Eigen", "hex8_full", "tet4", "j2", "Exodus II"})
    CHECK_THAT(said, Catch::Contains(word));
}

TEST_CASE("info: the keys of a scene, to be read and for programs") {
  const std::string text = printed({.keys = true});
  CHECK_THAT(text, Catch::Contains("\nrun.end: number > 0 [time]; required, or steps\n    The run ends with"));
  CHECK_THAT(text, Catch::Contains("\nmaterials.n (johnson_cook): number > 0; required\n"));
  CHECK_THAT(text, Catch::Contains("\nguards.energy_stop: number > 0; default 0.1\n"));
  CHECK_THAT(text, !Catch::Contains("]("));
  const auto maps = nlohmann::json::parse(printed({.keys = true, .json = true}));
  const auto rotate = std::ranges::find_if(maps, [](const auto& map) { return map["map"] == "mesh.rotate"; });
  REQUIRE(rotate != maps.end());
  CHECK((*rotate)["keys"][1] == nlohmann::json{{"key", "degrees"},
                                               {"of", nlohmann::json::array()},
                                               {"type", "number"},
                                               {"unit", "degree"},
                                               {"default", "required"},
                                               {"meaning", "Angle."}});
}
