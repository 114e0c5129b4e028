// SPDX-License-Identifier: Apache-2.0
// What a question consists of, and which questions are the same.
#include "app/depth/depth_work.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "prepared_scene.hpp"

using namespace brunt;
using Catch::Contains;

namespace {

const std::string cube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

app::DepthOptions two_cubes(const support::SceneFolder& folder) {
  app::DepthOptions options;
  options.a = folder.write("a.obj", cube);
  options.b = folder.write("b.obj", cube);
  options.at = std::string("0.5,0,0");
  return options;
}

}  // namespace

TEST_CASE("depth_work: metrics once each, translations first") {
  app::DepthOptions options;
  options.metrics = {"object_norm", "translation", "displacement", "translation"};
  CHECK(app::metrics_of(options) ==
        std::vector{depth::Metric::translation, depth::Metric::displacement, depth::Metric::object_norm});
}

TEST_CASE("depth_work: two files are two bodies at one pose, or at those of a file") {
  const support::SceneFolder folder;
  app::DepthOptions options = two_cubes(folder);
  const app::DepthWork work = app::depth_work(comm::Communicator::self(), options);
  REQUIRE(work.bodies.size() == 2);
  CHECK(work.bodies[0].mass.mass == Approx(1));
  REQUIRE(work.poses.size() == 1);
  CHECK(work.poses[0].start.translation == Vec3(.5, 0, 0));
  options.at.clear();
  options.poses = folder.write("p.csv", "x,y,z\n1,0,0\n2,0,0\n");
  CHECK(app::depth_work(comm::Communicator::self(), options).poses.size() == 2);
  options.along = std::string("x");
  CHECK_THROWS_WITH(app::depth_work(comm::Communicator::self(), options), Contains("--metric translation"));
  options.metrics = {"translation"};
  CHECK(app::depth_work(comm::Communicator::self(), options).along == std::vector<Vec3>{Vec3::UnitX()});
  options.b.clear();
  CHECK_THROWS_WITH(app::depth_work(comm::Communicator::self(), options), Contains("expected A and B"));
}

TEST_CASE("depth_work: faults of both files are told at once; pieces have to lie inside") {
  const support::SceneFolder folder;
  app::DepthOptions options = two_cubes(folder);
  options.pieces = folder.write("pieces.yaml", "b: [[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 2]]]\n");
  CHECK_THROWS_WITH(app::depth_work(comm::Communicator::self(), options),
                    Contains("pieces.yaml: b: invalid piece 1: a corner lies outside the body"));
  options.a = folder.write("a.obj", "v 0 0 0\n");
  options.b = folder.write("b.obj", "v 0 0 nan\n");
  try {
    (void)app::depth_work(comm::Communicator::self(), options);
    FAIL("both files are faulty");
  } catch (const InputError& error) {
    CHECK(error.faults().size() == 2);
  }
}

TEST_CASE("depth_work: the fingerprint is that of the question, not of the way to the answer") {
  const support::SceneFolder folder;
  app::DepthOptions options = two_cubes(folder);
  const auto print = [&] { return app::fingerprint_of(options, app::depth_work(comm::Communicator::self(), options)); };
  const std::string one = print();
  options.json = true;
  options.out = folder.file("elsewhere");
  CHECK(print() == one);
  options.at = std::string("0.5,0,1e-9");
  CHECK(print() != one);
  options.at = std::string("0.5,0,0");
  options.careful = true;
  CHECK(print() != one);
}
